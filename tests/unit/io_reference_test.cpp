// SPDX-License-Identifier: GPL-3.0-or-later
// Real RGB-D files whose pixel values were computed by other libraries (sample.json of each folder).
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/io/project.h"
#include "tests/support/temp_folder.h"

namespace {

struct ReferenceDepth {
    const char* folder;
    std::optional<double> unit;
};

class ReferenceTest : public testing::TestWithParam<ReferenceDepth> {};

}  // namespace

TEST_P(ReferenceTest, DepthAgreesWithOtherLibraries) {
    const char* root = std::getenv("PATINA_REFERENCE_DATA");
    if (root == nullptr) GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set";
    const std::string folder = std::string(root) + "/rgbd/" + GetParam().folder + "/";
    const nlohmann::json sample = nlohmann::json::parse(test::readBytes(folder + "sample.json"));
    int checks = 0;
    for (const nlohmann::json& entry : sample["entries"]) {
        core::CreateOptions options;
        options.color = folder + entry["color"].get<std::string>();
        options.depth = folder + entry["depth"].get<std::string>();
        options.depthUnit = GetParam().unit;
        const nlohmann::json& k = entry["intrinsics"];
        options.intrinsics = core::Camera{0, 0, k["fx"], k["fy"], k["cx"], k["cy"]};
        const core::Scene scene = core::createScene(options);
        const core::ImageF& depth = scene.photo->depth;
        ASSERT_EQ(depth.width(), entry["stats"]["width"].get<int>());
        ASSERT_EQ(depth.height(), entry["stats"]["height"].get<int>());
        std::size_t valid = 0;
        for (const float z : depth.pixels()) valid += z > 0 ? 1U : 0U;
        EXPECT_NEAR(static_cast<double>(valid) / static_cast<double>(depth.size()),
                    entry["stats"]["valid_fraction"].get<double>(), 1e-4);
        for (const nlohmann::json& check : entry["checks"]) {
            const auto z = static_cast<double>(depth(check["x"], check["y"]));
            const double expected = check["depth"].is_null() ? 0.0 : check["depth"].get<double>();
            EXPECT_NEAR(z, expected, 1e-5) << check.dump();
            ++checks;
        }
    }
    EXPECT_GE(checks, 4);
}

INSTANTIATE_TEST_SUITE_P(PlainFormats, ReferenceTest,
                         testing::Values(ReferenceDepth{"png16_tum_fr2_desk", 1.0 / 5000},
                                         ReferenceDepth{"png16_bop_lmo_desk", std::nullopt},
                                         ReferenceDepth{"exr_cleargrasp_bottles", std::nullopt},
                                         ReferenceDepth{"exr_cleargrasp_cups_mug", std::nullopt}),
                         [](const auto& test) { return std::string(test.param.folder); });
