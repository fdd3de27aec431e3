// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

#include "core/base/image.h"

namespace ui {

/// Shows a scene-linear colour as it appears on the screen; a click opens a colour dialog. Setting a colour from
/// outside emits nothing.
class ColorButton : public QToolButton {
    Q_OBJECT
  public:
    ColorButton(const QString& key, const QString& title, QWidget* parent = nullptr);

    [[nodiscard]] const core::Vector3f& color() const { return color_; }
    void setColor(const core::Vector3f& linear);

  signals:
    /// The user changes the colour in the dialog; scene-linear, in [0, 1].
    void colorChanged(const core::Vector3f& linear);
    void editingFinished();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void choose();

    QString title_;
    core::Vector3f color_{0.5f, 0.5f, 0.5f};
};

}  // namespace ui
