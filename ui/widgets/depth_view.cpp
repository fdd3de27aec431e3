// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/depth_view.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "ui/canvas/display.h"

namespace ui {

namespace {

/// From where a new photograph is seen: far enough aside that depth in the wrong order or scale looks wrong.
constexpr double kFirstYaw = 25 * std::numbers::pi / 180;
constexpr double kFirstPitch = 14 * std::numbers::pi / 180;
constexpr double kQuarterTurn = std::numbers::pi / 2;
constexpr double kKeyTurn = 5 * std::numbers::pi / 180;
constexpr double kZoomStep = 1.2;
constexpr double kMinZoom = 0.01;
constexpr double kMaxZoom = 100;
/// Points nearer to the second camera than this share of its distance are behind its lens.
constexpr float kNearShare = 0.02f;
/// Neighbours seen at an angle still touch.
constexpr float kOverlap = 1.4f;
constexpr int kMaxSplat = 8;  ///< [px]
/// A neighbour whose depth differs by more than this many point sizes belongs to something else.
constexpr float kMaxSlope = 3;
constexpr QRgb kBackground = qRgb(34, 34, 34);

/// Mean colour of a cell of the photograph, from up to 3 x 3 of its pixels.
QRgb cellColor(const core::ImageRgb& color, double left, double top, double width, double height) {
    core::Vector3f sum(0, 0, 0);
    constexpr std::array<double, 3> kPlaces{1.0 / 6, 0.5, 5.0 / 6};
    for (const double v : kPlaces)
        for (const double u : kPlaces) {
            const int x = std::clamp(static_cast<int>(left + u * width), 0, color.width() - 1);
            const int y = std::clamp(static_cast<int>(top + v * height), 0, color.height() - 1);
            sum += color(x, y);
        }
    return displayColor(sum / 9).rgb();
}

/// What a point of size `size` stands for when it also closes the gaps to its neighbours on the same surface, such as
/// the steps of coarsely stored depth.
float closedSize(const core::ImageF& depth, int x, int y, int step, float size) {
    const float z = depth(x, y);
    float gap = size;
    for (const auto& [u, v] : {std::pair{x + step, y}, {x - step, y}, {x, y + step}, {x, y - step}}) {
        if (!depth.contains(u, v) || !(depth(u, v) > 0)) continue;
        const float difference = std::abs(depth(u, v) - z);
        if (difference <= kMaxSlope * size) gap = std::max(gap, difference);
    }
    return gap;
}

float atShare(std::vector<float>& values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The largest of 1, 2 and 5 times a power of ten that is not above `value`.
double roundLength(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

}  // namespace

DepthPoints makeDepthPoints(const core::ImageRgb& color, const core::ImageF& depth, const core::Camera& camera,
                            int maxCount) {
    DepthPoints points;
    points.camera = camera;
    if (depth.empty() || color.empty()) return points;
    const int step =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(depth.size()) / std::max(1, maxCount)))));
    const double sx = static_cast<double>(camera.width) / depth.width();
    const double sy = static_cast<double>(camera.height) / depth.height();
    std::vector<float> depths;
    for (int y = step / 2; y < depth.height(); y += step)
        for (int x = step / 2; x < depth.width(); x += step) {
            const float z = depth(x, y);
            if (!(z > 0)) continue;
            const auto u = static_cast<float>((x + 0.5) * sx);
            const auto v = static_cast<float>((y + 0.5) * sy);
            points.positions.emplace_back(camera.ray(u, v) * z);
            points.colors.push_back(cellColor(color, (x - step / 2) * sx, (y - step / 2) * sy, step * sx, step * sy));
            const double pitch =
                std::max(step * sx / static_cast<double>(camera.fx), step * sy / static_cast<double>(camera.fy));
            points.sizes.push_back(closedSize(depth, x, y, step, z * static_cast<float>(pitch)));
            depths.push_back(z);
        }
    if (depths.empty()) return points;
    points.nearest = atShare(depths, 0.02);
    points.middle = atShare(depths, 0.5);
    points.farthest = atShare(depths, 0.98);
    return points;
}

DepthView::DepthView(QWidget* parent) : QWidget(parent), yaw_(kFirstYaw), pitch_(kFirstPitch) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(tr("Depth in space"));
    setToolTip(tr("Drag to turn, wheel to zoom, double-click for the first view; or arrow keys, + and -, Home"));
}

QSize DepthView::sizeHint() const {
    const int unit = fontMetrics().height();
    return {32 * unit, 24 * unit};
}

QSize DepthView::minimumSizeHint() const { return sizeHint() / 2; }

void DepthView::setPoints(std::shared_ptr<const DepthPoints> points, const QString& reason) {
    points_ = points != nullptr && !points->empty() ? std::move(points) : nullptr;
    reason_ = points_ == nullptr ? reason : QString();
    if (fitted_) fit();
    update();
}

void DepthView::showSide(Side side) {
    switch (side) {
        case Side::Turned:
            setAngles(kFirstYaw, kFirstPitch);
            break;
        case Side::Front:
            setAngles(0, 0);
            break;
        case Side::Top:
            setAngles(0, kQuarterTurn);
            break;
        case Side::Right:
            setAngles(kQuarterTurn, 0);
            break;
    }
    fit();
}

