// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "core/analysis/analysis.h"
#include "core/base/directional_map.h"
#include "core/base/image.h"
#include "core/geometry/depth_layers.h"
#include "core/shading/environment_sampler.h"
#include "gpu/command_encoder.h"
#include "gpu/device.h"
#include "gpu/texture.h"
#include "shaders/shared/build_pyramid_block.h"
#include "shaders/shared/geometry_block.h"

namespace render {

/// Levels of the min/max pyramid and their layout in its texture (kernel::pyramidIndex).
struct PyramidShape {
    std::uint32_t finest = 0;  ///< first level that is stored: cells of 2^finest pixels
    std::uint32_t top = 0;     ///< last level
    std::uint32_t blocks = 0;  ///< blocks of 4x4 cells along a row of the finest level
    std::uint32_t rows = 0;    ///< rows of cells of the finest level, rounded up; each level has half as many
    [[nodiscard]] std::uint64_t cells() const;
};
/// Shape for an image of this size; leaves out the finest levels that would need more than `maxCells`.
[[nodiscard]] PyramidShape pyramidShape(std::uint32_t width, std::uint32_t height, std::uint64_t maxCells);

/// The photographed scene on the device: both layers, the pyramid over them, the light. Bind group 0 of all kernels
/// that read the scene (shaders/lib/geometry.glsl).
class SceneGeometry {
  public:
    /// The pyramid has at most `maxPyramidCells`, and no more than the device has room for.
    explicit SceneGeometry(const gpu::Device& device,
                           std::uint64_t maxPyramidCells = std::numeric_limits<std::uint64_t>::max());

    /// Throws gpu::Error(OutOfMemory) when a picture of this size is larger than the device allows.
    void requireFits(std::uint32_t width, std::uint32_t height) const;
    /// The same for a buffer; `what` is a noun in the plural.
    void requireBufferFits(const char* what, std::uint64_t bytes) const;
    /// Uploads only the patches, for marching; colours, normals and light are black.
    void setPatches(const core::DepthLayers& layers);
    /// Uploads a new picture.
    void setLayers(const core::DepthLayers& layers, const core::ImageRgb& photo, const core::Surface& front,
                   const core::Surface& back);
    /// Begins to upload a new picture; `uploadRows` does the work. The arguments have to live until it is done.
    void beginLayers(const core::DepthLayers& layers, const core::ImageRgb& photo, const core::Surface& front,
                     const core::Surface& back);
    /// Continues for about `seconds`, at least by a few rows; true when everything is uploaded.
    bool uploadRows(double seconds);
    /// Uploads the light and the table for sampling it; an empty map is black.
    void setEnvironment(const core::DirectionalMap& environment,
                        core::LightSampling lightSampling = core::LightSampling::Both);

    /// Builds the pyramid if the layers are new; to be called before kernels that march.
    void record(const gpu::CommandEncoder& encoder);
    /// Builds the pyramid in any case.
    void recordPyramid(const gpu::CommandEncoder& encoder);

    [[nodiscard]] const gpu::BindGroupLayout& layout() const { return layout_; }
    /// Valid once layers and environment are set.
    [[nodiscard]] const gpu::BindGroup& bindGroup();
    [[nodiscard]] const gpu::Texture& photo() const { return frontColor_; }
    [[nodiscard]] const gpu::Texture& pyramid() const { return pyramid_; }
    [[nodiscard]] const PyramidShape& pyramidShape() const { return shape_; }
    /// Range of inverse depth of all solids [1/m]; first > second when there is none.
    [[nodiscard]] std::pair<float, float> rangeOfW() const { return {minW_, maxW_}; }
    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }

  private:
    /// Picture that is uploaded row by row; only patches when the other pointers are null.
    struct Source {
        const core::DepthLayers* layers = nullptr;
        const core::ImageRgb* photo = nullptr;
        const core::Surface* front = nullptr;
        const core::Surface* back = nullptr;
        int row = 0;
    };
    void begin(const Source& source);
    void uploadPatches(int firstRow, int rows);
    void uploadImage(const gpu::Texture& texture, const core::ImageV3& image, int firstRow, int rows);
    void writeRows(const gpu::Texture& texture, int firstRow, int rows);
    [[nodiscard]] gpu::Texture makeLayer(const char* label) const;
    [[nodiscard]] gpu::Texture upload(const char* label, std::uint32_t width, std::uint32_t height,
                                      const std::vector<float>& texels) const;
    gpu::Device device_;
    gpu::BindGroupLayout layout_;
    gpu::ComputePipeline buildPyramid_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::uint64_t maxPyramidCells_;
    PyramidShape shape_;
    float minW_ = 0, maxW_ = 0;
    gpu::Texture frontPatch_, backPatch_, frontColor_, backColor_, frontNormal_, backNormal_, environment_;
    gpu::Texture pyramid_;
    gpu::Buffer environmentTable_;
    kernel::GeometryBlock environmentBlock_;  ///< its members about the environment
    gpu::Buffer block_;
    core::Camera camera_;
    gpu::BindGroup group_;
    Source source_;              ///< without layers when nothing is being uploaded
    std::vector<float> texels_;  ///< scratch
    bool pyramidStale_ = false;
};

/// Records one dispatch over a list of `count` items with the geometry in group 0, `group` in group 1 and `block` as
/// immediates. Nothing for an empty list.
void recordList(const gpu::CommandEncoder& encoder, const char* label, const gpu::ComputePipeline& pipeline,
                SceneGeometry& geometry, const gpu::BindGroup& group, const void* block, std::size_t blockSize,
                std::uint32_t count);
template <class Block>
void recordList(const gpu::CommandEncoder& encoder, const char* label, const gpu::ComputePipeline& pipeline,
                SceneGeometry& geometry, const gpu::BindGroup& group, const Block& block, std::uint32_t count) {
    recordList(encoder, label, pipeline, geometry, group, &block, sizeof(block), count);
}

}  // namespace render
