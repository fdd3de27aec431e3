// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/image.h"

namespace ui {

/// Two pictures of one segment's two layers: its thickness as seen by the camera (brighter = thicker), and a side view,
/// the outline of front and back in z over y in the column where the segment is thickest.
class ProfileView : public QWidget {
    Q_OBJECT
  public:
    explicit ProfileView(QWidget* parent = nullptr);

    void clear(const QString& reason);
    void show(const core::LabelImage& labels, std::uint16_t label, const core::Surface& front,
              const core::Surface& back);
    /// Largest z_back − z_front of the segment shown [m]; 0 when nothing is shown.
    [[nodiscard]] float maxThickness() const { return maxThickness_; }

    [[nodiscard]] QSize sizeHint() const override { return {260, 170}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString reason_;
    QImage thickness_;
    std::vector<QPointF> frontLine_;  ///< (z, y) [m]
    std::vector<QPointF> backLine_;
    float maxThickness_ = 0;
};

}  // namespace ui
