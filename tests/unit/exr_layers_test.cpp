// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/exr_layers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/io/image_io.h"
#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"
#include "tests/support/temp_folder.h"

using core::ExrChannel;

namespace {

using Names = std::vector<std::string>;

OIIO::ImageSpec part(const Names& names, const std::string& name = {}) {
    OIIO::ImageSpec spec(2, 1, static_cast<int>(names.size()), OIIO::TypeFloat);
    spec.channelnames = names;
    if (!name.empty()) spec.attribute("oiio:subimagename", name);
    return spec;
}

/// Names of the colour's layer and of the depth channel; "-" = none.
std::pair<std::string, std::string> chosenOf(const std::vector<OIIO::ImageSpec>& parts) {
    const std::vector<ExrChannel> channels = core::exrChannels(parts);
    const auto color = core::exrColor(channels);
    const auto depth = core::exrDepth(channels);
    return {color ? color->layer : "-", depth ? depth->name() : "-"};
}

std::pair<std::string, std::string> chosen(const Names& names) { return chosenOf({part(names)}); }

using Pair = std::pair<std::string, std::string>;

}  // namespace

TEST(ExrLayers, DepthByTheNamesOfRenderers) {
    EXPECT_EQ(chosen({"A", "B", "G", "R", "Z"}), Pair("", "Z"));
    EXPECT_EQ(chosen({"B", "G", "R", "VRayZDepth"}), Pair("", "VRayZDepth"));
    EXPECT_EQ(chosen({"B", "G", "R", "depth.depth"}), Pair("", "depth.depth"));
    EXPECT_EQ(chosen({"B", "G", "R", "depth.Z"}), Pair("", "depth.Z"));
    EXPECT_EQ(chosen({"B", "G", "R", "Depth.V"}), Pair("", "Depth.V"));
    EXPECT_EQ(chosen({"B", "G", "R", "Z Depth.R"}), Pair("", "Z Depth.R"));
    EXPECT_EQ(chosen({"B", "G", "R", "Pz"}), Pair("", "Pz"));
    EXPECT_EQ(chosen({"B", "G", "R", "left.Z"}), Pair("", "left.Z"));
    EXPECT_EQ(chosen({"B", "G", "R", "depth.Z", "Z"}), Pair("", "Z")) << "OpenEXR's own name first";
}

TEST(ExrLayers, NoComponentOfAVectorIsDepth) {
    EXPECT_EQ(chosen({"B", "G", "R", "N.X", "N.Y", "N.Z"}), Pair("", "-"));
    EXPECT_EQ(chosen({"B", "G", "R", "P.X", "P.Y", "P.Z"}), Pair("", "-"));
    EXPECT_EQ(chosen({"B", "G", "R", "surface.X", "surface.Y", "surface.Z"}), Pair("", "-")) << "whatever its name";
    EXPECT_EQ(chosen({"X", "Y", "Z"}), Pair("-", "-"));
    EXPECT_EQ(chosen({"B", "G", "R", "View.Mist.Z"}), Pair("", "-"));
    EXPECT_EQ(chosen({"B", "G", "R", "View.Vector.Z", "View.Vector.W"}), Pair("", "-"));
    EXPECT_EQ(chosen({"B", "G", "R", "RayDepth"}), Pair("", "-")) << "a number of bounces";
    EXPECT_EQ(chosen({"B", "G", "R", "View.Denoising Normal.X", "View.Denoising Normal.Y", "View.Denoising Normal.Z",
                      "View.Depth.Z"}),
              Pair("", "View.Depth.Z"));
    EXPECT_EQ(chosenOf({part({"X", "Y", "Z"}, "N"), part({"Z"}, "depth"), part({"R", "G", "B"}, "rgba")}),
              Pair("rgba", "depth.Z"));
    EXPECT_EQ(chosenOf({part({"N.X", "N.Y", "N.Z"}, "N"), part({"depth.Z"}, "depth"), part({"R", "G", "B"}, "rgba")}),
              Pair("rgba", "depth.Z"))
        << "the part's name may be repeated in the channels";
}

