// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

namespace ui {

class MainWindow : public QMainWindow {
    Q_OBJECT
};

}  // namespace ui
