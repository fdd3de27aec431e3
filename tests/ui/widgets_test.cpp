// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <cmath>
#include <set>

#include "tests/ui/support.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/display.h"
#include "ui/canvas/ruler.h"
#include "ui/canvas/view_layer.h"
#include "ui/canvas/view_transform.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/map_view.h"
#include "ui/widgets/param_slider.h"
#include "ui/widgets/profile_view.h"

namespace {

const ui::ParamSpec kExponent{.key = "exponent",
                              .label = "Exponent",
                              .unit = {},
                              .toolTip = {},
                              .minimum = 1,
                              .maximum = 10000,
                              .initial = 100,
                              .logarithmic = true,
                              .decimals = 1};

TEST(ParamSlider, LogarithmicMiddleIsTheGeometricMean) {
    ui::ParamSlider slider(kExponent);
    QSignalSpy changes(&slider, &ui::ParamSlider::valueChanged);
    test::child<QSlider>(slider, "exponentSlider")->setValue(250);
    EXPECT_NEAR(slider.value(), 10.0, 1e-9);
    EXPECT_NEAR(test::child<QDoubleSpinBox>(slider, "exponentSpin")->value(), 10.0, 1e-9);
    EXPECT_EQ(changes.size(), 1);
}

TEST(ParamSlider, ValueFromOutsideIsClampedAndSilent) {
    ui::ParamSlider slider(kExponent);
    QSignalSpy changes(&slider, &ui::ParamSlider::valueChanged);
    slider.setValue(1e9);
    EXPECT_EQ(slider.value(), 10000);
    EXPECT_EQ(test::child<QSlider>(slider, "exponentSlider")->value(), 1000);
    EXPECT_EQ(changes.size(), 0);
}

TEST(ParamSlider, DoubleClickReturnsToTheInitialValue) {
    ui::ParamSlider slider(kExponent);
    slider.setValue(3);
    QSignalSpy changes(&slider, &ui::ParamSlider::valueChanged);
    QSignalSpy ends(&slider, &ui::ParamSlider::editingFinished);
    QTest::mouseDClick(slider.findChild<QLabel*>(), Qt::LeftButton);
    EXPECT_EQ(slider.value(), 100);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_EQ(ends.size(), 1);
}

TEST(Display, TransferFunctionMatchesTheStandardAndInverts) {
    EXPECT_NEAR(ui::encodeSrgb(0.5f), 0.735357f, 1e-5f);  // IEC 61966-2-1
    EXPECT_NEAR(ui::encodeSrgb(0.002f), 0.02584f, 1e-6f);
    EXPECT_FLOAT_EQ(ui::encodeSrgb(7.0f), 1.0f);
    EXPECT_EQ(ui::encodeSrgb(-1.0f), 0.0f);
    for (int i = 0; i <= 100; ++i) {
        const float v = static_cast<float>(i) / 100;
        EXPECT_NEAR(ui::decodeSrgb(ui::encodeSrgb(v)), v, 1e-5f);
    }
}

TEST(Display, ExposureOfOneStopDoublesLight) {
    const core::ImageRgb picture(1, 1, core::Vector3f::Constant(0.25f));
    EXPECT_EQ(qRed(ui::displayImage(picture, 1).pixel(0, 0)), 188);  // sRGB of 0.5
    EXPECT_EQ(qRed(ui::displayImage(picture, 0).pixel(0, 0)), 137);  // sRGB of 0.25
}

TEST(ViewTransform, FitsTheWholePictureAndNeverEnlarges) {
    ui::ViewTransform view;
    view.setSizes({1000, 500}, {4000, 1000});
    EXPECT_NEAR(view.zoom(), 0.98 * 0.25, 1e-12);
    EXPECT_NEAR(view.toPicture({500, 250}).x(), 2000, 1e-9);
    view.setSizes({1000, 500}, {100, 100});
    EXPECT_EQ(view.zoom(), 1);
}

TEST(ViewTransform, ZoomKeepsThePointUnderTheCursor) {
    ui::ViewTransform view;
    view.setSizes({800, 600}, {800, 600});
    const QPointF cursor(200, 450);
    const QPointF before = view.toPicture(cursor);
    view.zoomAt(cursor, 8);
    constexpr double kHalfDevicePixel = 0.5 / 8;
    EXPECT_NEAR(view.toPicture(cursor).x(), before.x(), kHalfDevicePixel);
    EXPECT_NEAR(view.toPicture(cursor).y(), before.y(), kHalfDevicePixel);
    EXPECT_EQ(view.zoom(), 8);
    view.zoomAt(cursor, 1e9);
    EXPECT_EQ(view.zoom(), ui::ViewTransform::kMaxZoom);
}

TEST(ViewTransform, PanMovesByDevicePixelsAndBackAndForthAgree) {
    ui::ViewTransform view;
    view.setSizes({800, 600}, {1600, 1200});
    view.zoomCentered(2);
    const QPointF before = view.toPicture({400, 300});
    view.pan({10, -20});
    EXPECT_NEAR(view.toPicture({400, 300}).x(), before.x() - 5, 1e-9);
    EXPECT_NEAR(view.toPicture({400, 300}).y(), before.y() + 10, 1e-9);
    const QPointF there = view.toView(view.toPicture({123, 45}));
    EXPECT_NEAR(there.x(), 123, 1e-9);
    EXPECT_NEAR(there.y(), 45, 1e-9);
}

TEST(ViewTransform, PicturePixelsLieOnWholeDevicePixels) {
    ui::ViewTransform view;
    view.setSizes({801, 603}, {960, 640});
    for (const double zoom : {1.0, 2.0, 3.0}) {
        view.zoomCentered(zoom);
        view.pan({0.3, -0.4});
        const QPointF corner = view.toView({100, 50});
        EXPECT_NEAR(corner.x(), std::round(corner.x()), 1e-9);
        EXPECT_NEAR(corner.y(), std::round(corner.y()), 1e-9);
    }
}

TEST(ViewTransform, EmptySizesAreHarmless) {
    ui::ViewTransform view;
    view.setSizes({}, {});
    view.zoomAt({0, 0}, 2);
    view.pan({5, 5});
    view.fit();
    EXPECT_TRUE(std::isfinite(view.toPicture({3, 3}).x()));
    EXPECT_EQ(view.zoom(), 1);
}

TEST(Ruler, IsRoundAndFitsTheView) {
    for (double scale = 1e-5; scale < 1e4; scale *= 1.07)
        for (const double ratio : {1.0, 1.5, 2.0}) {
            const ui::Ruler ruler = ui::roundRuler(scale, ratio);
            EXPECT_LE(ruler.pixels, 200.001 * ratio);
            EXPECT_GE(ruler.pixels, 79.999 * ratio);
            EXPECT_NEAR(ruler.pixels * scale, ruler.millimetres, 1e-9 * ruler.millimetres);
            const double power = std::pow(10, std::floor(std::log10(ruler.millimetres) + 1e-9));
            const double first = std::round(1e6 * ruler.millimetres / power) / 1e6;
            EXPECT_TRUE(first == 1 || first == 2 || first == 5) << ruler.millimetres;
        }
    EXPECT_DOUBLE_EQ(ui::roundRuler(0.1, 1).millimetres, 20);
    EXPECT_DOUBLE_EQ(ui::roundRuler(0.1, 1).pixels, 200);
    for (const double nothing : {0.0, -1.0, std::nan(""), HUGE_VAL}) EXPECT_EQ(ui::roundRuler(nothing, 1), ui::Ruler());
}

TEST(Ruler, SaysItsLengthInTheUsualUnit) {
    EXPECT_EQ(ui::rulerText(5), QStringLiteral("5 mm"));
    EXPECT_EQ(ui::rulerText(20), QStringLiteral("2 cm"));
    EXPECT_EQ(ui::rulerText(500), QStringLiteral("50 cm"));
    EXPECT_EQ(ui::rulerText(1000), QStringLiteral("1 m"));
    EXPECT_EQ(ui::rulerText(0.02), QStringLiteral("20 µm"));
}

TEST(Ruler, ItsBarHasTheLength) {
    for (const double ratio : {1.0, 2.0}) {
        const ui::Ruler ruler{.millimetres = 2, .pixels = 120 * ratio};
        const QImage image = ui::rulerImage(ruler, ratio);
        int longest = 0;
        for (int y = 0; y < image.height(); ++y) {
            int white = 0;
            for (int x = 0; x < image.width(); ++x) white += image.pixelColor(x, y) == QColor(Qt::white) ? 1 : 0;
            longest = std::max(longest, white);
        }
        EXPECT_NEAR(longest, ruler.pixels, 2 * ratio);
        EXPECT_EQ(image.pixelColor(0, 0).alpha(), 0);
    }
    EXPECT_TRUE(ui::rulerImage({}, 1).isNull());
}

TEST(MapView, MarksOnlyWhatNobodyObserved) {
    const auto analysis = test::makeAnalysis(test::makeScene());
    ui::MapView map;
    map.setMap(*analysis->environment);
    const QImage plain = map.image();
    map.setCoverageShown(true);
    EXPECT_EQ(map.image().pixel(8, 4), plain.pixel(8, 4));
    EXPECT_NE(map.image().pixel(0, 0), plain.pixel(0, 0));
}

TEST(ProfileView, MeasuresTheThickness) {
    const core::Scene scene = test::makeScene();
    const auto analysis = test::makeAnalysis(scene);
    ui::ProfileView profile;
    profile.show(scene.photo->labels, 2, *analysis->front, *analysis->back);
    EXPECT_NEAR(profile.maxThickness(), 0.1f, 1e-6f);
    profile.show(scene.photo->labels, 9, *analysis->front, *analysis->back);
    EXPECT_EQ(profile.maxThickness(), 0);
}

TEST(ViewLayer, EveryLayerHasThePhotographsSizeWithAndWithoutAnalysis) {
    const core::Scene scene = test::makeScene();
    const auto analysis = test::makeAnalysis(scene);
    std::set<QString> keys;
    for (const ui::ViewLayer layer : ui::kViewLayers) {
        keys.insert(ui::layerKey(layer));
        EXPECT_FALSE(ui::layerTitle(layer).isEmpty());
        for (const core::Analysis* known : {static_cast<const core::Analysis*>(nullptr), analysis.get()}) {
            const ui::LayerPicture picture = ui::makeLayerPicture(layer, *scene.photo, known);
            EXPECT_TRUE(picture.pixels.sameSize(scene.photo->color));
        }
    }
    EXPECT_EQ(keys.size(), ui::kViewLayers.size());
}

TEST(ViewLayer, NearIsTheBrightEndOfTheRamp) {
    const core::Scene scene = test::makeScene();
    const ui::LayerPicture picture = ui::makeLayerPicture(ui::ViewLayer::Depth, *scene.photo, nullptr);
    EXPECT_TRUE(picture.pixels(15, 12).isApprox(ui::rampColor(1), 1e-5f));
    EXPECT_TRUE(picture.pixels(0, 0).isApprox(ui::rampColor(0), 1e-5f));
}

TEST(CanvasPicture, KeepsColourAsHalfFloats) {
    core::ImageRgb pixels(2, 1, core::Vector3f(1.0f, 0.5f, -2.0f));
    pixels(1, 0) = {1e9f, 0, 0};
    const auto picture = ui::makeCanvasPicture({pixels, false});
    ASSERT_EQ(picture->rgba.size(), 8u);
    EXPECT_EQ(picture->rgba[0], 0x3c00);  // 1
    EXPECT_EQ(picture->rgba[1], 0x3800);  // 0.5
    EXPECT_EQ(picture->rgba[2], 0xc000);  // -2
    EXPECT_EQ(picture->rgba[4], 0x7bff);  // the largest half, not infinity
}

}  // namespace
