// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/notes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/analysis/light/reflectance.h"
#include "core/base/label_table.h"
#include "core/scene/masks.h"

namespace core {
namespace {

constexpr std::size_t kFewPixels = 50;

std::string number(const char* format, double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

/// The note for scenes in which nothing shows the light.
Message unknownLight(bool glossy, bool mapLoaded) {
    if (glossy && mapLoaded)
        return Message("messages",
                       "No glossy segment mirrors the light and no pixel is distant, so nothing is known of the light: "
                       "the loaded map is all of it.");
    if (glossy)
        return Message("messages",
                       "No glossy segment mirrors the light and no pixel is distant, so nothing is known of the light: "
                       "edits are lit as the shading suggests. Flag something glossy or load an environment map.");
    if (mapLoaded)
        return Message("messages",
                       "No segment is flagged as glossy and no pixel is distant, so nothing is known of the light: the "
                       "loaded map is all of it.");
    return Message("messages",
                   "No segment is flagged as glossy and no pixel is distant, so nothing is known of the light: edits "
                   "are lit as the shading suggests. Flag something glossy or load an environment map.");
}

void noteLight(const Scene& scene, const Analysis& analysis, Notes& notes) {
    const EnvironmentParams& params = scene.environment;
    if ((params.image && params.use == EnvironmentUse::Replace) || !analysis.environment) return;
    const DirectionalMap& map = *analysis.environment;
    double seen = 0;
    for (int y = 0; y < map.coverage.height(); ++y)
        for (int x = 0; x < map.coverage.width(); ++x)
            if (map.coverage(x, y) > 0)
                seen += static_cast<double>(
                    DirectionalMap::texelSolidAngle(y, map.coverage.width(), map.coverage.height()));
    const std::string percent = number("%.0f", seen / (4 * std::numbers::pi) * 100);
    const bool glossy = std::ranges::any_of(scene.segments, [](const Segment& s) { return s.glossy; });
    if (seen <= 0) {
        notes.push_back(unknownLight(glossy, params.image != nullptr));
    } else if (!glossy && params.image) {
        notes.push_back(Message("messages",
                                "No segment is flagged as glossy: the light is known only from distant pixels, %1 % of "
                                "all directions; the loaded map gives the rest. Flag something glossy to recover more.")
                            .with(percent));
    } else if (!glossy) {
        notes.push_back(Message("messages",
                                "No segment is flagged as glossy: the light is known only from distant pixels, %1 % of "
                                "all directions; the rest is guessed. Flag something glossy to recover more.")
                            .with(percent));
    }
    const auto clipped = std::ranges::count_if(map.clipped.pixels(), [](std::uint8_t c) { return c != 0; });
    if (clipped > 0)
        notes.push_back(Message("messages",
                                "The camera clipped the light in %1 texels of the environment; their radiance is "
                                "estimated from the blur around them. Use a photograph with more range (EXR) to get it "
                                "right.")
                            .with(clipped));
}

/// Pixels with depth of each label.
LabelTable<std::size_t> depthPixels(const Scene& scene, const Analysis& analysis) {
    LabelTable<std::size_t> pixels;
    if (!scene.photo || !analysis.front || !analysis.front->depth.sameSize(scene.photo->labels)) return pixels;
    for (std::size_t i = 0; i < analysis.front->depth.size(); ++i)
        if (analysis.front->depth[i] > 0) ++pixels[scene.photo->labels[i]];
    return pixels;
}

void noteSegment(const Segment& segment, const Analysis& analysis, std::size_t pixels, Notes& notes) {
    if (pixels == 0) {
        notes.push_back(Message("messages",
                                "Segment \"%1\" has no pixel with depth, so it cannot be edited. Give it depth or "
                                "mark it again.")
                            .with(segment.name));
        return;
    }
    const Reflectance* found = segment.glossy ? analysis.findReflectance(segment.label) : nullptr;
    if (found == nullptr) return;
    const Reflectance& reflectance = *found;
    if (pixels < kFewPixels) {
        notes.push_back(Message("messages",
                                "Segment \"%1\" is glossy but has only %2 pixels with depth: too few to estimate its "
                                "reflectance and the light from it.")
                            .with(segment.name, pixels));
    } else if (!segment.reflectance && analysis::showsMoreThanItMirrors(reflectance)) {
        notes.push_back(Message("messages",
                                "Segment \"%1\" shows more light than it can mirror: it has colours of its own, so the "
                                "light is not recovered from it. If it is a mirror, set its reflectance yourself.")
                            .with(segment.name));
    } else if (!reflectance.reliable && !segment.reflectance) {
        notes.push_back(Message("messages",
                                "Segment \"%1\" mirrors too little whose brightness is known (%2 sr), so its "
                                "reflectance is a guess. Set it yourself.")
                            .with(segment.name, number("%.2f", static_cast<double>(reflectance.commonSolidAngle))));
    }
}

}  // namespace

Notes analysisNotes(const Scene& scene, const Analysis& analysis) {
    Notes notes;
    noteLight(scene, analysis, notes);
    const LabelTable<std::size_t> pixels = depthPixels(scene, analysis);
    for (const Segment& segment : scene.segments) noteSegment(segment, analysis, pixels[segment.label], notes);
    for (Message& note : maskNotes(scene)) notes.push_back(std::move(note));
    for (const BackSideInfo& info : analysis.backSides) {
        const Segment* segment = scene.findSegment(info.label);
        if (!info.note.empty() && segment != nullptr && segment->edit)
            notes.push_back(Message("messages", "Back side of \"%1\": %2").with(segment->name, info.note));
    }
    return notes;
}

Notes glossyNotes(const Scene& scene, const Analysis& analysis) {
    Notes notes;
    if (std::ranges::none_of(scene.segments, &Segment::glossy)) return notes;
    const LabelTable<std::size_t> pixels = depthPixels(scene, analysis);
    for (const Segment& segment : scene.segments)
        if (segment.glossy) noteSegment(segment, analysis, pixels[segment.label], notes);
    return notes;
}

}  // namespace core
