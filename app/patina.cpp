// SPDX-License-Identifier: GPL-3.0-or-later
// The window. `patina [FILE]`, see --help.
#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "ui/main_window.h"
#include "ui/style.h"
#include "ui/translations.h"

namespace {

/// Without a display Qt would abort with a core dump instead of a message.
bool displayMissing(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]).starts_with("-platform") || std::string_view(argv[i]).starts_with("--platform")) {
            return false;
        }
    }
    const auto unset = [](const char* name) {
        const char* value = std::getenv(name);
        return value == nullptr || *value == '\0';
    };
    return unset("DISPLAY") && unset("WAYLAND_DISPLAY") && unset("QT_QPA_PLATFORM");
}

/// --help and --version work without a display.
bool onlyText(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--help" || argument == "-h" || argument == "--version" || argument == "-v") return true;
    }
    return false;
}

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        QCoreApplication::translate("main", "Changes the materials of objects in photographs with depth."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"),
                                 QCoreApplication::translate("main", "Project (.patina) or photograph to open."),
                                 QStringLiteral("[FILE]"));
    parser.addOption({QStringLiteral("device"),
                      QCoreApplication::translate("main", "Part of the graphics device's name, or its index."),
                      QStringLiteral("D")});
}

void nameApplication() {
    QCoreApplication::setOrganizationName(QStringLiteral("Patina"));
    QCoreApplication::setApplicationName(QStringLiteral("Patina"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PATINA_VERSION));
}

}  // namespace

int main(int argc, char** argv) {
    nameApplication();
    if (onlyText(argc, argv)) {
        const QCoreApplication application(argc, argv);
        QCommandLineParser parser;
        describe(parser);
        parser.process(application);
        return 0;
    }
    if (displayMissing(argc, argv)) {
        std::fputs(
            "Patina needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set. "
            "Use patina-cli to work without a window.\n",
            stderr);
        return 4;
    }
    QApplication application(argc, argv);
    QApplication::setDesktopFileName(QStringLiteral("patina"));
    const auto translators = ui::installTranslators(QLocale());
    QCommandLineParser parser;
    describe(parser);
    parser.process(application);
    if (parser.positionalArguments().size() > 1) {
        std::fputs("Patina opens one file at a time.\n", stderr);
        return 2;
    }
    ui::applyStyle(application);
    try {
        ui::MainWindow window({.canvas = true, .device = parser.value(QStringLiteral("device"))});
        window.show();
        if (!parser.positionalArguments().isEmpty()) {
            QTimer::singleShot(0, &window, [&] { window.openFile(parser.positionalArguments().front()); });
        }
        return QApplication::exec();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 4;
    }
}
