// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/selection/selection_picture.h"

namespace core {

namespace {

/// Colour difference (OKLab) that is half a boundary where nothing around is textured.
constexpr float kColorContrast = 0.035f;
/// Half-width of the window in which texture is measured [working px].
constexpr int kTextureRadius = 9;
/// Weight of texture against the contrast of a boundary.
constexpr float kTextureWeight = 1.3f;
/// Share of the colour's boundaries that exact depth leaves where it sees a smooth surface.
constexpr float kColorOnSmoothDepth = 0.45f;
/// Cosines between the normals on both sides of a crease: none, and a full boundary.
constexpr float kNoCrease = 0.985f;
constexpr float kFullCrease = 0.80f;
/// Strengths of a full concave and convex crease. Solids meet in concave ones ([SSPW14]).
constexpr float kConcave = 0.85f;
constexpr float kConvex = 0.22f;
/// Strength of the border of the region without depth.
constexpr float kDepthEnds = 0.8f;
/// The same where the map's edges lie beside those of the photograph: sensors fail within objects too, on dark and
/// shiny spots.
constexpr float kSensorFails = 0.05f;
/// Largest distance looked at between an edge of the depth map and one of the photograph [working px].
constexpr int kMaxOffset = 12;

/// One direction in the picture: right or down.
struct Axis {
    int dx, dy;
};
constexpr Axis kRight{1, 0};
constexpr Axis kDown{0, 1};

template <class T>
const T& clampedAt(const Image<T>& image, int x, int y) {
    return image(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
}

/// Contrast between (x, y) and its neighbour, antialiased edges included.
float colorContrast(const ImageV3& lab, int x, int y, Axis axis) {
    const float near = (lab(x, y) - lab(x + axis.dx, y + axis.dy)).norm();
    const float wide =
        (clampedAt(lab, x - axis.dx, y - axis.dy) - clampedAt(lab, x + 2 * axis.dx, y + 2 * axis.dy)).norm();
    return 0.5f * (near + wide);
}

/// Sum over windows of 2·radius+1 pixels along one axis.
ImageF boxMean(const ImageF& image, int radius, Axis axis, const Progress& progress) {
    ImageF result(image.width(), image.height());
    const int lines = axis.dx != 0 ? image.height() : image.width();
    const int length = axis.dx != 0 ? image.width() : image.height();
    const auto at = [&](int line, int i) { return axis.dx != 0 ? image(i, line) : image(line, i); };
    parallelFor(progress, lines, [&](int line) {
        std::vector<double> sums(static_cast<std::size_t>(length) + 1);
        for (int i = 0; i < length; ++i)
            sums[static_cast<std::size_t>(i) + 1] =
                sums[static_cast<std::size_t>(i)] + static_cast<double>(at(line, i));
        for (int i = 0; i < length; ++i) {
            const int from = std::max(0, i - radius);
            const int to = std::min(length, i + radius + 1);
            const double mean =
                (sums[static_cast<std::size_t>(to)] - sums[static_cast<std::size_t>(from)]) / (to - from);
            (axis.dx != 0 ? result(i, line) : result(line, i)) = static_cast<float>(mean);
        }
    });
    return result;
}

/// Largest value in windows of 2·radius+1 pixels along one axis.
ImageF boxMax(const ImageF& image, int radius, Axis axis, const Progress& progress) {
    ImageF result(image.width(), image.height());
    parallelFor(progress, image.height(), [&](int y) {
        for (int x = 0; x < image.width(); ++x)
            for (int k = -radius; k <= radius; ++k)
                result(x, y) = std::max(result(x, y), clampedAt(image, x + k * axis.dx, y + k * axis.dy));
    });
    return result;
}

/// 0 below `low`, 1 above `high`.
float ramp(float value, float low, float high) {
    const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Strength of the depth step between (x, y) and its neighbour: neither side, continued as a plane, reaches the other.
float depthStep(const SelectionPicture& picture, int x, int y, Axis axis) {
    const ImageF& w = picture.inverseDepth;
    const float a = w(x, y);
    const float b = w(x + axis.dx, y + axis.dy);
    if (!(a > 0) && !(b > 0)) return 0;
    if (!(a > 0) || !(b > 0)) return kDepthEnds;
    const int span = picture.quality.span;
    const float beforeA = clampedAt(w, x - span * axis.dx, y - span * axis.dy);
    const float afterB = clampedAt(w, x + (1 + span) * axis.dx, y + (1 + span) * axis.dy);
    const auto length = static_cast<float>(span);
    const float direct = std::abs(a - b);
    const float fromA = beforeA > 0 ? std::abs(a + (a - beforeA) / length - b) : direct;
    const float fromB = afterB > 0 ? std::abs(b + (b - afterB) / length - a) : direct;
    const float step = std::min({fromA, fromB, direct}) / std::max(a, b);
    const float noise = picture.quality.noise;
    return ramp(step, 0.001f + 2 * noise, 0.006f + 6 * noise);
}

/// Strength of the crease between (x, y) and its neighbour.
float crease(const SelectionPicture& picture, int x, int y, Axis axis) {
    const int reach = picture.quality.span;
    const int ax = x - (reach - 1) * axis.dx, ay = y - (reach - 1) * axis.dy;
    const int bx = x + reach * axis.dx, by = y + reach * axis.dy;
    const ImageF& w = picture.inverseDepth;
    if (!w.contains(ax, ay) || !w.contains(bx, by) || !(w(ax, ay) > 0) || !(w(bx, by) > 0)) return 0;
    const Vector3f& na = picture.normal(ax, ay);
    const Vector3f& nb = picture.normal(bx, by);
    const float bend = ramp(-na.dot(nb), -kNoCrease, -kFullCrease);
    if (bend == 0) return 0;
    const Vector3f between =
        picture.camera.backProject(ax, ay, 1 / w(ax, ay)) - picture.camera.backProject(bx, by, 1 / w(bx, by));
    return bend * ((na - nb).dot(between) < 0 ? kConcave : kConvex);
}

/// Strengths of one cue along both axes, [0, 1].
struct CueStrength {
    ImageF right, down;
    CueStrength(int width, int height) : right(width, height), down(width, height) {}
    [[nodiscard]] ImageF& along(Axis axis) { return axis.dx != 0 ? right : down; }
    [[nodiscard]] const ImageF& along(Axis axis) const { return axis.dx != 0 ? right : down; }
};

/// Calls `strength(x, y, axis)` for every pair of neighbours.
template <class Strength>
CueStrength measure(int width, int height, const Progress& progress, const Strength& strength) {
    CueStrength cue(width, height);
    parallelFor(progress, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            if (x + 1 < width) cue.right(x, y) = strength(x, y, kRight);
            if (y + 1 < height) cue.down(x, y) = strength(x, y, kDown);
        }
    });
    return cue;
}

/// Strength of colour boundaries relative to the texture around them.
CueStrength colorBoundaries(const SelectionPicture& picture, const Progress& progress) {
    const int width = picture.lab.width();
    const int height = picture.lab.height();
    CueStrength contrast = measure(width, height, progress.part(0, 0.4f),
                                   [&](int x, int y, Axis axis) { return colorContrast(picture.lab, x, y, axis); });
    ImageF texture(width, height);
    for (std::size_t i = 0; i < texture.size(); ++i)
        texture[i] = std::min(0.15f, std::max(contrast.right[i], contrast.down[i]));
    texture = boxMean(texture, kTextureRadius, kRight, progress.part(0.4f, 0.6f));
    texture = boxMean(texture, kTextureRadius, kDown, progress.part(0.6f, 0.8f));
    parallelFor(progress.part(0.8f, 1.0f), height, [&](int y) {
        for (int x = 0; x < width; ++x)
            for (const Axis axis : {kRight, kDown}) {
                float& value = contrast.along(axis)(x, y);
                const float scale =
                    kColorContrast * kColorContrast + kTextureWeight * texture(x, y) * kTextureWeight * texture(x, y);
                value = value * value / (value * value + scale);
            }
    });
    return contrast;
}

/// Distance between the edges of the depth map and those of the photograph: 0 where most lie on each other, otherwise
/// one within which most of the strongest colour edges across a depth edge are found [working px].
int measureEdgeOffset(const CueStrength& depth, const CueStrength& color) {
    std::array<std::size_t, kMaxOffset + 1> found{};
    std::size_t count = 0;
    const int width = depth.right.width();
    const int height = depth.right.height();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const Axis axis : {kRight, kDown}) {
                if (depth.along(axis)(x, y) < 0.7f || (x * 7 + y * 3) % 4 != 0) continue;
                int best = -1;
                float strongest = 0.3f;
                for (int k = 0; k <= kMaxOffset; ++k)
                    for (const int sign : {-1, 1}) {
                        const int px = x + sign * k * axis.dx, py = y + sign * k * axis.dy;
                        if (!depth.right.contains(px, py) || color.along(axis)(px, py) <= strongest * 1.05f) continue;
                        strongest = color.along(axis)(px, py);
                        best = k;
                    }
                if (best < 0) continue;
                ++found[static_cast<std::size_t>(best)];
                ++count;
            }
    if (count < 50) return 0;
    std::size_t sum = found[0] + found[1];
    if (2 * sum > count) return 0;
    int offset = 1;
    while (offset < kMaxOffset && 3 * sum < 2 * count) sum += found[static_cast<std::size_t>(++offset)];
    return offset;
}

/// Takes most of their strength from the borders of areas without depth.
void weakenHoles(const SelectionPicture& picture, CueStrength& steps) {
    const ImageF& w = picture.inverseDepth;
    for (int y = 0; y < w.height(); ++y)
        for (int x = 0; x < w.width(); ++x)
            for (const Axis axis : {kRight, kDown})
                if (w.contains(x + axis.dx, y + axis.dy) && (w(x, y) > 0) != (w(x + axis.dx, y + axis.dy) > 0))
                    steps.along(axis)(x, y) = kSensorFails;
}

float atLeastOne(float a, float b) { return 1 - (1 - a) * (1 - b); }

}  // namespace

