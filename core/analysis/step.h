// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/analysis/step_context.h"
#include "core/geometry/depth_layers.h"
#include "core/scene/changes.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Content hash of the inputs of a step; 64 bits, not cryptographic.
class Hash {
  public:
    template <class T>
    requires std::is_trivially_copyable_v<T> Hash& add(const T& value) { return bytes(&value, sizeof(T)); }
    Hash& add(const Vector3f& v) { return bytes(v.data(), sizeof(float) * 3); }
    Hash& add(const std::string& text) { return add(text.size()).bytes(text.data(), text.size()); }
    template <class T>
    Hash& add(const Image<T>& image) {
        add(image.width()).add(image.height());
        return bytes(image.data(), image.size() * sizeof(T));
    }
    [[nodiscard]] std::uint64_t value() const { return state_ ^ (state_ >> 29); }

  private:
    Hash& bytes(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (; size >= 8; size -= 8, bytes += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes, 8);
            mix(word);
        }
        std::uint64_t rest = size + 1;
        for (std::size_t i = 0; i < size; ++i) rest = rest << 8 | bytes[i];
        mix(rest);
        return *this;
    }
    void mix(std::uint64_t word) {
        state_ = (std::rotl(state_, 23) ^ word) * 0x9E3779B97F4A7C15ull;
        state_ ^= state_ >> 32;
    }
    std::uint64_t state_ = 0x51ED270B0A1F3C49ull;
};

/// Adds the parameters whose first stage is `stage` (core/scene/params.h): those of the scene, or of one segment.
Hash& addParams(Hash& hash, Stage stage, const Scene& scene);
Hash& addParams(Hash& hash, Stage stage, const Segment& segment);

/// What steps exchange. The first three come with the scene, the others are computed.
enum class Item {
    Photo,
    UserBackDepth,
    UserEnvironment,
    Depth,
    Front,
    Back,
    Layers,
    Reflectances,
    Environment,
    TextureDetail,
    Count
};

/// Depth as all later steps use it.
struct RecoveredDepth {
    ImageF depth;                 ///< planar z [m], 0 = none
    Image<std::uint8_t> distant;  ///< 1 = shows distant light (`findDistantPixels`)
    /// Estimated standard deviation of the depth divided by it; 0 = exact.
    float relativeNoise = 0;
    std::map<std::uint16_t, float> smoothing;  ///< [px] by label, as Analysis::smoothing
};

/// Result of the back-side step.
struct BackLayer {
    Surface surface;
    std::vector<BackSideInfo> segments;
};

struct SegmentReflections;

/// One segment's reflections with the key they were computed for: segments are recomputed one by one.
struct CachedReflectance {
    std::uint64_t key = 0;
    std::shared_ptr<const SegmentReflections> reflections;
};

/// Everything computed so far. A step reads and writes only what it declares.
struct Board {
    const Scene* scene = nullptr;
    std::shared_ptr<const RecoveredDepth> depth;
    std::shared_ptr<const Surface> front;
    std::shared_ptr<const BackLayer> back;
    std::shared_ptr<const DepthLayers> layers;
    // Item::Reflectances is both of these.
    std::vector<std::shared_ptr<const Reflectance>> reflectances;
    std::vector<std::shared_ptr<const SegmentReflections>> reflections;  ///< what they were estimated from
    std::shared_ptr<const DirectionalMap> environment;
    std::shared_ptr<const ImageF> textureDetail;

    std::uint64_t layersKey = 0;  ///< content of Item::Layers, for `reflectanceCache`
    std::map<std::uint16_t, CachedReflectance> reflectanceCache;
};

/// One node of the processing graph. Its result is kept as long as the items it reads and its parameters do not change.
struct Step {
    Task task = Task::Working;
    std::vector<Item> reads;
    Item writes = Item::Count;
    /// Adds all parameters of the scene that affect the result.
    void (*params)(const Scene&, Hash&) = nullptr;
    /// Computes the result and writes its item last, so that cancelling keeps the old one.
    void (*run)(Board&, const StepContext&) = nullptr;
};

/// Photo → Depth: filtered, filled and smoothed (docs/method.md#depth).
Step recoverDepthStep();
/// Depth → Front: normals, positions, patch areas (docs/method.md#depth).
Step computeNormalsStep();
/// Front → Back: the unseen side (docs/method.md#back-side).
Step backSideStep();
/// Front, Back → Layers: what rays march through.
Step depthLayersStep();
/// Layers → Reflectances: L_S, L_G and ρ of every glossy segment (docs/method.md#reflectance).
Step reflectanceStep();
/// Reflectances → Environment (docs/method.md#environment).
Step environmentStep();
/// Front → TextureDetail: the photograph's texture apart from its shading.
Step textureDetailStep();

}  // namespace core::analysis
