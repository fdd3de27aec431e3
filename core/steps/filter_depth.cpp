// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/filter_depth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Filter depth";

/// Display encoding, a plain 1/2.2 power: the filter's colour range is in what the eye compares.
ImageRgb encodeColor(const ImageRgb& color, const StepContext& context) {
    ImageRgb encoded(color.width(), color.height());
    parallelFor(
        context, kName, color.height(),
        [&](int y) {
            for (int x = 0; x < color.width(); ++x)
                encoded(x, y) = color(x, y).cwiseMax(0.0f).cwiseMin(1.0f).array().pow(1 / 2.2f);
        },
        0.0f, 0.1f);
    return encoded;
}

float median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Relative step between neighbouring stored values, 0 when the depth is not quantised: then nearly every pixel has a
/// value of its own.
float relativeQuantum(const ImageF& depth) {
    std::vector<float> values;
    const std::size_t stride = depth.size() / 200000 + 1;
    for (std::size_t i = 0; i < depth.size(); i += stride)
        if (depth[i] > 0) values.push_back(depth[i]);
    const std::size_t count = values.size();
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    if (values.size() < 3 || values.size() * 4 > count) return 0;
    std::vector<float> gaps;
    for (std::size_t i = 1; i < values.size(); ++i) gaps.push_back(values[i] / values[i - 1] - 1);
    return median(gaps);
}

}  // namespace

float estimateRelativeNoise(const ImageF& depth, const LabelImage& labels) {
    std::vector<float> residuals;
    const auto add = [&](std::size_t i, std::size_t step) {
        const std::size_t a = i - step;
        const std::size_t b = i + step;
        if (depth[a] <= 0 || depth[b] <= 0 || labels[a] != labels[i] || labels[b] != labels[i]) return;
        residuals.push_back(std::abs(0.5f * (depth[i] / depth[a] + depth[i] / depth[b]) - 1));
    };
    const auto width = static_cast<std::size_t>(depth.width());
    const int stride = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(depth.size()) / 100000)));
    for (int y = 1; y + 1 < depth.height(); y += stride) {
        for (int x = 1; x + 1 < depth.width(); x += stride) {
            const std::size_t i = depth.index(x, y);
            if (depth[i] <= 0) continue;
            add(i, 1);
            add(i, width);
        }
    }
    if (residuals.empty()) return 0;
    // median |r| = 0.6745 σ_r and σ_r² = 1.5 σ²; a uniform error of one quantum has σ = quantum/√12.
    const float measured = median(residuals) / (0.6745f * std::sqrt(1.5f));
    return std::max(measured, relativeQuantum(depth) / std::sqrt(12.0f));
}

ImageF filterDepth(const ImageF& depth, const ImageRgb& color, const LabelImage& labels,
                   const DepthFilterParams& params, float relativeNoise, const StepContext& context) {
    const float depthSigma = std::min(params.depthSigma, 3 * relativeNoise);
    if (!params.enabled || params.spatialSigma <= 0 || depthSigma <= 1e-7f) return depth;

    struct Pair {
        int dx, dy;
        float exponent;
    };
    const int radius = std::clamp(static_cast<int>(std::ceil(2 * params.spatialSigma)), 1, 16);
    std::vector<Pair> pairs;
    for (int dy = 0; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx)
            if ((dy > 0 || dx > 0) && dx * dx + dy * dy <= radius * radius)
                pairs.push_back(
                    {dx, dy, static_cast<float>(dx * dx + dy * dy) / (2 * params.spatialSigma * params.spatialSigma)});
    const ImageRgb encoded = encodeColor(color, context);
    const float colorFactor = 1 / (2 * std::max(params.colorSigma, 1e-4f) * std::max(params.colorSigma, 1e-4f));
    const float depthFactor = 1 / (2 * depthSigma * depthSigma);
    // Either pixel of a pair may differ more: a slope is no discontinuity, but a jump of several σ is.
    const float jump = 8 * params.depthSigma;

    ImageF result(depth.width(), depth.height());
    parallelFor(
        context, kName, depth.height(),
        [&](int y) {
            for (int x = 0; x < depth.width(); ++x) {
                const float z = depth(x, y);
                if (z <= 0) continue;
                const std::uint16_t label = labels(x, y);
                const Vector3f& center = encoded(x, y);
                float sum = 1;
                float weight = 1;
                for (const Pair& pair : pairs) {
                    const int ax = x + pair.dx, ay = y + pair.dy, bx = x - pair.dx, by = y - pair.dy;
                    if (!depth.contains(ax, ay) || !depth.contains(bx, by)) continue;
                    const float za = depth(ax, ay);
                    const float zb = depth(bx, by);
                    if (za <= 0 || zb <= 0 || labels(ax, ay) != label || labels(bx, by) != label) continue;
                    const float wa = z / za;
                    const float wb = z / zb;
                    if (std::abs(wa - 1) > jump || std::abs(wb - 1) > jump) continue;
                    const float mean = 0.5f * (wa + wb);
                    const float residual = mean - 1;
                    const float exponent =
                        pair.exponent + residual * residual * depthFactor +
                        ((encoded(ax, ay) - center).squaredNorm() + (encoded(bx, by) - center).squaredNorm()) *
                            colorFactor;
                    if (exponent > 10) continue;
                    const float k = 2 * std::exp(-exponent);
                    sum += k * mean;
                    weight += k;
                }
                result(x, y) = z * weight / sum;
            }
        },
        0.1f, 1.0f);
    return result;
}

