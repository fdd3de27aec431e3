// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged and dishonest files that claim to carry depth: refused at once, with a message, in little memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/io/import/import_format.h"
#include "core/io/import/jpeg_segments.h"
#include "core/io/project.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"
#include "tests/support/photo_containers.h"

using core::ErrorKind;

namespace {

const std::string kDepthNamespace = "xmlns:GDepth=\"http://ns.google.com/photos/1.0/depthmap/\"";

class ImportHostileTest : public testing::Test {
  protected:
    void expectRefused(const std::string& name, const std::string& bytes, std::vector<std::string> parts) {
        SCOPED_TRACE(name);
        test::writeBytes(folder / name, bytes);
        parts.push_back(name);
        core::CreateOptions options;
        options.color = folder / name;
        const auto begin = std::chrono::steady_clock::now();
        test::expectError(ErrorKind::Input, parts, [&] { (void)core::createScene(options); });
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(seconds.count(), 2.0);
    }

    /// The file is taken for a picture without depth, and that is said.
    void expectWithoutDepth(const std::string& name, const std::string& bytes) {
        SCOPED_TRACE(name);
        test::writeBytes(folder / name, bytes);
        core::CreateOptions options;
        options.color = folder / name;
        core::Notes notes;
        const core::Scene scene = core::createScene(options, &notes);
        EXPECT_TRUE(std::ranges::all_of(scene.photo->depth.pixels(), [](float z) { return z == 0; }));
        EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr(name + "\" contains no depth map")));
    }

    /// Whatever is done to the file, it is read or refused.
    void expectNoCrash(const std::string& name, const std::string& whole, std::size_t begin, std::size_t step) {
        int refused = 0;
        for (std::size_t at = begin; at < whole.size(); at += step) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(~damaged[at]);
            refused += isRefused(name, damaged) ? 1 : 0;
            refused += isRefused(name, whole.substr(0, at)) ? 1 : 0;
        }
        EXPECT_GT(refused, 10) << name;
    }

    std::string jpeg(int width = 6, int height = 4, int channels = 1) {
        return test::plainJpeg(folder, width, height, channels,
                               std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * channels), 77));
    }

    /// A JPEG whose XMP has these GDepth attributes.
    std::string gdepth(const std::string& attributes) {
        return test::withSegments(jpeg(), test::xmpSegment(test::xmpText(kDepthNamespace, attributes)));
    }

    std::string depthPng() {
        return test::base64(test::pngBytes(6, 4, 8, 0, std::vector<std::string>(4, std::string(6, '\x40'))));
    }

    test::TempFolder folder;

  private:
    bool isRefused(const std::string& name, const std::string& bytes) {
        test::writeBytes(folder / name, bytes);
        try {
            core::CreateOptions options;
            options.color = folder / name;
            (void)core::createScene(options);
        } catch (const core::Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input) << error.what();
            return true;
        }
        return false;
    }
};

const std::string kRange = "GDepth:Format=\"RangeInverse\" GDepth:Near=\"1\" GDepth:Far=\"3\" ";

std::string cloud(const std::string& header, const std::string& data) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + header + data;
}

std::string fields(const std::string& width, const std::string& height, const std::string& data) {
    return "FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " + width + "\nHEIGHT " + height +
           "\nDATA " + data + "\n";
}

}  // namespace

TEST_F(ImportHostileTest, ControlTheHonestFileIsRead) {
    test::writeBytes(folder / "ok.jpg", gdepth(kRange + "GDepth:Data=\"" + depthPng() + "\""));
    core::CreateOptions options;
    options.color = folder / "ok.jpg";
    EXPECT_NEAR(core::createScene(options).photo->depth(3, 2), 3 / (3 - 64 / 255.0 * 2), 1e-5);
}

