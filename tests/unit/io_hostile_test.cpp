// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>

#include "core/io/image_io.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"

using core::ErrorKind;

namespace {

class HostileTest : public testing::Test {
  protected:
    /// The file is refused by every reader, with a message that has these parts, and at once.
    void expectRefused(const std::string& path, const std::vector<std::string>& parts) {
        const auto begin = std::chrono::steady_clock::now();
        test::expectError(ErrorKind::Input, parts, [&] { (void)core::loadColor(path); });
        test::expectError(ErrorKind::Input, parts, [&] { (void)core::loadScalar(path); });
        test::expectError(ErrorKind::Input, {}, [&] { (void)core::loadLabels(path); });
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(seconds.count(), 2.0) << path;
    }

    test::TempFolder folder;
};

/// An EXR header, byte by byte, one half channel Y, no compression, and an empty offset table.
std::string exrHeader(int width, int height) {
    const auto box = [&] {
        return test::little32(0) + test::little32(0) + test::little32(static_cast<std::uint32_t>(width - 1)) +
               test::little32(static_cast<std::uint32_t>(height - 1));
    };
    const auto attribute = [](const std::string& name, const std::string& type, const std::string& value) {
        return name + '\0' + type + '\0' + test::little32(static_cast<std::uint32_t>(value.size())) + value;
    };
    const std::string channels =
        std::string("Y\0", 2) + test::little32(1) + test::little32(0) + test::little32(1) + test::little32(1) + '\0';
    const std::string one("\0\0\x80\x3f", 4);
    return std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + attribute("channels", "chlist", channels) +
           attribute("compression", "compression", std::string(1, '\0')) + attribute("dataWindow", "box2i", box()) +
           attribute("displayWindow", "box2i", box()) + attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", one) + attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
           attribute("screenWindowWidth", "float", one) + '\0';
}

}  // namespace

TEST_F(HostileTest, MissingFolderEmptyAndText) {
    expectRefused(folder / "nothing.png", {"nothing.png", "does not exist"});
    expectRefused(folder.path().string(), {folder.path().string(), "is a folder"});
    test::writeBytes(folder / "empty.exr", "");
    expectRefused(folder / "empty.exr", {"empty.exr", "empty (0 bytes)"});
    test::writeBytes(folder / "text.png", "hello, this is no picture at all\n");
    expectRefused(folder / "text.png", {"text.png", "no image format", "expected EXR, PNG"});
    expectRefused("/dev/zero", {"/dev/zero", "not a regular file"});
}

TEST_F(HostileTest, SizesThatCannotBe) {
    const std::string padding(1000, '\0');
    test::writeBytes(folder / "huge.png", test::pngBytes(100000, 100000, 8, 2, {std::string(16, '\0')}) + padding);
    expectRefused(folder / "huge.png", {"huge.png"});
    test::writeBytes(folder / "wide.png", test::pngBytes(32000, 31250, 8, 2, {std::string(16, '\0')}) + padding);
    expectRefused(folder / "wide.png", {"wide.png", "32000x31250", "200 megapixels"});
    test::writeBytes(folder / "lie.png", test::pngBytes(14000, 14000, 8, 2, {std::string(16, '\0')}) + padding);
    expectRefused(folder / "lie.png", {"lie.png", "14000x14000", "bytes"});
    test::writeBytes(folder / "huge.pfm", "PF\n32000 31250\n-1.0\n" + padding);
    expectRefused(folder / "huge.pfm", {"huge.pfm", "32000x31250"});
    test::writeBytes(folder / "huge.exr", exrHeader(32000, 31250) + padding);
    expectRefused(folder / "huge.exr", {"huge.exr"});
    test::writeBytes(folder / "long.exr", exrHeader(2000000000, 1) + padding);
    expectRefused(folder / "long.exr", {"long.exr"});
    test::writeBytes(folder / "huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32000 +X 31250\n" + padding);
    expectRefused(folder / "huge.hdr", {"huge.hdr", "31250x32000"});
}

