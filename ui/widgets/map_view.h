// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "core/base/directional_map.h"

namespace ui {

/// Shows a directional map (latitude-longitude, centre = the camera's forward direction). The overlay hatches
/// directions that were not observed but interpolated.
class MapView : public QWidget {
    Q_OBJECT
  public:
    explicit MapView(QWidget* parent = nullptr);

    void setMap(const core::DirectionalMap& map);
    /// Shows `reason` instead of a map.
    void setEmpty(const QString& reason);
    void setExposure(float stops);
    void setCoverageShown(bool shown);
    /// The displayed picture, for tests and for saving it.
    [[nodiscard]] const QImage& image() const { return image_; }

    [[nodiscard]] QSize sizeHint() const override { return {256, 128}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return width / 2; }

  signals:
    /// Text about the direction under the pointer; "" when there is none.
    void hovered(const QString& text);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    void rebuild();
    [[nodiscard]] QRectF target() const;

    core::DirectionalMap map_;
    QImage image_;
    QString reason_;
    float exposureStops_ = 0;
    bool coverageShown_ = false;
};

}  // namespace ui
