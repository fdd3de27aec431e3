// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace ui {

/// Keeps the mouse wheel from changing values that only pass under the pointer while a panel is scrolled. Watches the
/// whole application: combo boxes never follow the wheel (their lists do), spin boxes and sliders only with the
/// keyboard focus, which the wheel does not give them. What they refuse scrolls what is around them.
class WheelGuard : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ui