TEST_F(HostileTest, ControlTheSameHeadersWithHonestSizesAreRead) {
    test::writeBytes(folder / "ok.png", test::pngBytes(2, 2, 8, 2, {std::string(6, '\x40'), std::string(6, '\x40')}));
    EXPECT_EQ(core::loadColor(folder / "ok.png").width(), 2);
    std::string exr = exrHeader(1, 1);
    const std::size_t offset = exr.size() + 8;
    exr += test::little32(static_cast<std::uint32_t>(offset)) + test::little32(0);  // offset table
    exr += test::little32(0) + test::little32(2) + std::string("\0\x3c", 2);        // row 0, 2 bytes, half 1.0
    test::writeBytes(folder / "ok.exr", exr);
    EXPECT_EQ(core::loadScalar(folder / "ok.exr")(0, 0), 1.0f);
}

TEST_F(HostileTest, TruncatedFilesOfEveryFormat) {
    // A picture with noise, so that the compressed data is long.
    const int size = 64;
    std::vector<float> values(static_cast<std::size_t>(size * size * 3));
    std::uint32_t state = 1;
    for (float& v : values) {
        state = state * 1664525U + 1013904223U;
        v = static_cast<float>(state >> 8U) / 16777216.0f;
    }
    const std::vector<std::pair<std::string, std::string>> formats = {
        {"openexr", "t.exr"}, {"png", "t.png"}, {"tiff", "t.tif"}, {"jpeg", "t.jpg"}, {"hdr", "t.hdr"}};
    for (const auto& [plugin, name] : formats) {
        const bool isFloat = plugin == "openexr" || plugin == "hdr";
        test::writeWith(plugin, folder / name,
                        OIIO::ImageSpec(size, size, 3, isFloat ? OIIO::TypeFloat : OIIO::TypeUInt8), OIIO::TypeFloat,
                        values.data());
        EXPECT_EQ(core::loadColor(folder / name).height(), size) << name;
        const std::string whole = test::readBytes(folder / name);
        for (const double part : {0.02, 0.5, 0.95}) {
            test::writeBytes(folder / name,
                             whole.substr(0, static_cast<std::size_t>(static_cast<double>(whole.size()) * part)));
            SCOPED_TRACE(name + " cut at " + std::to_string(part));
            test::expectError(ErrorKind::Input, {name}, [&, &file = name] { (void)core::loadColor(folder / file); });
        }
    }
    test::writePfm(folder / "t.pfm", size, size, 3, values);
    const std::string whole = test::readBytes(folder / "t.pfm");
    test::writeBytes(folder / "t.pfm", whole.substr(0, whole.size() / 2));
    test::expectError(ErrorKind::Input, {"t.pfm"}, [&] { (void)core::loadColor(folder / "t.pfm"); });
}

TEST_F(HostileTest, DamagedBytesNeverCrash) {
    test::writeWith("openexr", folder / "d.exr", OIIO::ImageSpec(8, 8, 3, OIIO::TypeHalf), OIIO::TypeFloat,
                    std::vector<float>(192, 0.5f).data());
    test::writeBytes(folder / "d.png", test::pngBytes(4, 1, 8, 3, {std::string("\0\1\2\3", 4)}, std::string(12, 'x')));
    for (const char* name : {"d.exr", "d.png"}) {
        const std::string whole = test::readBytes(folder / name);
        int refused = 0;
        for (std::size_t at = 4; at < whole.size(); at += 3) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(~damaged[at]);
            test::writeBytes(folder / name, damaged);
            try {
                (void)core::loadLabels(folder / name);
            } catch (const core::Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::Input);
                ++refused;
            }
        }
        EXPECT_GT(refused, 10) << name;
    }
}

TEST_F(HostileTest, JpegLabelsAreRefused) {
    test::writeWith("jpeg", folder / "l.jpg", OIIO::ImageSpec(8, 8, 1, OIIO::TypeUInt8), OIIO::TypeUInt8,
                    std::vector<std::uint8_t>(64, 3).data());
    EXPECT_EQ(core::loadColor(folder / "l.jpg").width(), 8);
    test::expectError(ErrorKind::Input, {"l.jpg", "JPEG"}, [&] { (void)core::loadLabels(folder / "l.jpg"); });
}