void fillSmallHoles(ImageF& depth, const LabelImage& labels, int radius) {
    if (radius <= 0) return;
    radius = std::min(radius, 64);
    const ImageF original = depth;
    Image<std::uint8_t> visited(depth.width(), depth.height(), 0);
    constexpr std::array<std::array<int, 2>, 4> kNeighbors{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    // A hole of which every pixel is within `radius` of valid depth cannot be longer than its outline allows, so the
    // flood stops early only in area: a thin scratch across the segment is a small hole too.
    const auto nearValid = [&](int x, int y) {
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (dx * dx + dy * dy <= radius * radius && depth.contains(x + dx, y + dy) &&
                    labels(x + dx, y + dy) == labels(x, y) && original(x + dx, y + dy) > 0)
                    return true;
        return false;
    };
    const auto fill = [&](int x, int y) {
        // Plane in inverse depth: weighted least squares about the hole pixel, nearest neighbours first.
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
        double low = 1e30;
        double high = 0;
        const int reach = radius + 2;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                if (!depth.contains(x + dx, y + dy) || labels(x + dx, y + dy) != labels(x, y)) continue;
                const double z = original(x + dx, y + dy);
                if (z <= 0) continue;
                const double squared = dx * dx + dy * dy;
                const Eigen::Vector3d row(1, dx, dy);
                const double weight = 1 / (squared * squared);
                normal += weight * row * row.transpose();
                rhs += weight / z * row;
                low = std::min(low, 1 / z);
                high = std::max(high, 1 / z);
            }
        }
        normal.diagonal() += Eigen::Vector3d(0, 1e-9, 1e-9) * normal(0, 0);
        const double w = normal.ldlt().solve(rhs)[0];
        return static_cast<float>(1 / std::clamp(w, low, high));
    };

    std::vector<std::array<int, 2>> hole;
    for (int startY = 0; startY < depth.height(); ++startY) {
        for (int startX = 0; startX < depth.width(); ++startX) {
            if (visited(startX, startY) != 0 || original(startX, startY) > 0 || labels(startX, startY) == 0) continue;
            const std::uint16_t label = labels(startX, startY);
            hole.assign(1, {startX, startY});
            visited(startX, startY) = 1;
            bool small = true;
            for (std::size_t next = 0; next < hole.size(); ++next) {
                const auto [x, y] = hole[next];
                small = small && nearValid(x, y);
                for (const auto& [dx, dy] : kNeighbors) {
                    const int nx = x + dx;
                    const int ny = y + dy;
                    if (!depth.contains(nx, ny) || visited(nx, ny) != 0 || labels(nx, ny) != label ||
                        original(nx, ny) > 0)
                        continue;
                    visited(nx, ny) = 1;
                    hole.push_back({nx, ny});
                }
            }
            if (!small) continue;
            for (const auto& [x, y] : hole) depth(x, y) = fill(x, y);
        }
    }
}

