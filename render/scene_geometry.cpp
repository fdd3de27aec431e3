// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_geometry.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/base/clock.h"
#include "gpu/adapter.h"
#include "kernels/build_pyramid.h"
#include "render/kernels/kernels.h"

namespace render {
namespace {

constexpr std::size_t kTexelBytes = 4 * sizeof(float);
constexpr std::uint64_t kMinPyramidCells = 16 * 16;  // fits on any device
constexpr int kTexelsAtOnce = 1 << 16;               // per layer; takes some milliseconds

/// Cells of 2^level pixels along `pixels`.
std::uint32_t cellsAlong(std::uint32_t pixels, std::uint32_t level) {
    return (pixels + (std::uint32_t{1} << level) - 1) >> level;
}

std::vector<float> texelsOf(const core::Image<core::Vector3f>& image) {
    std::vector<float> texels(image.size() * 4, 1.0f);
    for (std::size_t i = 0; i < image.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) texels[4 * i + c] = image[i][static_cast<Eigen::Index>(c)];
    return texels;
}

}  // namespace

std::uint64_t PyramidShape::cells() const {
    return std::uint64_t{blocks} * 4 * ((2 * std::uint64_t{rows} + 3) / 4 * 4);
}

PyramidShape pyramidShape(std::uint32_t width, std::uint32_t height, std::uint64_t maxCells) {
    constexpr std::uint32_t kLevels = 8;  // up to cells of 256 pixels, few of which cross a picture
    PyramidShape shape;
    const auto levels = std::min(static_cast<std::uint32_t>(std::bit_width(std::max(width, height) - 1)), kLevels);
    for (shape.finest = 0;; ++shape.finest) {
        shape.top = std::max(levels, shape.finest);
        shape.blocks = (cellsAlong(width, shape.finest) + 3) / 4;
        shape.rows = cellsAlong(height, shape.top) << (shape.top - shape.finest);
        if (shape.cells() <= maxCells || shape.cells() <= kMinPyramidCells) return shape;
    }
}

SceneGeometry::SceneGeometry(const gpu::Device& device, std::uint64_t maxPyramidCells)
    : device_(device),
      layout_(makeGeometryLayout(device)),
      maxPyramidCells_(
          std::min(maxPyramidCells, std::uint64_t{kernel::kPyramidWidth} * device.limits().maxTextureDimension2D)) {
    using enum gpu::BindingType;
    const gpu::BindGroupLayout build = makeLayout(device, "build_pyramid",
                                                  {{BUILD_PYRAMID_FRONT_PATCH, SampledTexture},
                                                   {BUILD_PYRAMID_BACK_PATCH, SampledTexture},
                                                   {BUILD_PYRAMID_RANGES, ReadWriteStorageTexture}});
    buildPyramid_ =
        makePipeline(device, "build_pyramid", build_pyramid_spv, {build}, sizeof(kernel::BuildPyramidBlock));
    block_ = device.createBuffer({.label = "geometry",
                                  .size = sizeof(kernel::GeometryBlock),
                                  .usage = gpu::BufferUsage::Uniform | gpu::BufferUsage::CopyDst});
}

void SceneGeometry::requireFits(std::uint32_t width, std::uint32_t height) const {
    const gpu::Limits& limits = device_.limits();
    const std::uint64_t bytes = std::uint64_t{width} * height * kTexelBytes;
    const auto fail = [&](const std::string& limit) {
        throw gpu::Error(gpu::ErrorKind::OutOfMemory, "The picture (" + std::to_string(width) + "x" +
                                                          std::to_string(height) + ") is too large for the device \"" +
                                                          device_.adapterInfo().name + "\": " + limit + ".");
    };
    if (std::max(width, height) > limits.maxTextureDimension2D)
        fail("its textures have at most " + std::to_string(limits.maxTextureDimension2D) + " texels on a side");
    if (bytes > limits.maxBufferSize)
        fail("its textures have at most " + std::to_string(limits.maxBufferSize) + " bytes and one layer needs " +
             std::to_string(bytes));
    // Six layers, the accumulated picture, its filtered copy, the result, and the pyramid.
    if (limits.deviceMemory > 0 && 10 * bytes > limits.deviceMemory)
        fail("it has " + std::to_string(limits.deviceMemory) + " bytes of memory and the layers need " +
             std::to_string(10 * bytes));
}

void SceneGeometry::requireBufferFits(const char* what, std::uint64_t bytes) const {
    if (bytes > device_.limits().maxStorageBufferBindingSize)
        throw gpu::Error(gpu::ErrorKind::OutOfMemory,
                         std::string("The ") + what + " need " + std::to_string(bytes) +
                             " bytes, and a buffer of the device \"" + device_.adapterInfo().name + "\" has at most " +
                             std::to_string(device_.limits().maxStorageBufferBindingSize) + ".");
}

gpu::Texture SceneGeometry::upload(const char* label, std::uint32_t width, std::uint32_t height,
                                   const std::vector<float>& texels) const {
    gpu::Texture texture = device_.createTexture(
        {.label = label,
         .size = {width, height},
         .format = gpu::TextureFormat::RGBA32Float,
         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst | gpu::TextureUsage::CopySrc});
    device_.queue().writeTexture(texture, texels.data(), texels.size() * sizeof(float));
    return texture;
}

gpu::Texture SceneGeometry::makeLayer(const char* label) const {
    return device_.createTexture(
        {.label = label,
         .size = {width_, height_},
         .format = gpu::TextureFormat::RGBA32Float,
         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst | gpu::TextureUsage::CopySrc});
}

void SceneGeometry::setLayers(const core::DepthLayers& layers, const core::ImageRgb& photo, const core::Surface& front,
                              const core::Surface& back) {
    beginLayers(layers, photo, front, back);
    uploadRows(std::numeric_limits<double>::infinity());
}

void SceneGeometry::setPatches(const core::DepthLayers& layers) {
    begin({.layers = &layers});
    const gpu::Texture nothing = upload("no picture", 1, 1, std::vector<float>(4, 0.0f));
    frontColor_ = backColor_ = frontNormal_ = backNormal_ = nothing;
    uploadRows(std::numeric_limits<double>::infinity());
    setEnvironment(core::DirectionalMap());
}

void SceneGeometry::beginLayers(const core::DepthLayers& layers, const core::ImageRgb& photo,
                                const core::Surface& front, const core::Surface& back) {
    CORE_ASSERT(layers.front.sameSize(photo) && layers.back.sameSize(photo) && layers.labels.sameSize(photo) &&
                    front.normal.sameSize(photo) && back.normal.sameSize(photo) && back.color.sameSize(photo),
                "layers of one size");
    begin({.layers = &layers, .photo = &photo, .front = &front, .back = &back});
    frontColor_ = makeLayer("photo");
    backColor_ = makeLayer("back colour");
    frontNormal_ = makeLayer("front normal");
    backNormal_ = makeLayer("back normal");
}

void SceneGeometry::begin(const Source& source) {
    const core::DepthLayers& layers = *source.layers;
    const auto width = static_cast<std::uint32_t>(layers.front.width());
    const auto height = static_cast<std::uint32_t>(layers.front.height());
    requireFits(width, height);
    source_ = source;
    camera_ = layers.camera;
    width_ = width;
    height_ = height;
    minW_ = kernel::kEmptyRangeMin;
    maxW_ = kernel::kEmptyRangeMax;
    frontPatch_ = makeLayer("front patch");
    backPatch_ = makeLayer("back patch");
    constexpr std::uint64_t kRow = kernel::kPyramidWidth;
    shape_ = render::pyramidShape(width, height, maxPyramidCells_);
    pyramid_ = device_.createTexture(
        {.label = "pyramid",
         .size = {kernel::kPyramidWidth, static_cast<std::uint32_t>((shape_.cells() + kRow - 1) / kRow)},
         .format = gpu::TextureFormat::R32Uint,
         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::StorageBinding | gpu::TextureUsage::CopySrc});
    pyramidStale_ = true;
    group_ = {};
}

bool SceneGeometry::uploadRows(double seconds) {
    const auto start = core::Clock::now();
    const auto height = static_cast<int>(height_);
    const int rowsAtOnce = std::max(1, kTexelsAtOnce / static_cast<int>(std::max(width_, 1u)));
    while (source_.layers != nullptr) {
        const int first = source_.row;
        const int rows = std::min(rowsAtOnce, height - first);
        uploadPatches(first, rows);
        if (source_.photo != nullptr) {
            uploadImage(frontColor_, *source_.photo, first, rows);
            uploadImage(backColor_, source_.back->color, first, rows);
            uploadImage(frontNormal_, source_.front->normal, first, rows);
            uploadImage(backNormal_, source_.back->normal, first, rows);
        }
        source_.row += rows;
        if (source_.row == height) {
            source_ = {};
            texels_ = {};
        }
        if (core::secondsSince(start) > seconds) break;
    }
    return source_.layers == nullptr;
}

void SceneGeometry::writeRows(const gpu::Texture& texture, int firstRow, int rows) {
    device_.queue().writeTexture({.texture = texture, .origin = {0, static_cast<std::uint32_t>(firstRow), 0}},
                                 texels_.data(), texels_.size() * sizeof(float), {},
                                 {width_, static_cast<std::uint32_t>(rows), 1});
}

void SceneGeometry::uploadPatches(int firstRow, int rows) {
    const core::DepthLayers& layers = *source_.layers;
    const std::size_t first = layers.front.index(0, firstRow);
    const std::size_t count = std::size_t{width_} * static_cast<std::size_t>(rows);
    texels_.resize(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const core::DepthLayers::Patch& f = layers.front[first + i];
        const core::DepthLayers::Patch& b = layers.back[first + i];
        const float texel[] = {f.w, f.gu, f.gv, static_cast<float>(layers.labels[first + i])};
        std::copy_n(texel, 4, &texels_[4 * i]);
        const kernel::vec2 range = kernel::pixelRange({f.w, f.gu, f.gv, 0}, {b.w, b.gu, b.gv, 0});
        minW_ = std::min(minW_, range.x);
        maxW_ = std::max(maxW_, range.y);
    }
    writeRows(frontPatch_, firstRow, rows);
    for (std::size_t i = 0; i < count; ++i) {
        const core::DepthLayers::Patch& b = layers.back[first + i];
        const float texel[] = {b.w, b.gu, b.gv, 0};
        std::copy_n(texel, 4, &texels_[4 * i]);
    }
    writeRows(backPatch_, firstRow, rows);
}

void SceneGeometry::uploadImage(const gpu::Texture& texture, const core::ImageV3& image, int firstRow, int rows) {
    const std::size_t first = image.index(0, firstRow);
    const std::size_t count = std::size_t{width_} * static_cast<std::size_t>(rows);
    texels_.resize(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(image[first + i].data(), 3, &texels_[4 * i]);
        texels_[4 * i + 3] = 1;
    }
    writeRows(texture, firstRow, rows);
}

void SceneGeometry::setEnvironment(const core::DirectionalMap& environment, core::LightSampling lightSampling) {
    core::EnvironmentSampler sampler;
    if (environment.empty()) {
        environment_ = upload("environment", 2, 1, std::vector<float>(8, 0.0f));
    } else {
        const auto width = static_cast<std::uint32_t>(environment.radiance.width());
        const auto height = static_cast<std::uint32_t>(environment.radiance.height());
        if (std::max(width, height) > device_.limits().maxTextureDimension2D)
            throw gpu::Error(gpu::ErrorKind::OutOfMemory,
                             "The environment map (" + std::to_string(width) + "x" + std::to_string(height) +
                                 ") is too large for the device \"" + device_.adapterInfo().name + "\": at most " +
                                 std::to_string(device_.limits().maxTextureDimension2D) + " texels on a side.");
        std::vector<float> texels = texelsOf(environment.radiance);
        if (lightSampling == core::LightSampling::Both) sampler = core::EnvironmentSampler(environment);
        for (std::size_t i = 0; i < environment.radiance.size(); ++i)
            texels[4 * i + 3] = sampler.empty() ? 0.0f : sampler.density()[i];
        environment_ = upload("environment", width, height, texels);
    }
    environmentTable_ = makeBuffer(device_, "environment table", gpu::BufferUsage::Storage,
                                   std::vector<float>(sampler.table().begin(), sampler.table().end()));
    environmentBlock_ = {};
    environmentBlock_.environmentWidth = environment_.width();
    environmentBlock_.environmentHeight = environment_.height();
    environmentBlock_.tableColumns = static_cast<std::uint32_t>(sampler.columns());
    environmentBlock_.tableRows = static_cast<std::uint32_t>(sampler.rows());
    environmentBlock_.tableCell = static_cast<std::uint32_t>(sampler.cellSize());
    environmentBlock_.meanLuminance = sampler.meanLuminance();
    environmentBlock_.environmentSampled = sampler.empty() ? 0 : 1;
    group_ = {};
}

const gpu::BindGroup& SceneGeometry::bindGroup() {
    if (group_) return group_;
    kernel::GeometryBlock block = environmentBlock_;
    block.camera = {camera_.fx, camera_.fy, camera_.cx, camera_.cy};
    block.width = width_;
    block.height = height_;
    block.pyramidTop = shape_.top;
    block.pyramidFinest = shape_.finest;
    block.pyramidRows = shape_.rows;
    block.pyramidBlocks = shape_.blocks;
    block.minW = minW_;
    block.maxW = maxW_;
    device_.queue().writeBuffer(block_, 0, &block, sizeof(block));
    group_ = device_.createBindGroup(
        {.label = "geometry",
         .layout = layout_,
         .entries = {{.binding = GEOMETRY_BLOCK, .buffer = block_},
                     {.binding = GEOMETRY_PYRAMID, .textureView = pyramid_.createView()},
                     {.binding = GEOMETRY_FRONT_PATCH, .textureView = frontPatch_.createView()},
                     {.binding = GEOMETRY_BACK_PATCH, .textureView = backPatch_.createView()},
                     {.binding = GEOMETRY_FRONT_COLOR, .textureView = frontColor_.createView()},
                     {.binding = GEOMETRY_BACK_COLOR, .textureView = backColor_.createView()},
                     {.binding = GEOMETRY_FRONT_NORMAL, .textureView = frontNormal_.createView()},
                     {.binding = GEOMETRY_BACK_NORMAL, .textureView = backNormal_.createView()},
                     {.binding = GEOMETRY_ENVIRONMENT, .textureView = environment_.createView()},
                     {.binding = GEOMETRY_ENVIRONMENT_TABLE, .buffer = environmentTable_}}});
    return group_;
}

void SceneGeometry::record(const gpu::CommandEncoder& encoder) {
    if (!pyramidStale_) return;
    recordPyramid(encoder);
    pyramidStale_ = false;
}

void SceneGeometry::recordPyramid(const gpu::CommandEncoder& encoder) {
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "build_pyramid",
         .layout = buildPyramid_.getBindGroupLayout(0),
         .entries = {{.binding = BUILD_PYRAMID_FRONT_PATCH, .textureView = frontPatch_.createView()},
                     {.binding = BUILD_PYRAMID_BACK_PATCH, .textureView = backPatch_.createView()},
                     {.binding = BUILD_PYRAMID_RANGES, .textureView = pyramid_.createView()}}});
    const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = "build pyramid"});
    pass.setPipeline(buildPyramid_);
    pass.setBindGroup(0, group);
    kernel::BuildPyramidBlock block;
    block.finest = shape_.finest;
    block.blocks = shape_.blocks;
    block.rows = shape_.rows;
    block.minW = minW_;
    block.scale = kernel::rangeScale(minW_, maxW_);
    block.sourceWidth = width_;
    block.sourceHeight = height_;
    for (std::uint32_t level = shape_.finest; level <= shape_.top; ++level) {
        block.step = level - shape_.finest;
        block.width = cellsAlong(width_, level);
        block.height = cellsAlong(height_, level);
        pass.setImmediates(0, block);
        pass.dispatchWorkgroups((block.width + kTileSize - 1) / kTileSize, (block.height + kTileSize - 1) / kTileSize);
        block.sourceWidth = block.width;
        block.sourceHeight = block.height;
    }
    pass.end();
}

void recordList(const gpu::CommandEncoder& encoder, const char* label, const gpu::ComputePipeline& pipeline,
                SceneGeometry& geometry, const gpu::BindGroup& group, const void* block, std::size_t blockSize,
                std::uint32_t count) {
    if (count == 0) return;
    const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = label});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, geometry.bindGroup());
    pass.setBindGroup(1, group);
    pass.setImmediates(0, block, blockSize);
    const ListGroups groups = listGroups(count, encoder.device().limits());
    pass.dispatchWorkgroups(groups.x, groups.y);
    pass.end();
}

}  // namespace render
