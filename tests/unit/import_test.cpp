// SPDX-License-Identifier: GPL-3.0-or-later
// Photographs that carry their depth, from files made here.
#include <OpenImageIO/deepdata.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/color.h"
#include "core/io/depth_beside.h"
#include "core/io/import/import_format.h"
#include "core/io/import/lzf.h"
#include "core/io/import/xmp.h"
#include "core/io/orientation.h"
#include "core/io/photo_contents.h"
#include "core/io/photo_loader.h"
#include "core/io/project.h"
#include "tests/support/expect_error.h"
#include "tests/support/photo_containers.h"

using core::DepthKind;
using core::ErrorKind;

namespace {

const std::string kGoogle =
    "xmlns:GDepth=\"http://ns.google.com/photos/1.0/depthmap/\" "
    "xmlns:GImage=\"http://ns.google.com/photos/1.0/image/\"";

class ImportTest : public testing::Test {
  protected:
    core::ImportedPhoto import(const std::string& path, const char* nameContains) {
        const core::ImportFile file(path);
        const core::ImportFormat* format = core::findImportFormat(file);
        if (format == nullptr) throw std::runtime_error("no import format recognises " + path);
        EXPECT_THAT(format->name, testing::HasSubstr(nameContains));
        return format->read(file);
    }

    std::string grey(int width, int height, std::uint8_t value) {
        return test::plainJpeg(folder, width, height, 1,
                               std::vector<std::uint8_t>(static_cast<std::size_t>(width * height), value));
    }

    /// A JPEG of 6x4 pixels whose depth map has the values 0, 10, 20, ... as red, green and blue.
    void writeGdepth(const std::string& path, const std::string& attributes, int orientation = 1,
                     const std::string& sharp = {}) {
        std::vector<std::string> rows;
        for (int y = 0; y < 4; ++y) {
            std::string& row = rows.emplace_back();
            for (int x = 0; x < 6; ++x)
                row += std::string(3, static_cast<char>(10 * (6 * y + x))) + static_cast<char>(255);
        }
        std::string data = "GDepth:Data=\"" + test::base64(test::pngBytes(6, 4, 8, 6, rows)) + "\"";
        if (!sharp.empty()) data += " GImage:Data=\"" + test::base64(sharp) + "\"";
        const std::string segments =
            test::exifSegment(orientation) +
            test::xmpSegment(test::xmpText(
                kGoogle + " xmlns:xmpNote=\"http://ns.adobe.com/xmp/note/\"",
                attributes + " GDepth:Mime=\"image/png\" xmpNote:HasExtendedXMP=\"" + test::kGuid + "\"")) +
            test::extendedXmpSegment("of another packet", 0, 17, "FFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF") +
            test::extendedXmp(test::xmpText(kGoogle, data), 100);
        test::writeBytes(path, test::withSegments(grey(6, 4, 50), segments));
    }

    test::TempFolder folder;
};

float linear(int value) { return core::srgbDecode(static_cast<float>(value) / 255.0f); }

std::string element(const std::string& name, const std::string& value) {
    return "<" + name + ">" + value + "</" + name + ">";
}

}  // namespace

TEST_F(ImportTest, GoogleDepthInSeveralPartsOfExtendedXmp) {
    writeGdepth(folder / "g.jpg", "GDepth:Format=\"RangeInverse\" GDepth:Near=\"2\" GDepth:Far=\"10\"", 1,
                grey(6, 4, 200));
    const core::ImportedPhoto photo = import(folder / "g.jpg", "Google");
    ASSERT_EQ(photo.depth.width(), 6);
    ASSERT_EQ(photo.depth.height(), 4);
    for (int i = 0; i < 24; ++i) {
        const double n = 10 * i / 255.0;
        EXPECT_NEAR(photo.depth(i % 6, i / 6), 1 / (n / 10 + (1 - n) / 2), 1e-5) << i;
    }
    EXPECT_EQ(photo.kind, DepthKind::Z);
    EXPECT_EQ(photo.unit, 1.0);
    EXPECT_THAT(photo.assumedUnit.english(), testing::HasSubstr("g.jpg"));
    EXPECT_NEAR(photo.color(3, 2).x(), linear(200), 0.01) << "the sharp picture, not the blurred one";
    EXPECT_FALSE(photo.camera.has_value());
}

TEST_F(ImportTest, GoogleDepthLinearAlongTheRayInMillimetres) {
    writeGdepth(folder / "g.jpg",
                "GDepth:Format=\"RangeLinear\" GDepth:Near=\"1000\" GDepth:Far=\"3550\" GDepth:Units=\"mm\" "
                "GDepth:MeasureType=\"OpticRay\"");
    const core::ImportedPhoto photo = import(folder / "g.jpg", "Google");
    EXPECT_NEAR(photo.depth(5, 1), 1000 + 10 * 110, 1e-3);
    EXPECT_EQ(photo.unit, 0.001);
    EXPECT_EQ(photo.assumedUnit, "");
    EXPECT_EQ(photo.kind, DepthKind::Distance);
    EXPECT_NEAR(photo.color(3, 2).x(), linear(50), 0.01);
}

TEST_F(ImportTest, GoogleDepthInTheSecondPacketWithCommasAndOtherUnits) {
    const std::string rating =
        test::xmpSegment(test::xmpText("xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\"", "xmp:Rating=\"5\""));
    const auto read = [&](const std::string& units) {
        writeGdepth(folder / "g.jpg", "GDepth:Format=\"RangeLinear\" GDepth:Near=\"0,5\" GDepth:Far=\"3,05\" " + units);
        test::writeBytes(folder / "g.jpg", test::withSegments(test::readBytes(folder / "g.jpg"), rating));
        return import(folder / "g.jpg", "Google");
    };
    const core::ImportedPhoto photo = read("GDepth:Units=\"cm\"");
    EXPECT_NEAR(photo.depth(5, 1), 0.5 + 0.01 * 110, 1e-5);
    EXPECT_EQ(photo.unit, 0.01);
    EXPECT_EQ(photo.assumedUnit, "");
    EXPECT_EQ(read("GDepth:Units=\"Meters\"").assumedUnit, "");
    EXPECT_THAT(read("GDepth:Units=\"furlong\"").assumedUnit.english(), testing::HasSubstr("\"furlong\""));
    EXPECT_THAT(read("").assumedUnit.english(), testing::HasSubstr("has no unit"));
}

