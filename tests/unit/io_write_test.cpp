// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "core/base/files.h"
#include "core/io/cryptomatte.h"
#include "core/io/image_io.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"

using core::ErrorKind;
using core::Vector3f;

namespace {

core::ImageRgb gradient(int width, int height) {
    core::ImageRgb image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image(x, y) = Vector3f(static_cast<float>(x) / static_cast<float>(width),
                                   static_cast<float>(y) / static_cast<float>(height), 0.25f);
    return image;
}

/// Largest relative error, with an absolute floor of 1e-3.
double difference(const core::ImageRgb& a, const core::ImageRgb& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const auto expected = static_cast<double>(a[i][c]);
            largest = std::max(largest, std::abs(expected - static_cast<double>(b[i][c])) / std::max(expected, 1e-3));
        }
    return largest;
}

/// Files may not grow beyond this many bytes while it lives: a full disk.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit old_{};
    void (*handler_)(int) = nullptr;
};

class WriteTest : public testing::Test {
  protected:
    test::TempFolder folder;
};

}  // namespace

TEST_F(WriteTest, ColourRoundTrips) {
    core::ImageRgb image = gradient(40, 30);
    // 16-bit sRGB: half a step is at most 1/65535/2 * 12.92 absolute; RGBE has 8 bits of the largest channel.
    const std::vector<std::pair<std::string, double>> formats = {
        {"a.png", 1e-3}, {"a.tif", 1e-3}, {"a.tiff", 1e-3}, {"a.EXR", 0}};
    for (const auto& [name, tolerance] : formats) {
        core::saveColor(image, folder / name);
        EXPECT_LE(difference(image, core::loadColor(folder / name)), tolerance) << name;
    }
    image(0, 0) = Vector3f(20, 30, 10);
    core::saveColor(image, folder / "b.exr");
    EXPECT_EQ(core::loadColor(folder / "b.exr")(0, 0), Vector3f(20, 30, 10));
    core::saveColor(image, folder / "b.hdr");
    EXPECT_NEAR(static_cast<double>(core::loadColor(folder / "b.hdr")(0, 0).y()), 30, 30.0 / 128);
    core::saveColor(image, folder / "b.png");
    EXPECT_EQ(core::loadColor(folder / "b.png")(0, 0), Vector3f(1, 1, 1)) << "clipped";
    const core::ImageRgb flat(40, 30, Vector3f(0.2f, 0.5f, 0.1f));
    core::saveColor(flat, folder / "b.jpg");
    EXPECT_LE(difference(flat, core::loadColor(folder / "b.jpg")), 0.05);
    EXPECT_EQ(folder.fileCount(), 8U) << "no temporary file is left";
}

TEST_F(WriteTest, SameImageSameBytes) {
    const std::vector<std::string> extensions = {"exr", "png", "tif", "jpg", "hdr"};
    for (const std::string& extension : extensions) core::saveColor(gradient(20, 20), folder / ("one." + extension));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // no time of day in the file
    for (const std::string& extension : extensions) {
        core::saveColor(gradient(20, 20), folder / ("two." + extension));
        EXPECT_TRUE(test::readBytes(folder / ("one." + extension)) == test::readBytes(folder / ("two." + extension)))
            << extension;
    }
}