BoundaryStrength findBoundaries(SelectionPicture& picture, const Progress& progress) {
    const int width = picture.lab.width();
    const int height = picture.lab.height();
    CueStrength color = colorBoundaries(picture, progress.part(0, 0.4f));
    CueStrength shape(width, height);
    CueStrength near(width, height);
    DepthQuality& quality = picture.quality;
    if (quality.present) {
        CueStrength steps = measure(width, height, progress.part(0.4f, 0.6f),
                                    [&](int x, int y, Axis axis) { return depthStep(picture, x, y, axis); });
        quality.edgeOffset = measureEdgeOffset(steps, color);
        if (quality.edgeOffset > 0) weakenHoles(picture, steps);
        shape = measure(width, height, progress.part(0.6f, 0.8f), [&](int x, int y, Axis axis) {
            return std::max(steps.along(axis)(x, y), crease(picture, x, y, axis));
        });
        if (quality.edgeOffset > 0) {
            ImageF strongest(width, height);
            for (std::size_t i = 0; i < strongest.size(); ++i) strongest[i] = std::max(shape.right[i], shape.down[i]);
            strongest = boxMax(strongest, quality.edgeOffset, kRight, progress.part(0.8f, 0.85f));
            near.right = near.down = boxMax(strongest, quality.edgeOffset, kDown, progress.part(0.85f, 0.9f));
        }
    }
    BoundaryStrength result{Image<std::uint8_t>(width, height), Image<std::uint8_t>(width, height)};
    parallelFor(progress.part(0.9f, 1.0f), height, [&](int y) {
        for (int x = 0; x < width; ++x)
            for (const Axis axis : {kRight, kDown}) {
                if (x + axis.dx >= width || y + axis.dy >= height) continue;
                const bool smooth = picture.inverseDepth(x, y) > 0;
                float fromColor = color.along(axis)(x, y);
                float fromShape = shape.along(axis)(x, y);
                if (quality.edgeOffset > 0) {
                    fromColor *= smooth ? 0.4f + 0.6f * near.along(axis)(x, y) : 1.0f;
                    fromShape *= 0.5f;
                } else if (smooth) {
                    fromColor *= kColorOnSmoothDepth;
                }
                const float strength = std::clamp(atLeastOne(fromColor, fromShape), 0.0f, 1.0f);
                (axis.dx != 0 ? result.right : result.down)(x, y) = static_cast<std::uint8_t>(255 * strength + 0.5f);
            }
    });
    return result;
}

}  // namespace core
