// SPDX-License-Identifier: GPL-3.0-or-later
// Every back-side method on the path-traced scenes of PATINA_REFERENCE_DATA, whose true back sides are known: prints
// the table and holds the automatic choice to it. Skipped, saying so, without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/analysis/back/back_side.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/segment/support_planes.h"
#include "core/io/image_io.h"

namespace {

using core::BackSideMethod;

constexpr std::array kMethods{BackSideMethod::Offset,        BackSideMethod::ParallelMirror, BackSideMethod::PcaMirror,
                              BackSideMethod::SpannedMirror, BackSideMethod::FlatFaces,      BackSideMethod::Automatic};

const std::set<std::string> kConvex{"synthetic/sphere_bag/sphere",
                                    "synthetic/buddha/chrome_ball",
                                    "studio/vase",
                                    "studio/orange",
                                    "studio/lemon",
                                    "studio/pear",
                                    "studio/sphere"};

class BackSideReference : public testing::TestWithParam<const char*> {};

float median(std::vector<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

TEST_P(BackSideReference, AutomaticIsNearTheBestMethod) {
    const char* root = std::getenv("PATINA_REFERENCE_DATA");
    if (root == nullptr || *root == '\0')
        GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set: no true back sides to compare with.";
    const std::filesystem::path folder = std::filesystem::path(root) / GetParam();
    nlohmann::json json;
    std::ifstream(folder / "scene.json") >> json;
    const core::ImageF depth = core::loadScalar((folder / "depth.exr").string());
    const core::ImageF truth = core::loadScalar((folder / "depth_back.exr").string());
    const core::LabelImage labels = core::loadLabels((folder / "segments.png").string());
    const core::Camera camera{depth.width(), depth.height(), json["fx"], json["fy"], json["cx"], json["cy"]};
    core::Surface front;
    front.depth = depth;
    front.color = core::ImageRgb(depth.width(), depth.height());
    core::analysis::computeSurface({camera, labels}, front, {});

    std::vector<core::Segment> segments;
    for (const auto& entry : json["segments"]) {
        core::Segment segment;
        segment.label = entry["label"];
        segment.name = entry["name"];
        segments.push_back(segment);
    }
    std::array<core::ImageF, kMethods.size()> backs;
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
        for (core::Segment& segment : segments) segment.backSide.method = kMethods[m];
        backs[m] = core::analysis::inventBackSide(camera, labels, front, segments, nullptr, 0, {}).surface.depth;
    }

    const std::vector<bool> supports = core::analysis::findSupports(labels);
    std::printf("%-32s offset parallel   pca  spanned  faces  automatic\n", GetParam());
    for (const core::Segment& segment : segments) {
        std::array<float, kMethods.size()> relative{};
        for (std::size_t m = 0; m < kMethods.size(); ++m) {
            std::vector<float> errors, thickness;
            for (std::size_t i = 0; i < depth.size(); ++i) {
                if (labels[i] != segment.label || depth[i] <= 0) continue;
                errors.push_back(std::abs(backs[m][i] - truth[i]));
                thickness.push_back(truth[i] - depth[i]);
            }
            relative[m] = median(errors) / median(thickness);
        }
        std::printf("  %-30s", segment.name.c_str());
        for (const float error : relative) std::printf(" %7.3f", static_cast<double>(error));
        std::printf("\n");
        const std::string name = std::string(GetParam()) + "/" + segment.name;
        if (supports[segment.label]) continue;
        const float best = *std::min_element(relative.begin(), relative.end() - 1);
        EXPECT_LE(relative.back(), best + 0.1f) << name << ": of the thickness";
        if (kConvex.contains(name)) {
            EXPECT_LE(relative.back(), 0.1f) << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BackSideReference,
                         testing::Values("synthetic/dragon", "synthetic/sphere_bag", "synthetic/buddha", "studio"));

}  // namespace