TEST_F(WriteTest, ScalarsVectorsLabels) {
    core::ImageF depth(2, 1);
    depth(0, 0) = 1.2345f;
    depth(1, 0) = std::nanf("");
    core::saveScalar(depth, folder / "d.exr", "Z");
    EXPECT_EQ(core::loadScalar(folder / "d.exr")(0, 0), 1.2345f);
    EXPECT_TRUE(core::readImageInfo(folder / "d.exr").hasDepthChannel);
    core::saveScalar(depth, folder / "d.tif", "Z");
    EXPECT_EQ(core::loadScalar(folder / "d.tif")(0, 0), 1.2345f);
    core::saveScalar(depth, folder / "d.png", "Z", 1000);
    EXPECT_EQ(core::loadScalar(folder / "d.png")(0, 0), 1235);
    EXPECT_EQ(core::loadScalar(folder / "d.png")(1, 0), 0);
    test::expectError(ErrorKind::Usage, {"d.jpg"}, [&] { core::saveScalar(depth, folder / "d.jpg", "Z"); });

    test::expectError(ErrorKind::Usage, {"far.png", "65.535", "70"},
                      [&] { core::saveScalar(core::ImageF(1, 1, 70.0f), folder / "far.png", "Z"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "far.png"));
    for (const char* name : {"p.png", "p.jpg", "p.hdr"})
        test::expectError(ErrorKind::Usage, {name, "positions", ".exr or .tif"},
                          [&] { core::savePositions(core::ImageV3(1, 1, Vector3f(0.1f, 0.2f, 0.3f)), folder / name); });

    core::ImageV3 normals(1, 1, Vector3f(0.6f, 0, -0.8f));
    core::saveVectors(normals, folder / "n.exr");
    EXPECT_EQ(core::loadColor(folder / "n.exr")(0, 0), Vector3f(0.6f, 0, 0)) << "read as colour, -0.8 is 0";
    core::saveVectors(normals, folder / "n.png");
    EXPECT_NEAR(core::loadColor(folder / "n.png")(0, 0).x(), 0.8f, 1e-4f);

    for (const std::uint16_t label : {std::uint16_t{200}, std::uint16_t{40000}})
        for (const char* name : {"l.png", "l.tif", "l.exr"}) {
            core::LabelImage labels(2, 1, 0);
            labels(1, 0) = label;
            core::saveLabels(labels, folder / name);
            EXPECT_EQ(core::loadLabels(folder / name), labels) << name;
        }
    test::expectError(ErrorKind::Usage, {"l.jpg"}, [&] { core::saveLabels(core::LabelImage(1, 1), folder / "l.jpg"); });
}

TEST_F(WriteTest, DirectionalMapIsAnOpenExrEnvironment) {
    core::DirectionalMap map;
    map.radiance = gradient(8, 4);
    map.coverage = core::ImageF(8, 4, 3.0f);
    core::saveDirectionalMap(map, folder / "env.exr");
    const auto input = OIIO::ImageInput::open(folder / "env.exr");
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().get_string_attribute("textureformat"), "LatLong Environment");
    EXPECT_EQ(input->spec().nchannels, 4);
    EXPECT_EQ(core::loadColor(folder / "env.exr"), map.radiance);
}

TEST_F(WriteTest, TargetsThatCannotBeWritten) {
    const core::ImageRgb image = gradient(4, 4);
    test::expectError(ErrorKind::Usage, {"a.xyz", ".xyz", "expected .exr"},
                      [&] { core::saveColor(image, folder / "a.xyz"); });
    const std::string missing = folder / "no/such/a.png";
    test::expectError(ErrorKind::Output, {missing, "does not exist"}, [&] { core::saveColor(image, missing); });
    std::filesystem::create_directory(folder / "dir.png");
    test::expectError(ErrorKind::Output, {"dir.png", "is a folder"},
                      [&] { core::saveColor(image, folder / "dir.png"); });
    test::expectError(ErrorKind::Output, {"/proc/a.png"}, [&] { core::saveColor(image, "/proc/a.png"); });
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    test::expectError(ErrorKind::Output, {"full.png", "not a regular file"},
                      [&] { core::saveColor(image, folder / "full.png"); });
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    test::expectError(ErrorKind::Output, {"empty"}, [&] { core::writeFileAtomically("", "x"); });
}

TEST_F(WriteTest, OldFileSurvivesAFullDisk) {
    const core::ImageRgb noise = [] {
        core::ImageRgb image(128, 128);
        std::uint32_t state = 7;
        for (Vector3f& p : image.pixels())
            for (int c = 0; c < 3; ++c) {
                state = state * 1664525U + 1013904223U;
                p[c] = static_cast<float>(state >> 8U) / 16777216.0f;
            }
        return image;
    }();
    for (const char* name : {"a.exr", "a.png", "a.tif", "a.jpg", "a.hdr"}) {
        test::writeBytes(folder / name, "old content");
        {
            const FullDisk full(4096);
            test::expectError(ErrorKind::Output, {name}, [&] { core::saveColor(noise, folder / name); });
        }
        EXPECT_TRUE(test::readBytes(folder / name) == "old content") << name;
        core::saveColor(noise, folder / name);
        EXPECT_GT(test::readBytes(folder / name).size(), 4096U) << "control: " << name;
    }
    EXPECT_EQ(folder.fileCount(), 5U) << "no temporary file is left";
}

