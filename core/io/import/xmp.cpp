// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/xmp.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "core/io/import/jpeg_segments.h"

namespace core {

namespace {

constexpr std::string_view kRdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
/// Ancestors searched for the definition of a prefix.
constexpr int kMaxAncestors = 64;

/// Namespace that a prefix stands for at `node`.
std::string_view namespaceOf(pugi::xml_node node, std::string_view prefix) {
    const std::string attribute = prefix.empty() ? "xmlns" : "xmlns:" + std::string(prefix);
    for (int depth = 0; node && depth < kMaxAncestors; ++depth, node = node.parent())
        if (const pugi::xml_attribute found = node.attribute(attribute.c_str())) return found.value();
    return {};
}

/// Whether `qualified` (prefix:name, as written at `node`) is that name.
bool isNamed(const pugi::xml_node& node, std::string_view qualified, std::string_view uri, std::string_view name) {
    const std::size_t colon = qualified.find(':');
    const std::string_view local = colon == std::string_view::npos ? qualified : qualified.substr(colon + 1);
    if (local != name) return false;
    return namespaceOf(node, colon == std::string_view::npos ? std::string_view() : qualified.substr(0, colon)) == uri;
}

pugi::xml_node findElement(const pugi::xml_node& node, std::string_view uri, std::string_view name) {
    for (const pugi::xml_node& element : node.children())
        if (element.type() == pugi::node_element && isNamed(element, element.name(), uri, name)) return element;
    return {};
}

std::optional<double> parseNumber(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    while (!text.empty() && (kSpace.find(text.front()) != std::string_view::npos || text.front() == '+'))
        text.remove_prefix(1);
    while (!text.empty() && kSpace.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
    std::string digits(text);
    // Some programs write numbers in the language of the user.
    if (std::ranges::count(digits, ',') == 1 && digits.find('.') == std::string::npos)
        std::ranges::replace(digits, ',', '.');
    double value = 0;
    const char* const stop = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), stop, value);
    if (error != std::errc() || end != stop) return std::nullopt;
    return value;
}

}  // namespace

std::optional<std::string> XmpNode::text(std::string_view uri, std::string_view name) const {
    for (const pugi::xml_attribute& attribute : node_.attributes())
        if (isNamed(node_, attribute.name(), uri, name)) return attribute.value();
    if (const pugi::xml_node element = findElement(node_, uri, name)) return element.text().get();
    return std::nullopt;
}

std::optional<double> XmpNode::number(std::string_view uri, std::string_view name) const {
    const auto found = text(uri, name);
    return found ? parseNumber(*found) : std::nullopt;
}

std::optional<XmpNode> XmpNode::child(std::string_view uri, std::string_view name) const {
    const pugi::xml_node element = findElement(node_, uri, name);
    if (!element) return std::nullopt;
    const pugi::xml_node description = findElement(element, kRdf, "Description");
    return XmpNode(description ? description : element);
}

std::vector<XmpNode> XmpNode::items(std::string_view uri, std::string_view name) const {
    std::vector<XmpNode> result;
    const pugi::xml_node property = findElement(node_, uri, name);
    for (const char* container : {"Seq", "Bag", "Alt"})
        for (const pugi::xml_node& item : findElement(property, kRdf, container).children()) {
            if (item.type() != pugi::node_element || !isNamed(item, item.name(), kRdf, "li")) continue;
            const pugi::xml_node description = findElement(item, kRdf, "Description");
            result.emplace_back(description ? description : item);
        }
    return result;
}

std::vector<double> XmpNode::numbers(std::string_view uri, std::string_view name) const {
    std::vector<double> result;
    for (const XmpNode& item : items(uri, name)) {
        const auto value = parseNumber(item.node_.text().get());
        if (!value) return {};
        result.push_back(*value);
    }
    return result;
}

Xmp::Xmp(const std::vector<std::string>& packets, Message* damage) {
    for (const std::string& packet : packets) {
        auto document = std::make_unique<pugi::xml_document>();
        const pugi::xml_parse_result result = document->load_buffer(packet.data(), packet.size());
        if (!result) {
            if (damage != nullptr && damage->empty())
                *damage = Message("messages", "its XMP is no well-formed XML: %1").with(result.description());
            continue;
        }
        const pugi::xml_node meta = findElement(*document, "adobe:ns:meta/", "xmpmeta");
        const pugi::xml_node rdf = findElement(meta ? meta : *document, kRdf, "RDF");
        for (const pugi::xml_node& description : rdf.children())
            if (isNamed(description, description.name(), kRdf, "Description")) descriptions_.emplace_back(description);
        documents_.push_back(std::move(document));
    }
}

bool Xmp::has(std::string_view uri, std::string_view name) const { return text(uri, name).has_value(); }

std::optional<std::string> Xmp::text(std::string_view uri, std::string_view name) const {
    for (const XmpNode& description : descriptions_)
        if (auto found = description.text(uri, name)) return found;
    return std::nullopt;
}

std::optional<double> Xmp::number(std::string_view uri, std::string_view name) const {
    const auto found = text(uri, name);
    return found ? parseNumber(*found) : std::nullopt;
}

std::optional<XmpNode> Xmp::child(std::string_view uri, std::string_view name) const {
    for (const XmpNode& description : descriptions_)
        if (auto found = description.child(uri, name)) return found;
    return std::nullopt;
}

std::vector<XmpNode> Xmp::items(std::string_view uri, std::string_view name) const {
    for (const XmpNode& description : descriptions_)
        if (auto found = description.items(uri, name); !found.empty()) return found;
    return {};
}

std::vector<double> Xmp::numbers(std::string_view uri, std::string_view name) const {
    for (const XmpNode& description : descriptions_)
        if (auto found = description.numbers(uri, name); !found.empty()) return found;
    return {};
}

Xmp readJpegXmp(std::string_view stream, Message* damage) {
    Message problem;
    Xmp xmp(jpegXmpPackets(stream, &problem), &problem);
    if (damage != nullptr) *damage = problem;
    return xmp;
}

std::optional<std::string> decodeBase64(std::string_view text) {
    static const std::array<std::int8_t, 256> kValues = [] {
        std::array<std::int8_t, 256> values{};
        values.fill(-1);
        constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (std::size_t i = 0; i < kDigits.size(); ++i)
            values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::int8_t>(i);
        return values;
    }();
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    unsigned count = 0;  // bits not yet written
    bool padded = false;
    for (const char c : text) {
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') {
            padded = true;
            continue;
        }
        const std::int8_t value = kValues[static_cast<unsigned char>(c)];
        if (value < 0 || padded) return std::nullopt;
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<char>(bits >> count));
    }
    return bytes;
}

}  // namespace core
