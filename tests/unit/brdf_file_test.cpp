// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/brdf_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/io/material_json.h"
#include "core/io/project.h"
#include "core/shading/segment_shading.h"
#include "tests/support/expect_error.h"
#include "tests/support/merl_file.h"
#include "tests/support/temp_folder.h"

namespace core {
namespace {

using test::expectError;

class MerlFile : public testing::Test {
  protected:
    MerlFile() {
        test::writeMerl(path_, [](double, double, double) { return Vector3f(0.1f, 0.2f, 0.3f); });
    }
    void overwrite(std::size_t offset, const void* bytes, std::size_t size) const {
        std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
        file.seekp(static_cast<std::streamoff>(offset));
        file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    }
    void refuse(const std::vector<std::string>& parts) const {
        expectError(ErrorKind::Input, parts, [&] { static_cast<void>(loadBrdfFile(path_)); });
    }
    test::TempFolder folder_;
    std::string path_ = folder_ / "a.binary";
};

constexpr std::size_t kBytes = 12 + std::size_t{3} * 90 * 90 * 180 * 8;

TEST_F(MerlFile, OfAnotherSizeIsRefused) {
    for (const std::size_t size : {std::size_t{1}, std::size_t{11}, std::size_t{12}, kBytes - 1, kBytes + 1}) {
        std::filesystem::resize_file(path_, size);
        refuse({"a.binary", std::to_string(size) + " bytes", "MERL", std::to_string(kBytes)});
    }
    // Sparse, because it must not be read.
    std::filesystem::resize_file(path_, std::uintmax_t{1} << 40U);
    refuse({"a.binary", "MERL"});
    std::filesystem::resize_file(path_, 0);
    refuse({"a.binary", "empty"});
    std::filesystem::remove(path_);
    refuse({"a.binary", "does not exist"});
    expectError(ErrorKind::Input, {"folder"}, [&] { static_cast<void>(loadBrdfFile(folder_.path().string())); });
}

TEST_F(MerlFile, OfOtherDimensionsIsRefused) {
    for (const std::array<std::int32_t, 3> wrong :
         {std::array{90, 90, 360}, std::array{0, 0, 0}, std::array{-90, -90, 180}, std::array{0x7fffffff, 90, 180}}) {
        overwrite(0, wrong.data(), sizeof(wrong));
        refuse({"a.binary", "dimensions " + std::to_string(wrong[0]), "expected", "90, 90, 180"});
    }
}

TEST_F(MerlFile, WithValuesThatAreNoNumbersIsRefused) {
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
        overwrite(12 + 8 * (90 * 90 * 180 + 5), &wrong, sizeof(wrong));
        refuse({"a.binary", "value 5 of the green plane", "not a finite number"});
    }
}

TEST_F(MerlFile, NegativeValuesAreZero) {
    const double invalid = -1;
    for (std::size_t i = 0; i < 180; ++i) overwrite(12 + 8 * i, &invalid, sizeof(invalid));
    const Material m = fileMaterial(loadBrdfFile(path_));
    const kernel::BrdfParams b = toKernel(m, Vector3f(1, 1, 1));
    for (kernel::uint p = 0; p < 180; ++p) {
        EXPECT_EQ(kernel::measured_entry(b, 0, 0, p).x, 0);
        EXPECT_NEAR(kernel::measured_entry(b, 0, 0, p).y, 0.2f, 1e-6f);
    }
}

TEST_F(MerlFile, IsLoadedOnceWhileInUseAndAgainWhenItChanged) {
    const auto first = loadBrdfFile(path_);
    EXPECT_EQ(loadBrdfFile(path_), first);
    const double zero = 0;
    overwrite(12, &zero, sizeof(zero));
    std::filesystem::last_write_time(path_, std::filesystem::last_write_time(path_) + std::chrono::seconds(2));
    EXPECT_NE(loadBrdfFile(path_), first);
}

TEST_F(MerlFile, IsNamedByEditsAndProjects) {
    expectError(ErrorKind::Usage, {"brdf", "path"},
                [] { static_cast<void>(materialFromJson(R"({"brdf": "file:"})")); });
    expectError(ErrorKind::Input, {"nowhere.binary", "does not exist"},
                [] { static_cast<void>(materialFromJson(R"({"brdf": "file:nowhere.binary"})")); });
    expectError(ErrorKind::Usage, {"alpha", "no parameters"},
                [&] { static_cast<void>(materialFromJson(R"({"brdf": "file:)" + path_ + R"(", "alpha": 0.2})")); });
    const Material m = materialFromJson(R"({"brdf": "file:)" + path_ + R"("})");
    EXPECT_EQ(m.brdf, "file");
    EXPECT_EQ(m.brdfFile->name, "a.binary");
    EXPECT_EQ(materialFromJson(materialToJson(m)), m);
}

TEST_F(MerlFile, IsStoredRelativeToTheProjectWhichOpensWithoutIt) {
    std::filesystem::copy(PATINA_SAMPLES "/studio", folder_ / "studio", std::filesystem::copy_options::recursive);
    const std::string project = folder_ / "studio/studio.patina";
    Scene scene = loadProject(project);
    scene.segments[0].edit = fileMaterial(loadBrdfFile(path_));
    saveProject(scene, project);
    EXPECT_THAT(test::readBytes(project), testing::HasSubstr("\"file:../a.binary\""));
    EXPECT_TRUE(usable(*loadProject(project).segments[0].edit));

    std::filesystem::rename(path_, folder_ / "b.binary");
    core::Notes notes;
    const Scene without = loadProject(project, &notes);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_THAT(notes[0].english(),
                testing::AllOf(testing::HasSubstr("segments[0].edit.brdf"), testing::HasSubstr("a.binary"),
                               testing::HasSubstr("does not exist")));
    ASSERT_TRUE(without.segments[0].edit.has_value());
    EXPECT_FALSE(usable(*without.segments[0].edit));
    // It shows the photograph, and is still named when saved again.
    EXPECT_EQ(buildSegmentShading(without, Analysis())[without.segments[0].label].diffuse.w, 0);
    saveProject(without, project);
    EXPECT_THAT(test::readBytes(project), testing::HasSubstr("\"file:../a.binary\""));
}

}  // namespace
}  // namespace core