TEST_F(WriteTest, LinksAreFollowedAndPermissionsKept) {
    test::writeBytes(folder / "real.txt", "old");
    std::filesystem::permissions(folder / "real.txt", std::filesystem::perms(0640));
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    core::writeFileAtomically(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(test::readBytes(folder / "real.txt"), "new");
    EXPECT_EQ(std::filesystem::status(folder / "real.txt").permissions(), std::filesystem::perms(0640));
}

TEST(Cryptomatte, HashesOfTheSpecification) {
    EXPECT_EQ(core::murmurHash3("torus"), 4053562365U);
    EXPECT_EQ(core::murmurHash3("равнина"), 2518896926U);
    EXPECT_EQ(core::murmurHash3(""), 0U);
    EXPECT_NEAR(static_cast<double>(std::bit_cast<float>(core::cryptomatteId("torus"))) / -1.54943624832e+30, 1, 1e-6);
}

TEST(Cryptomatte, IdsAreFiniteNumbers) {
    int flipped = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::string name = "object " + std::to_string(i);
        const auto id = std::bit_cast<float>(core::cryptomatteId(name));
        EXPECT_TRUE(std::isnormal(id)) << name;
        if (core::cryptomatteId(name) != core::murmurHash3(name)) ++flipped;
    }
    EXPECT_GT(flipped, 5) << "about 2 of 256 hashes have an exponent that needs it";
}

TEST_F(WriteTest, CryptomatteFileNamesEverySegment) {
    auto photo = std::make_shared<core::Photo>();
    photo->camera = {2, 1, 1, 1, 1, 0.5f};
    photo->color = core::ImageRgb(2, 1, Vector3f(1, 2, 3));
    photo->depth = core::ImageF(2, 1, 1.0f);
    photo->labels = core::LabelImage(2, 1, 0);
    photo->labels(1, 0) = 5;
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    scene.segments[0].name = "torus";
    core::saveCryptomatte(scene, folder / "c.exr");

    const auto input = OIIO::ImageInput::open(folder / "c.exr");
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    ASSERT_EQ(spec.nchannels, 8);
    std::vector<float> pixels(16);
    ASSERT_TRUE(input->read_image(0, 0, 0, 8, OIIO::TypeFloat, pixels.data()));
    const auto channel = [&](const std::string& name, std::size_t pixel) {
        return pixels[pixel * 8 + static_cast<std::size_t>(spec.channelindex(name))];
    };
    EXPECT_EQ(std::bit_cast<std::uint32_t>(channel("CryptoObject00.r", 1)), 4053562365U);
    EXPECT_EQ(channel("CryptoObject00.g", 1), 1.0f);
    EXPECT_EQ(channel("CryptoObject00.r", 0), 0.0f);
    EXPECT_EQ(channel("CryptoObject00.g", 0), 0.0f);
    EXPECT_EQ(channel("G", 0), 2.0f);
    std::string key;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        if (name.starts_with("cryptomatte/") && name.ends_with("/name")) key = name.substr(0, name.size() - 4);
    }
    ASSERT_FALSE(key.empty());
    EXPECT_EQ(key.size(), std::string("cryptomatte/1234567/").size());
    EXPECT_EQ(spec.get_string_attribute(key + "name"), "CryptoObject");
    EXPECT_EQ(spec.get_string_attribute(key + "hash"), "MurmurHash3_32");
    EXPECT_EQ(spec.get_string_attribute(key + "conversion"), "uint32_to_float32");
    EXPECT_EQ(spec.get_string_attribute(key + "manifest"), R"({"torus":"f19c73fd"})");
    test::expectError(ErrorKind::Usage, {"c.png"}, [&] { core::saveCryptomatte(scene, folder / "c.png"); });
}
