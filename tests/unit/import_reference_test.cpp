// SPDX-License-Identifier: GPL-3.0-or-later
// Photographs that carry their depth, whose pixel values were computed by other libraries (sample.json of each folder).
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/io/import/import_format.h"
#include "core/io/photo_loader.h"
#include "tests/support/temp_folder.h"

namespace {

struct Reference {
    const char* folder;
    const char* file;
    std::size_t entry;     ///< of sample.json
    int offsetX, offsetY;  ///< of the data window in the display window [px]
    float principalShift;  ///< from the sample's pixel coordinates to ours (centre of the first pixel at 0.5)
    /// The sample rounds to five digits after the point. Its flattened deep picture blends the depths of a pixel's
    /// samples (200 units away); ours picks one of them.
    double depthTolerance;
};

class ImportReference : public testing::TestWithParam<Reference> {};

}  // namespace

TEST_P(ImportReference, DepthAndIntrinsicsAgreeWithOtherLibraries) {
    const char* root = std::getenv("PATINA_REFERENCE_DATA");
    if (root == nullptr) GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set";
    const Reference& reference = GetParam();
    const std::string folder = std::string(root) + "/rgbd/" + reference.folder + "/";
    const nlohmann::json sample = nlohmann::json::parse(test::readBytes(folder + "sample.json"));
    const nlohmann::json& entry = sample["entries"].at(reference.entry);

    const core::ImportFile file(folder + reference.file);
    const core::ImportFormat* format = core::findImportFormat(file);
    ASSERT_NE(format, nullptr);
    const core::ImportedPhoto photo = format->read(file);
    const core::Camera ownSize{photo.depth.width(), photo.depth.height(), 1000, 1000, 0, 0};
    const core::ImageF depth =
        core::planarDepth(photo.depth, photo.kind.value_or(core::DepthKind::Z), photo.unit, ownSize);
    if (reference.offsetX == 0) {
        EXPECT_EQ(depth.width(), entry["stats"]["width"].get<int>());
        EXPECT_EQ(depth.height(), entry["stats"]["height"].get<int>());
    }
    ASSERT_EQ(entry["checks"].size(), 4U);
    for (const nlohmann::json& check : entry["checks"]) {
        const double expected = check["depth"].is_null() ? 0.0 : check["depth"].get<double>();
        const int x = check["x"].get<int>() + reference.offsetX;
        const int y = check["y"].get<int>() + reference.offsetY;
        EXPECT_NEAR(static_cast<double>(depth(x, y)), expected, reference.depthTolerance) << check.dump();
    }
    float least = core::kMaxDepth;
    float most = 0;
    std::size_t valid = 0;
    for (const float z : depth.pixels()) {
        if (!(z > 0)) continue;
        ++valid;
        least = std::min(least, z);
        most = std::max(most, z);
    }
    const nlohmann::json& stats = entry["stats"];
    const auto pixels = stats["width"].get<double>() * stats["height"].get<double>();
    EXPECT_NEAR(static_cast<double>(valid) / pixels, stats["valid_fraction"].get<double>(), 1e-4);
    EXPECT_NEAR(static_cast<double>(least), stats["depth_min"].get<double>(), 1e-3);
    // The deep picture's farthest depth is a blend of two samples there; ours is that of one.
    EXPECT_NEAR(static_cast<double>(most), stats["depth_max"].get<double>(), most > 700 ? 1.0 : 1e-3);

    const nlohmann::json& k = entry["intrinsics"];
    ASSERT_EQ(photo.camera.has_value(), !k.is_null());
    if (k.is_null()) return;
    const bool normalised = k.contains("normalised");
    const double side = normalised ? std::max(photo.color.width(), photo.color.height()) : 1.0;
    const double width = normalised ? photo.color.width() : 1.0;
    const double height = normalised ? photo.color.height() : 1.0;
    EXPECT_NEAR(static_cast<double>(photo.camera->fx), k["fx"].get<double>() * side, 0.01);
    EXPECT_NEAR(static_cast<double>(photo.camera->fy), k["fy"].get<double>() * side, 0.01);
    EXPECT_NEAR(static_cast<double>(photo.camera->cx - reference.principalShift), k["cx"].get<double>() * width, 0.01);
    EXPECT_NEAR(static_cast<double>(photo.camera->cy - reference.principalShift), k["cy"].get<double>() * height, 0.01);
    if (k.contains("ref_width")) {
        EXPECT_EQ(photo.color.width(), k["ref_width"].get<int>());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, ImportReference,
    testing::Values(Reference{"exr_renderer_z", "beachball_singlepart.0001.exr", 0, 654, 245, 0, 1e-5},
                    Reference{"exr_renderer_z", "balls_deep.exr", 1, 131, 170, 0, 0.01},
                    Reference{"jpeg_gdepth_greek_helmet", "greek-helmet.jpg", 0, 0, 0, 0, 1e-5},
                    Reference{"jpeg_gdepth_maneki_neko", "yamasa-maneki-neko.jpg", 0, 0, 0, 0, 1e-5},
                    Reference{"jpeg_mpf_iphonex_vase", "image-with-depth.jpg", 0, 0, 0, 0, 1e-5},
                    Reference{"jpeg_xdm_r200_barstools", "xdm-photo4.jpg", 0, 0, 0, 0, 1e-5},
                    Reference{"heic_iphone13pro_pug", "pug.heic", 0, 0, 0, 0, 1e-5},
                    Reference{"pcd_kinect_bottles", "milk_cartoon_all_small_clorox.pcd", 0, 0, 0, 0.5f, 1e-5}),
    [](const auto& test) { return std::string(test.param.folder) + "_" + std::to_string(test.param.entry); });