TEST_F(ImportTest, DepthTurnsWithThePhotograph) {
    const std::string range = "GDepth:Format=\"RangeLinear\" GDepth:Near=\"0\" GDepth:Far=\"255\"";
    writeGdepth(folder / "up.jpg", range);
    const core::ImageF stored = import(folder / "up.jpg", "Google").depth;
    for (int orientation = 2; orientation <= 8; ++orientation) {
        writeGdepth(folder / "turned.jpg", range, orientation, grey(6, 4, 200));
        const core::ImportedPhoto photo = import(folder / "turned.jpg", "Google");
        EXPECT_EQ(photo.color.width(), orientation >= 5 ? 4 : 6) << orientation;
        EXPECT_EQ(photo.depth, core::applyOrientation(stored, orientation)) << orientation;
    }
}

TEST_F(ImportTest, TheCameraTurnsLikeThePixels) {
    const core::Camera stored{6, 4, 10, 12, 1.5f, 3.5f};
    core::ImageF picture(6, 4, 0.0f);
    picture(1, 3) = 1;  // the pixel whose centre is the principal point
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const core::ImageF turned = core::applyOrientation(picture, orientation);
        const core::Camera camera = core::orientCamera(stored, orientation);
        EXPECT_EQ(camera.width, turned.width()) << orientation;
        EXPECT_EQ(camera.height, turned.height()) << orientation;
        EXPECT_EQ(turned(static_cast<int>(camera.cx - 0.5f), static_cast<int>(camera.cy - 0.5f)), 1) << orientation;
        EXPECT_EQ(camera.fx, orientation >= 5 ? 12 : 10) << orientation;
    }
}

TEST_F(ImportTest, XdmWithEntitiesInItsText) {
    std::vector<std::string> rows;
    for (const int value : {0, 1861, 65535, 40000})
        rows.push_back(test::bigEndian16(static_cast<std::size_t>(value)) + test::bigEndian16(500));
    std::string data;
    for (const char c : test::base64(test::pngBytes(2, 4, 16, 0, rows))) {
        data += c;
        if (data.size() % 7 == 0) data += "&#xA;";
    }
    // Prefixes are free: other ones than the usual.
    const auto file = [&](const std::string& metric) {
        const std::string camera =
            element("C:DepthMap rdf:parseType='Resource'",
                    element("M:Data", data) + element("M:Format", "RangeLinear") + element("M:Near", "0.000000") +
                        element("M:Far", "65535.000000") + element("M:Metric", metric)) +
            element("C:ImagingModel rdf:parseType='Resource'",
                    element("P:FocalLengthX", "0.9") + element("P:FocalLengthY", "0.8") +
                        element("P:PrincipalPointX", "0.54") + element("P:PrincipalPointY", "0.5"));
        std::string text = test::xmpText(
            "xmlns:D='http://ns.xdm.org/photos/1.0/device/' xmlns:C='http://ns.xdm.org/photos/1.0/camera/' "
            "xmlns:M='http://ns.xdm.org/photos/1.0/depthmap/' "
            "xmlns:P='http://ns.xdm.org/photos/1.0/perspectivemodel/'",
            "", element("D:Cameras", element("rdf:Seq", element("rdf:li rdf:parseType='Resource'", camera))));
        for (const std::string tag : {"C:DepthMap", "C:ImagingModel", "rdf:li"}) {
            const std::string wrong = "</" + tag + " rdf:parseType='Resource'>";
            text.replace(text.find(wrong), wrong.size(), "</" + tag + ">");
        }
        return test::withSegments(grey(20, 40, 90), test::xmpSegment(text));
    };
    test::writeBytes(folder / "x.jpg", file("False"));
    const core::ImportedPhoto photo = import(folder / "x.jpg", "XDM");
    EXPECT_EQ(photo.unit, 0.001);
    EXPECT_THAT(photo.assumedUnit.english(), testing::HasSubstr("millimetre"));
    EXPECT_NEAR(photo.depth(0, 1), 1861, 1e-3);
    EXPECT_NEAR(photo.depth(1, 3), 500, 1e-3);
    EXPECT_EQ(photo.depth(0, 2), 0) << "saturated: nothing measured";
    ASSERT_TRUE(photo.camera.has_value());
    EXPECT_NEAR(photo.camera->fx, 0.9 * 40, 1e-4);
    EXPECT_NEAR(photo.camera->fy, 0.8 * 40, 1e-4);
    EXPECT_NEAR(photo.camera->cx, 0.54 * 20, 1e-4);
    EXPECT_NEAR(photo.camera->cy, 0.5 * 40, 1e-4);

    test::writeBytes(folder / "metric.jpg", file("True"));
    const core::ImportedPhoto metric = import(folder / "metric.jpg", "XDM");
    EXPECT_EQ(metric.unit, 1.0);
    EXPECT_EQ(metric.assumedUnit, "");
}

