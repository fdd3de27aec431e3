// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene.h"

#include <algorithm>

#include "core/base/label_table.h"

namespace core {

const Segment* Scene::findSegment(std::uint16_t label) const {
    const auto found = std::ranges::find(segments, label, &Segment::label);
    return found == segments.end() ? nullptr : &*found;
}

Segment* Scene::findSegment(std::uint16_t label) {
    const auto found = std::ranges::find(segments, label, &Segment::label);
    return found == segments.end() ? nullptr : &*found;
}

Segment* Scene::findSegment(const std::string& labelOrName) {
    const auto byName = std::ranges::find(segments, labelOrName, &Segment::name);
    if (byName != segments.end()) return &*byName;
    const auto byLabel =
        std::ranges::find_if(segments, [&](const Segment& s) { return std::to_string(s.label) == labelOrName; });
    return byLabel == segments.end() ? nullptr : &*byLabel;
}

Scene visibleScene(const Scene& scene) {
    Scene result = scene;
    for (Segment& segment : result.segments)
        if (!segment.visible) segment.edit.reset();
    return result;
}

void addMissingSegments(Scene& scene) {
    if (!scene.photo) return;
    LabelTable<char> present;
    for (const std::uint16_t label : scene.photo->labels.pixels()) present[label] = 1;
    for (const Segment& segment : scene.segments) present[segment.label] = 0;
    for (std::size_t label = 1; label < present.size(); ++label) {
        const auto value = static_cast<std::uint16_t>(label);
        if (present[label] == 0) continue;
        Segment segment;
        segment.label = value;
        segment.name = "segment " + std::to_string(label);
        scene.segments.push_back(std::move(segment));
    }
    std::ranges::sort(scene.segments, {}, &Segment::label);
}

}  // namespace core
