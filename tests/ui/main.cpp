// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/style.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("PatinaTests"));
    QCoreApplication::setApplicationName(QStringLiteral("ui_tests"));
    // The tests' settings and pictures are their own and end with them.
    const QTemporaryDir settings;
    qputenv("XDG_CACHE_HOME", settings.path().toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    ui::applyStyle(application);
    return RUN_ALL_TESTS();
}
