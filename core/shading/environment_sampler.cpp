// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/environment_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/color.h"

namespace core {
namespace {

/// Mean luminance of the map's bilinear interpolation over each texel.
Image<double> texelLuminance(const ImageRgb& radiance) {
    const int width = radiance.width();
    const int height = radiance.height();
    constexpr double kWeight[3] = {0.125, 0.75, 0.125};
    Image<double> rows(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int i = -1; i <= 1; ++i)
                sum += kWeight[i + 1] * static_cast<double>(luminance(radiance((x + i + width) % width, y)));
            rows(x, y) = sum;
        }
    Image<double> result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int i = -1; i <= 1; ++i) sum += kWeight[i + 1] * rows(x, std::clamp(y + i, 0, height - 1));
            result(x, y) = sum;
        }
    return result;
}

/// Interval of cumulative probabilities that contains `u`, and the position inside it.
struct Interval {
    int index;
    float fraction;  ///< [0, 1)
};
Interval invert(std::span<const float> cumulative, float u) {
    const auto after = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, u);
    const auto index = static_cast<std::size_t>(after - cumulative.begin()) - 1;
    return {static_cast<int>(index), (u - cumulative[index]) / (cumulative[index + 1] - cumulative[index])};
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const DirectionalMap& map) {
    if (map.empty()) return;
    const int width = map.radiance.width();
    const int height = map.radiance.height();
    const Image<double> light = texelLuminance(map.radiance);
    double total = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            total += light(x, y) * static_cast<double>(DirectionalMap::texelSolidAngle(y, width, height));
    const double mean = total / (4 * std::numbers::pi);
    if (!(mean > 0) || !std::isfinite(mean)) return;

    const int cell = (width + kMaxColumns - 1) / kMaxColumns;
    const int columns = (width + cell - 1) / cell;
    const int rows = (height + cell - 1) / cell;
    Image<double> excess(columns, rows, 0.0);
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double value = std::max(light(x, y) - mean, 0.0) *
                                 static_cast<double>(DirectionalMap::texelSolidAngle(y, width, height));
            excess(x / cell, y / cell) += value;
            sum += value;
        }
    if (sum < kMinShare * total) return;

    columns_ = columns;
    rows_ = rows;
    cellSize_ = cell;
    meanLuminance_ = static_cast<float>(mean);
    const auto rowStart = [&](int y) {
        return static_cast<std::size_t>(rows + 1) + static_cast<std::size_t>(y) * static_cast<std::size_t>(columns + 1);
    };
    table_.assign(rowStart(rows), 0.0f);
    double before = 0;
    for (int y = 0; y < rows; ++y) {
        double row = 0;
        for (int x = 0; x < columns; ++x) row += excess(x, y);
        double inRow = 0;
        for (int x = 0; x < columns; ++x) {
            inRow += excess(x, y);
            const double share = row > 0 ? std::min(inRow / row, 1.0) : (x + 1.0) / columns;
            table_[rowStart(y) + static_cast<std::size_t>(x) + 1] = static_cast<float>(x + 1 == columns ? 1.0 : share);
        }
        before += row;
        table_[static_cast<std::size_t>(y) + 1] = static_cast<float>(y + 1 == rows ? 1.0 : std::min(before / sum, 1.0));
    }
    // Density of the rounded table, because that is the one sampled.
    density_ = ImageF(width, height);
    for (int y = 0; y < height; ++y) {
        const int r = y / cell;
        const double top = std::cos(std::numbers::pi * r * cell / height);
        const double bottom = std::cos(std::numbers::pi * std::min((r + 1) * cell, height) / height);
        const auto ry = static_cast<std::size_t>(r);
        const double rowShare = static_cast<double>(table_[ry + 1]) - static_cast<double>(table_[ry]);
        for (int x = 0; x < width; ++x) {
            const int c = x / cell;
            const std::size_t at = rowStart(r) + static_cast<std::size_t>(c);
            const double share = static_cast<double>(table_[at + 1]) - static_cast<double>(table_[at]);
            const double angle = 2 * std::numbers::pi * (std::min((c + 1) * cell, width) - c * cell) / width;
            density_(x, y) = static_cast<float>(rowShare * share / (angle * (top - bottom)));
        }
    }
}

EnvironmentSampler::Sample EnvironmentSampler::sample(float u, float v) const {
    CORE_ASSERT(!empty(), "an environment to sample");
    const std::span<const float> table(table_);
    const auto cells = static_cast<std::size_t>(columns_) + 1;
    const Interval row = invert(table.first(static_cast<std::size_t>(rows_) + 1), v);
    const Interval column = invert(
        table.subspan(static_cast<std::size_t>(rows_) + 1 + static_cast<std::size_t>(row.index) * cells, cells), u);
    const auto width = static_cast<float>(density_.width());
    const auto height = static_cast<float>(density_.height());
    const auto at = [](int index, int cell, float size) { return std::min(static_cast<float>(index * cell), size); };
    const float x0 = at(column.index, cellSize_, width);
    const float x1 = at(column.index + 1, cellSize_, width);
    constexpr float kPi = std::numbers::pi_v<float>;
    const float top = std::cos(kPi * at(row.index, cellSize_, height) / height);
    const float bottom = std::cos(kPi * at(row.index + 1, cellSize_, height) / height);
    const float cosine = top + (bottom - top) * row.fraction;
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
    const float phi = 2 * kPi * ((x0 + (x1 - x0) * column.fraction) / width - 0.5f);
    return {.direction = {sine * std::sin(phi), -cosine, sine * std::cos(phi)},
            .pdf = density_(column.index * cellSize_, row.index * cellSize_)};
}

float EnvironmentSampler::pdf(const Vector3f& d) const {
    if (empty()) return 0;
    const Vector2f texel = DirectionalMap::texelFromDirection(d, density_.width(), density_.height());
    return density_(std::clamp(static_cast<int>(texel.x()), 0, density_.width() - 1),
                    std::clamp(static_cast<int>(texel.y()), 0, density_.height() - 1));
}

}  // namespace core
