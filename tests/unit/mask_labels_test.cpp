// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "core/io/image_io.h"
#include "core/io/mask_labels.h"
#include "core/io/project.h"
#include "tests/support/image_files.h"

namespace {

constexpr int kMaskSize = 64;

/// Share of a pixel that lies inside, from 8 x 8 points.
double coverageOf(int x, int y, const std::function<bool(double, double)>& inside) {
    int count = 0;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i)
            if (inside(x + (i + 0.5) / 8, y + (j + 0.5) / 8)) ++count;
    return count / 64.0;
}

/// A disc of this radius [px] with antialiased edges, values from 0 to `maximum`.
core::ImageF softDisc(double radius, double maximum, int center = 30) {
    core::ImageF values(kMaskSize, kMaskSize);
    for (int y = 0; y < kMaskSize; ++y)
        for (int x = 0; x < kMaskSize; ++x)
            values(x, y) = static_cast<float>(std::round(maximum * coverageOf(x, y, [&](double u, double v) {
                                                             return std::hypot(u - center, v - center) < radius;
                                                         })));
    return values;
}

std::string rowsOf(const core::ImageF& values, int bytes, const core::ImageF* alpha = nullptr) {
    std::string all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto put = [&](float value) {
            const auto v = static_cast<unsigned>(value);
            if (bytes == 2) all += static_cast<char>(v >> 8U);
            all += static_cast<char>(v & 255U);
        };
        put(values[i]);
        if (alpha != nullptr) put((*alpha)[i]);
    }
    return all;
}

void writePng(const std::string& path, const core::ImageF& values, int bits, const core::ImageF* alpha = nullptr) {
    const std::string all = rowsOf(values, bits / 8, alpha);
    const std::size_t stride = all.size() / kMaskSize;
    std::vector<std::string> rows;
    for (std::size_t y = 0; y < kMaskSize; ++y) rows.push_back(all.substr(y * stride, stride));
    test::writeBytes(path, test::pngBytes(kMaskSize, kMaskSize, bits, alpha != nullptr ? 4 : 0, rows));
}

std::set<int> labelsIn(const core::LabelImage& labels) { return {labels.pixels().begin(), labels.pixels().end()}; }

std::size_t areaOf(const core::LabelImage& labels, int label) {
    return static_cast<std::size_t>(std::ranges::count(labels.pixels(), static_cast<std::uint16_t>(label)));
}

class MaskLabels : public testing::Test {
  protected:
    test::TempFolder folder;
    core::Notes remarks;

    [[nodiscard]] std::string remark() const { return remarks.empty() ? "" : remarks.front().english(); }
    /// Loads a map that must stay as it is.
    void expectLabelMap(const core::ImageF& values, int bits) {
        writePng(folder / "map.png", values, bits);
        const core::LabelImage labels = core::loadLabels(folder / "map.png", &remarks);
        for (std::size_t i = 0; i < labels.size(); ++i) ASSERT_EQ(labels[i], values[i]) << i;
        EXPECT_EQ(remark(), "");
    }
};

/// A photograph with depth and a mask with soft edges.
core::CreateOptions softProject(const test::TempFolder& folder) {
    test::writePnm8(folder / "c.ppm", kMaskSize, kMaskSize, 3,
                    std::vector<std::uint8_t>(3UL * kMaskSize * kMaskSize, 99));
    test::writePfm(folder / "d.pfm", kMaskSize, kMaskSize, 1, std::vector<float>(1UL * kMaskSize * kMaskSize, 1.0f));
    writePng(folder / "mask.png", softDisc(20, 65535), 16);
    core::CreateOptions options;
    options.color = folder / "c.ppm";
    options.depth = folder / "d.pfm";
    options.segments = folder / "mask.png";
    return options;
}

}  // namespace

