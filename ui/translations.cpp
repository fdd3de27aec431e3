// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QString>

namespace ui {

std::vector<std::unique_ptr<QTranslator>> installTranslators(const QLocale& locale) {
    std::vector<std::unique_ptr<QTranslator>> result;
    const auto install = [&](const QString& name, const QString& folder) {
        auto translator = std::make_unique<QTranslator>();
        if (!translator->load(locale, name, QStringLiteral("_"), folder)) return;
        QCoreApplication::installTranslator(translator.get());
        result.push_back(std::move(translator));
    };
    install(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(QStringLiteral("patina"), QStringLiteral(":/translations"));
    return result;
}

}  // namespace ui