TEST_F(ImportTest, DynamicDepthBehindAConfidenceMap) {
    const std::string confidence = grey(6, 4, 255);
    const std::string depth = grey(6, 4, 100);
    const std::string model =
        "<Camera:Image Image:ItemSemantic='Primary' Image:ItemURI='primary'/><Camera:ImagingModel "
        "ImagingModel:FocalLengthX='800' ImagingModel:FocalLengthY='808' ImagingModel:ImageWidth='48' "
        "ImagingModel:ImageHeight='32' ImagingModel:PrincipalPointX='24' ImagingModel:PrincipalPointY='12'/>";
    const auto read = [&](const std::string& units, int orientation, bool plain) {
        const std::string xmp = test::dynamicDepthXmp(
            {{"confidence", std::to_string(confidence.size()), "3"}, {"depth", std::to_string(depth.size())}},
            "DepthMap:ItemSemantic='Depth' DepthMap:Format='RangeInverse' DepthMap:Near='1' DepthMap:Far='3' "
            "DepthMap:DepthURI='depth' DepthMap:ConfidenceURI='confidence' DepthMap:Units='" +
                units + "'",
            model, plain);
        test::writeBytes(folder / "d.jpg",
                         test::withSegments(grey(6, 4, 50), test::exifSegment(orientation) + test::xmpSegment(xmp)) +
                             confidence + "pad" + depth);
        return import(folder / "d.jpg", "Dynamic Depth");
    };
    for (const bool plain : {false, true}) {
        const core::ImportedPhoto photo = read("Meters", 1, plain);
        EXPECT_NEAR(photo.depth(3, 2), 3 / (3 - 100 / 255.0 * 2), 1e-5);
        EXPECT_EQ(photo.kind, DepthKind::Z);
        EXPECT_EQ(photo.unit, 1.0);
        EXPECT_EQ(photo.assumedUnit, "");
        ASSERT_TRUE(photo.camera.has_value());
        EXPECT_EQ(photo.camera->width, 6);
        EXPECT_NEAR(photo.camera->fx, 100, 1e-4);
        EXPECT_NEAR(photo.camera->fy, 101, 1e-4);
        EXPECT_NEAR(photo.camera->cx, 3, 1e-4);
        EXPECT_NEAR(photo.camera->cy, 1.5, 1e-4);
    }
    const core::ImportedPhoto turned = read("Millimeters", 6, false);
    EXPECT_EQ(turned.unit, 0.001);
    EXPECT_EQ(turned.depth.width(), 4);
    EXPECT_EQ(turned.camera->width, 4);
    EXPECT_NEAR(turned.camera->fx, 101, 1e-4);
    EXPECT_NEAR(turned.camera->cx, 2.5, 1e-4);
    EXPECT_THAT(read("None", 1, false).assumedUnit.english(), testing::HasSubstr("has no unit"));
    EXPECT_THAT(read("Diopters", 1, false).assumedUnit.english(),
                testing::HasSubstr("\"Diopters\", which is not known"));
}

TEST_F(ImportTest, DynamicDepthOfASharpPictureInExtendedXmp) {
    const std::string sharp = grey(6, 4, 200);
    std::vector<std::string> rows(4);
    for (std::string& row : rows)
        for (std::size_t x = 0; x < 6; ++x) row += test::bigEndian16(10'000 * x);
    const std::string depth = test::pngBytes(6, 4, 16, 0, rows);
    const std::string xmp = test::dynamicDepthXmp(
        {{"original", std::to_string(sharp.size())}, {"depth", std::to_string(depth.size())}},
        "DepthMap:Format='RangeLinear' DepthMap:Near='0.5' DepthMap:Far='7.0535' DepthMap:DepthURI='depth' "
        "DepthMap:Units='Meters' DepthMap:MeasureType='OpticRay'",
        "<Camera:Image Image:ItemSemantic='Original' Image:ItemURI='original'/>");
    const std::string standard = test::xmpText("xmlns:xmpNote=\"http://ns.adobe.com/xmp/note/\"",
                                               "xmpNote:HasExtendedXMP=\"" + test::kGuid + "\"");
    test::writeBytes(
        folder / "s.jpg",
        test::withSegments(grey(6, 4, 50), test::xmpSegment(standard) + test::extendedXmp(xmp, 300)) + sharp + depth);
    const core::ImportedPhoto photo = import(folder / "s.jpg", "Dynamic Depth");
    EXPECT_NEAR(photo.color(3, 2).x(), linear(200), 0.01) << "the sharp picture, not the blurred one";
    for (int x = 0; x < 6; ++x) EXPECT_NEAR(photo.depth(x, 2), 0.5 + x, 1e-4);
    EXPECT_EQ(photo.kind, DepthKind::Distance);
    EXPECT_FALSE(photo.camera.has_value());
}

TEST_F(ImportTest, AppleDisparityInTheSecondPicture) {
    std::vector<std::uint8_t> ramp;
    for (int i = 0; i < 16 * 8; ++i) ramp.push_back(static_cast<std::uint8_t>(i % 16 * 16 + 7));
    const std::string apple = test::appleXmp("0.5", "2.5", 64, 32, {50, 0, 0, 0, 51, 0, 20, 15, 1});
    const std::string second = test::withSegments(test::plainJpeg(folder, 16, 8, 1, ramp), test::xmpSegment(apple));
    const std::string front = grey(32, 16, 128);
    test::writeBytes(folder / "m.jpg", test::mpfFile(front, test::exifSegment(1), second));
    const core::ImportedPhoto photo = import(folder / "m.jpg", "MPF");
    EXPECT_EQ(photo.kind, DepthKind::Disparity);
    ASSERT_EQ(photo.depth.width(), 16);
    EXPECT_NEAR(photo.depth(3, 4), 0.5 + (3 * 16 + 7) / 255.0 * 2, 0.02) << "JPEG, quality 100";
    ASSERT_TRUE(photo.camera.has_value());
    EXPECT_EQ(*photo.camera, (core::Camera{32, 16, 25, 25.5f, 10, 7.5f}));
    ASSERT_EQ(photo.remarks.size(), 1U);
    EXPECT_THAT(photo.remarks[0].english(), testing::HasSubstr("relative"));

    const core::PhotoContents contents = core::inspectPhoto(folder / "m.jpg");
    EXPECT_EQ(contents.kind, DepthKind::Disparity);
    EXPECT_EQ(contents.width, 32);
    EXPECT_EQ(contents.depthWidth, 16);
    EXPECT_EQ(contents.depthHeight, 8);
    EXPECT_EQ(contents.unit, photo.unit);
    EXPECT_NEAR(contents.hfov.value(), 2 * std::atan(16 / 25.0f), 1e-5f);
    EXPECT_THAT(contents.depthPlace.english(), testing::HasSubstr("MPF"));

    test::writeBytes(folder / "turned.jpg", test::mpfFile(front, test::exifSegment(6), second));
    const core::ImportedPhoto turned = import(folder / "turned.jpg", "MPF");
    EXPECT_EQ(turned.depth, core::applyOrientation(photo.depth, 6));
    EXPECT_EQ(*turned.camera, (core::Camera{16, 32, 25.5f, 25, 8.5f, 10}));
}

TEST_F(ImportTest, AppleDisparityWhoseIndexHasMoved) {
    const std::string apple = test::appleXmp("0.5", "2.5", 32, 16, {50, 0, 0, 0, 51, 0, 20, 15, 1});
    const std::string second = test::withSegments(grey(16, 8, 100), test::xmpSegment(apple));
    const std::string front = grey(32, 16, 128);
    const std::string whole = test::mpfFile(front, "", second);
    test::writeBytes(folder / "whole.jpg", whole);
    const core::ImageF depth = import(folder / "whole.jpg", "MPF").depth;
    // Another program puts a segment before the index, and leaves its offsets.
    const std::string keyword = test::jpegSegment(0xed, std::string(566, 'k'));
    test::writeBytes(folder / "moved.jpg", test::withSegments(whole, keyword));
    EXPECT_EQ(import(folder / "moved.jpg", "MPF").depth, depth);
    test::writeBytes(folder / "tail.jpg", test::withSegments(whole, keyword) + std::string(5000, 'v'));
    EXPECT_EQ(import(folder / "tail.jpg", "MPF").depth, depth);
    test::writeBytes(folder / "noindex.jpg", test::withSegments(front, keyword) + second);
    EXPECT_EQ(import(folder / "noindex.jpg", "MPF").depth, depth);

    const std::string first = whole.substr(0, whole.size() - second.size());
    for (const std::string& tail : {std::string(), std::string(5000, 'v')}) {
        test::writeBytes(folder / "dropped.jpg", first + tail);
        const core::ImportedPhoto photo = import(folder / "dropped.jpg", "MPF");
        EXPECT_TRUE(photo.depth.empty());
        ASSERT_EQ(photo.remarks.size(), 1U);
        EXPECT_THAT(photo.remarks[0].english(), testing::HasSubstr("another program dropped it"));
    }
}

TEST_F(ImportTest, DepthOfAnotherFileKeepsItsMeaning) {
    const std::string apple = test::appleXmp("0.5", "2.5", 32, 16, {50, 0, 0, 0, 51, 0, 20, 10, 1});
    const std::string second = test::withSegments(grey(16, 8, 100), test::xmpSegment(apple));
    test::writeBytes(folder / "phone.jpg", test::mpfFile(grey(32, 16, 128), "", second));
    test::writeBytes(folder / "developed.jpg", grey(64, 32, 90));
    core::CreateOptions options;
    options.color = folder / "developed.jpg";
    options.depth = folder / "phone.jpg";
    core::Notes notes;
    const core::Scene scene = core::createScene(options, &notes);
    EXPECT_EQ(scene.photo->camera, (core::Camera{64, 32, 100, 102, 40, 20}));
    EXPECT_EQ(scene.photo->source.depthKind, DepthKind::Disparity);
    EXPECT_NEAR(scene.photo->depth(30, 20), 1 / (0.5 + 100 / 255.0 * 2), 0.01);
    EXPECT_NEAR(scene.photo->color.image()(3, 3).x(), linear(90), 0.01) << "the developed picture";
    EXPECT_THAT(core::english(notes),
                testing::Contains(testing::HasSubstr("intrinsics are taken from \"" + options.depth)));
    core::saveProject(scene, folder / "p.patina");
    EXPECT_EQ(core::loadProject(folder / "p.patina").photo->depth.image(), scene.photo->depth.image());

    test::writeBytes(folder / "small.jpg", grey(8, 4, 90));
    options.color = folder / "small.jpg";
    const core::Scene small = core::createScene(options, &notes);
    EXPECT_EQ(small.photo->depth.width(), 8) << "smaller than the depth that the phone stored";
    EXPECT_NEAR(small.photo->depth(4, 2), 1 / (0.5 + 100 / 255.0 * 2), 0.01);
    EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr("is reduced to the colour image (8x4)")));

    test::writeBytes(folder / "square.jpg", grey(32, 32, 90));
    options.color = folder / "square.jpg";
    test::expectError(ErrorKind::Input, {"16x8", "32x32", "phone.jpg"}, [&] { (void)core::createScene(options); });
}

