// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/heif_boxes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace core {

namespace {

constexpr std::size_t kMaxBoxes = 4096;

struct Box {
    std::string_view type;
    std::size_t begin = 0;    ///< in the bytes that were searched
    std::size_t content = 0;  ///< behind the header
    std::size_t end = 0;
    bool toTheEnd = false;  ///< has no size of its own
};

std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::string numberBytes(std::uint64_t value, std::size_t size) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[size - 1 - i] = static_cast<char>(value >> 8U * i & 0xffU);
    return bytes;
}

/// The boxes that fill `bytes` from `begin`; nullopt when they do not.
std::optional<std::vector<Box>> boxesIn(std::string_view bytes, std::size_t begin) {
    std::vector<Box> boxes;
    for (std::size_t at = begin; at < bytes.size();) {
        const std::size_t left = bytes.size() - at;
        if (left < 8 || boxes.size() == kMaxBoxes) return std::nullopt;
        std::uint64_t size = number(bytes, at, 4);
        std::size_t header = 8;
        const bool toTheEnd = size == 0;
        if (toTheEnd) size = left;
        if (size == 1) {
            if (left < 16) return std::nullopt;
            size = number(bytes, at + 8, 8);
            header = 16;
        }
        if (size < header || size > left) return std::nullopt;
        boxes.push_back({bytes.substr(at + 4, 4), at, at + header, at + static_cast<std::size_t>(size), toTheEnd});
        at += static_cast<std::size_t>(size);
    }
    return boxes;
}

const Box* findBox(const std::vector<Box>& boxes, std::string_view type) {
    const auto found = std::ranges::find(boxes, type, &Box::type);
    return found == boxes.end() ? nullptr : &*found;
}

std::string boxBytes(std::string_view type, const std::string& content) {
    return numberBytes(content.size() + 8, 4) + std::string(type) + content;
}

/// The content of a box of references with one target for each auxiliary image; nullopt when it has that already, or is
/// damaged. Version 0 has identifiers of 2 bytes, version 1 of 4.
std::optional<std::string> singleTargets(std::string_view content, std::uint64_t primary) {
    if (content.size() < 4) return std::nullopt;
    const std::size_t width = content[0] == 0 ? 2 : 4;
    const auto boxes = boxesIn(content, 4);
    if (!boxes) return std::nullopt;
    std::string result(content.substr(0, 4));
    bool changed = false;
    for (const Box& box : *boxes) {
        const std::string_view body = content.substr(box.content, box.end - box.content);
        const std::uint64_t count = body.size() >= width + 2 ? number(body, width, 2) : 0;
        if (box.type != "auxl" || count < 2) {
            result += content.substr(box.begin, box.end - box.begin);
            continue;
        }
        if (body.size() < width + 2 + count * width) return std::nullopt;
        std::uint64_t target = number(body, width + 2, width);
        for (std::size_t i = 0; i < count; ++i)
            if (number(body, width + 2 + i * width, width) == primary) target = primary;
        result +=
            boxBytes(box.type, std::string(body.substr(0, width)) + numberBytes(1, 2) + numberBytes(target, width));
        changed = true;
    }
    if (!changed) return std::nullopt;
    return result;
}

/// A `meta` box with single targets; nullopt as above.
std::optional<std::string> rewrittenMeta(std::string_view meta, std::size_t content) {
    if (meta.size() < content + 4) return std::nullopt;
    const auto boxes = boxesIn(meta, content + 4);
    if (!boxes) return std::nullopt;
    const Box* item = findBox(*boxes, "pitm");
    const Box* references = findBox(*boxes, "iref");
    if (item == nullptr || references == nullptr || item->end - item->content < 6) return std::nullopt;
    const std::size_t width = meta[item->content] == 0 ? 2 : 4;
    if (item->end - item->content < 4 + width) return std::nullopt;
    const auto single = singleTargets(meta.substr(references->content, references->end - references->content),
                                      number(meta, item->content + 4, width));
    if (!single) return std::nullopt;
    std::string result(meta.substr(content, 4));
    for (const Box& box : *boxes)
        result +=
            &box == references ? boxBytes("iref", *single) : std::string(meta.substr(box.begin, box.end - box.begin));
    return boxBytes("meta", result);
}

}  // namespace

std::optional<std::string> withSingleAuxiliaryTargets(std::string_view file) {
    const auto boxes = boxesIn(file, 0);
    const Box* meta = boxes ? findBox(*boxes, "meta") : nullptr;
    if (meta == nullptr) return std::nullopt;
    const auto rewritten =
        rewrittenMeta(file.substr(meta->begin, meta->end - meta->begin), meta->content - meta->begin);
    if (!rewritten) return std::nullopt;
    // The items are found by their place in the file: nothing may move. The new box comes last, the old one is void.
    std::string result(file);
    result.replace(meta->begin + 4, 4, "free");
    const Box& last = boxes->back();
    if (last.toTheEnd) {
        if (last.end - last.begin > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
        result.replace(last.begin, 4, numberBytes(last.end - last.begin, 4));
    }
    return result + *rewritten;
}

}  // namespace core
