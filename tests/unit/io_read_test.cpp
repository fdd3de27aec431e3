// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/io/image_io.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"

using core::ErrorKind;
using core::Vector3f;

namespace {

/// IEC 61966-2-1, in double.
double srgbToLinear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

void expectColor(const Vector3f& found, double r, double g, double b, double tolerance = 1e-6) {
    EXPECT_NEAR(static_cast<double>(found.x()), r, tolerance);
    EXPECT_NEAR(static_cast<double>(found.y()), g, tolerance);
    EXPECT_NEAR(static_cast<double>(found.z()), b, tolerance);
}

std::string s15Fixed16(double value) {
    return test::bigEndian32(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536))));
}

/// A matrix/gamma RGB profile of ICC version 2, byte by byte (columns: D50 XYZ of red, green, blue).
std::vector<std::uint8_t> iccProfile(const double (&xyz)[3][3], double gamma) {
    const auto xyzTag = [](double x, double y, double z) {
        return std::string("XYZ \0\0\0\0", 8) + s15Fixed16(x) + s15Fixed16(y) + s15Fixed16(z);
    };
    const auto fixed8 = static_cast<unsigned>(std::lround(gamma * 256));
    std::string curve = std::string("curv\0\0\0\0\0\0\0\1", 12);
    curve += {static_cast<char>(fixed8 >> 8U), static_cast<char>(fixed8 & 255U), 0, 0};
    std::vector<std::pair<std::string, std::string>> tags{
        {"desc", std::string("desc\0\0\0\0\0\0\0\2t\0", 14) + std::string(78, '\0')},
        {"cprt", std::string("text\0\0\0\0none", 12) + std::string(4, '\0')},
        {"wtpt", xyzTag(0.9642, 1, 0.8249)}};
    const char* names[] = {"rXYZ", "gXYZ", "bXYZ"};
    for (int i = 0; i < 3; ++i) tags.emplace_back(names[i], xyzTag(xyz[0][i], xyz[1][i], xyz[2][i]));
    for (const char* name : {"rTRC", "gTRC", "bTRC"}) tags.emplace_back(name, curve);
    std::string table = test::bigEndian32(static_cast<std::uint32_t>(tags.size()));
    std::string data;
    for (const auto& [name, content] : tags) {
        const std::size_t offset = 128 + 4 + 12 * tags.size() + data.size();
        table += name + test::bigEndian32(static_cast<std::uint32_t>(offset)) +
                 test::bigEndian32(static_cast<std::uint32_t>(content.size()));
        data += content;
        data.resize((data.size() + 3) / 4 * 4);
    }
    std::string header(128, '\0');
    header.replace(0, 4, test::bigEndian32(static_cast<std::uint32_t>(128 + table.size() + data.size())));
    header.replace(8, 4, std::string("\2\x20\0\0", 4));
    header.replace(12, 12, "mntrRGB XYZ ");
    header.replace(36, 4, "acsp");
    header.replace(68, 12, s15Fixed16(0.9642) + s15Fixed16(1) + s15Fixed16(0.8249));
    const std::string all = header + table + data;
    return {all.begin(), all.end()};
}

class ReadTest : public testing::Test {
  protected:
    test::TempFolder folder;
};

}  // namespace