TEST_F(ImportTest, HeicTakesTheDepthAndNotTheGainMap) {
    const int w = 256;
    const int h = 128;
    std::vector<std::vector<std::uint8_t>> color(3, std::vector<std::uint8_t>(static_cast<std::size_t>(w * h), 60));
    for (int y = 0; y < h / 2; ++y) std::fill_n(color[0].begin() + y * w, w / 2, std::uint8_t{220});
    std::vector<std::uint8_t> disparity;
    for (int y = 0; y < h / 2; ++y)
        for (int x = 0; x < w / 2; ++x) disparity.push_back(static_cast<std::uint8_t>(x + y));
    const std::vector<std::uint8_t> white(disparity.size(), 255);
    const test::HevcPicture colorPicture = test::encodeHevc(w, h, color);
    const test::HevcPicture gain = test::encodeHevc(w / 2, h / 2, {white});
    const test::HevcPicture depth = test::encodeHevc(w / 2, h / 2, {disparity});
    const std::string apple = test::appleXmp("1", "3", w, h, {100, 0, 0, 0, 101, 0, 60, 40, 1});

    test::writeBytes(folder / "h.heic", test::heicFile(colorPicture, gain, depth, apple, 0));
    const core::ImportedPhoto photo = import(folder / "h.heic", "HEIC");
    ASSERT_EQ(photo.depth.width(), w / 2);
    ASSERT_EQ(photo.depth.height(), h / 2);
    for (int x = 0; x < w / 2; x += 7) EXPECT_NEAR(photo.depth(x, 40), 1 + 2 * (x + 40) / 255.0, 1e-5) << x;
    EXPECT_EQ(photo.kind, DepthKind::Disparity);
    EXPECT_EQ(*photo.camera, (core::Camera{w, h, 100, 101, 60, 40}));
    EXPECT_NEAR(photo.color(20, 20).x(), linear(220), 0.05);
    EXPECT_NEAR(photo.color(20, 20).z(), linear(60), 0.05);

    // A quarter turn clockwise: three counter-clockwise ones, EXIF orientation 6.
    test::writeBytes(folder / "turned.heic", test::heicFile(colorPicture, gain, depth, apple, 3));
    const core::ImportedPhoto turned = import(folder / "turned.heic", "HEIC");
    EXPECT_EQ(turned.color.width(), h);
    EXPECT_EQ(turned.depth, core::applyOrientation(photo.depth, 6));
    EXPECT_NEAR(turned.color(h - 20, 20).x(), linear(220), 0.05);
    EXPECT_EQ(*turned.camera, (core::Camera{h, w, 101, 100, h - 40, 60}));
}

