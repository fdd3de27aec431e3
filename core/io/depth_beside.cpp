// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/depth_beside.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <tuple>
#include <vector>

namespace core {

namespace {

namespace fs = std::filesystem;
using NameWords = std::vector<std::string>;

/// A folder with more entries is not searched to its end.
constexpr int kMaxEntries = 20000;
/// Extensions of pictures that can be depth maps, the best ones first.
constexpr std::array<std::string_view, 9> kMapExtensions{".exr", ".pfm", ".tif", ".tiff", ".png",
                                                         ".pgm", ".hdr", ".jpg", ".jpeg"};
constexpr std::array<std::string_view, 4> kDepthWords{"depth", "depthmap", "disparity", "disp"};
constexpr std::array<std::string_view, 7> kColorWords{"color", "colour", "rgb", "image", "img", "photo", "picture"};

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return text;
}

template <class List>
bool listHas(const List& list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
}

/// Words of a name without its extension, in lower case: "IMG_12-Depth" and "IMG12depth" are img, 12, depth.
NameWords nameWords(const fs::path& path) {
    enum class Kind { Other, Letter, Digit };
    NameWords words;
    Kind before = Kind::Other;
    for (const char c : lowerCase(path.stem().string())) {
        const auto byte = static_cast<unsigned char>(c);
        // Bytes of letters beyond ASCII belong to words.
        const Kind kind = std::isdigit(byte) != 0                   ? Kind::Digit
                          : std::isalpha(byte) != 0 || byte >= 0x80 ? Kind::Letter
                                                                    : Kind::Other;
        if (kind != Kind::Other) {
            if (kind != before) words.emplace_back();
            words.back() += c;
        }
        before = kind;
    }
    constexpr std::string_view kDepth = "depth";
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].size() <= kDepth.size() || !words[i].ends_with(kDepth)) continue;
        words[i].resize(words[i].size() - kDepth.size());
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::string(kDepth));
    }
    return words;
}

NameWords without(NameWords words, const auto& list) {
    std::erase_if(words, [&](const std::string& word) { return listHas(list, word); });
    return words;
}

std::size_t extensionRank(const fs::path& path) {
    return static_cast<std::size_t>(std::ranges::find(kMapExtensions, lowerCase(path.extension().string())) -
                                    kMapExtensions.begin());
}

}  // namespace

std::optional<DepthBeside> findDepthBeside(const std::string& color) {
    const fs::path photo(color);
    const NameWords photoWords = nameWords(photo);
    const auto namesDepth = [](const NameWords& words) {
        return std::ranges::any_of(words, [](const std::string& word) { return listHas(kDepthWords, word); });
    };
    if (namesDepth(photoWords)) return std::nullopt;
    const NameWords subject = without(photoWords, kColorWords);
    struct Candidate {
        std::tuple<bool, std::size_t, std::string> order;  ///< the first is the best
        DepthBeside found;
    };
    std::vector<Candidate> candidates;
    int photographs = 0;
    std::error_code code;
    fs::directory_iterator entry(photo.has_parent_path() ? photo.parent_path() : fs::path("."), code);
    for (int i = 0; !code && entry != fs::directory_iterator() && i < kMaxEntries; entry.increment(code), ++i) {
        const fs::path& path = entry->path();
        const NameWords words = nameWords(path);
        if (!namesDepth(words)) {
            if (extensionRank(path) < kMapExtensions.size() || lowerCase(path.extension().string()) == ".heic")
                ++photographs;
            continue;
        }
        if (extensionRank(path) == kMapExtensions.size()) continue;
        const NameWords rest = without(without(words, kDepthWords), kColorWords);
        if (rest != subject && !rest.empty()) continue;
        const bool disparity = listHas(words, "disparity") || listHas(words, "disp");
        candidates.push_back({{rest != subject, extensionRank(path), path.filename().string()},
                              {path.string(), disparity ? std::optional(DepthKind::Disparity) : std::nullopt}});
    }
    const auto best = std::ranges::min_element(candidates, {}, &Candidate::order);
    if (best == candidates.end()) return std::nullopt;
    const bool generic = std::get<0>(best->order);
    if (generic && photographs > 1) return std::nullopt;
    return best->found;
}

}  // namespace core
