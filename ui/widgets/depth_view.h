// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/base/camera.h"
#include "core/base/image.h"

namespace ui {

/// A photograph as coloured points in space.
struct DepthPoints {
    core::Camera camera;  ///< of the photograph
    /// Camera frame [m], row by row.
    std::vector<Eigen::Vector3f> positions;
    std::vector<QRgb> colors;
    std::vector<float> sizes;  ///< side of the square facing the camera that a point stands for [m]
    // Planar depth [m] below which 2 %, 50 % and 98 % of the points lie.
    float nearest = 0;
    float middle = 0;
    float farthest = 0;
    [[nodiscard]] bool empty() const { return positions.empty(); }
};

inline constexpr int kMaxDepthPoints = 100000;

/// At most about `maxCount` points, on a grid of the depth map's pixels. `color` is scene-linear and has the camera's
/// size; `depth` is planar z [m] in the same layout, of any resolution, 0 = none.
[[nodiscard]] DepthPoints makeDepthPoints(const core::ImageRgb& color, const core::ImageF& depth,
                                          const core::Camera& camera, int maxCount = kMaxDepthPoints);

/// Shows a photograph's points as a second camera sees them, which the user moves around their median depth: dragging
/// turns, the wheel zooms, a double click shows the first view again; arrow keys, + and -, Home do the same. Lines
/// show the photograph's own camera, a bar the scale.
class DepthView : public QWidget {
    Q_OBJECT
  public:
    enum class Side { Turned, Front, Top, Right };

    explicit DepthView(QWidget* parent = nullptr);

    /// nullptr or no points: `reason` is shown. The direction of view stays.
    void setPoints(std::shared_ptr<const DepthPoints> points, const QString& reason = {});
    [[nodiscard]] const DepthPoints* points() const { return points_.get(); }
    /// What is shown instead of points; "" = points.
    [[nodiscard]] const QString& reason() const { return reason_; }

    /// Looks from one side and makes everything fit.
    void showSide(Side side);

    /// Angles [rad] by which the second camera has moved around the middle of the scene, to the right and upwards,
    /// seen from the photograph's camera. Pitch is in [-π/2, π/2].
    void setAngles(double yaw, double pitch);
    [[nodiscard]] double yaw() const { return yaw_; }
    [[nodiscard]] double pitch() const { return pitch_; }
    /// 1 shows the photograph as large as the widget when seen from the front.
    [[nodiscard]] double zoom() const { return zoom_; }
    /// Moves the picture [fractions of its width and height].
    [[nodiscard]] QPointF shift() const { return shift_; }

    /// Draws the points alone, for a widget of this size [px].
    [[nodiscard]] QImage drawPoints(const QSize& size) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    /// The second camera: a point p of the scene is seen at center + focal·(x/z, y/z) of rotation·(p − pivot) + (0, 0,
    /// distance).
    struct Lens {
        Eigen::Matrix3f rotation;
        Eigen::Vector3f pivot;  ///< camera frame [m]
        float distance = 1;     ///< [m]
        Eigen::Vector2f focal;  ///< [px]
        Eigen::Vector2f center;
    };
    [[nodiscard]] Lens lens(const QSize& size) const;
    void fit();
    void turn(double yaw, double pitch);
    void zoomBy(double factor);
    void drawCamera(QPainter& painter, const Lens& lens) const;
    void drawScale(QPainter& painter, const Lens& lens) const;

    std::shared_ptr<const DepthPoints> points_;
    QString reason_;
    double yaw_ = 0;
    double pitch_ = 0;
    double zoom_ = 1;
    QPointF shift_;
    bool fitted_ = true;  ///< until the user zooms
    QPointF lastPosition_;
};

}  // namespace ui
