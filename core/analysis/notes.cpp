// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/notes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>

#include "core/analysis/light/reflectance.h"
#include "core/scene/masks.h"

namespace core {
namespace {

constexpr std::size_t kFewPixels = 50;

std::string number(const char* format, double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

void noteLight(const Scene& scene, const Analysis& analysis, std::vector<std::string>& notes) {
    const EnvironmentParams& params = scene.environment;
    if ((params.image && params.use == EnvironmentUse::Replace) || !analysis.environment) return;
    const DirectionalMap& map = *analysis.environment;
    double seen = 0;
    for (int y = 0; y < map.coverage.height(); ++y)
        for (int x = 0; x < map.coverage.width(); ++x)
            if (map.coverage(x, y) > 0)
                seen += static_cast<double>(
                    DirectionalMap::texelSolidAngle(y, map.coverage.width(), map.coverage.height()));
    const std::string percent = number("%.0f", seen / (4 * std::numbers::pi) * 100) + " % of all directions";
    const bool glossy = std::ranges::any_of(scene.segments, [](const Segment& s) { return s.glossy; });
    const std::string rest = params.image ? "the loaded map gives the rest" : "the rest is guessed";
    if (seen <= 0) {
        notes.push_back(
            std::string(glossy ? "No glossy segment mirrors the light" : "No segment is flagged as glossy") +
            " and no pixel is distant, so nothing is known of the light" +
            (params.image
                 ? ": the loaded map is all of it."
                 : ": edits are lit as the shading suggests. Flag something glossy or load an environment map."));
    } else if (!glossy) {
        notes.push_back("No segment is flagged as glossy: the light is known only from distant pixels, " + percent +
                        "; " + rest + ". Flag something glossy to recover more.");
    }
    const auto clipped = std::ranges::count_if(map.clipped.pixels(), [](std::uint8_t c) { return c != 0; });
    if (clipped > 0)
        notes.push_back("The camera clipped the light in " + std::to_string(clipped) +
                        " texels of the environment; their radiance is estimated from the blur around them. A "
                        "photograph with more range (EXR) knows it.");
}

}  // namespace

std::vector<std::string> analysisNotes(const Scene& scene, const Analysis& analysis) {
    std::vector<std::string> notes;
    noteLight(scene, analysis, notes);
    std::map<std::uint16_t, std::size_t> pixels;
    if (scene.photo && analysis.front)
        for (std::size_t i = 0; i < analysis.front->depth.size(); ++i)
            if (analysis.front->depth[i] > 0) ++pixels[scene.photo->labels[i]];
    for (const Segment& segment : scene.segments) {
        const std::string name = "Segment \"" + segment.name + "\"";
        if (pixels[segment.label] == 0) {
            notes.push_back(name + " has no pixel with depth, so it cannot be edited. Give it depth or mark it again.");
            continue;
        }
        const Reflectance* reflectance = segment.glossy ? analysis.findReflectance(segment.label) : nullptr;
        if (reflectance == nullptr) continue;
        if (pixels[segment.label] < kFewPixels) {
            notes.push_back(name + " is glossy but has only " + std::to_string(pixels[segment.label]) +
                            " pixels with depth: too few to tell its reflectance and the light from it.");
        } else if (!segment.reflectance && analysis::showsMoreThanItMirrors(*reflectance)) {
            notes.push_back(name +
                            " shows more light than it can mirror: it has colours of its own, so the light is not "
                            "recovered from it. If it is a mirror, set its reflectance by hand.");
        } else if (!reflectance->reliable && !segment.reflectance) {
            notes.push_back(name + " shows too little whose brightness is known otherwise (" +
                            number("%.2f", static_cast<double>(reflectance->commonSolidAngle)) +
                            " sr), so its reflectance is a guess. Set it by hand.");
        }
    }
    for (std::string& note : maskNotes(scene)) notes.push_back(std::move(note));
    for (const BackSideInfo& info : analysis.backSides) {
        const Segment* segment = scene.findSegment(info.label);
        if (!info.note.empty() && segment != nullptr && segment->edit)
            notes.push_back("Back side of \"" + segment->name + "\": " + info.note);
    }
    return notes;
}

}  // namespace core