TEST_F(ReadTest, PfmIsLinearAndTopDown) {
    const std::string path = folder / "a.pfm";
    test::writePfm(path, 2, 2, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    const core::ImageRgb image = core::loadColor(path);
    ASSERT_EQ(image.width(), 2);
    ASSERT_EQ(image.height(), 2);
    expectColor(image(0, 0), 1, 2, 3);
    expectColor(image(1, 1), 10, 11, 12);
}

TEST_F(ReadTest, EightBitIsDecodedBySrgb) {
    const std::string path = folder / "a.ppm";
    test::writePnm8(path, 2, 1, 3, {0, 5, 10, 128, 200, 255});
    const core::ImageRgb image = core::loadColor(path);
    expectColor(image(0, 0), 0, srgbToLinear(5 / 255.0), srgbToLinear(10 / 255.0));
    expectColor(image(1, 0), srgbToLinear(128 / 255.0), srgbToLinear(200 / 255.0), 1);
}

TEST_F(ReadTest, SixteenBitPngIsDecodedBySrgbAndAlphaIsIgnored) {
    const std::string path = folder / "a.png";
    test::writeBytes(path, test::pngBytes(1, 1, 16, 6, {std::string("\x03\xe8\x80\x00\xff\xff\x40\x00", 8)}));
    const core::ImageRgb image = core::loadColor(path);
    expectColor(image(0, 0), srgbToLinear(1000 / 65535.0), srgbToLinear(32768 / 65535.0), 1);
}

TEST_F(ReadTest, GreyAndPaletteAreExpanded) {
    test::writePnm8(folder / "grey.pgm", 1, 1, 1, {128});
    expectColor(core::loadColor(folder / "grey.pgm")(0, 0), srgbToLinear(128 / 255.0), srgbToLinear(128 / 255.0),
                srgbToLinear(128 / 255.0));
    test::writeBytes(folder / "palette.png",
                     test::pngBytes(1, 1, 8, 3, {std::string(1, '\1')}, std::string("\0\0\0\xff\0\x80", 6)));
    expectColor(core::loadColor(folder / "palette.png")(0, 0), 1, 0, srgbToLinear(128 / 255.0));
}

TEST_F(ReadTest, GammaChunkIsObeyed) {
    std::string png = test::pngBytes(1, 1, 8, 2, {std::string("\x80\x80\x80", 3)});
    const std::size_t afterHeader = 8 + 25;
    png.insert(afterHeader, test::pngChunk("gAMA", test::bigEndian32(100000)));
    test::writeBytes(folder / "linear.png", png);
    expectColor(core::loadColor(folder / "linear.png")(0, 0), 128 / 255.0, 128 / 255.0, 128 / 255.0, 1e-5);
}

TEST_F(ReadTest, IccProfileDecidesColour) {
    // Adobe RGB primaries as D50 XYZ, gamma 2.2 (563/256); truth: D50 XYZ to linear sRGB by Bradford, in double.
    const double adobe[3][3] = {{0.60974, 0.20528, 0.14919}, {0.31111, 0.62567, 0.06322}, {0.01947, 0.06087, 0.74457}};
    const double fromD50[3][3] = {
        {3.1338561, -1.6168667, -0.4906146}, {-0.9787684, 1.9161415, 0.0334540}, {0.0719453, -0.2289914, 1.4052427}};
    const double gamma = 563 / 256.0;
    const std::vector<std::uint8_t> profile = iccProfile(adobe, gamma);
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeUInt8);
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
    const std::uint8_t pixel[] = {180, 150, 90};
    test::writeWith("tiff", folder / "adobe.tif", spec, OIIO::TypeUInt8, pixel);

    double linear[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) linear[i] += fromD50[i][j] * adobe[j][k] * std::pow(pixel[k] / 255.0, gamma);
    expectColor(core::loadColor(folder / "adobe.tif")(0, 0), linear[0], linear[1], linear[2], 1e-3);
    EXPECT_GT(std::abs(linear[0] - srgbToLinear(180 / 255.0)), 0.01) << "the profile has to make a difference";
}

TEST_F(ReadTest, WhatIsNoRadianceIsRepaired) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    test::writePfm(folder / "a.pfm", 2, 1, 3, {nan, 0.5f, inf, -inf, -1, 2});
    core::Notes remarks;
    const core::ImageRgb image = core::loadColor(folder / "a.pfm", &remarks);
    expectColor(image(0, 0), 0, 0.5, 65504);
    expectColor(image(1, 0), 0, 0, 2);
    ASSERT_EQ(remarks.size(), 2u);
    EXPECT_NE(remarks[0].english().find("a.pfm\" 50 % of the pixels are not numbers"), std::string::npos)
        << remarks[0].english();
}

TEST_F(ReadTest, AnInfiniteSunIsTheBrightestPixel) {
    const float inf = std::numeric_limits<float>::infinity();
    test::writePfm(folder / "sun.pfm", 2, 1, 3, {inf, inf, inf, 0.5f, 80000, 2});
    core::Notes remarks;
    const core::ImageRgb image = core::loadColor(folder / "sun.pfm", &remarks);
    expectColor(image(0, 0), 80000, 80000, 80000);
    expectColor(image(1, 0), 0.5, 80000, 2);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].english().find("50 % of the pixels are infinite"), std::string::npos);
}

TEST_F(ReadTest, OnlyTheSignOfAPfmScaleCounts) {
    for (const char* scale : {"-1.0", "-0.003922", "-250"}) {
        std::ofstream file(folder / "a.pfm", std::ios::binary);
        const float values[] = {3, 7};
        file << "Pf\n2 1\n" << scale << "\n";
        file.write(reinterpret_cast<const char*>(values), sizeof values);
        file.close();
        core::Notes remarks;
        const core::ImageF image = core::loadScalar(folder / "a.pfm", &remarks);
        EXPECT_FLOAT_EQ(image(0, 0), 3) << scale;
        EXPECT_FLOAT_EQ(image(1, 0), 7) << scale;
        EXPECT_EQ(remarks.size(), std::string(scale) == "-1.0" ? 0u : 1u);
    }
}