TEST(ExrLayers, ColourIsTheFinishedPicture) {
    const Names rgb{"R", "G", "B"};
    const auto layers = [&](const Names& names) {
        Names channels;
        for (const std::string& layer : names)
            for (const std::string& c : rgb) channels.push_back(layer + "." + c);
        return channels;
    };
    EXPECT_EQ(chosen(layers({"View.AO", "View.Combined"})).first, "View.Combined");
    EXPECT_EQ(chosen(layers({"albedo", "beauty"})).first, "beauty");
    EXPECT_EQ(chosen(layers({"albedo"})).first, "albedo");
    EXPECT_EQ(chosen({"a.red", "a.green", "a.blue"}).first, "a");
    EXPECT_EQ(chosenOf({part(rgb, "AO"), part(rgb, "Combined")}).first, "Combined");
    EXPECT_EQ(chosen({"R", "G"}).first, "-");
    EXPECT_EQ(chosen({"x.R", "y.G", "z.B"}).first, "-") << "of one layer";
}

TEST(ExrLayers, ColourAndDepthAreOfOneViewLayer) {
    const Names both{"Back.Combined.B", "Back.Combined.G", "Back.Combined.R", "Back.Depth.Z",
                     "View.Combined.B", "View.Combined.G", "View.Combined.R", "View.Depth.Z"};
    EXPECT_EQ(chosen(both), Pair("Back.Combined", "Back.Depth.Z"));
    const auto color = core::exrColor(core::exrChannels({part(both)}));
    ASSERT_TRUE(color);
    EXPECT_EQ(color->others, Names{"View.Combined"});
    Names later(both.begin() + 4, both.end());
    later.insert(later.end(), both.begin(), both.begin() + 4);
    EXPECT_EQ(chosen(later), Pair("View.Combined", "View.Depth.Z"));
}

TEST(ExrLayers, ObjectNumbers) {
    const auto found = core::exrIndices(core::exrChannels({part({"B", "G", "R", "View.IndexMA.X", "View.IndexOB.X"})}));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->name(), "View.IndexOB.X");
    EXPECT_FALSE(core::exrIndices(core::exrChannels({part({"R", "G", "B", "Z"})})));
}

class ExrFileTest : public testing::Test {
  protected:
    void write(const Names& names, const std::vector<float>& values) {
        OIIO::ImageSpec spec(1, 1, static_cast<int>(names.size()), OIIO::TypeFloat);
        spec.channelnames = names;
        test::writeWith("openexr", file, spec, OIIO::TypeFloat, values.data());
    }
    test::TempFolder folder;
    std::string file = folder / "a.exr";
};

TEST_F(ExrFileTest, TheChannelOfALayerIsSaid) {
    write({"B", "G", "R", "N.X", "N.Y", "N.Z", "depth.Z"}, {1, 2, 3, 0, 0, 1, 7});
    core::Notes remarks;
    EXPECT_EQ(core::loadScalar(file, &remarks)(0, 0), 7);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].english().find("\"depth.Z\""), std::string::npos);
    EXPECT_TRUE(core::readImageInfo(file).hasDepthChannel);
}

TEST_F(ExrFileTest, WithoutDepthTheChannelsAreListed) {
    write({"B", "G", "R", "N.X", "N.Y", "N.Z"}, {1, 2, 3, 0, 0, 1});
    EXPECT_FALSE(core::readImageInfo(file).hasDepthChannel);
    test::expectError(core::ErrorKind::Input, {"a.exr", "depth map", "N.X", "N.Z"},
                      [&] { (void)core::loadScalar(file); });
    write({"N.X", "N.Y", "N.Z"}, {0, 0, 1});
    test::expectError(core::ErrorKind::Input, {"a.exr", "R, G, B", "N.X"}, [&] { (void)core::loadColor(file); });
}

TEST_F(ExrFileTest, TheOnlyChannelIsTheMapWhateverItsName) {
    write({"left.anything"}, {5});
    EXPECT_EQ(core::loadScalar(file)(0, 0), 5);
    write({"R", "G", "B"}, {5, 5, 5});
    EXPECT_EQ(core::loadScalar(file)(0, 0), 5) << "grey in three channels";
}

TEST_F(ExrFileTest, LabelsFromObjectNumbers) {
    write({"B", "G", "R", "View.IndexOB.X"}, {0.1f, 0.2f, 0.3f, 2});
    EXPECT_EQ(core::loadLabels(file)(0, 0), 2);
    write({"B", "G", "R", "CryptoObject00.r"}, {0.1f, 0.2f, 0.3f, 2});
    test::expectError(core::ErrorKind::Input, {"a.exr", "Cryptomatte", "CryptoObject00.r"},
                      [&] { (void)core::loadLabels(file); });
}