TEST_F(MaskLabels, SoftEdgesOfAMaskAreOneObject) {
    const double radius = 20.3;
    for (const int bits : {8, 16}) {
        remarks.clear();
        const int maximum = bits == 8 ? 255 : 65535;
        writePng(folder / "mask.png", softDisc(radius, maximum), bits);
        const core::LabelImage labels = core::loadLabels(folder / "mask.png", &remarks);
        EXPECT_EQ(labelsIn(labels), (std::set<int>{0, maximum}));
        const double area = std::numbers::pi * radius * radius;
        EXPECT_NEAR(static_cast<double>(areaOf(labels, maximum)), area, 0.01 * area);
        EXPECT_NE(remark().find("mask with soft edges"), std::string::npos) << remark();
        EXPECT_NE(remark().find("mask.png"), std::string::npos);
    }
}

TEST_F(MaskLabels, SoHaveFeatheredAndThinObjects) {
    core::ImageF feathered(kMaskSize, kMaskSize);
    core::ImageF line(kMaskSize, kMaskSize);
    for (int y = 0; y < kMaskSize; ++y)
        for (int x = 0; x < kMaskSize; ++x) {
            const double r = std::hypot(x - 30.3, y - 31.1);
            feathered(x, y) = static_cast<float>(std::round(255 * std::clamp((22 - r) / 6, 0.0, 1.0)));
            line(x, y) = static_cast<float>(
                std::round(255 * coverageOf(x, y, [](double u, double v) { return std::abs(v - 0.4 * u - 9.7) < 2; })));
        }
    for (const core::ImageF& mask : {feathered, line}) {
        remarks.clear();
        writePng(folder / "mask.png", mask, 8);
        const core::LabelImage labels = core::loadLabels(folder / "mask.png", &remarks);
        EXPECT_EQ(labelsIn(labels), (std::set<int>{0, 255}));
        EXPECT_EQ(remarks.size(), 1U);
    }
}

TEST_F(MaskLabels, FloatMaskIsOneObjectToo) {
    const core::ImageF disc = softDisc(20, 255);
    std::vector<float> values;
    for (const float v : disc.pixels()) values.push_back(v / 255);
    test::writePfm(folder / "mask.pfm", kMaskSize, kMaskSize, 1, values);
    const core::LabelImage labels = core::loadLabels(folder / "mask.pfm", &remarks);
    EXPECT_EQ(labelsIn(labels), (std::set<int>{0, 1}));
    EXPECT_EQ(remarks.size(), 1U);
}

TEST_F(MaskLabels, ObjectInTheAlphaChannel) {
    const core::ImageF alpha = softDisc(20, 255);
    core::ImageF cut = alpha;
    for (float& v : cut.pixels()) v = v > 0 ? 255.0f : 0.0f;
    for (const core::ImageF& values :
         {core::ImageF(kMaskSize, kMaskSize, 0.0f), core::ImageF(kMaskSize, kMaskSize, 255.0f), cut}) {
        remarks.clear();
        writePng(folder / "alpha.png", values, 8, &alpha);
        const core::LabelImage labels = core::loadLabels(folder / "alpha.png", &remarks);
        for (std::size_t i = 0; i < labels.size(); ++i) ASSERT_EQ(labels[i], alpha[i] >= 127.5f ? 255 : 0);
        EXPECT_NE(remark().find("alpha channel"), std::string::npos) << remark();
    }
}

TEST_F(MaskLabels, AlphaOfALabelMapIsIgnored) {
    core::ImageF values(kMaskSize, kMaskSize, 0.0f);
    core::ImageF alpha(kMaskSize, kMaskSize, 255.0f);
    for (int y = 10; y < 30; ++y)
        for (int x = 5; x < 60; ++x) values(x, y) = x < 30 ? 1.0f : 2.0f;
    for (int x = 0; x < kMaskSize; ++x) alpha(x, 20) = 0;
    writePng(folder / "labels.png", values, 8, &alpha);
    const core::LabelImage labels = core::loadLabels(folder / "labels.png", &remarks);
    for (std::size_t i = 0; i < labels.size(); ++i) ASSERT_EQ(labels[i], values[i]);
    EXPECT_TRUE(remarks.empty());
}