TEST_F(ReadTest, TheExposureOfARadiancePictureIsUndone) {
    // RGBE (128, 64, 32, 129): 1, 0.5, 0.25.
    for (const auto& [lines, factor] :
         {std::pair("", 1.0), {"EXPOSURE=4.0\n", 4.0}, {"EXPOSURE=2\nEXPOSURE=0.25\n", 0.5}}) {
        std::ofstream file(folder / "a.hdr", std::ios::binary);
        file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"
             << lines << "\n-Y 1 +X 1\n"
             << "\x80\x40\x20\x81";
        file.close();
        expectColor(core::loadColor(folder / "a.hdr")(0, 0), 1 / factor, 0.5 / factor, 0.25 / factor, 0.01);
    }
}

TEST_F(ReadTest, AColourPictureIsNoMap) {
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeUInt16);
    const std::uint16_t grey[] = {500, 500, 500, 900, 900, 900};
    test::writeWith("png", folder / "grey.png", spec, OIIO::TypeUInt16, grey);
    EXPECT_EQ(core::loadScalar(folder / "grey.png")(1, 0), 900);
    const std::uint16_t color[] = {500, 500, 500, 900, 901, 900};
    test::writeWith("png", folder / "color.png", spec, OIIO::TypeUInt16, color);
    test::expectError(core::ErrorKind::Input, {"color.png", "colour picture", "one number per pixel"},
                      [&] { (void)core::loadScalar(folder / "color.png"); });
}

TEST_F(ReadTest, AFloatingPointTiffIsDecodedByItsProfile) {
    const double adobe[3][3] = {{0.60974, 0.20528, 0.14919}, {0.31111, 0.62567, 0.06322}, {0.01947, 0.06087, 0.74457}};
    const std::vector<std::uint8_t> profile = iccProfile(adobe, 2.0);
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                   profile.data());
    const float pixel[] = {0.5f, 0.5f, 0.5f};
    test::writeWith("tiff", folder / "a.tif", spec, OIIO::TypeFloat, pixel);
    expectColor(core::loadColor(folder / "a.tif")(0, 0), 0.25, 0.25, 0.25, 2e-3);
}

TEST_F(ReadTest, PixelsThatAreNoRadianceAreSaid) {
    std::vector<float> values(3 * 1000, 0.5f);
    const auto remarkOf = [&](int negative, int notANumber) {
        for (std::size_t i = 0; i < 1000; ++i) {
            const auto n = static_cast<std::size_t>(negative);
            values[3 * i + 1] = i < n ? -0.1f : 0.5f;
            if (i >= n && i < n + static_cast<std::size_t>(notANumber))
                values[3 * i + 1] = std::numeric_limits<float>::quiet_NaN();
        }
        test::writePfm(folder / "a.pfm", 100, 10, 3, values);
        core::Notes remarks;
        (void)core::loadColor(folder / "a.pfm", &remarks);
        std::string all;
        for (const core::Message& remark : remarks) all += remark.english() + "\n";
        return all;
    };
    EXPECT_EQ(remarkOf(20, 0), "") << "colours outside Rec.709 are usual";
    EXPECT_NE(remarkOf(300, 0).find("30 % of the pixels are negative"), std::string::npos);
    EXPECT_NE(remarkOf(300, 3).find("3 of the pixels are not numbers"), std::string::npos);
    EXPECT_NE(remarkOf(300, 3).find("30 % of the pixels are negative"), std::string::npos);
}

TEST_F(ReadTest, ExrChannelsByNameAlsoInLayers) {
    OIIO::ImageSpec spec(1, 1, 5, OIIO::TypeFloat);
    spec.channelnames = {"View.Combined.A", "View.Combined.B", "View.Combined.G", "View.Combined.R", "View.Depth.Z"};
    const float pixel[] = {0.25f, 3, 2, 1, 7};
    test::writeWith("openexr", folder / "layers.exr", spec, OIIO::TypeFloat, pixel);
    expectColor(core::loadColor(folder / "layers.exr")(0, 0), 1, 2, 3);
    EXPECT_EQ(core::loadScalar(folder / "layers.exr")(0, 0), 7);
    EXPECT_TRUE(core::readImageInfo(folder / "layers.exr").hasDepthChannel);
}

