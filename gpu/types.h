// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace gpu {

/// Enumerations that are sets of bits; they combine with | and &, and `has` asks for all of some bits.
template <class E>
inline constexpr bool kIsFlags = false;
template <class E>
concept Flags = std::is_enum_v<E> && kIsFlags<E>;

template <Flags E>
constexpr E operator|(E a, E b) {
    using U = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<U>(a) | static_cast<U>(b));
}
template <Flags E>
constexpr E operator&(E a, E b) {
    using U = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<U>(a) & static_cast<U>(b));
}
template <Flags E>
constexpr E& operator|=(E& a, E b) {
    return a = a | b;
}
template <Flags E>
constexpr bool has(E set, E bits) {
    return (set & bits) == bits;
}

enum class BufferUsage : std::uint32_t {
    None = 0,
    MapRead = 1,   ///< may only be combined with CopyDst
    MapWrite = 2,  ///< may only be combined with CopySrc
    CopySrc = 4,
    CopyDst = 8,
    Index = 16,
    Vertex = 32,
    Uniform = 64,
    Storage = 128,
    Indirect = 256,
    QueryResolve = 512,
};
template <>
inline constexpr bool kIsFlags<BufferUsage> = true;

enum class TextureUsage : std::uint32_t {
    None = 0,
    CopySrc = 1,
    CopyDst = 2,
    TextureBinding = 4,
    StorageBinding = 8,
    RenderAttachment = 16,
};
template <>
inline constexpr bool kIsFlags<TextureUsage> = true;

enum class ShaderStage : std::uint32_t { None = 0, Vertex = 1, Fragment = 2, Compute = 4 };
template <>
inline constexpr bool kIsFlags<ShaderStage> = true;

enum class TextureFormat {
    Undefined,
    R8Unorm,
    RGBA8Unorm,
    RGBA8UnormSrgb,
    BGRA8Unorm,
    R16Float,
    RGBA16Float,
    R32Uint,
    R32Float,
    RG32Float,
    RGBA32Uint,
    RGBA32Float,
};

enum class MapMode { Read, Write };
enum class BufferMapState { Unmapped, Pending, Mapped };
enum class MapAsyncStatus { Success, Aborted, Error };
enum class FilterMode { Nearest, Linear };
enum class AddressMode { ClampToEdge, Repeat, MirrorRepeat };
enum class LoadOp { Load, Clear };
enum class StoreOp { Store, Discard };
enum class PrimitiveTopology { TriangleList, TriangleStrip, LineList, LineStrip, PointList };
enum class IndexFormat { Uint16, Uint32 };
enum class VertexFormat { Float32, Float32x2, Float32x3, Float32x4, Uint32, Unorm8x4 };
enum class VertexStepMode { Vertex, Instance };
enum class CullMode { None, Front, Back };
enum class BlendFactor { Zero, One, SrcAlpha, OneMinusSrcAlpha, DstAlpha, OneMinusDstAlpha };
enum class QueryType { Timestamp };
enum class ErrorFilter { Validation, OutOfMemory, Internal };
enum class DeviceLostReason { Unknown, Destroyed };
enum class AdapterType { DiscreteGPU, IntegratedGPU, VirtualGPU, CPU, Unknown };

/// Kind of resource a shader expects at a binding.
enum class BindingType {
    UniformBuffer,
    StorageBuffer,
    ReadOnlyStorageBuffer,
    Sampler,
    SampledTexture,          ///< GLSL texture2D / utexture2D
    CombinedTextureSampler,  ///< GLSL sampler2D: give both the view and the sampler
    WriteOnlyStorageTexture,
    ReadOnlyStorageTexture,
    ReadWriteStorageTexture,
};

/// Type of the values a shader reads from a sampled texture.
enum class TextureSampleType { Any, Float, Uint, Sint };

/// Size in texels. Textures are two-dimensional: the third extent must be 1.
struct Extent3D {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t depthOrArrayLayers = 1;
    friend bool operator==(const Extent3D&, const Extent3D&) = default;
};

/// Corner of a region, in texels.
struct Origin3D {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t z = 0;
    friend bool operator==(const Origin3D&, const Origin3D&) = default;
};

/// Clear value, in the units of the attachment.
struct Color {
    double r = 0;
    double g = 0;
    double b = 0;
    double a = 1;
};

/// "From the offset to the end".
inline constexpr std::uint64_t kWholeSize = ~std::uint64_t{0};
/// "All remaining levels".
inline constexpr std::uint32_t kAllMipLevels = ~std::uint32_t{0};
/// WebGPU's limit maxImmediateSize [bytes], the same on every device; Vulkan guarantees 128.
inline constexpr std::uint32_t kMaxImmediateSize = 64;

/// Limits of a device; sizes in bytes. Values of the Vulkan device, so at least Vulkan's guaranteed minimum.
struct Limits {
    std::uint32_t maxTextureDimension2D = 0;
    std::uint32_t maxBindGroups = 0;
    std::uint64_t maxBufferSize = 0;  ///< largest allocation of one buffer or texture
    std::uint64_t maxUniformBufferBindingSize = 0;
    std::uint64_t maxStorageBufferBindingSize = 0;
    std::uint32_t minUniformBufferOffsetAlignment = 0;
    std::uint32_t minStorageBufferOffsetAlignment = 0;
    std::uint32_t maxComputeWorkgroupStorageSize = 0;
    std::uint32_t maxComputeInvocationsPerWorkgroup = 0;
    std::uint32_t maxComputeWorkgroupSizeX = 0;
    std::uint32_t maxComputeWorkgroupSizeY = 0;
    std::uint32_t maxComputeWorkgroupSizeZ = 0;
    std::uint32_t maxComputeWorkgroupsPerDimension = 0;  ///< the smallest of x, y, z
    std::uint32_t maxColorAttachments = 0;
    std::uint32_t maxImmediateSize = kMaxImmediateSize;
    std::uint64_t deviceMemory = 0;  ///< largest device-local heap
    bool timestamps = false;         ///< whether timestamp queries work on the compute and graphics queue
    double timestampPeriod = 0;      ///< nanoseconds per timestamp tick; 0 without timestamps
};

/// Bytes of one texel.
[[nodiscard]] std::uint32_t texelSize(TextureFormat format);
/// WebGPU's spelling, for example "rgba32float".
[[nodiscard]] const char* toString(TextureFormat format);
[[nodiscard]] const char* toString(AdapterType type);
[[nodiscard]] const char* toString(BindingType type);
/// Names of the bits, for example "CopySrc|Storage".
[[nodiscard]] std::string toString(BufferUsage usage);
[[nodiscard]] std::string toString(TextureUsage usage);
/// Levels of a full pyramid down to 1x1.
[[nodiscard]] std::uint32_t fullMipLevelCount(std::uint32_t width, std::uint32_t height);

}  // namespace gpu
