// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSize>

namespace ui {

/// Logical pixels (mouse positions, widget sizes) times the device pixel ratio.
[[nodiscard]] inline QPointF devicePosition(const QPointF& logical, double devicePixelRatio) {
    return logical * devicePixelRatio;
}

/// How the picture lies in the view: pan and zoom. Positions in the view are device pixels, positions in the picture
/// are picture pixels, both from the top-left corner.
class ViewTransform {
  public:
    static constexpr double kMinZoom = 1.0 / 64;
    static constexpr double kMaxZoom = 64;

    /// Empty sizes are allowed (minimised window, nothing open); every map is then the identity around the centre.
    void setSizes(const QSize& view, const QSize& picture);

    /// Device pixels per picture pixel.
    [[nodiscard]] double zoom() const { return zoom_; }
    [[nodiscard]] bool fitted() const { return fitted_; }

    /// Whole picture with a small margin, never above 100 %; stays fitted when a size changes.
    void fit();
    /// Keeps the picture point under `viewPosition` where it is, to half a device pixel.
    void zoomAt(const QPointF& viewPosition, double zoom);
    void zoomCentered(double zoom);
    void pan(const QPointF& deviceDelta);

    /// Picture point at the view's top-left corner. From 100 % up it lies on whole device pixels: a picture pixel must
    /// not be smeared over two.
    [[nodiscard]] QPointF origin() const;
    [[nodiscard]] QPointF toPicture(const QPointF& viewPosition) const;
    [[nodiscard]] QPointF toView(const QPointF& picturePosition) const;

  private:
    void clampCenter();

    QSize view_;
    QSize picture_;
    double zoom_ = 1;
    QPointF center_;  ///< picture point in the middle of the view
    bool fitted_ = true;
};

}  // namespace ui