TEST_F(ImportTest, HeicWhoseDepthBelongsToTwoPictures) {
    std::vector<std::uint8_t> ramp;
    for (int i = 0; i < 64 * 64; ++i) ramp.push_back(static_cast<std::uint8_t>(i % 64 * 3));
    const test::HevcPicture grey = test::encodeHevc(64, 64, {ramp});
    const test::HevcPicture color = test::encodeHevc(64, 64, {ramp, ramp, ramp});
    const std::string apple = test::appleXmp("1", "3", 64, 64, {100, 0, 0, 0, 101, 0, 30, 30, 1});
    const auto read = [&](const std::vector<std::size_t>& targets) {
        test::writeBytes(folder / "h.heic", test::heicFile(color, grey, grey, apple, 1, 2, 2, targets));
        return import(folder / "h.heic", "HEIC");
    };
    const core::ImportedPhoto one = read({1});
    for (const std::vector<std::size_t>& targets : {std::vector<std::size_t>{1, 5}, {5, 1}, {5, 1, 5}}) {
        const core::ImportedPhoto photo = read(targets);
        EXPECT_EQ(photo.depth, one.depth);
        EXPECT_EQ(photo.color, one.color);
        EXPECT_EQ(photo.camera, one.camera);
        EXPECT_EQ(photo.kind, DepthKind::Disparity);
    }
    // A last box without size ends where the file did.
    std::string open = test::heicFile(color, grey, grey, apple, 1, 2, 2, {5, 1});
    open.replace(open.find("mdat") - 4, 4, std::string(4, '\0'));
    test::writeBytes(folder / "open.heic", open);
    EXPECT_EQ(import(folder / "open.heic", "HEIC").depth, one.depth);
}

TEST_F(ImportTest, HeicColorIsDecodedByItsNclx) {
    const int w = 64;
    std::vector<std::vector<std::uint8_t>> planes(3);
    const std::vector<std::uint8_t> patch{160, 100, 60};
    for (std::size_t c = 0; c < 3; ++c) planes[c].assign(static_cast<std::size_t>(w * w), patch[c]);
    const test::HevcPicture color = test::encodeHevc(w, w, planes);
    const test::HevcPicture grey = test::encodeHevc(w, w, {planes[0]});
    const std::string apple = test::appleXmp("1", "3", w, w, {100, 0, 0, 0, 101, 0, 60, 40, 1});
    const auto read = [&](std::size_t primaries, std::size_t transfer) -> core::Vector3f {
        test::writeBytes(folder / "c.heic", test::heicFile(color, grey, grey, apple, 0, primaries, transfer));
        return import(folder / "c.heic", "HEIC").color(32, 32);
    };
    // What the encoder makes of the patch: the same bytes as linear light of Rec.709.
    const core::Vector3f coded = read(1, 8);
    ASSERT_NEAR(coded.x(), 160 / 255.0, 0.02);
    const auto each = [&](const auto& decode) -> core::Vector3f { return coded.unaryExpr(decode); };
    const auto expect = [](const core::Vector3f& a, const core::Vector3f& b) {
        EXPECT_LT((a - b).norm(), 2e-3f) << a.transpose() << " against " << b.transpose();
    };
    const core::Vector3f srgb = each([](float v) { return core::srgbDecode(v); });
    expect(read(1, 13), srgb);
    expect(read(2, 2), srgb);
    expect(read(1, 1), each([](float v) { return std::pow((v + 0.0993f) / 1.0993f, 1 / 0.45f); }));
    expect(read(1, 4), each([](float v) { return std::pow(v, 2.2f); }));
    // Linear P3 with white D65 to linear Rec.709 (SMPTE EG 432-1), and Rec.2020 (ITU-R BT.2087).
    Eigen::Matrix3f p3, rec2020;
    p3 << 1.2249f, -0.2247f, 0, -0.0420f, 1.0419f, 0, -0.0197f, -0.0786f, 1.0979f;
    rec2020 << 1.6605f, -0.5876f, -0.0728f, -0.1246f, 1.1329f, -0.0083f, -0.0182f, -0.1006f, 1.1187f;
    expect(read(12, 13), p3 * srgb);
    expect(read(9, 8), (rec2020 * coded).cwiseMax(0.0f));
    for (const std::size_t transfer : {9U, 16U, 18U})
        test::expectError(ErrorKind::Input, {"c.heic", "transfer function " + std::to_string(transfer)},
                          [&] { read(1, transfer); });
}

namespace {

/// A raster of points seen by a pin-hole camera, f = 20 x 25 px, c = (9.25, 7.5); every seventh is missing.
std::vector<float> cloudPoints(int width, int height) {
    std::vector<float> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float z = (x + y * width) % 7 == 0 ? std::nanf("") : 1.0f + 0.01f * static_cast<float>(x * y);
            values.push_back((static_cast<float>(x) + 0.5f - 9.25f) / 20 * z);
            values.push_back((static_cast<float>(y) + 0.5f - 7.5f) / 25 * z);
            values.push_back(z);
        }
    return values;
}

std::string cloudHeader(int width, int height, const std::string& data) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\n"
           "COUNT 1 1 1 1\nWIDTH " +
           std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
           std::to_string(width * height) + "\nDATA " + data + "\n";
}

std::string raw(const void* value) { return {static_cast<const char*>(value), 4}; }

/// LZF with literal runs only.
std::string literalLzf(const std::string& bytes) {
    std::string block;
    for (std::size_t i = 0; i < bytes.size(); i += 32) {
        const std::string run = bytes.substr(i, 32);
        block += static_cast<char>(run.size() - 1);
        block += run;
    }
    return block;
}

}  // namespace