TEST_F(ImportHostileTest, GoogleDepthThatIsNone) {
    const std::string data = "GDepth:Data=\"" + depthPng() + "\"";
    expectRefused("nodata.jpg", gdepth(kRange), {"GDepth:Data"});
    expectRefused("garbage.jpg", gdepth(kRange + "GDepth:Data=\"!!!no base64!!!\""), {"depth map", "base64"});
    expectRefused("nothing.jpg", gdepth(kRange + "GDepth:Data=\"\""), {"depth map", "base64"});
    expectRefused("noimage.jpg", gdepth(kRange + "GDepth:Data=\"" + test::base64("no image at all") + "\""),
                  {"the depth map inside", "no image format"});
    expectRefused("format.jpg", gdepth("GDepth:Format=\"Round\" " + data), {"Round", "RangeInverse"});
    expectRefused("norange.jpg", gdepth("GDepth:Format=\"RangeLinear\" " + data), {"nothing (Near)"});
    for (const char* range : {"GDepth:Near=\"3\" GDepth:Far=\"1\"", "GDepth:Near=\"0\" GDepth:Far=\"1\"",
                              "GDepth:Near=\"nan\" GDepth:Far=\"1\"", "GDepth:Near=\"1\" GDepth:Far=\"inf\"",
                              "GDepth:Near=\"-1\" GDepth:Far=\"1\"", "GDepth:Near=\"one\" GDepth:Far=\"1\""})
        expectRefused("range.jpg", gdepth("GDepth:Format=\"RangeInverse\" " + std::string(range) + " " + data),
                      {"Near", "Far"});
    // A header that claims 14000x14000 pixels in a few bytes.
    const std::string lie = test::pngBytes(14000, 14000, 8, 0, {std::string(16, '\0')});
    expectRefused("lie.jpg", gdepth(kRange + "GDepth:Data=\"" + test::base64(lie) + "\""), {"14000x14000"});
    const std::string tall = test::pngBytes(2, 4, 8, 0, std::vector<std::string>(4, "ab"));
    expectRefused("shape.jpg", gdepth(kRange + "GDepth:Data=\"" + test::base64(tall) + "\""), {"2x4", "6x4"});
}