void completeSegments(ImageF& depth, const LabelImage& labels, const StepContext& context) {
    struct Box {
        int x0 = 1 << 30, y0 = 1 << 30, x1 = -1, y1 = -1;
        bool known = false, missing = false;
    };
    std::vector<Box> boxes(65536);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            Box& box = boxes[labels(x, y)];
            box.x0 = std::min(box.x0, x), box.x1 = std::max(box.x1, x);
            box.y0 = std::min(box.y0, y), box.y1 = std::max(box.y1, y);
            (depth(x, y) > 0 ? box.known : box.missing) = true;
        }
    }

    /// Inverse depth times weight, and weight.
    using Level = Image<Eigen::Vector2d>;
    for (std::size_t label = 1; label < boxes.size(); ++label) {
        const Box& box = boxes[label];
        if (!box.known || !box.missing) continue;
        context.checkpoint(kName, 1.0f);
        Level finest(box.x1 - box.x0 + 1, box.y1 - box.y0 + 1);
        const auto inside = [&](int x, int y) {
            return finest.contains(x, y) && labels(box.x0 + x, box.y0 + y) == label;
        };
        for (int y = 0; y < finest.height(); ++y)
            for (int x = 0; x < finest.width(); ++x)
                if (inside(x, y) && depth(box.x0 + x, box.y0 + y) > 0)
                    finest(x, y) = {1.0 / static_cast<double>(depth(box.x0 + x, box.y0 + y)), 1.0};

        // Pull: averages of what is known, over ever larger cells; push: what is unknown takes the next larger cell's.
        std::vector<Level> levels{finest};
        while (levels.back().width() > 1 || levels.back().height() > 1) {
            const Level& fine = levels.back();
            Level coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
            for (int y = 0; y < fine.height(); ++y)
                for (int x = 0; x < fine.width(); ++x) coarse(x / 2, y / 2) += fine(x, y);
            levels.push_back(std::move(coarse));
        }
        for (std::size_t l = levels.size() - 1; l-- > 0;) {
            for (int y = 0; y < levels[l].height(); ++y) {
                for (int x = 0; x < levels[l].width(); ++x) {
                    Eigen::Vector2d& cell = levels[l](x, y);
                    const Eigen::Vector2d& parent = levels[l + 1](x / 2, y / 2);
                    if (cell.y() <= 0) cell = {parent.x() / parent.y(), 1.0};
                }
            }
        }

        // Relax the filled pixels to a membrane over the known ones.
        constexpr int kRounds = 200;
        std::vector<std::array<int, 2>> missing;
        for (int y = 0; y < finest.height(); ++y)
            for (int x = 0; x < finest.width(); ++x)
                if (inside(x, y) && finest(x, y).y() <= 0) missing.push_back({x, y});
        Level& values = levels.front();
        for (int round = 0; round < kRounds; ++round) {
            for (const auto& [x, y] : missing) {
                double sum = 0;
                double count = 0;
                for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    if (!inside(x + dx, y + dy)) continue;
                    sum += values(x + dx, y + dy).x();
                    count += 1;
                }
                if (count > 0) values(x, y).x() = sum / count;
            }
        }
        for (const auto& [x, y] : missing) depth(box.x0 + x, box.y0 + y) = static_cast<float>(1.0 / values(x, y).x());
    }
}

Step filterDepthStep() {
    Step step;
    step.name = kName;
    step.reads = {Item::Photo};
    step.writes = Item::Depth;
    step.params = [](const Scene& scene, Hash& hash) {
        const DepthFilterParams& p = scene.depthFilter;
        hash.add(p.enabled).add(p.automatic).add(p.spatialSigma).add(p.colorSigma).add(p.depthSigma).add(p.holeRadius);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        auto result = std::make_shared<FilteredDepth>();
        ImageF depth = photo.depth;
        for (float& z : depth.pixels())
            if (!(z > 0) || !std::isfinite(z)) z = 0;
        if (std::ranges::none_of(depth.pixels(), [](float z) { return z > 0; }))
            throw Error(ErrorKind::Input,
                        "The depth map has no valid pixel: all of its " + std::to_string(depth.size()) +
                            " values are zero or not finite, but at least one positive depth is needed. Load a depth "
                            "map that belongs to the photograph, or check its unit and kind.");
        result->relativeNoise = estimateRelativeNoise(depth, photo.labels);
        result->depth =
            filterDepth(depth, photo.color, photo.labels, board.scene->depthFilter, result->relativeNoise, context);
        if (board.scene->depthFilter.enabled)
            fillSmallHoles(result->depth, photo.labels, board.scene->depthFilter.holeRadius);
        completeSegments(result->depth, photo.labels, context);
        board.depth = std::move(result);
    };
    return step;
}

}  // namespace core::steps
