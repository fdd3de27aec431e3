// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/segment_state.h"
#include "core/shading/drive_table.h"
#include "core/shading/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace render {
namespace {

// Order of the pixels in a sweep: an ordered dither, so that a part of a sweep shows the change all over the segment.
constexpr int kSweepStep = 4;
constexpr std::array<std::pair<int, int>, kSweepStep * kSweepStep> kSweepOrder{{{0, 0},
                                                                                {2, 2},
                                                                                {2, 0},
                                                                                {0, 2},
                                                                                {1, 1},
                                                                                {3, 3},
                                                                                {3, 1},
                                                                                {1, 3},
                                                                                {1, 0},
                                                                                {3, 2},
                                                                                {3, 0},
                                                                                {1, 2},
                                                                                {0, 1},
                                                                                {2, 3},
                                                                                {2, 1},
                                                                                {0, 3}}};

bool equal(const kernel::vec4& a, const kernel::vec4& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

bool equal(const kernel::SegmentShading& a, const kernel::SegmentShading& b) {
    return equal(a.brdf.albedo, b.brdf.albedo) && equal(a.brdf.specular, b.brdf.specular) &&
           equal(a.brdf.eta, b.brdf.eta) && equal(a.brdf.k, b.brdf.k) && equal(a.brdf.values, b.brdf.values) &&
           equal(a.brdf.values2, b.brdf.values2) && equal(a.brdf.values3, b.brdf.values3) &&
           a.brdf.type == b.brdf.type && a.brdf.file == b.brdf.file && a.brdf.measured == b.brdf.measured &&
           equal(a.diffuse, b.diffuse) && equal(a.blend, b.blend);
}

bool equal(const DriveKey& a, const DriveKey& b) {
    return a.label == b.label && a.source == b.source && a.drive.slot == b.drive.slot &&
           equal(a.drive.from, b.drive.from) && equal(a.drive.to, b.drive.to) && equal(a.drive.range, b.drive.range);
}

}  // namespace

std::vector<DriveKey> driveKeys(const core::Scene& scene, std::span<const kernel::SegmentShading> shading,
                                const core::DriveTable& table, const core::Segment* only) {
    std::vector<DriveKey> keys;
    for (const core::Segment& segment : scene.segments) {
        if (only != nullptr && segment.label != only->label) continue;
        const kernel::uvec4 range = shading[segment.label].drives;
        for (std::uint32_t i = range.x; i < range.x + range.y; ++i) {
            const core::DrivePlane& plane = table.planes[table.planeOf[i]];
            // The weights of the camera's own surface are the composite's.
            if (only != nullptr && table.drives[i].slot >= kernel::kDriveBlendNew) continue;
            std::shared_ptr<const void> source = plane.mask;
            if (!plane.mask) source = plane.detail;
            keys.push_back({segment.label, table.drives[i], std::move(source)});
        }
    }
    return keys;
}

bool SumKey::same(const SumKey& other) const {
    return seed == other.seed && bounces == other.bounces && surfaceSamples == other.surfaceSamples &&
           irradianceSamples == other.irradianceSamples && quality == other.quality && eta == other.eta &&
           std::equal(shading.begin(), shading.end(), other.shading.begin(), other.shading.end(),
                      [](const auto& a, const auto& b) { return equal(a, b); }) &&
           std::equal(drives.begin(), drives.end(), other.drives.begin(), other.drives.end(),
                      [](const auto& a, const auto& b) { return equal(a, b); });
}

void SegmentState::restartReshade() {
    if (pixels.count > 0) sweepStart = (sweepStart + cursor) % pixels.count;
    cursor = 0;
    samples = 0;
    filteredSamples = 0;
    filterStep = -1;
}

PixelRange SegmentState::nextPixels(std::uint64_t units) const {
    const std::uint32_t first = (sweepStart + cursor) % pixels.count;
    const std::uint32_t most = std::min(pixels.count - cursor, pixels.count - first);
    return {first, static_cast<std::uint32_t>(std::min<std::uint64_t>(units, most))};
}

std::uint32_t SegmentState::gatherable() const {
    for (const std::uint32_t part : {1U, 8U, 64U})
        if (litPoints >= std::max(points.count / part, 1U)) return points.count / part;
    return 0;
}

void SegmentState::restartLight() {
    litPoints = litRays = gridPoints = 0;
    diffusionFresh = true;
    restartGather();
}

SegmentPixels findSegmentPixels(const core::Photo& photo, const core::ImageF& depth, std::uint16_t label,
                                const std::vector<std::uint8_t>& edited, core::CoverageFrom from) {
    const core::LabelImage& labels = photo.labels;
    SegmentPixels found;
    for (const auto& [x0, y0] : kSweepOrder)
        for (int y = y0; y < labels.height(); y += kSweepStep)
            for (int x = x0; x < labels.width(); x += kSweepStep)
                if (labels(x, y) == label && depth(x, y) > 0) {
                    found.list.push_back(static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16);
                    found.bounds.include(x, y);
                }
    found.outline = core::findSilhouette(photo.color, labels, depth, label, edited, from);
    return found;
}

SurfaceGrids makeSurfaceGrids(const core::Photo& photo, const core::Analysis& analysis, std::uint16_t label,
                              const core::RenderParams& params) {
    SurfaceGrids made;
    made.surface = core::sampleSurface(analysis, photo.labels, label, params.surfaceSamples, params.seed);
    std::vector<core::Vector3f> positions;
    positions.reserve(made.surface.samples.size());
    for (const core::SurfaceSample& sample : made.surface.samples) positions.push_back(sample.position);
    made.grid =
        core::buildDiffusionGrid(positions, std::sqrt(made.surface.areaPerSample()), photo.labels,
                                 analysis.front->depth, analysis.front->position, label, params.diffusionQuality);
    return made;
}

}  // namespace render
