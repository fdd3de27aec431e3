// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words.h"

#include <QCoreApplication>
#include <new>

#include "gpu/error.h"

namespace ui {

QString taskName(core::Task task) {
    const auto say = [](const char* text) { return QCoreApplication::translate("tasks", text); };
    switch (task) {
        case core::Task::Working:
            return say(QT_TRANSLATE_NOOP("tasks", "Working"));
        case core::Task::LoadPhoto:
            return say(QT_TRANSLATE_NOOP("tasks", "Loading the photograph"));
        case core::Task::FindRegions:
            return say(QT_TRANSLATE_NOOP("tasks", "Finding regions to select"));
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

namespace {

QString settingHint(core::Setting setting) {
    switch (setting) {
        case core::Setting::None:
            break;
        case core::Setting::DepthUnit:
            return QCoreApplication::translate("messages", "It is \"Depth unit\" under File > New from photograph.");
        case core::Setting::DepthUnitOrKind:
            return QCoreApplication::translate(
                "messages", "They are \"Depth unit\" and \"Depth is\" under File > New from photograph.");
        case core::Setting::FieldOfView:
            return QCoreApplication::translate("messages",
                                               "\"Field of view\" under File > New from photograph sets it.");
    }
    return {};
}

/// What is wrong, in the user's language; the details name objects of the program and stay in English.
QString deviceFailure(const gpu::Error& error) {
    const auto say = [&](const char* text) {
        return QCoreApplication::translate("messages", text).arg(QString::fromUtf8(error.what()));
    };
    switch (error.kind()) {
        case gpu::ErrorKind::OutOfMemory:
            return say(QT_TRANSLATE_NOOP("messages", "The graphics device has too little memory for this. (%1)"));
        case gpu::ErrorKind::DeviceLost:
            return say(QT_TRANSLATE_NOOP("messages", "The graphics device no longer answers. (%1)"));
        case gpu::ErrorKind::NoAdapter:
            return say(QT_TRANSLATE_NOOP("messages", "No graphics device can be used. (%1)"));
        case gpu::ErrorKind::Validation:
        case gpu::ErrorKind::Internal:
            break;
    }
    return say(QT_TRANSLATE_NOOP("messages", "The graphics device failed. (%1)"));
}

}  // namespace

QString translated(const core::Message& message) {
    const QString sentence = QString::fromStdString(message.text([](const char* context, const std::string& pattern) {
        return QCoreApplication::translate(context, pattern.c_str()).toStdString();
    }));
    const QString hint = settingHint(message.setting());
    return hint.isEmpty() ? sentence : sentence + QLatin1Char(' ') + hint;
}

QString translated(const std::exception& error) {
    if (const auto* known = dynamic_cast<const core::Error*>(&error)) return translated(known->message());
    if (const auto* device = dynamic_cast<const gpu::Error*>(&error)) return deviceFailure(*device);
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return QCoreApplication::translate("messages", "There is not enough memory for this.");
    return QString::fromUtf8(error.what());
}

QStringList translatedEach(std::span<const core::Message> notes) {
    QStringList sentences;
    for (const core::Message& note : notes) sentences << translated(note);
    return sentences;
}

}  // namespace ui