TEST_F(MaskLabels, LabelMapsStayAsTheyAre) {
    core::ImageF areas(kMaskSize, kMaskSize, 0.0f);   // few large objects, the last label the largest that fits
    core::ImageF voided(kMaskSize, kMaskSize, 0.0f);  // objects with a border of the label 255 around each
    core::ImageF crumbs(kMaskSize, kMaskSize, 0.0f);  // objects of one pixel
    core::ImageF ramp(kMaskSize, kMaskSize, 0.0f);    // every pixel an object
    for (int y = 0; y < kMaskSize; ++y)
        for (int x = 0; x < kMaskSize; ++x) {
            areas(x, y) = x < 16 ? 0.0f : x < 32 ? 90.0f : x < 40 ? 91.0f : x < 50 ? 200.0f : 255.0f;
            const int u = x % 16, v = y % 16;
            const bool border = u == 1 || v == 1 || u == 14 || v == 14;
            if (u > 0 && v > 0 && u < 15 && v < 15)
                voided(x, y) = border ? 255.0f : static_cast<float>(1 + x / 16 + 4 * (y / 16));
            if (x % 4 == 1 && y % 4 == 1) crumbs(x, y) = static_cast<float>(x / 4 + 16 * (y / 4));
            ramp(x, y) = static_cast<float>(x + kMaskSize * y) * 65535 / (kMaskSize * kMaskSize - 1);
            ramp(x, y) = std::round(ramp(x, y));
        }
    expectLabelMap(areas, 8);
    expectLabelMap(voided, 8);
    expectLabelMap(crumbs, 8);
    remarks.clear();
    writePng(folder / "ramp.png", ramp, 16);
    EXPECT_EQ(labelsIn(core::loadLabels(folder / "ramp.png")).size(), std::size_t{kMaskSize * kMaskSize});
}

TEST_F(MaskLabels, SoftEdgesBetweenSeveralObjectsAreSaid) {
    core::ImageF values = softDisc(9, 200, 14);
    const core::ImageF second = softDisc(9, 90, 45);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::max(values[i], second[i]);
    writePng(folder / "soft.png", values, 8);
    const core::LabelImage labels = core::loadLabels(folder / "soft.png", &remarks);
    for (std::size_t i = 0; i < labels.size(); ++i) ASSERT_EQ(labels[i], values[i]);
    EXPECT_NE(remark().find("without antialiasing"), std::string::npos) << remark();
}

TEST_F(MaskLabels, ValuesThatAreNoNumbersAreNoMask) {
    core::ImageF values(kMaskSize, kMaskSize, std::numeric_limits<float>::quiet_NaN());
    EXPECT_FALSE(core::hardenMask(values, 1, "nan.exr"));
    values = core::ImageF(kMaskSize, kMaskSize, -1.0f);
    EXPECT_FALSE(core::hardenMask(values, 1, "negative.exr"));
}

TEST_F(MaskLabels, ANewProjectHasOneSegmentAndANote) {
    const core::Scene scene = core::createScene(softProject(folder), &remarks);
    EXPECT_EQ(scene.segments.size(), 1U);
    EXPECT_TRUE(std::ranges::any_of(
        remarks, [](const core::Message& note) { return note.english().find("soft edges") != std::string::npos; }));
}

TEST_F(MaskLabels, AProjectThatHasASegmentForEachValueStillOpens) {
    const core::Scene scene = core::createScene(softProject(folder));
    core::saveProject(scene, folder / "new.patina");
    auto project = nlohmann::json::parse(test::readBytes(folder / "new.patina"));
    const core::LabelImage values = core::loadLabels(folder / "mask.png", nullptr, core::MaskEdges::Keep);
    const auto soft = *std::ranges::find_if(values.pixels(), [](int v) { return v > 0 && v < 65535; });
    project["segments"].push_back({{"label", soft}, {"name", "edge"}});
    test::writeBytes(folder / "old.patina", project.dump());
    EXPECT_GT(core::loadProject(folder / "old.patina").segments.size(), 10U);
    EXPECT_EQ(core::loadProject(folder / "new.patina").segments.size(), 1U);
}