TEST_F(ImportTest, PointCloudsInEveryLayout) {
    const int w = 20;
    const int h = 15;
    const std::vector<float> points = cloudPoints(w, h);
    std::string text = cloudHeader(w, h, "ascii");
    std::string binary;
    std::string fields[4];
    for (std::uint32_t i = 0; i < w * h; ++i) {
        const std::uint32_t argb = 0xff000000U | i % 200 << 16U | 100U << 8U | 30U;
        for (std::size_t k = 0; k < 3; ++k) {
            const float value = points[3 * i + k];
            text += (std::isnan(value) ? "nan" : std::to_string(value)) + " ";
            binary += raw(&value);
            fields[k] += raw(&value);
        }
        text += std::to_string(argb) + "\n";
        binary += raw(&argb);
        fields[3] += raw(&argb);
    }
    const std::string block = literalLzf(fields[0] + fields[1] + fields[2] + fields[3]);
    const auto packed = static_cast<std::uint32_t>(block.size());
    const auto unpacked = static_cast<std::uint32_t>(binary.size());
    test::writeBytes(folder / "text.pcd", text);
    test::writeBytes(folder / "binary.pcd", cloudHeader(w, h, "binary") + binary);
    test::writeBytes(folder / "packed.pcd",
                     cloudHeader(w, h, "binary_compressed") + raw(&packed) + raw(&unpacked) + block);
    for (const char* name : {"text.pcd", "binary.pcd", "packed.pcd"}) {
        SCOPED_TRACE(name);
        const core::ImportedPhoto photo = import(folder / name, "PCD");
        ASSERT_EQ(photo.depth.width(), w);
        ASSERT_EQ(photo.depth.height(), h);
        EXPECT_NEAR(photo.depth(3, 4), 1.12f, 1e-5);
        EXPECT_TRUE(std::isnan(photo.depth(0, 0)));
        EXPECT_NEAR(photo.camera->fx, 20, 1e-3);
        EXPECT_NEAR(photo.camera->fy, 25, 1e-3);
        EXPECT_NEAR(photo.camera->cx, 9.25, 1e-3);
        EXPECT_NEAR(photo.camera->cy, 7.5, 1e-3);
        EXPECT_NEAR(photo.color(3, 4).x(), linear(83), 1e-5);
        EXPECT_NEAR(photo.color(3, 4).y(), linear(100), 1e-5);
        EXPECT_NEAR(photo.color(3, 4).z(), linear(30), 1e-5);
    }
}

TEST_F(ImportTest, PointsWithoutXOrYAreHoles) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const int w = 20, h = 15;
    std::string points;
    for (int v = 0; v < h; ++v)
        for (int u = 0; u < w; ++u) {
            const float z = u < 3 ? 5 : 1;
            const float x = u == 0 || u == 1 ? nan : (static_cast<float>(u) + 0.5f - 10) / 20 * z;
            const float y = u == 0 || u == 2 ? nan : (static_cast<float>(v) + 0.5f - 7) / 20 * z;
            const std::uint32_t color = 0xff808080U;
            points += raw(&x) + raw(&y) + raw(&z) + raw(&color);
        }
    test::writeBytes(folder / "p.pcd", cloudHeader(w, h, "binary") + points);
    const core::ImageF depth = import(folder / "p.pcd", "PCD").depth;
    for (int u = 0; u < w; ++u) EXPECT_EQ(std::isnan(depth(u, 4)), u < 3) << u;
    EXPECT_EQ(depth(3, 4), 1);
}

TEST_F(ImportTest, LzfReferencesThatOverlap) {
    // "abc", then 9 bytes from 3 back (they repeat "abc"), then 20 bytes from 1 back, by a long reference.
    const std::string block = std::string(
                                  "\x02"
                                  "abc\xe0\x00\x02",
                                  7) +
                              std::string("\xe0\x0b\x00", 3);
    EXPECT_EQ(core::lzfDecompress(block, 3 + 9 + 20), "abcabcabcabc" + std::string(20, 'c'));
    EXPECT_EQ(core::lzfDecompress(block, 31), std::nullopt);
    EXPECT_EQ(core::lzfDecompress(block, 33), std::nullopt);
}

TEST_F(ImportTest, Base64) {
    EXPECT_EQ(core::decodeBase64("UGF0\naW5h"), "Patina");
    EXPECT_EQ(core::decodeBase64(test::base64("Patina!")), "Patina!");
    EXPECT_EQ(core::decodeBase64(test::base64(std::string("\0\xff\x80", 3) + "x")), std::string("\0\xff\x80", 3) + "x");
    EXPECT_EQ(core::decodeBase64("UGF0*W5h"), std::nullopt);
    EXPECT_EQ(core::decodeBase64("UG=F0"), std::nullopt);
}

TEST_F(ImportTest, DepthOfPixelsCoveredInPartIsNotUsed) {
    const auto read = [&](const std::vector<float>& alphas) {
        OIIO::ImageSpec spec(4, 1, 5, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B", "A", "Z"};
        std::vector<float> pixels;
        for (const float alpha : alphas) pixels.insert(pixels.end(), {alpha, 0, 0, alpha, 5});
        test::writeWith("openexr", folder / "a.exr", spec, OIIO::TypeFloat, pixels.data());
        core::CreateOptions options;
        options.color = folder / "a.exr";
        const core::ImageF depth = core::createScene(options).photo->depth;
        return std::vector<float>(depth.pixels().begin(), depth.pixels().end());
    };
    EXPECT_EQ(read({1, 0.999f, 0.5f, 1}), (std::vector<float>{5, 5, 0, 5}));
    // A body of glass, or a file whose alpha is none.
    EXPECT_EQ(read({0.5f, 0.25f, 1, 0.5f}), (std::vector<float>{5, 5, 5, 5}));
    EXPECT_EQ(read({0, 0, 0, 0}), (std::vector<float>{5, 5, 5, 5}));
}

TEST_F(ImportTest, DeepExrIsFlattenedToOneSurfaceAPixel) {
    OIIO::ImageSpec spec(4, 2, 5, OIIO::TypeFloat);
    spec.channelnames = {"R", "G", "B", "A", "Z"};
    spec.deep = true;
    spec.x = 1;
    spec.full_width = 6;
    spec.full_height = 2;
    OIIO::DeepData samples(spec);
    const auto set = [&](std::int64_t pixel, const std::vector<std::array<float, 3>>& layers) {
        samples.set_samples(pixel, static_cast<int>(layers.size()));
        for (int s = 0; s < static_cast<int>(layers.size()); ++s) {
            const auto& [red, alpha, z] = layers[static_cast<std::size_t>(s)];
            const float values[] = {red, 0, 0, alpha, z};
            for (int c = 0; c < 5; ++c) samples.set_deep_value(pixel, c, s, values[c]);
        }
    };
    set(0, {{0.5f, 1, 3}});                    // one opaque surface
    set(1, {{0.1f, 0.25f, 2}, {0.8f, 1, 5}});  // a thin veil before it
    set(2, {{0.4f, 0.6f, 2}, {0.8f, 1, 5}});   // more than half covered
    set(3, {{0.2f, 0.25f, 2}});                // mostly empty
    set(4, {{0.8f, 1, 5}, {0.1f, 0.25f, 2}});  // out of order
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(folder / "deep.exr", spec) && output->write_deep_image(samples) && output->close())
        << output->geterror();

    const core::ImportedPhoto photo = import(folder / "deep.exr", "EXR");
    ASSERT_EQ(photo.depth.width(), 6);
    const float expected[] = {0, 3, 5, 2, 0, 0};
    for (int x = 0; x < 6; ++x) EXPECT_EQ(photo.depth(x, 0), expected[x]) << x;
    EXPECT_EQ(photo.depth(1, 1), 5);
    EXPECT_EQ(photo.depth(2, 1), 0) << "no samples";
    EXPECT_NEAR(photo.color(2, 0).x(), 0.1f + 0.75f * 0.8f, 1e-6);
    EXPECT_NEAR(photo.color(1, 1).x(), 0.1f + 0.75f * 0.8f, 1e-6);
    EXPECT_FALSE(photo.kind.has_value()) << "a renderer may store distances";
}

