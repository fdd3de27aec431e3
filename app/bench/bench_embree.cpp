// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_embree.h"

#ifdef PATINA_EMBREE
#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#include "core/base/clock.h"
#endif

namespace render {

#ifdef PATINA_EMBREE

namespace {

struct Mesh {
    std::vector<core::Vector3f> vertices;  ///< front positions, then back positions
    std::vector<std::array<unsigned, 3>> triangles;
};

Mesh meshOf(const core::Surface& front, const core::Surface& back, const core::LabelImage& labels) {
    Mesh mesh;
    const int width = labels.width();
    const auto pixels = static_cast<unsigned>(labels.size());
    mesh.vertices.assign(front.position.pixels().begin(), front.position.pixels().end());
    mesh.vertices.insert(mesh.vertices.end(), back.position.pixels().begin(), back.position.pixels().end());
    const auto at = [&](int x, int y) { return static_cast<unsigned>(y * width + x); };
    const auto joined = [&](int x, int y) {  // the four pixel centres from (x, y) on are one surface
        if (x < 0 || y < 0 || x + 1 >= width || y + 1 >= labels.height()) return false;
        const auto label = labels(x, y);
        for (const auto& [u, v] : {std::pair{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
            if (labels(u, v) != label || !(front.depth(u, v) > 0) || !(back.depth(u, v) > 0)) return false;
        return true;
    };
    const auto quad = [&](unsigned a, unsigned b, unsigned c, unsigned d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
    };
    for (int y = 0; y + 1 < labels.height(); ++y)
        for (int x = 0; x + 1 < width; ++x) {
            if (!joined(x, y)) continue;
            const unsigned a = at(x, y);
            const unsigned b = at(x + 1, y);
            const unsigned c = at(x, y + 1);
            const unsigned d = at(x + 1, y + 1);
            quad(a, b, c, d);
            quad(pixels + a, pixels + b, pixels + c, pixels + d);
            if (!joined(x, y - 1)) quad(a, b, pixels + a, pixels + b);
            if (!joined(x, y + 1)) quad(c, d, pixels + c, pixels + d);
            if (!joined(x - 1, y)) quad(a, c, pixels + a, pixels + c);
            if (!joined(x + 1, y)) quad(b, d, pixels + b, pixels + d);
        }
    return mesh;
}

}  // namespace

std::optional<EmbreeTimes> benchEmbree(const core::Surface& front, const core::Surface& back,
                                       const core::LabelImage& labels, const std::vector<Ray>& rays) {
    EmbreeTimes times;
    const RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) return std::nullopt;
    times.buildSeconds = std::numeric_limits<double>::max();
    RTCScene scene = nullptr;
    for (int i = 0; i < kTimedBuilds; ++i) {
        if (scene != nullptr) rtcReleaseScene(scene);
        const auto start = core::Clock::now();
        const Mesh mesh = meshOf(front, back, labels);
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            std::copy_n(mesh.vertices[v].data(), 3, vertices + 3 * v);
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            std::copy_n(mesh.triangles[t].data(), 3, indices + 3 * t);
        rtcCommitGeometry(geometry);
        scene = rtcNewScene(device);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        times.buildSeconds = std::min(times.buildSeconds, core::secondsSince(start));
    }
    double best = std::numeric_limits<double>::max();
    std::atomic<std::size_t> hits{0};
    for (int i = 0; i < kTimedMarches; ++i) {
        hits = 0;
        const auto start = core::Clock::now();
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 1024), [&](const auto& range) {
            std::size_t found = 0;
            for (std::size_t r = range.begin(); r < range.end(); ++r) {
                RTCIntersectContext context;
                rtcInitIntersectContext(&context);
                const Ray& ray = rays[r];
                RTCRayHit query{};
                query.ray.org_x = ray.origin.x();
                query.ray.org_y = ray.origin.y();
                query.ray.org_z = ray.origin.z();
                query.ray.dir_x = ray.direction.x();
                query.ray.dir_y = ray.direction.y();
                query.ray.dir_z = ray.direction.z();
                query.ray.tfar = std::numeric_limits<float>::infinity();
                query.ray.mask = ~0u;
                query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene, &context, &query);
                found += query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1u : 0u;
            }
            hits += found;
        });
        best = std::min(best, core::secondsSince(start));
    }
    times.raysPerSecond = static_cast<double>(rays.size()) / best;
    times.hitShare = static_cast<double>(hits) / static_cast<double>(rays.size());
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return times;
}

#else

std::optional<EmbreeTimes> benchEmbree(const core::Surface&, const core::Surface&, const core::LabelImage&,
                                       const std::vector<Ray>&) {
    return std::nullopt;
}

#endif

}  // namespace render
