// SPDX-License-Identifier: GPL-3.0-or-later
// Organised point clouds (Point Cloud Library, PCD 0.7): a raster of points with colours. Intrinsics follow from the
// points themselves. A point without x or y is none, whatever its z: filters of the library write one there.
#include <cmath>
#include <limits>

#include "core/io/color_decode.h"
#include "core/io/import/pcd_points.h"

namespace core {

namespace {

/// RMS residual of the pin-hole fit [px].
constexpr double kMaxResidual = 2;
/// Points needed for a reliable fit.
constexpr std::size_t kMinCloudPoints = 100;

bool recognisesPcd(const ImportFile& file) {
    return file.head().starts_with("# .PCD") ||
           (file.head().starts_with("VERSION") && file.head().find("\nFIELDS ") != std::string::npos);
}

const PcdField& requireReal(const ImportFile& file, const PcdHeader& header, const char* name) {
    const PcdField* field = header.find(name);
    if (field == nullptr || field->type != 'F' || field->size < 4)
        file.fail(Message("messages", "the point cloud has no field \"%1\" of type F and size 4 or 8")
                      .with(std::string(name)));
    return *field;
}

/// Least squares line through (slope of the ray, image coordinate): focal length and principal point.
class AxisFit {
  public:
    void add(double slope, double coordinate) {
        ++n_;
        sx_ += slope;
        sy_ += coordinate;
        sxx_ += slope * slope;
        sxy_ += slope * coordinate;
        syy_ += coordinate * coordinate;
    }
    [[nodiscard]] double focal() const { return (n_ * sxy_ - sx_ * sy_) / (n_ * sxx_ - sx_ * sx_); }
    [[nodiscard]] double center() const { return (sy_ - focal() * sx_) / n_; }
    /// Root mean square distance from the line.
    [[nodiscard]] double residual() const {
        const double f = focal();
        const double c = center();
        const double sum = syy_ + f * f * sxx_ + n_ * c * c - 2 * f * sxy_ - 2 * c * sy_ + 2 * f * c * sx_;
        return std::sqrt(std::max(sum, 0.0) / n_);
    }

  private:
    double n_ = 0, sx_ = 0, sy_ = 0, sxx_ = 0, sxy_ = 0, syy_ = 0;
};

Camera fitCamera(const ImportFile& file, const PcdPoints& points, const PcdField& x, const PcdField& y,
                 const ImageF& depth) {
    AxisFit horizontal;
    AxisFit vertical;
    std::size_t valid = 0;
    for (int v = 0; v < depth.height(); ++v)
        for (int u = 0; u < depth.width(); ++u) {
            const std::size_t i = depth.index(u, v);
            const auto z = static_cast<double>(depth[i]);
            const double slopeX = points.real(x, i) / z;
            const double slopeY = points.real(y, i) / z;
            if (!(z > 0) || !std::isfinite(slopeX) || !std::isfinite(slopeY)) continue;
            horizontal.add(slopeX, u + 0.5);
            vertical.add(slopeY, v + 0.5);
            ++valid;
        }
    if (valid < kMinCloudPoints)
        file.fail(Message("messages", "only %1 points have x, y and z > 0, expected %2 or more")
                      .with(valid, kMinCloudPoints));
    const Camera camera{depth.width(),
                        depth.height(),
                        static_cast<float>(horizontal.focal()),
                        static_cast<float>(vertical.focal()),
                        static_cast<float>(horizontal.center()),
                        static_cast<float>(vertical.center())};
    const double residual = std::max(horizontal.residual(), vertical.residual());
    if (!(camera.fx > 0) || !(camera.fy > 0) || !(residual <= kMaxResidual)) {
        file.fail(
            Message("messages",
                    "its raster is not what a pin-hole camera sees (fx=%1, fy=%2, off by %3 pixels), expected x to "
                    "the right, y downwards, z forward")
                .with(camera.fx, camera.fy, residual));
    }
    return camera;
}

ImportedPhoto readPcd(const ImportFile& file) {
    const PcdPoints points(file);
    const PcdHeader& header = points.header();
    const PcdField& x = requireReal(file, header, "x");
    const PcdField& y = requireReal(file, header, "y");
    const PcdField& z = requireReal(file, header, "z");
    const PcdField* color = header.find("rgba");
    if (color == nullptr) color = header.find("rgb");
    if (color == nullptr || color->size != 4)
        file.fail(
            Message("messages", "the point cloud has no colours, expected a field \"rgb\" or \"rgba\" of size 4"));

    ImportedPhoto photo;
    photo.kind = DepthKind::Z;
    photo.color = ImageRgb(header.width, header.height);
    photo.depth = ImageF(header.width, header.height);
    for (std::size_t i = 0; i < photo.depth.size(); ++i) {
        const bool placed = std::isfinite(points.real(x, i)) && std::isfinite(points.real(y, i));
        photo.depth[i] = placed ? static_cast<float>(points.real(z, i)) : std::numeric_limits<float>::quiet_NaN();
        const std::uint32_t argb = points.word(*color, i);
        photo.color[i] = Vector3f(static_cast<float>(argb >> 16U & 255U), static_cast<float>(argb >> 8U & 255U),
                                  static_cast<float>(argb & 255U)) /
                         255.0f;
    }
    decodeSrgb(photo.color.pixels());
    photo.camera = fitCamera(file, points, x, y, photo.depth);
    return photo;
}

}  // namespace

const ImportFormat pcdFormat{MESSAGE_TEXT("messages", "an organised point cloud (PCD)"), recognisesPcd, readPcd};

}  // namespace core