void DepthView::setAngles(double yaw, double pitch) {
    yaw_ = std::remainder(yaw, 2 * std::numbers::pi);
    pitch_ = std::clamp(pitch, -kQuarterTurn, kQuarterTurn);
    update();
}

DepthView::Lens DepthView::lens(const QSize& size) const {
    const core::Camera& camera = points_->camera;
    Lens result;
    const Eigen::Matrix3d turned =
        (Eigen::AngleAxisd(pitch_, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(yaw_, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    result.rotation = turned.cast<float>();
    result.pivot = {0, 0, points_->middle};
    result.distance = points_->middle;
    const double scale =
        std::min(static_cast<double>(size.width()) / camera.width, static_cast<double>(size.height()) / camera.height) *
        zoom_;
    result.focal = Eigen::Vector2f(camera.fx, camera.fy) * static_cast<float>(scale);
    const Eigen::Vector2d place(
        size.width() * (0.5 + shift_.x()) + scale * (static_cast<double>(camera.cx) - 0.5 * camera.width),
        size.height() * (0.5 + shift_.y()) + scale * (static_cast<double>(camera.cy) - 0.5 * camera.height));
    result.center = place.cast<float>();
    return result;
}

void DepthView::fit() {
    fitted_ = true;
    zoom_ = 1;
    shift_ = {};
    update();
    if (points_ == nullptr || (yaw_ == 0 && pitch_ == 0)) return;
    // The outermost twentieths may lie anywhere: skies, flying pixels.
    constexpr double kOutside = 0.05;
    constexpr double kFilled = 0.9;
    const QSize size(std::max(1, width()), std::max(1, height()));
    const Lens from = lens(size);
    std::vector<float> us;
    std::vector<float> vs;
    for (const Eigen::Vector3f& position : points_->positions) {
        const Eigen::Vector3f p = from.rotation * (position - from.pivot);
        const float z = p.z() + from.distance;
        if (z < kNearShare * from.distance) continue;
        us.push_back(from.center.x() + from.focal.x() * p.x() / z);
        vs.push_back(from.center.y() + from.focal.y() * p.y() / z);
    }
    if (us.empty()) return;
    const double left = static_cast<double>(atShare(us, kOutside));
    const double right = static_cast<double>(atShare(us, 1 - kOutside));
    const double top = static_cast<double>(atShare(vs, kOutside));
    const double bottom = static_cast<double>(atShare(vs, 1 - kOutside));
    zoom_ = std::clamp(
        kFilled * std::min(size.width() / std::max(1.0, right - left), size.height() / std::max(1.0, bottom - top)),
        kMinZoom, 1.0);
    // The middle of the box comes to the middle of the widget; zooming keeps the distance from the widget's middle.
    shift_ =
        QPointF(zoom_ * (0.5 - (left + right) / 2 / size.width()), zoom_ * (0.5 - (top + bottom) / 2 / size.height()));
}

QImage DepthView::drawPoints(const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    image.fill(kBackground);
    if (points_ == nullptr) return image;
    const int width = size.width();
    const int height = size.height();
    const Lens from = lens(size);
    const float spread = kOverlap * std::max(from.focal.x(), from.focal.y());
    std::vector<float> nearest(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                               std::numeric_limits<float>::max());
    auto* pixels = reinterpret_cast<QRgb*>(image.bits());
    const auto stride = static_cast<std::size_t>(image.bytesPerLine()) / sizeof(QRgb);
    for (std::size_t i = 0; i < points_->positions.size(); ++i) {
        const Eigen::Vector3f p = from.rotation * (points_->positions[i] - from.pivot);
        const float z = p.z() + from.distance;
        if (z < kNearShare * from.distance) continue;
        const float u = from.center.x() + from.focal.x() * p.x() / z;
        const float v = from.center.y() + from.focal.y() * p.y() / z;
        const float side = std::clamp(spread * points_->sizes[i] / z, 1.0f, static_cast<float>(kMaxSplat));
        // Also refuses what does not fit an integer.
        if (!(u > -side && v > -side && u < static_cast<float>(width) + side && v < static_cast<float>(height) + side))
            continue;
        const int cells = static_cast<int>(side + 0.5f);
        const int left = static_cast<int>(std::floor(u - 0.5f * static_cast<float>(cells) + 0.5f));
        const int top = static_cast<int>(std::floor(v - 0.5f * static_cast<float>(cells) + 0.5f));
        const int right = std::min(left + cells, width);
        const int bottom = std::min(top + cells, height);
        const QRgb color = points_->colors[i];
        for (int y = std::max(top, 0); y < bottom; ++y) {
            float* depthRow = nearest.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
            QRgb* row = pixels + static_cast<std::size_t>(y) * stride;
            for (int x = std::max(left, 0); x < right; ++x) {
                if (z >= depthRow[x]) continue;
                depthRow[x] = z;
                row[x] = color;
            }
        }
    }
    return image;
}

void DepthView::drawCamera(QPainter& painter, const Lens& lens) const {
    const core::Camera& camera = points_->camera;
    const auto place = [&](const Eigen::Vector3f& position) -> std::optional<QPointF> {
        const Eigen::Vector3f p = lens.rotation * (position - lens.pivot);
        const float z = p.z() + lens.distance;
        if (z < kNearShare * lens.distance) return std::nullopt;
        const Eigen::Vector2f uv = lens.center + lens.focal.cwiseProduct(p.head<2>()) / z;
        constexpr float kFar = 20000;
        if (uv.cwiseAbs().maxCoeff() > kFar) return std::nullopt;
        return QPointF(static_cast<double>(uv.x()), static_cast<double>(uv.y()));
    };
    const auto w = static_cast<float>(camera.width);
    const auto h = static_cast<float>(camera.height);
    const std::array<Eigen::Vector3f, 4> corners{
        camera.ray(0, 0) * points_->nearest, camera.ray(w, 0) * points_->nearest, camera.ray(w, h) * points_->nearest,
        camera.ray(0, h) * points_->nearest};
    QColor color = palette().color(QPalette::Link);
    color.setAlphaF(0.7f);
    painter.setPen(color);
    const auto line = [&](const std::optional<QPointF>& a, const std::optional<QPointF>& b) {
        if (a && b) painter.drawLine(*a, *b);
    };
    const auto eye = place(Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        line(eye, place(corners[i]));
        line(place(corners[i]), place(corners[(i + 1) % corners.size()]));
    }
}

void DepthView::drawScale(QPainter& painter, const Lens& lens) const {
    const double pixelsPerMetre = static_cast<double>(lens.focal.x() / lens.distance);
    if (!(pixelsPerMetre > 0) || !std::isfinite(pixelsPerMetre)) return;
    const int unit = fontMetrics().height();
    const double metres = roundLength(8 * unit / pixelsPerMetre);
    const QString text = metres >= 1      ? tr("%1 m").arg(metres, 0, 'g', 4)
                         : metres >= 0.01 ? tr("%1 cm").arg(metres * 100, 0, 'g', 4)
                                          : tr("%1 mm").arg(metres * 1000, 0, 'g', 4);
    const QPointF start(unit / 2.0, height() - unit / 2.0);
    const QPointF end = start + QPointF(metres * pixelsPerMetre, 0);
    const QPointF tick(0, -unit / 3.0);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawPolyline(std::array{start + tick, start, end, end + tick}.data(), 4);
    painter.drawText(start + QPointF(unit / 3.0, -unit / 3.0), text);
}

void DepthView::paintEvent(QPaintEvent* event) {
    Q_UNUSED(event);
    QPainter painter(this);
    if (points_ == nullptr) {
        painter.fillRect(rect(), QColor(kBackground));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const int margin = fontMetrics().height();
        painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                         reason_);
    } else {
        const double ratio = devicePixelRatioF();
        QImage image = drawPoints((QSizeF(size()) * ratio).toSize());
        image.setDevicePixelRatio(ratio);
        painter.drawImage(QPointF(0, 0), image);
        painter.setRenderHint(QPainter::Antialiasing);
        const Lens from = lens(size());
        drawCamera(painter, from);
        drawScale(painter, from);
    }
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void DepthView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (fitted_) fit();
}

void DepthView::turn(double yaw, double pitch) { setAngles(yaw_ + yaw, pitch_ + pitch); }

void DepthView::zoomBy(double factor) {
    const double before = zoom_;
    zoom_ = std::clamp(zoom_ * factor, kMinZoom, kMaxZoom);
    shift_ *= zoom_ / before;
    fitted_ = false;
    update();
}

void DepthView::mousePressEvent(QMouseEvent* event) {
    lastPosition_ = event->position();
    if (event->button() == Qt::LeftButton) setFocus(Qt::MouseFocusReason);
}

void DepthView::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton)) return;
    const QPointF moved = event->position() - lastPosition_;
    lastPosition_ = event->position();
    // Half a turn across the widget; the scene follows the pointer.
    const double angle = std::numbers::pi / std::max(1, std::min(width(), height()));
    turn(-moved.x() * angle, moved.y() * angle);
}

void DepthView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) showSide(Side::Turned);
}

void DepthView::wheelEvent(QWheelEvent* event) {
    constexpr double kUnitsPerStep = 120;
    zoomBy(std::pow(kZoomStep, event->angleDelta().y() / kUnitsPerStep));
    event->accept();
}

void DepthView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            return turn(kKeyTurn, 0);
        case Qt::Key_Right:
            return turn(-kKeyTurn, 0);
        case Qt::Key_Up:
            return turn(0, -kKeyTurn);
        case Qt::Key_Down:
            return turn(0, kKeyTurn);
        case Qt::Key_Plus:
            return zoomBy(kZoomStep);
        case Qt::Key_Minus:
            return zoomBy(1 / kZoomStep);
        case Qt::Key_Home:
            return showSide(Side::Turned);
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace ui