TEST_F(ImportHostileTest, ExtendedXmpThatDoesNotAddUp) {
    const std::string text = test::xmpText(kDepthNamespace, "GDepth:Data=\"" + depthPng() + "\"");
    const auto file = [&](const std::string& parts) {
        const std::string standard = test::xmpText(kDepthNamespace + " xmlns:n=\"http://ns.adobe.com/xmp/note/\"",
                                                   kRange + "n:HasExtendedXMP=\"" + test::kGuid + "\"");
        return test::withSegments(jpeg(), test::xmpSegment(standard) + parts);
    };
    const std::string first = text.substr(0, 100);
    const std::string rest = text.substr(100);
    const auto part = [&](const std::string& bytes, std::size_t offset, std::size_t claimed) {
        return test::extendedXmpSegment(bytes, offset, claimed);
    };
    expectRefused("missing.jpg", file(part(first, 0, text.size())), {"extended XMP", std::to_string(text.size())});
    expectRefused("gap.jpg", file(part(first, 0, text.size()) + part(rest, 101, text.size())), {"extended XMP"});
    expectRefused("overlap.jpg", file(part(first, 0, text.size()) + part(rest, 99, text.size())), {"extended XMP"});
    expectRefused("twice.jpg", file(part(first, 0, text.size()) + part(first, 0, text.size())), {"extended XMP"});
    expectRefused("huge.jpg", file(part(text, 0, 1'000'000'000)), {"extended XMP", "1000000000"});
    expectRefused("far.jpg", file(part(text, 0xfffffff0U, text.size())), {"extended XMP"});
    expectRefused("sizes.jpg", file(part(first, 0, text.size()) + part(rest, 100, 7)), {"extended XMP"});
    expectRefused("xml.jpg", file(part("<x:xmpmeta><a", 0, 13)), {"well-formed"});
    // Entities that would expand to gigabytes stay what they are.
    std::string bomb = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\">";
    for (char c = 'b'; c <= 'z'; ++c)
        bomb += std::string("<!ENTITY ") + c + " \"&" + static_cast<char>(c - 1) + ";&" + static_cast<char>(c - 1) +
                ";&" + static_cast<char>(c - 1) + ";\">";
    bomb += "]>" + test::xmpText(kDepthNamespace, "GDepth:Data=\"&z;\"");
    expectRefused("bomb.jpg", file(part(bomb, 0, bomb.size())), {"base64"});
    std::string nested;
    for (int i = 0; i < 5000; ++i) nested += "<a>";
    expectRefused("nested.jpg", file(part(nested, 0, nested.size())), {"well-formed"});
}

TEST_F(ImportHostileTest, DamagedJpegSegments) {
    const std::string whole = gdepth(kRange + "GDepth:Data=\"" + depthPng() + "\"");
    expectNoCrash("d.jpg", whole, 1, 5);
    bool complete = true;
    EXPECT_TRUE(core::jpegSegments("", &complete).empty());
    EXPECT_FALSE(complete);
    EXPECT_TRUE(core::jpegSegments("\xff\xd8\xff", &complete).empty());
    EXPECT_TRUE(core::jpegSegments(std::string("\xff\xd8\xff\xe1\0\1", 6), &complete).empty());
    EXPECT_TRUE(core::jpegSegments("\xff\xd8\xff\xe1\xff\xff too short", &complete).empty());
    EXPECT_FALSE(complete);
}

TEST_F(ImportHostileTest, DynamicDepthThatIsNotWhereItIsListed) {
    const std::string map = jpeg();
    const std::string size = std::to_string(map.size());
    const std::string depth =
        "DepthMap:Format='RangeLinear' DepthMap:Near='1' DepthMap:Far='3' DepthMap:Units='Meters' "
        "DepthMap:DepthURI='depth' ";
    const auto file = [&](const std::vector<test::DynamicItem>& items, const std::string& attributes = {},
                          const std::string& elements = {}) {
        return test::withSegments(jpeg(),
                                  test::xmpSegment(test::dynamicDepthXmp(items, depth + attributes, elements))) +
               map + map;
    };
    const std::string honest = file({{"other", size}, {"depth", size}});
    test::writeBytes(folder / "ok.jpg", honest);
    core::CreateOptions options;
    options.color = folder / "ok.jpg";
    EXPECT_NEAR(core::createScene(options).photo->depth(3, 2), 1 + 77 / 255.0 * 2, 1e-5);
    // An item without bytes of its own shares those of the item before.
    test::writeBytes(folder / "ok.jpg", file({{"other", size}, {"depth", "0"}}));
    EXPECT_NEAR(core::createScene(options).photo->depth(3, 2), 1 + 77 / 255.0 * 2, 1e-5);

    expectRefused("absent.jpg", file({{"other", size}}), {"no \"depth\"", "the depth map"});
    expectRefused("unlisted.jpg", file({}), {"no \"depth\""});
    expectRefused("short.jpg", file({{"depth", std::to_string(map.size() - 5)}}), {"the depth map is not where"});
    expectRefused("overlap.jpg", file({{"other", std::to_string(map.size() - 5)}, {"depth", size}}),
                  {"the depth map is not where"});
    expectRefused("gap.jpg", file({{"other", size, "5"}, {"depth", std::to_string(map.size() - 5)}}),
                  {"the depth map is not where"});
    expectRefused("beyond.jpg", file({{"other", size}, {"depth", std::to_string(map.size() + 1)}}),
                  {"truncated", "the depth map"});
    expectRefused("cut.jpg", honest.substr(0, honest.size() - 10), {"truncated", "the depth map"});
    for (const char* wrong : {"-1", "1e300", "nan", "1.5", "many", "99999999999999999999"}) {
        expectRefused("length.jpg", file({{"depth", wrong}}), {"Item:Length", wrong});
        expectRefused("padding.jpg", file({{"other", size, wrong}, {"depth", size}}), {"Item:Padding", wrong});
    }
    expectRefused("mask.jpg", file({{"depth", size}}, "DepthMap:ItemSemantic='Segmentation'"),
                  {"Segmentation", "not depth"});
    expectRefused("sharp.jpg",
                  file({{"depth", size}}, "", "<Camera:Image Image:ItemSemantic='Original' Image:ItemURI='o'/>"),
                  {"no \"o\"", "the sharp picture"});
    // The cameras were in an extended packet of which a part is missing.
    const std::string standard = test::xmpText(
        "xmlns:Device=\"http://ns.google.com/photos/dd/1.0/device/\" xmlns:n=\"http://ns.adobe.com/xmp/note/\"",
        "n:HasExtendedXMP=\"" + test::kGuid + "\"", "<Device:Container/>");
    expectRefused("packet.jpg",
                  test::withSegments(jpeg(), test::xmpSegment(standard) + test::extendedXmpSegment("<x", 0, 500)),
                  {"extended XMP"});
    expectNoCrash("n.jpg", honest, 10, 13);
}

TEST_F(ImportHostileTest, PictureIndexThatPointsElsewhere) {
    const std::string front = jpeg(32, 16);
    const std::string apple = test::appleXmp("0.5", "2.5", 32, 16, {50, 0, 0, 0, 51, 0, 20, 15, 1});
    const std::string second = test::withSegments(jpeg(16, 8), test::xmpSegment(apple));
    const std::string whole = test::mpfFile(front, "", second);
    core::CreateOptions options;
    test::writeBytes(folder / "ok.jpg", whole);
    options.color = folder / "ok.jpg";
    EXPECT_GT(core::createScene(options).photo->depth(0, 0), 0);

    expectRefused("cut.jpg", whole.substr(0, whole.size() - 10), {"truncated", "MPF"});
    expectWithoutDepth("beyond.jpg", test::withSegments(front, test::mpfSegment(0xfffffff0U, 100)));
    expectWithoutDepth("endless.jpg", test::withSegments(front, test::mpfSegment(10, 0xffffffffU)));
    // Starts of pictures without end take no time.
    std::string starts;
    for (int i = 0; i < 200'000; ++i) starts += "\xff\xd8\xff";
    expectWithoutDepth("starts.jpg", front + starts);
    expectWithoutDepth("nowhere.jpg", test::withSegments(front, test::mpfSegment(5, 50)));
    expectNoCrash("m.jpg", whole, 10, 13);

    const auto withRange = [&](const std::string& xmp) {
        return test::mpfFile(front, "", test::withSegments(jpeg(16, 8), test::xmpSegment(xmp)));
    };
    const std::vector<double> k{50, 0, 0, 0, 51, 0, 20, 15, 1};
    expectRefused("norange.jpg", withRange(test::appleXmp("", "", 32, 16, k)), {"FloatMinValue"});
    expectRefused("inverted.jpg", withRange(test::appleXmp("2", "1", 32, 16, k)), {"FloatMinValue"});
    expectWithoutDepth("matte.jpg", withRange(test::appleXmp("0", "1", 32, 16, k, "portraiteffectsmatte")));
    // Intrinsics that no camera has are left out, and said to be.
    for (const std::vector<double>& wrong : {std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 1}, {1e300}, {}}) {
        test::writeBytes(folder / "k.jpg", withRange(test::appleXmp("0.5", "2.5", 32, 16, wrong)));
        options.color = folder / "k.jpg";
        core::Notes notes;
        EXPECT_GT(core::createScene(options, &notes).photo->camera.fx, 1);
        if (wrong.size() == 9) {
            EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr("fit no camera")));
        }
    }
}

TEST_F(ImportHostileTest, PointCloudsThatCannotBe) {
    const std::string some(400, '\0');
    expectRefused("negative.pcd", cloud(fields("-20", "10", "binary"), some), {"WIDTH", "-20"});
    expectRefused("zero.pcd", cloud(fields("0", "10", "binary"), some), {"WIDTH", "is 0"});
    expectRefused("flat.pcd", cloud(fields("200", "1", "binary"), some), {"HEIGHT 1", "raster"});
    expectRefused("huge.pcd", cloud(fields("32000", "32000", "binary"), some), {"32000x32000"});
    expectRefused("wide.pcd", cloud(fields("4294967297", "2", "binary"), some), {"WIDTH", "4294967297"});
    expectRefused("word.pcd", cloud(fields("many", "2", "binary"), some), {"WIDTH", "many"});
    expectRefused("short.pcd", cloud(fields("100", "100", "binary"), some), {"truncated", "160000", "400"});
    expectRefused("text.pcd", cloud(fields("100", "100", "ascii"), "1 2 3 4\n"), {"truncated", "10000"});
    expectRefused("words.pcd", cloud(fields("2", "2", "ascii"), "1 2 3 4\n1 2 three 4\n1 2 3 4 1 2 3 4\n1 2 3 4\n"),
                  {"point 1", "\"z\""});
    expectRefused("kind.pcd", cloud(fields("10", "10", "zip"), some), {"zip", "binary_compressed"});
    expectRefused("endless.pcd", cloud("FIELDS x y z\n" + std::string(70000, '#'), ""), {"DATA"});
    expectRefused("nodata.pcd", cloud("FIELDS x y z rgba\nSIZE 4 4 4 4\n", ""), {"DATA"});
    expectRefused("uneven.pcd",
                  cloud("FIELDS x y z rgba\nSIZE 4 4 4\nTYPE F F F U\nWIDTH 5\nHEIGHT 4\nDATA binary\n", some),
                  {"4, 3, 4"});
    expectRefused("size.pcd",
                  cloud("FIELDS x y z rgba\nSIZE 4 4 -4 4\nTYPE F F F U\nWIDTH 5\nHEIGHT 4\nDATA binary\n", some),
                  {"SIZE", "-4"});
    expectRefused(
        "count.pcd",
        cloud("FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 99999\nWIDTH 5\nHEIGHT 4\nDATA binary\n",
              some),
        {"COUNT", "99999"});
    expectRefused(
        "points.pcd",
        cloud("FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 5\nHEIGHT 4\nPOINTS 7\nDATA binary\n", some),
        {"POINTS", "7", "20"});
    expectRefused("noz.pcd",
                  cloud("FIELDS x y w rgba\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 5\nHEIGHT 4\nDATA binary\n", some),
                  {"\"z\""});
    expectRefused("nocolor.pcd",
                  cloud("FIELDS x y z i\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 5\nHEIGHT 4\nDATA binary\n", some), {"rgb"});
    expectRefused("nowhere.pcd", cloud(fields("5", "5", "binary"), some), {"0 points"});
}

TEST_F(ImportHostileTest, LzfBombsAndDamage) {
    const auto file = [&](std::uint32_t packed, std::uint32_t unpacked, const std::string& block) {
        return cloud(fields("5000", "5000", "binary_compressed"),
                     test::little32(packed) + test::little32(unpacked) + block);
    };
    const std::uint32_t all = 5000 * 5000 * 16;
    expectRefused("bomb.pcd", file(100, all, std::string(100, '\xff')), {"LZF"});
    expectRefused("claim.pcd", file(0xffffffffU, all, std::string(100, '\xff')), {"truncated", "4294967295"});
    expectRefused("size.pcd", file(100, 12345, std::string(100, '\xff')), {"12345", std::to_string(all)});
    expectRefused("none.pcd", cloud(fields("50", "50", "binary_compressed"), "abc"), {"truncated"});
    const std::string small = fields("10", "10", "binary_compressed");
    for (const std::string& block : {std::string(1700, '\xe0'), std::string(50, '\x1f'), std::string("\x00", 1),
                                     std::string(1600, '\x3f'), std::string()})
        expectRefused(
            "block.pcd",
            cloud(small, test::little32(static_cast<std::uint32_t>(block.size())) + test::little32(1600) + block),
            {"LZF"});
}

TEST_F(ImportHostileTest, CloudThatIsNoPhotograph) {
    std::string text = fields("20", "15", "ascii");
    for (int i = 0; i < 300; ++i) text += std::to_string(i * 37 % 101) + " " + std::to_string(i * 53 % 97) + " 1 0\n";
    expectRefused("random.pcd", cloud(text, ""), {"pin-hole"});
}

TEST_F(ImportHostileTest, CameraRawIsNoPhotograph) {
    const auto little = [](std::size_t value, std::size_t size) {
        std::string bytes;
        for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8U * i & 0xffU);
        return bytes;
    };
    const auto entry = [&](std::size_t tag, std::size_t type, std::size_t count, std::size_t value) {
        return little(tag, 2) + little(type, 2) + little(count, 4) + little(value, 4);
    };
    // A preview, and the sensor's values in a directory below it.
    const auto raw = [&](std::size_t photometric, std::size_t next) {
        return std::string("II*\0", 4) + little(8, 4) + little(2, 2) + entry(254, 4, 1, 1) + entry(330, 4, 1, 40) +
               little(next, 4) + little(0, 2) + little(2, 2) + entry(254, 4, 1, 0) + entry(262, 3, 1, photometric) +
               little(next, 4);
    };
    expectRefused("mosaic.dng", raw(32803, 0), {"camera raw", "developed"});
    expectRefused("linear.dng", raw(34892, 0), {"camera raw"});
    expectRefused("f.raf", "FUJIFILMCCD-RAW 0201", {"camera raw"});
    expectRefused("c.cr3", std::string("\0\0\0\x18", 4) + "ftypcrx isom", {"camera raw"});
    test::writeBytes(folder / "mosaic.dng", raw(32803, 0));
    core::CreateOptions options;
    options.color = options.depth = folder / "mosaic.dng";
    test::expectError(ErrorKind::Input, {"camera raw"}, [&] { (void)core::createScene(options); });
    // Directories in a circle, and those beyond the end.
    for (const std::size_t next : {std::size_t{8}, std::size_t{40}, std::size_t{0xfffffff0U}})
        expectRefused("round.tif", raw(2, next), {});
    expectNoCrash("r.dng", raw(32803, 0), 1, 1);
}

TEST_F(ImportHostileTest, DamagedHeic) {
    const std::vector<std::uint8_t> plane(64 * 64, 100);
    const test::HevcPicture picture = test::encodeHevc(64, 64, {plane});
    const test::HevcPicture color = test::encodeHevc(64, 64, {plane, plane, plane});
    const std::string apple = test::appleXmp("1", "3", 64, 64, {100, 0, 0, 0, 101, 0, 30, 30, 1});
    const std::string whole = test::heicFile(color, picture, picture, apple, 0);
    core::CreateOptions options;
    test::writeBytes(folder / "ok.heic", whole);
    options.color = folder / "ok.heic";
    EXPECT_GT(core::createScene(options).photo->depth(9, 9), 0);
    expectRefused("noxmp.heic", test::heicFile(color, picture, picture, "nothing", 0), {"AuxiliaryImageType"});
    expectRefused("cut.heic", whole.substr(0, whole.size() / 2), {});
    expectRefused("head.heic", whole.substr(0, 40), {});
    expectNoCrash("d.heic", whole, 4, 17);
    expectNoCrash("t.heic", test::heicFile(color, picture, picture, apple, 0, 2, 2, {5, 1}), 4, 17);
}