TEST_F(ImportTest, TheUserKnowsBetterThanTheFile) {
    std::vector<std::uint8_t> ramp(16 * 8, 200);
    const std::string apple = test::appleXmp("0.5", "2.5", 64, 32, {50, 0, 0, 0, 51, 0, 20, 15, 1});
    const std::string second = test::withSegments(test::plainJpeg(folder, 16, 8, 1, ramp), test::xmpSegment(apple));
    test::writeBytes(folder / "m.jpg", test::mpfFile(grey(32, 16, 128), test::exifSegment(1), second));
    core::CreateOptions options;
    options.color = folder / "m.jpg";
    core::Notes notes;
    const core::Scene scene = core::createScene(options, &notes);
    EXPECT_EQ(scene.photo->camera, (core::Camera{32, 16, 25, 25.5f, 10, 7.5f}));
    EXPECT_EQ(scene.photo->source.depthKind, DepthKind::Disparity);
    const double metres = 1 / (0.5 + 200 / 255.0 * 2);
    EXPECT_NEAR(scene.photo->depth(9, 9), metres, 0.01);
    EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr("intrinsics are taken from")));
    EXPECT_THAT(core::english(notes), testing::Contains(testing::HasSubstr("relative")));

    core::saveProject(scene, folder / "p.patina");
    const core::Scene again = core::loadProject(folder / "p.patina");
    EXPECT_EQ(again.photo->depth.image(), scene.photo->depth.image());
    EXPECT_EQ(again.photo->camera, scene.photo->camera);

    options.intrinsics = core::Camera{0, 0, 40, 40, 16, 8};
    options.depthUnit = 2;
    const core::Scene own = core::createScene(options);
    EXPECT_EQ(own.photo->camera.fx, 40);
    EXPECT_NEAR(own.photo->depth(9, 9), 2 * metres, 0.02);
    options.depthKind = DepthKind::Distance;
    notes.clear();
    const core::Scene other = core::createScene(options, &notes);
    EXPECT_NEAR(other.photo->depth(16, 8), 2 / metres, 0.02) << "straight ahead, so a distance is a depth";
    EXPECT_THAT(core::english(notes), testing::Contains(testing::AllOf(testing::HasSubstr("read as \"distance\""),
                                                                       testing::HasSubstr("\"disparity\""))));
    core::saveProject(other, folder / "other.patina");
    EXPECT_EQ(core::loadProject(folder / "other.patina").photo->depth.image(), other.photo->depth.image());
    options.depthKind = DepthKind::Z;
    const core::Scene planar = core::createScene(options);
    core::saveProject(planar, folder / "z.patina");
    EXPECT_EQ(core::loadProject(folder / "z.patina").photo->depth.image(), planar.photo->depth.image());
}

TEST_F(ImportTest, ASeparateDepthImageReplacesTheOneInside) {
    writeGdepth(folder / "g.jpg", "GDepth:Format=\"RangeInverse\" GDepth:Near=\"2\" GDepth:Far=\"10\"", 1,
                grey(6, 4, 200));
    test::writePfm(folder / "d.pfm", 6, 4, 1, std::vector<float>(24, 0.75f));
    core::CreateOptions options;
    options.color = folder / "g.jpg";
    options.depth = folder / "d.pfm";
    const core::Scene scene = core::createScene(options);
    EXPECT_EQ(scene.photo->depth(2, 2), 0.75f);
    EXPECT_NEAR(scene.photo->color(2, 2).x(), linear(50), 0.01) << "the picture that other programs show";
}

TEST_F(ImportTest, APictureWithoutDepthHasContentsToo) {
    OIIO::ImageSpec spec(40, 30, 3, OIIO::TypeUInt8);
    spec["Make"] = "Maker";
    spec["Model"] = "Maker Model 5";
    spec["Exif:FocalLengthIn35mmFilm"] = 28;
    const std::vector<std::uint8_t> pixels(40UL * 30 * 3, 90);
    test::writeWith("jpeg", folder / "plain.jpg", spec, OIIO::TypeUInt8, pixels.data());
    const core::PhotoContents contents = core::inspectPhoto(folder / "plain.jpg");
    EXPECT_EQ(contents.device, "Maker Model 5");
    EXPECT_EQ(contents.width, 40);
    EXPECT_TRUE(contents.depthPlace.empty());
    // 28 mm on a diagonal of 43.27 mm; the width is 4/5 of the diagonal.
    EXPECT_NEAR(contents.hfov.value(), 2 * std::atan(0.5 * 0.8 * 43.2666 / 28), 1e-4);
    test::expectError(ErrorKind::Input, {"none.jpg"}, [&] { (void)core::inspectPhoto(folder / "none.jpg"); });
}

