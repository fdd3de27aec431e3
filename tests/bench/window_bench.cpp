// SPDX-License-Identifier: GPL-3.0-or-later
// Latency of the real window: drags a material's slider with the mouse and measures the time until a frame with the
// new material is presented. `./dev bench-window` starts it on a virtual display.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/ui/stall_meter.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/style.h"

namespace {

struct Options {
    std::string project = PATINA_SAMPLES "/studio/studio.patina";
    std::string segment = "vase";
    std::string brdf = "ggx";
    std::string parameter = "alpha";
    double seconds = 10;
};

double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

/// Centre of the slider's handle at `value`.
QPoint handle(QSlider& slider, int value) {
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.orientation = slider.orientation();
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = value;
    option.sliderValue = value;
    return slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
}

int fail(const char* message) {
    std::fprintf(stderr, "patina-window-bench: %s\n", message);
    return 1;
}

int run(const Options& options) {
    ui::MainWindow window;
    window.resize(1500, 950);
    window.show();
    window.openFile(QString::fromStdString(options.project));
    if (!test::waitUntil([&] { return window.settled() && window.workspace().analysis() != nullptr; }, 120000))
        return fail("the project was not opened and analysed within two minutes");
    const std::uint16_t label = test::labelOf(window.workspace().scene(), options.segment);
    if (label == 0) return fail("there is no such segment");
    window.workspace().select(label);
    auto* brdf = test::child<QComboBox>(window, "materialBrdf");
    brdf->setCurrentIndex(brdf->findData(QString::fromStdString(options.brdf)));
    emit brdf->activated(brdf->currentIndex());
    auto* slider = test::child<QSlider>(window, (options.parameter + "Slider").c_str());
    QTest::qWait(3000);

    QElapsedTimer clock;
    clock.start();
    const auto now = [&] { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; };
    std::vector<std::pair<std::uint64_t, double>> waiting;  // changes not yet shown: scene, time [ms]
    std::vector<double> latencies;
    int frames = 0;
    QObject::connect(slider, &QSlider::valueChanged, slider,
                     [&] { waiting.emplace_back(window.canvas().sceneNumber(), now()); });
    QObject::connect(&window.canvas(), &ui::Canvas::framePresented, &window, [&] {
        ++frames;
        std::erase_if(waiting, [&](const auto& change) {
            const bool shown = change.first <= window.canvas().shownScene();
            if (shown) latencies.push_back(now() - change.second);
            return shown;
        });
    });

    test::StallMeter stalls;
    const double start = now();
    QTest::mousePress(slider, Qt::LeftButton, {}, handle(*slider, slider->value()));
    QEventLoop dragging;  // not qWait, which sleeps between events
    QTimer mouse;
    mouse.setTimerType(Qt::PreciseTimer);
    QObject::connect(&mouse, &QTimer::timeout, &dragging, [&] {
        if (now() - start >= options.seconds * 1000) return dragging.quit();
        const double phase = (now() - start) / 4000;  // back and forth in four seconds
        const double triangle = std::abs(phase - std::floor(phase) - 0.5) * 2;
        QTest::mouseMove(slider, handle(*slider, static_cast<int>(100 + 800 * triangle)));
    });
    mouse.start(8);
    dragging.exec();
    QTest::mouseRelease(slider, Qt::LeftButton, {}, handle(*slider, slider->value()));
    const auto longest = static_cast<double>(stalls.longest());
    const double dragged = (now() - start) / 1000;
    QTest::qWait(1000);
    if (latencies.empty()) return fail("no change of the slider was ever shown");

    const core::ImageRgb& color = window.workspace().scene().photo->color;
    std::printf("device: %s\npicture: %d x %d, segment %s, %s %s\n", qPrintable(window.canvas().deviceName()),
                color.width(), color.height(), options.segment.c_str(), options.brdf.c_str(),
                options.parameter.c_str());
    std::printf("changes: %zu in %.1f s, %d frames\n", latencies.size(), dragged, frames);
    std::printf("slider to new pixels: median %.0f ms, 99th percentile %.0f ms, longest %.0f ms\n",
                quantile(latencies, 0.5), quantile(latencies, 0.99), quantile(latencies, 1));
    std::printf("window thread blocked: longest %.0f ms\n", longest);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Latency of the window while a slider is dragged"};
    app.add_option("--project", options.project, "Project to open")->capture_default_str();
    app.add_option("--segment", options.segment, "Name of the segment to edit")->capture_default_str();
    app.add_option("--brdf", options.brdf, "BRDF to give it")->capture_default_str();
    app.add_option("--parameter", options.parameter, "Key of the parameter to drag")->capture_default_str();
    app.add_option("--seconds", options.seconds, "Duration of the drag [s]")
        ->capture_default_str()
        ->check(CLI::Range(1, 600));
    CLI11_PARSE(app, argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("PatinaTests"));
    QCoreApplication::setApplicationName(QStringLiteral("window_bench"));
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    ui::applyStyle(application);
    return run(options);
}
