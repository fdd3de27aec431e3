// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Environment";
constexpr int kMaxUserRows = 1024;

}  // namespace

DirectionalMap recoverEnvironment(const Photo& photo, const ImageF& depth, int mapHeight,
                                  std::span<const std::shared_ptr<const Reflectance>> reflectances,
                                  std::span<const std::shared_ptr<const SegmentReflections>> reflections,
                                  const StepContext& context) {
    CORE_ASSERT(reflectances.size() == reflections.size(), "one ρ per segment");
    DirectionalAccumulator sum(std::clamp(mapHeight, 4, 2048));
    for (std::size_t i = 0; i < reflections.size(); ++i)
        sum.add(reflections[i]->missed, reflectances[i]->rho.cwiseMax(1e-3f).cwiseInverse());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int y = 0; y < depth.height(); ++y) {
        context.checkpoint(kName, 0.3f * static_cast<float>(y) / static_cast<float>(depth.height()));
        for (int x = 0; x < depth.width(); ++x) {
            mean += photo.color(x, y).cast<double>();
            if (depth(x, y) > 0) continue;
            bool mixed = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    mixed = mixed || (depth.contains(x + dx, y + dy) && depth(x + dx, y + dy) > 0);
            if (!mixed) sum.add(photo.camera.pixelRay(x, y).normalized(), photo.color(x, y));
        }
    }
    mean /= static_cast<double>(std::max<std::size_t>(1, depth.size()));
    DirectionalMap map = sum.map();
    fillDirections(map, mean.cast<float>(), kName, context, 0.3f, 1.0f);
    return map;
}

DirectionalMap userEnvironment(const ImageRgb& image, float rotation, float scale, const StepContext& context) {
    const int height = std::clamp(image.height(), 1, kMaxUserRows);
    const int width = 2 * height;
    DirectionalMap map{ImageRgb(width, height), ImageF(width, height, 1.0f)};
    const float turns = rotation / (2 * std::numbers::pi_v<float>);
    const float shift = turns - std::floor(turns);
    // Bilinear samples spread over the texel: as many as source texels it spans.
    const auto samples = [](int source, int target) { return std::clamp((source + target - 1) / target, 1, 32); };
    const int countX = samples(image.width(), width);
    const int countY = samples(image.height(), height);
    const DirectionalMap source{image, {}};
    const Vector2f size(static_cast<float>(image.width()), static_cast<float>(image.height()));
    parallelFor(context, kName, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Vector3f sum = Vector3f::Zero();
            for (int j = 0; j < countY; ++j) {
                for (int i = 0; i < countX; ++i) {
                    const float u =
                        (static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / static_cast<float>(countX)) /
                            static_cast<float>(width) -
                        shift;
                    const float v =
                        (static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(countY)) /
                        static_cast<float>(height);
                    sum += source.lookupTexel(size.cwiseProduct(Vector2f(u, v)));
                }
            }
            map.radiance(x, y) = scale / static_cast<float>(countX * countY) * sum;
        }
    });
    return map;
}

Step environmentStep() {
    Step step;
    step.name = kName;
    step.reads = {Item::Photo, Item::Depth, Item::Reflectances, Item::UserEnvironment};
    step.writes = Item::Environment;
    step.params = [](const Scene& scene, Hash& hash) {
        const EnvironmentParams& p = scene.environment;
        if (p.image) hash.add(p.rotation).add(p.scale);
        hash.add(p.use).add(p.fill).add(p.height);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Scene& scene = *board.scene;
        const EnvironmentParams& p = scene.environment;
        board.environment = std::make_shared<DirectionalMap>(
            p.image && !p.image->empty() ? userEnvironment(*p.image, p.rotation, p.scale, context)
                                         : recoverEnvironment(*scene.photo, board.depth->depth, p.height,
                                                              board.reflectances, board.reflections, context));
    };
    return step;
}

}  // namespace core::steps