TEST_F(ReadTest, ExrDataWindowIsPlacedInDisplayWindow) {
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeFloat);
    spec.x = 2;
    spec.y = 1;
    spec.full_width = 3;  // the second data pixel is overscan
    spec.full_height = 3;
    const float pixels[] = {1, 2, 3, 4, 5, 6};
    test::writeWith("openexr", folder / "window.exr", spec, OIIO::TypeFloat, pixels);
    const core::ImageRgb image = core::loadColor(folder / "window.exr");
    ASSERT_EQ(image.width(), 3);
    ASSERT_EQ(image.height(), 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            const bool inside = x == 2 && y == 1;
            expectColor(image(x, y), inside ? 1 : 0, inside ? 2 : 0, inside ? 3 : 0);
        }
}

TEST_F(ReadTest, ExrChromaticitiesAreConverted) {
    // Rec.2020 red is outside Rec.709: more than 1 in red, negative elsewhere (clamped to 0).
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeFloat);
    const float rec2020[] = {0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), rec2020);
    const float pixels[] = {1, 0, 0, 0.5f, 0.5f, 0.5f};
    test::writeWith("openexr", folder / "rec2020.exr", spec, OIIO::TypeFloat, pixels);
    const core::ImageRgb image = core::loadColor(folder / "rec2020.exr");
    expectColor(image(0, 0), 1.6605, 0, 0, 1e-3);  // ITU-R BT.2087
    expectColor(image(1, 0), 0.5, 0.5, 0.5, 1e-5);
}

TEST_F(ReadTest, OrientationTurnsTheRaster) {
    // 3x2 stored; what every EXIF orientation displays, row by row.
    const std::uint8_t stored[] = {1, 2, 3, 4, 5, 6};
    const std::vector<std::vector<int>> displayed = {{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                                     {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3},
                                                     {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        OIIO::ImageSpec spec(3, 2, 1, OIIO::TypeUInt8);
        spec["Orientation"] = orientation;
        test::writeWith("tiff", folder / "o.tif", spec, OIIO::TypeUInt8, stored);
        const core::LabelImage labels = core::loadLabels(folder / "o.tif");
        ASSERT_EQ(labels.width(), orientation >= 5 ? 2 : 3) << orientation;
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_EQ(labels[i], displayed[static_cast<std::size_t>(orientation - 1)][i]) << orientation << " " << i;
        const core::ImageInfo info = core::readImageInfo(folder / "o.tif");
        EXPECT_EQ(info.width, labels.width());
        EXPECT_EQ(info.orientation, orientation);
    }
}

TEST_F(ReadTest, ScalarTakesZThenY) {
    const float pixel[] = {1, 2, 3};
    const auto write = [&](const std::vector<std::string>& names) {
        OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
        spec.channelnames = names;
        test::writeWith("openexr", folder / "s.exr", spec, OIIO::TypeFloat, pixel);
        return core::loadScalar(folder / "s.exr")(0, 0);
    };
    EXPECT_EQ(write({"P", "Y", "Z"}), 3);
    EXPECT_EQ(write({"P", "X", "Y"}), 3);
    test::expectError(core::ErrorKind::Input, {"s.exr", "P, Q, S"}, [&] { (void)write({"P", "Q", "S"}); });
}

TEST_F(ReadTest, ScalarKeepsStoredIntegers) {
    test::writeBytes(folder / "d.png", test::pngBytes(3, 1, 16, 0, {std::string("\x00\x01\x1f\x5a\xff\xff", 6)}));
    const core::ImageF depth = core::loadScalar(folder / "d.png");
    EXPECT_EQ(depth(0, 0), 1);
    EXPECT_EQ(depth(1, 0), 8026);
    EXPECT_EQ(depth(2, 0), 65535);
    EXPECT_EQ(core::storedFormat(folder / "d.png").bits, 16);
    EXPECT_FALSE(core::storedFormat(folder / "d.png").floating);
}

TEST_F(ReadTest, PalettePngGivesIndicesNotColours) {
    const std::string palette("\x10\x10\x10\x10\x10\x10\xff\x00\x00\x10\x10\x10", 12);  // entries that look the same
    test::writeBytes(folder / "p8.png", test::pngBytes(4, 1, 8, 3, {std::string("\0\1\2\3", 4)}, palette));
    test::writeBytes(folder / "p2.png", test::pngBytes(4, 1, 2, 3, {std::string(1, '\x1b')}, palette));
    test::writeBytes(folder / "p4.png", test::pngBytes(4, 1, 4, 3, {std::string("\x01\x23", 2)}, palette));
    test::writeBytes(folder / "g2.png", test::pngBytes(4, 1, 2, 0, {std::string(1, '\x1b')}));
    for (const char* name : {"p8.png", "p2.png", "p4.png", "g2.png"}) {
        const core::LabelImage labels = core::loadLabels(folder / name);
        for (int x = 0; x < 4; ++x) EXPECT_EQ(labels(x, 0), x) << name;
    }
}

namespace {

/// A TIFF of 8-bit samples in one row, by hand: with `meaning` 3 its palette is grey, so that colours look like
/// numbers.
std::string smallTiff(bool bigEndian, int meaning, const std::string& samples) {
    const auto number = [&](std::uint32_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> static_cast<unsigned>(8 * (bigEndian ? bytes - 1 - i : i)) & 255U);
        return text;
    };
    const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
        return number(tag, 2) + number(type, 2) + number(count, 4) +
               (type == 3 && count == 1 ? number(value, 2) + number(0, 2) : number(value, 4));
    };
    const auto width = static_cast<std::uint32_t>(samples.size());
    const std::uint32_t entries = 9, data = 8 + 2 + 12 * entries + 4, palette = data + width;
    std::string tiff = std::string(bigEndian ? "MM" : "II") + number(42, 2) + number(8, 4) + number(entries, 2);
    tiff += entry(256, 3, 1, width) + entry(257, 3, 1, 1) + entry(258, 3, 1, 8) + entry(259, 3, 1, 1) +
            entry(262, 3, 1, static_cast<std::uint32_t>(meaning)) + entry(273, 4, 1, data) + entry(278, 3, 1, 1) +
            entry(279, 4, 1, width) + entry(320, 3, 768, palette) + number(0, 4) + samples;
    for (int channel = 0; channel < 3; ++channel)
        for (std::uint32_t i = 0; i < 256; ++i) tiff += number((97 * i & 255U) * 257, 2);
    return tiff;
}

}  // namespace

