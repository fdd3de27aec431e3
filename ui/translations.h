// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QTranslator>
#include <memory>
#include <vector>

namespace ui {

/// Installs the translations of Qt's own texts and of Patina's, as far as there are any for the locale. They last as
/// long as the result.
[[nodiscard]] std::vector<std::unique_ptr<QTranslator>> installTranslators(const QLocale& locale);

}  // namespace ui
