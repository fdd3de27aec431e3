// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace ui {

std::vector<Sample> bundledSamples() {
    const QString program = QCoreApplication::applicationDirPath();
    for (const QString& folder :
         {QDir(program).filePath(QStringLiteral("../share/patina")), QStringLiteral(PATINA_RESOURCES)}) {
        const QDir studio(folder + QStringLiteral("/samples/studio"));
        Sample edited{QCoreApplication::translate("samples", "Studio: a satin vase and a golden bag"),
                      QDir::cleanPath(studio.filePath(QStringLiteral("edited.patina"))),
                      QDir::cleanPath(studio.filePath(QStringLiteral("edited.jpg")))};
        if (QFileInfo::exists(edited.project)) return {std::move(edited)};
    }
    return {};
}

}  // namespace ui
