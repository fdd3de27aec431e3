// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QElapsedTimer>
#include <QStackedWidget>
#include <QTest>
#include <functional>
#include <string>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"

namespace test {

/// Runs the event loop until `done` or the time is over; returns `done()`.
inline bool waitUntil(const std::function<bool()>& done, int milliseconds) {
    return QTest::qWaitFor(done, milliseconds);
}

/// The one child of this type and name; a test fails at the null pointer with the name in the message.
template <class T>
T* child(QObject& parent, const char* name) {
    T* found = parent.findChild<T*>(QString::fromUtf8(name));
    if (found == nullptr) qFatal("no child named %s", name);
    return found;
}

/// Row of a segment in the list of segments; invalid when it is not there.
inline QModelIndex segmentRow(const QAbstractItemView& list, const QString& name) {
    const QAbstractItemModel& model = *list.model();
    const auto rows = model.match(model.index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly);
    return rows.isEmpty() ? QModelIndex() : rows.front();
}

/// Shows the canvas instead of the start page: its device starts when it is first shown.
inline void showCanvas(QWidget& window) {
    child<QStackedWidget>(window, "pages")->setCurrentWidget(child<QWidget>(window, "canvas"));
}

/// The segment of this name; the label 0 stands for none.
inline std::uint16_t labelOf(const core::Scene& scene, const std::string& name) {
    for (const core::Segment& segment : scene.segments) {
        if (segment.name == name) return segment.label;
    }
    return 0;
}

/// A flat card in front of a far wall: 32x24 pixels, segments 1 "wall" (2 m) and 2 "card" (1 m, the middle).
inline core::Scene makeScene() {
    auto photo = std::make_shared<core::Photo>();
    photo->camera = core::Camera::fromHorizontalFov(32, 24, 1.0f);
    photo->color = core::ImageRgb(32, 24, core::Vector3f(0.2f, 0.3f, 0.4f));
    photo->depth = core::ImageF(32, 24, 2.0f);
    photo->labels = core::LabelImage(32, 24, 1);
    for (int y = 8; y < 16; ++y) {
        for (int x = 10; x < 22; ++x) {
            photo->color(x, y) = {0.8f, 0.5f, 0.1f};
            photo->depth(x, y) = 1.0f;
            photo->labels(x, y) = 2;
        }
    }
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    scene.segments[0].name = "wall";
    scene.segments[1].name = "card";
    return scene;
}

/// A stand-in analysis of `makeScene`: front as given, back 10 cm behind it, a grey environment.
inline std::shared_ptr<const core::Analysis> makeAnalysis(const core::Scene& scene) {
    const core::Photo& photo = *scene.photo;
    auto front = std::make_shared<core::Surface>();
    front->depth = photo.depth;
    front->normal = core::ImageV3(32, 24, core::Vector3f(0, 0, -1));
    front->position = core::ImageV3(32, 24);
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 32; ++x) front->position(x, y) = photo.camera.backProject(x, y, photo.depth(x, y));
    }
    front->area = core::ImageF(32, 24, 1e-4f);
    front->color = photo.color;
    auto back = std::make_shared<core::Surface>(*front);
    for (float& z : back->depth.pixels()) z += 0.1f;
    auto environment = std::make_shared<core::DirectionalMap>();
    environment->radiance = core::ImageRgb(16, 8, core::Vector3f(0.5f, 0.5f, 0.5f));
    environment->coverage = core::ImageF(16, 8, 0.0f);
    environment->coverage(8, 4) = 3;
    auto reflectance = std::make_shared<core::Reflectance>();
    reflectance->label = 2;
    reflectance->rho = {0.25f, 0.5f, 0.75f};
    reflectance->reliable = true;
    reflectance->commonSolidAngle = 1.5f;
    reflectance->reflected = *environment;
    reflectance->incident = *environment;
    auto analysis = std::make_shared<core::Analysis>();
    analysis->front = front;
    analysis->back = back;
    analysis->environment = environment;
    analysis->reflectances = {reflectance};
    return analysis;
}

}  // namespace test