TEST_F(ImportTest, AFileWithoutDepthSaysWhereItWasLookedFor) {
    test::writeBytes(folder / "plain.jpg", grey(6, 4, 50));
    core::CreateOptions options;
    options.color = folder / "plain.jpg";
    core::Notes notes;
    const core::Scene scene = core::createScene(options, &notes);
    EXPECT_TRUE(std::ranges::all_of(scene.photo->depth.pixels(), [](float z) { return z == 0; }));
    EXPECT_TRUE(scene.photo->depth.sameSize(scene.photo->color));
    const std::vector<std::string> said = core::english(notes);
    const auto note = std::ranges::find_if(
        said, [](const std::string& sentence) { return sentence.find("no depth map") != std::string::npos; });
    ASSERT_NE(note, said.end());
    for (const char* part : {"plain.jpg", "depth channel", "Google", "HEIC", "PCD", "cannot be changed"})
        EXPECT_THAT(*note, testing::HasSubstr(part));
    core::saveProject(scene, folder / "plain.patina");
    EXPECT_EQ(core::loadProject(folder / "plain.patina").photo->depth.image(), scene.photo->depth.image());
}

TEST_F(ImportTest, FilesThatWereReadGiveTheSamePhotograph) {
    writeGdepth(folder / "g.jpg", "GDepth:Format=\"RangeInverse\" GDepth:Near=\"2\" GDepth:Far=\"10\"", 1,
                grey(6, 4, 200));
    std::vector<float> ramp(6);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = 1 + static_cast<float>(i);
    test::writePfm(folder / "d.pfm", 3, 2, 1, ramp);
    for (const char* depth : {"", "d.pfm"}) {
        SCOPED_TRACE(depth);
        core::CreateOptions options;
        options.color = folder / "g.jpg";
        if (*depth != 0) options.depth = folder / depth;
        core::PhotoFiles files = core::readStoredDepth(options.color, options.depth);
        core::readColor(files);
        core::Notes direct;
        core::Notes reused;
        const core::Scene expected = core::createScene(options, &direct);
        const core::Scene scene = core::createScene(options, files, &reused);
        EXPECT_EQ(scene.photo->depth.image(), expected.photo->depth.image());
        EXPECT_EQ(scene.photo->color.image(), expected.photo->color.image());
        EXPECT_TRUE(scene.photo->color.shares(files.color)) << "no second copy of the colour";
        EXPECT_EQ(scene.photo->source, expected.photo->source);
        EXPECT_EQ(scene.photo->clipLevel, expected.photo->clipLevel);
        EXPECT_EQ(core::english(reused), core::english(direct));
        const core::PhotoReading reading = core::interpretPhoto(files, core::photoRequest(options), nullptr);
        EXPECT_EQ(reading.camera, expected.photo->camera);
        if (reading.depth.sameSize(expected.photo->depth)) {
            EXPECT_EQ(reading.depth, expected.photo->depth.image());
        }
    }
}

TEST_F(ImportTest, AnUnknownUnitCanBeChosenByTheMedianDepth) {
    test::writeBytes(folder / "plain.jpg", grey(5, 1, 50));
    test::writePnm8(folder / "d8.pgm", 5, 1, 1, {0, 10, 20, 40, 80});
    const core::PhotoFiles files = core::readStoredDepth(folder / "plain.jpg", folder / "d8.pgm");
    for (const DepthKind kind : {DepthKind::Z, DepthKind::Inverse}) {
        EXPECT_TRUE(core::needsUnit(files, kind));
        core::CreateOptions options;
        options.color = folder / "plain.jpg";
        options.depth = folder / "d8.pgm";
        options.depthKind = kind;
        options.depthUnit = core::unitForMedian(files, kind, 1);
        const core::ImageF depth = core::createScene(options).photo->depth;
        EXPECT_EQ(depth(0, 0), 0);
        // The values in order are 10, 20, 40, 80; the median lies in the middle of 20 and 40 or is one of them.
        EXPECT_LE(std::min(depth(2, 0), depth(3, 0)), 1.0f);
        EXPECT_GE(std::max(depth(2, 0), depth(3, 0)), 1.0f);
    }
}

TEST_F(ImportTest, DepthBesideThePhotographIsFoundByItsName) {
    const auto found = [&](const std::string& photo, const std::vector<std::string>& others) -> std::string {
        const test::TempFolder place;
        test::writeBytes(place / photo, "x");
        for (const std::string& other : others) test::writeBytes(place / other, "x");
        const auto beside = core::findDepthBeside(place / photo);
        return beside ? std::filesystem::path(beside->path).filename().string() : "";
    };
    EXPECT_EQ(found("vase.jpg", {"vase_depth.png", "pot_depth.png", "pot.jpg"}), "vase_depth.png");
    EXPECT_EQ(found("vase.jpg", {"vase.depth.exr", "vase_depth.png"}), "vase.depth.exr") << "EXR first";
    EXPECT_EQ(found("Vase.JPG", {"depth_vase.PNG"}), "depth_vase.PNG");
    EXPECT_EQ(found("IMG_12.jpg", {"IMG_12Depth.png", "IMG_1.jpg", "IMG_1Depth.png"}), "IMG_12Depth.png");
    EXPECT_EQ(found("rgb.png", {"depth.png", "camera.json", "pot.png"}), "depth.png");
    EXPECT_EQ(found("80-opaque-rgb-img.jpg", {"80-opaque-depth-img.exr", "80-transparent-depth-img.exr"}),
              "80-opaque-depth-img.exr");
    EXPECT_EQ(found("1.png", {"1_depth.png", "2_depth.png", "2.png"}), "1_depth.png");
    EXPECT_EQ(found("vase.jpg", {"depth.png"}), "depth.png") << "the only photograph here";
    EXPECT_EQ(found("vase.jpg", {"depth.png", "pot.jpg"}), "") << "of which of the two?";
    EXPECT_EQ(found("vase.jpg", {"vase_depth.txt", "vase2_depth.png", "depthcharge.png"}), "");
    EXPECT_EQ(found("color.exr", {"depth_back.exr"}), "");
    EXPECT_EQ(found("vase_depth.png", {"vase_depth.exr"}), "") << "a depth map itself";
    EXPECT_FALSE(core::findDepthBeside(folder / "no/such/folder/a.jpg").has_value());
    test::writeBytes(folder / "a.jpg", "x");
    test::writeBytes(folder / "a_disparity.png", "x");
    EXPECT_EQ(core::findDepthBeside(folder / "a.jpg").value().kind, DepthKind::Disparity);
}
