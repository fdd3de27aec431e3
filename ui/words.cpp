// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words.h"

#include <QCoreApplication>

namespace ui {

QString taskName(core::Task task) {
    const auto say = [](const char* text) { return QCoreApplication::translate("tasks", text); };
    switch (task) {
        case core::Task::Working:
            return say(QT_TRANSLATE_NOOP("tasks", "Working"));
        case core::Task::LoadPhoto:
            return say(QT_TRANSLATE_NOOP("tasks", "Loading the photograph"));
        case core::Task::RecoverDepth:
            return say(QT_TRANSLATE_NOOP("tasks", "Recovering depth"));
        case core::Task::ComputeNormals:
            return say(QT_TRANSLATE_NOOP("tasks", "Computing normals"));
        case core::Task::InventBackSides:
            return say(QT_TRANSLATE_NOOP("tasks", "Inventing back sides"));
        case core::Task::BuildDepthLayers:
            return say(QT_TRANSLATE_NOOP("tasks", "Building depth layers"));
        case core::Task::EstimateReflectance:
            return say(QT_TRANSLATE_NOOP("tasks", "Estimating reflectance"));
        case core::Task::RecoverEnvironment:
            return say(QT_TRANSLATE_NOOP("tasks", "Recovering the environment"));
        case core::Task::SeparateTexture:
            return say(QT_TRANSLATE_NOOP("tasks", "Separating texture from shading"));
        case core::Task::Render:
            return say(QT_TRANSLATE_NOOP("tasks", "Rendering"));
        case core::Task::FilterPicture:
            return say(QT_TRANSLATE_NOOP("tasks", "Filtering the picture"));
        case core::Task::SumDiffusion:
            return say(QT_TRANSLATE_NOOP("tasks", "Summing diffuse light"));
        case core::Task::Benchmark:
            return say(QT_TRANSLATE_NOOP("tasks", "Running benchmarks"));
    }
    return {};
}

}  // namespace ui