TEST_F(ReadTest, PaletteTiffGivesIndicesNotColours) {
    for (const bool bigEndian : {false, true})
        for (const int meaning : {0, 1, 3}) {
            test::writeBytes(folder / "p.tif", smallTiff(bigEndian, meaning, std::string("\0\1\2\3", 4)));
            const core::LabelImage labels = core::loadLabels(folder / "p.tif");
            for (int x = 0; x < 4; ++x) EXPECT_EQ(labels(x, 0), x) << meaning << (bigEndian ? " MM" : " II");
        }
}

TEST_F(ReadTest, LabelsOf16BitAndWholeFloats) {
    test::writeBytes(folder / "l.png", test::pngBytes(2, 1, 16, 0, {std::string("\x01\x2c\xff\xff", 4)}));
    EXPECT_EQ(core::loadLabels(folder / "l.png")(0, 0), 300);
    EXPECT_EQ(core::loadLabels(folder / "l.png")(1, 0), 65535);
    test::writePfm(folder / "l.pfm", 2, 1, 1, {3, 65535});
    EXPECT_EQ(core::loadLabels(folder / "l.pfm")(0, 0), 3);
}

TEST_F(ReadTest, LabelsThatAreNoneAreRefused) {
    test::writePfm(folder / "half.pfm", 1, 1, 1, {0.5f});
    test::expectError(ErrorKind::Input, {"half.pfm", "0.5", "whole numbers"},
                      [&] { (void)core::loadLabels(folder / "half.pfm"); });
    test::writePfm(folder / "big.pfm", 1, 1, 1, {70000});
    test::expectError(ErrorKind::Input, {"big.pfm", "70000"}, [&] { (void)core::loadLabels(folder / "big.pfm"); });
    test::writePnm8(folder / "rgb.ppm", 1, 1, 3, {1, 2, 3});
    test::expectError(ErrorKind::Input, {"rgb.ppm", "colour picture"},
                      [&] { (void)core::loadLabels(folder / "rgb.ppm"); });
    test::writePnm8(folder / "grey.ppm", 1, 1, 3, {7, 7, 7});
    EXPECT_EQ(core::loadLabels(folder / "grey.ppm")(0, 0), 7);
}

TEST_F(ReadTest, FormatIsKnownByContent) {
    test::writePnm8(folder / "really_a.jpg", 1, 1, 3, {255, 255, 255});
    expectColor(core::loadColor(folder / "really_a.jpg")(0, 0), 1, 1, 1);
}
