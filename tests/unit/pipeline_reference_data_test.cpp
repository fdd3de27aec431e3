// SPDX-License-Identifier: GPL-3.0-or-later
// The analysis against path-traced photographs with true geometry, materials and light. Reads the folders of
// PATINA_REFERENCE_DATA; skipped, saying so, without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/analysis/pipeline.h"
#include "core/io/image_io.h"
#include "core/io/image_reader.h"

namespace {

using core::ImageF;
using core::Vector3f;

float quantile(std::vector<float> values, double q) {
    if (values.empty()) return 0;
    const auto rank = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + rank);
    return values[static_cast<std::size_t>(rank)];
}

class ReferenceData : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        const char* root = std::getenv("PATINA_REFERENCE_DATA");
        if (root == nullptr || *root == '\0')
            GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set: no path-traced photographs to compare with.";
        folder_ = std::filesystem::path(root) / GetParam();
        std::ifstream(folder_ / "scene.json") >> json_;
        auto photo = std::make_shared<core::Photo>();
        photo->color = core::loadColor(file("color.exr"));
        photo->depth = core::loadScalar(file("depth.exr"));
        photo->labels = core::loadLabels(file("segments.png"));
        photo->camera = {photo->color.width(), photo->color.height(), json_["fx"],
                         json_["fy"],          json_["cx"],           json_["cy"]};
        scene_.photo = photo;
        core::addMissingSegments(scene_);
        for (const auto& entry : json_["segments"]) {
            core::Segment* segment = scene_.findSegment(entry["label"].get<std::uint16_t>());
            if (segment == nullptr) continue;
            segment->name = entry["name"];
            segment->glossy = entry.value("glossy", false);
            materials_[segment->label] = entry["material"];
        }
    }
    [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }

    std::filesystem::path folder_;
    nlohmann::json json_;
    core::Scene scene_;
    std::map<std::uint16_t, nlohmann::json> materials_;
};

TEST_P(ReferenceData, AnalysisIsNearTheTruth) {
    core::AnalysisPipeline pipeline;
    const auto analysis = pipeline.run(scene_);
    const core::ImageV3 trueNormals = core::ImageReader(file("normal.exr")).readRgb(0, 1, 2);
    const ImageF trueBack = core::loadScalar(file("depth_back.exr"));
    const core::Photo& photo = *scene_.photo;

    std::vector<float> allAngles;
    for (const core::Segment& segment : scene_.segments) {
        std::vector<float> angles, backErrors, thickness;
        for (std::size_t i = 0; i < photo.depth.size(); ++i) {
            if (photo.labels[i] != segment.label || photo.depth[i] <= 0) continue;
            const float cosine = trueNormals[i].normalized().dot(analysis->front->normal[i]);
            angles.push_back(std::acos(std::clamp(cosine, -1.0f, 1.0f)) * 180 / std::numbers::pi_v<float>);
            ASSERT_GT(analysis->back->depth[i], analysis->front->depth[i]);
            backErrors.push_back(std::abs(analysis->back->depth[i] - trueBack[i]));
            thickness.push_back(trueBack[i] - photo.depth[i]);
        }
        // The table is half of the picture and a plane: it would hide everything else.
        if (segment.name != "table") allAngles.insert(allAngles.end(), angles.begin(), angles.end());
        if (segment.glossy) {
            EXPECT_LT(quantile(angles, 0.5), 1) << segment.name;
        }
        std::printf("%s/%s: normals %.2f deg median, %.2f deg p90; back side %.2f of the thickness %.4f m\n",
                    GetParam(), segment.name.c_str(), quantile(angles, 0.5), quantile(angles, 0.9),
                    quantile(backErrors, 0.5) / quantile(thickness, 0.5), quantile(thickness, 0.5));
    }
    EXPECT_LT(quantile(allAngles, 0.5), 2) << "normals of exact depth";

    for (const auto& reflectance : analysis->reflectances) {
        const auto& specular = materials_[reflectance->label]["specular_color"];
        const Vector3f truth(specular[0], specular[1], specular[2]);
        const Vector3f ratio = reflectance->rho.cwiseQuotient(truth);
        std::printf("%s/%s: reflectance over truth %.3f %.3f %.3f, common %.2f sr\n", GetParam(),
                    scene_.findSegment(reflectance->label)->name.c_str(), ratio[0], ratio[1], ratio[2],
                    reflectance->commonSolidAngle);
        EXPECT_TRUE(reflectance->reliable);
        EXPECT_GT(ratio.minCoeff(), 0.9f);
        EXPECT_LT(ratio.maxCoeff(), 1.15f);
    }

    const core::DirectionalMap truth{core::loadColor(file("env.exr")), {}};
    const core::DirectionalMap& environment = *analysis->environment;
    std::vector<float> errors;
    for (int y = 0; y < environment.radiance.height(); ++y) {
        for (int x = 0; x < environment.radiance.width(); ++x) {
            if (environment.coverage(x, y) <= 0) continue;
            const Vector3f d =
                core::DirectionalMap::directionFromTexel({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                                                         environment.radiance.width(), environment.radiance.height());
            const float expected = truth.lookup(d).mean();
            errors.push_back(std::abs(environment.radiance(x, y).mean() / std::max(expected, 1e-4f) - 1));
        }
    }
    std::printf("%s: environment, %zu observed texels, relative error %.2f median\n", GetParam(), errors.size(),
                quantile(errors, 0.5));
    EXPECT_GT(errors.size(), 1000u);
    // The studio's rooms have detail finer than what its vase, a rough mirror, shows of them.
    EXPECT_LT(quantile(errors, 0.5), 0.35f);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferenceData,
                         testing::Values("synthetic/dragon", "synthetic/sphere_bag", "synthetic/buddha", "studio"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '/', '_');
                             return name;
                         });

}  // namespace
