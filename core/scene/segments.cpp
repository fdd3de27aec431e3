// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/segments.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/base/error.h"
#include "core/base/label_table.h"

namespace core {

namespace {

constexpr int kLargestLabel = 65535;

/// A whole number, of any size; nullopt for other texts.
std::optional<long> wholeNumber(const std::string& text) {
    long value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    return code == std::errc() ? value : std::optional<long>(-1);
}

std::uint16_t newLabel(const Scene& scene, const std::string& labelOrName) {
    if (const std::optional<long> number = wholeNumber(labelOrName)) {
        if (*number < 1 || *number > kLargestLabel)
            throw Error(ErrorKind::Usage, Message("messages", "The label of a segment is \"%1\", expected 1 to %2.")
                                              .with(labelOrName, kLargestLabel));
        return static_cast<std::uint16_t>(*number);
    }
    for (int label = 1; label <= kLargestLabel; ++label)
        if (scene.findSegment(static_cast<std::uint16_t>(label)) == nullptr) return static_cast<std::uint16_t>(label);
    throw Error(ErrorKind::Usage,
                Message("messages", "The project has %1 segments already, no label is free.").with(kLargestLabel));
}

/// Segments whose label is gone, removed; throws for edited ones.
void dropEmptySegments(Scene& scene, const LabelImage& labels, Notes* notes) {
    LabelTable<char> present(0);
    for (const std::uint16_t label : labels.pixels()) present[label] = 1;
    for (const Segment& segment : scene.segments) {
        if (present[segment.label] != 0) continue;
        if (segment.edit)
            throw Error(ErrorKind::Usage,
                        Message("messages", "The selection covers all of the segment \"%1\", which is edited.")
                            .with(segment.name));
        if (notes != nullptr)
            notes->push_back(
                Message("messages", "The segment \"%1\" is gone: the selection covers all of it.").with(segment.name));
    }
    std::erase_if(scene.segments, [&](const Segment& segment) { return present[segment.label] == 0; });
}

}  // namespace

Scene withSegment(const Scene& scene, const Image<std::uint8_t>& mask, const std::string& labelOrName, Notes* notes) {
    CORE_ASSERT(mask.sameSize(scene.photo->labels), "a mask has the photograph's size");
    if (std::ranges::all_of(mask.pixels(), [](std::uint8_t value) { return value == 0; }))
        throw Error(ErrorKind::Usage, Message("messages", "Nothing is selected, so there is no segment to make."));
    if (labelOrName.empty()) throw Error(ErrorKind::Usage, Message("messages", "The name of the segment is empty."));
    Scene result = scene;
    const Segment* known = result.findSegment(labelOrName);
    const std::uint16_t label = known != nullptr ? known->label : newLabel(scene, labelOrName);
    if (result.findSegment(label) == nullptr) {
        Segment segment;
        segment.label = label;
        segment.name = wholeNumber(labelOrName) ? "segment " + std::to_string(label) : labelOrName;
        while (result.findSegment(segment.name) != nullptr) segment.name += "'";
        result.segments.push_back(std::move(segment));
        std::ranges::sort(result.segments, {}, &Segment::label);
    }
    auto photo = std::make_shared<Photo>(*scene.photo);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        std::uint16_t& pixel = photo->labels[i];
        if (mask[i] != 0)
            pixel = label;
        else if (pixel == label)
            pixel = 0;
    }
    dropEmptySegments(result, photo->labels, notes);
    result.photo = std::move(photo);
    return result;
}

}  // namespace core
