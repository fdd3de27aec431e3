// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/exr_layers.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <tuple>

namespace core {

namespace {

/// Lower case without spaces, underscores and hyphens.
std::string plain(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' && c != '_' && c != '-')
            result.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    return result;
}

std::string_view lastComponent(std::string_view layer) {
    const auto dot = layer.rfind('.');
    return dot == std::string_view::npos ? layer : layer.substr(dot + 1);
}

std::string_view firstComponent(std::string_view layer) { return layer.substr(0, layer.find('.')); }

template <std::size_t N>
bool isOneOf(std::string_view text, const std::array<std::string_view, N>& words) {
    return std::ranges::find(words, text) != words.end();
}

/// "depth", "VRayZDepth", "Pz", but not the number of bounces of a ray.
bool meansDepth(std::string_view word) {
    constexpr std::array<std::string_view, 3> kBounces{"raydepth", "bouncedepth", "tracedepth"};
    const std::string text = plain(word);
    return text == "pz" || text == "depthz" || (text.ends_with("depth") && !isOneOf(std::string_view(text), kBounces));
}

/// Layers whose Z is no distance even where it stands alone.
bool meansOther(std::string_view word) {
    constexpr std::array<std::string_view, 10> kShort{"n", "ng", "ns", "p", "pos", "ao", "uv", "st", "pref", "pworld"};
    constexpr std::array<std::string_view, 9> kParts{"normal", "position", "vector",    "motion", "velocity",
                                                     "mist",   "shadow",   "occlusion", "index"};
    const std::string text = plain(word);
    if (isOneOf(std::string_view(text), kShort)) return true;
    return std::ranges::any_of(kParts, [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

const ExrChannel* sibling(const std::vector<ExrChannel>& channels, const ExrChannel& of, std::string_view component) {
    const auto found = std::ranges::find_if(channels, [&](const ExrChannel& c) {
        return c.part == of.part && c.layer == of.layer && plain(c.component) == component;
    });
    return found == channels.end() ? nullptr : &*found;
}

/// The smaller, the more surely a distance from the camera plane; nullopt = none.
std::optional<int> depthRank(const std::vector<ExrChannel>& channels, const ExrChannel& channel) {
    constexpr std::array<std::string_view, 3> kScalar{"v", "y", "r"};
    const std::string component = plain(channel.component);
    const std::string_view layer = lastComponent(channel.layer);
    if (component == "z") {
        if (sibling(channels, channel, "x") != nullptr && sibling(channels, channel, "y") != nullptr)
            return std::nullopt;
        if (channel.layer.empty()) return 0;
        if (meansOther(layer)) return std::nullopt;
        return meansDepth(layer) ? 1 : 3;
    }
    if (meansDepth(channel.component) && !meansOther(layer)) return 1;
    if (isOneOf(std::string_view(component), kScalar) && meansDepth(layer)) return 2;
    return std::nullopt;
}

int colorRank(const std::string& layer) {
    constexpr std::array<std::string_view, 9> kBeauty{"beauty", "rgba",      "rgb",   "color", "colour",
                                                      "image",  "composite", "final", "main"};
    if (layer.empty()) return 0;
    const std::string last = plain(lastComponent(layer));
    if (last == "combined") return 1;
    return isOneOf(std::string_view(last), kBeauty) ? 2 : 3;
}

}  // namespace

std::vector<ExrChannel> exrChannels(const std::vector<OIIO::ImageSpec>& parts) {
    std::vector<ExrChannel> channels;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const std::string partName = parts[part].get_string_attribute("oiio:subimagename");
        for (int c = 0; c < parts[part].nchannels; ++c) {
            std::string name = parts[part].channel_name(c);
            const bool repeated = name.starts_with(partName + ".");
            if (parts.size() > 1 && !partName.empty() && !repeated) name.insert(0, partName + ".");
            const auto dot = name.rfind('.');
            ExrChannel channel{static_cast<int>(part), c, {}, name};
            if (dot != std::string::npos) {
                channel.layer = name.substr(0, dot);
                channel.component = name.substr(dot + 1);
            }
            channels.push_back(std::move(channel));
        }
    }
    return channels;
}

std::optional<ExrColor> exrColor(const std::vector<ExrChannel>& channels) {
    std::optional<ExrColor> best;
    std::vector<std::string> layers;
    for (const ExrChannel& red : channels) {
        const std::string component = plain(red.component);
        if (component != "r" && component != "red") continue;
        const bool words = component == "red";
        const ExrChannel* green = sibling(channels, red, words ? "green" : "g");
        const ExrChannel* blue = sibling(channels, red, words ? "blue" : "b");
        if (green == nullptr || blue == nullptr) continue;
        layers.push_back(red.layer);
        if (best && colorRank(best->layer) <= colorRank(red.layer)) continue;
        best = ExrColor{red.part, {red.index, green->index, blue->index}, red.layer, {}};
    }
    if (!best) return best;
    const int rank = colorRank(best->layer);
    if (rank > 0)
        for (const std::string& layer : layers)
            if (layer != best->layer && colorRank(layer) == rank) best->others.push_back(layer);
    return best;
}

std::optional<ExrChannel> exrDepth(const std::vector<ExrChannel>& channels) {
    using Preference = std::tuple<bool, int>;
    std::optional<Preference> least;
    std::optional<ExrChannel> best;
    const auto color = exrColor(channels);
    const std::string_view view = color ? firstComponent(color->layer) : std::string_view();
    for (const ExrChannel& channel : channels) {
        const auto rank = depthRank(channels, channel);
        if (!rank) continue;
        const Preference preference{!view.empty() && firstComponent(channel.layer) != view, *rank};
        if (least && *least <= preference) continue;
        least = preference;
        best = channel;
    }
    return best;
}

std::optional<ExrChannel> exrIndices(const std::vector<ExrChannel>& channels) {
    constexpr std::array<std::string_view, 7> kLayers{"indexob", "objectindex", "objectid", "objectids",
                                                      "id",      "instanceid",  "indexma"};
    std::optional<ExrChannel> best;
    std::size_t least = kLayers.size();
    for (const ExrChannel& channel : channels)
        for (const std::string_view word : {std::string_view(channel.component), lastComponent(channel.layer)}) {
            const auto found = std::ranges::find(kLayers, std::string_view(plain(word)));
            const auto rank = static_cast<std::size_t>(found - kLayers.begin());
            if (rank >= least) continue;
            least = rank;
            best = channel;
        }
    return best;
}

bool hasCryptomatte(const std::vector<ExrChannel>& channels) {
    return std::ranges::any_of(
        channels, [](const ExrChannel& channel) { return plain(channel.layer).find("crypto") != std::string::npos; });
}

std::string exrChannelNames(const std::vector<ExrChannel>& channels) {
    constexpr std::size_t kMost = 24;
    std::string text;
    for (std::size_t i = 0; i < std::min(channels.size(), kMost); ++i) text += (i > 0 ? ", " : "") + channels[i].name();
    if (channels.size() > kMost) text += ", …";
    return text;
}

}  // namespace core
