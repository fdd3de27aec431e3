// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/path_key.h"

#include <algorithm>

namespace render {
namespace {

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

/// Appends drives [first, first + count) of the scene's table.
void appendDrives(std::vector<DriveKey>& keys, const core::DriveTable& table, std::uint16_t label, std::uint32_t first,
                  std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
        const core::DrivePlane& plane = table.planes[table.planeOf[i]];
        std::shared_ptr<const void> source = plane.mask;
        if (!plane.mask) source = plane.detail;
        keys.push_back({label, table.drives[i], std::move(source)});
    }
}

PathKey keyWithSettings(const core::RenderParams& params) {
    PathKey key;
    key.seed = params.seed;
    key.bounces = std::max(params.bounces, 1);
    return key;
}

void addAllSegments(PathKey& key, const ShadedScene& shaded) {
    key.shading = shaded.shading;
    for (const core::Segment& segment : shaded.scene.segments) {
        const kernel::uvec4 range = shaded.shading[segment.label].drives;
        appendDrives(key.drives, shaded.drives, segment.label, range.x, range.y);
    }
}

}  // namespace

bool operator==(const DriveKey& a, const DriveKey& b) {
    return a.label == b.label && a.source == b.source && a.drive.slot == b.drive.slot &&
           equal(a.drive.from, b.drive.from) && equal(a.drive.to, b.drive.to) && equal(a.drive.range, b.drive.range);
}

bool operator==(const PathKey& a, const PathKey& b) {
    return a.seed == b.seed && a.bounces == b.bounces && a.drives == b.drives &&
           std::equal(a.shading.begin(), a.shading.end(), b.shading.begin(), b.shading.end(),
                      [](const auto& one, const auto& other) { return equal(one, other); });
}

PathKey cameraPathKey(const ShadedScene& shaded, const core::Segment& segment) {
    PathKey key = keyWithSettings(shaded.scene.render);
    if (key.bounces > 1) {
        addAllSegments(key, shaded);
        return key;
    }
    const kernel::SegmentShading& entry = shaded.shading[segment.label];
    kernel::SegmentShading own{};
    own.brdf = entry.brdf;
    key.shading = {own};
    appendDrives(key.drives, shaded.drives, segment.label, entry.drives.x, entry.drives.y);
    std::erase_if(key.drives, [](const DriveKey& drive) { return drive.drive.slot >= kernel::kDriveBlendNew; });
    return key;
}

PathKey enteringPathKey(const ShadedScene& shaded) {
    PathKey key = keyWithSettings(shaded.scene.render);
    if (key.bounces > 1) addAllSegments(key, shaded);
    return key;
}

std::vector<DriveKey> blendDriveKeys(const ShadedScene& shaded, const core::Segment& segment) {
    std::vector<DriveKey> keys;
    const kernel::uvec4 range = shaded.shading[segment.label].drives;
    appendDrives(keys, shaded.drives, segment.label, range.z, range.w);
    return keys;
}

}  // namespace render
