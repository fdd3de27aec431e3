// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/binary_mask.h"
#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/pixel.h"
#include "core/base/shared_image.h"
#include "core/base/words.h"
#include "core/material/material.h"
#include "shaders/shared/param_info.h"

namespace core {

/// Meaning of stored depth values. Z: planar; Distance: along the ray; Disparity, Inverse: 1/z in 1/unit (Disparity is
/// what phones store, Inverse what networks give; both are read as 1/z here).
enum class DepthKind { Z, Distance, Disparity, Inverse };
template <>
struct Words<DepthKind> {
    static constexpr Word<DepthKind> table[] = {{DepthKind::Z, "z"},
                                                {DepthKind::Distance, "distance"},
                                                {DepthKind::Disparity, "disparity"},
                                                {DepthKind::Inverse, "inverse"}};
};

/// Where the photograph came from; written to the project so that it can be loaded again.
struct PhotoSource {
    std::string color;     ///< path
    std::string depth;     ///< path, "" when the depth is inside the colour file
    std::string segments;  ///< path, "" = none, or not saved yet
    DepthKind depthKind = DepthKind::Z;
    double depthUnit = 1;  ///< metres per stored unit
    bool operator==(const PhotoSource&) const = default;
};

/// The input photograph, immutable once loaded. All images have the camera's size. A copy with other labels shares
/// colour and depth.
struct Photo {
    PhotoSource source;
    Camera camera;
    SharedImage<Vector3f> color;  ///< scene-linear Rec.709, finite and ≥ 0
    SharedImage<float> depth;     ///< planar z [m]; 0 = no valid depth (distant)
    LabelImage labels;            ///< 0 = no segment
    /// Photograph pixels per pixel of the stored depth map, ≥ 1; more than 1 when a smaller map was enlarged: its noise
    /// is smooth over that many pixels.
    float depthSampleSpacing = 1;
    /// Radiance at and above which the camera clipped; infinite for floating-point photographs.
    float clipLevel = std::numeric_limits<float>::infinity();
};

/// Ways to invent the unseen back side of a segment (docs/method.md#back-side).
enum class BackSideMethod {
    Automatic,       ///< whichever of the others has the lowest penalty
    Offset,          ///< front depth plus a constant
    ParallelMirror,  ///< front mirrored at a plane parallel to the image
    PcaMirror,       ///< front mirrored at a plane found by principal component analysis
    SpannedMirror,   ///< front mirrored along the rays at a surface spanned into the outline
    FlatFaces,       ///< hidden faces at right angles to the flat faces that end at the outline
};
template <>
struct Words<BackSideMethod> {
    static constexpr Word<BackSideMethod> table[] = {
        {BackSideMethod::Automatic, "automatic", PARAM_LABEL("scene", "Automatic")},
        {BackSideMethod::SpannedMirror, "spanned_mirror", PARAM_LABEL("scene", "Rounded: mirrored at its outline")},
        {BackSideMethod::FlatFaces, "flat_faces", PARAM_LABEL("scene", "Box: flat faces continued")},
        {BackSideMethod::PcaMirror, "pca_mirror", PARAM_LABEL("scene", "Mirrored at a fitted plane")},
        {BackSideMethod::ParallelMirror, "parallel_mirror",
         PARAM_LABEL("scene", "Mirrored at a plane facing the camera")},
        {BackSideMethod::Offset, "offset", PARAM_LABEL("scene", "Constant thickness")}};
};

struct BackSideParams {
    BackSideMethod method = BackSideMethod::Automatic;
    float offset = 0.05f;         ///< [m], Offset only
    float planeShift = 0;         ///< [m], mirrors only: moves the fitted plane or surface away from the camera
    float thicknessScale = 1;     ///< back = front + thicknessScale·(invented − front)
    float minThickness = 0.002f;  ///< [m], z_back ≥ z_front + minThickness
    bool operator==(const BackSideParams&) const = default;
};

/// What the user can edit of one segment. Ranges, labels and file keys of its parameters: core/scene/params.cpp.
struct Segment {
    std::uint16_t label = 0;  ///< value in the label image, > 0
    std::string name;         ///< unique, never empty
    bool visible = true;      ///< false: its edit is kept, but not applied
    bool locked = false;      ///< its pixels cannot be changed
    bool glossy = false;      ///< its colours are reflections of the surroundings
    BackSideParams backSide;
    std::optional<Vector3f> reflectance;  ///< replaces the estimated ρ
    std::optional<float> lobeWidth;       ///< replaces the estimated GGX width
    /// Bumps and dents narrower than about this [px] are smoothed away; 0 = none, nullopt = follows the noise of the
    /// depth. Nothing is smoothed while the depth filter is off.
    std::optional<float> smoothing;
    std::optional<Material> edit;  ///< nullopt = untouched
    bool operator==(const Segment&) const = default;
};

/// Edge-avoiding filter of the depth map (docs/method.md#depth).
struct DepthFilterParams {
    bool enabled = true;
    bool automatic = true;      ///< the three widths follow the measured noise instead of the values below
    float spatialSigma = 2.0f;  ///< [px]
    float colorSigma = 0.1f;    ///< in display-encoded colour, [0, 1]
    float depthSigma = 0.01f;   ///< relative depth difference |Δz|/z
    bool operator==(const DepthFilterParams&) const = default;
};

/// Role of a loaded map: it replaces the recovered light, or fills the directions in which nothing was observed.
enum class EnvironmentUse { Replace, Complete };
template <>
struct Words<EnvironmentUse> {
    static constexpr Word<EnvironmentUse> table[] = {
        {EnvironmentUse::Replace, "replace", PARAM_LABEL("scene", "Replaces the recovered light")},
        {EnvironmentUse::Complete, "complete", PARAM_LABEL("scene", "Completes the recovered light")}};
};

/// How unobserved directions are filled (docs/method.md#environment): the paper's Shepard interpolation with angular
/// distance, or a membrane on the sphere (Laplace's equation), which is smooth and keeps a small bright light from
/// spreading.
enum class EnvironmentFill { Shepard, Membrane };
template <>
struct Words<EnvironmentFill> {
    static constexpr Word<EnvironmentFill> table[] = {
        {EnvironmentFill::Membrane, "membrane", PARAM_LABEL("scene", "Smooth")},
        {EnvironmentFill::Shepard, "shepard", PARAM_LABEL("scene", "Inverse distance (Shepard)")}};
};

/// Legal range of EnvironmentParams::height.
inline constexpr int kMinMapRows = 4;
inline constexpr int kMaxMapRows = 4096;

/// The light: recovered from the photograph, or a map given by the user.
struct EnvironmentParams {
    std::string path;  ///< "" = recovered
    EnvironmentUse use = EnvironmentUse::Replace;
    EnvironmentFill fill = EnvironmentFill::Membrane;
    std::shared_ptr<const ImageRgb> image;  ///< loaded from `path`; latitude-longitude, camera frame
    float rotation = 0;                     ///< about the camera's y axis [rad]
    float scale = 1;                        ///< radiance factor
    int height = 128;  ///< rows of the recovered maps, kMinMapRows to kMaxMapRows; width is twice that
    bool operator==(const EnvironmentParams&) const = default;
};

/// Accuracy of summing light below a surface over its samples (core/shading/diffusion_grid.h).
enum class DiffusionQuality : std::uint8_t { Draft, Standard, Fine };
template <>
struct Words<DiffusionQuality> {
    static constexpr Word<DiffusionQuality> table[] = {
        {DiffusionQuality::Draft, "draft", PARAM_LABEL("scene", "Draft")},
        {DiffusionQuality::Standard, "standard", PARAM_LABEL("scene", "Standard")},
        {DiffusionQuality::Fine, "fine", PARAM_LABEL("scene", "Fine")}};
};

struct RenderParams {
    int samples = 64;  ///< paths per pixel at which accumulation stops
    /// Rendering time [s] after which the view stops refining, but never before its first complete picture; 0 = none.
    /// Final pictures ignore it and have all samples.
    double timeLimit = 0;
    std::uint32_t seed = 1;
    int bounces = 4;              ///< surfaces a path may visit; 1 = the paper
    bool filter = true;           ///< edge-aware filter of the result
    int surfaceSamples = 100000;  ///< translucency: samples on front and back of a segment
    int irradianceSamples = 8;    ///< translucency: rays per surface sample
    DiffusionQuality diffusionQuality = DiffusionQuality::Standard;
    bool operator==(const RenderParams&) const = default;
};

/// Pixels chosen in the picture, from which segments are made. Not saved.
struct PixelSelection {
    BinaryMask mask;  ///< of the photograph's size
    // How it was found, if by pointing: `base` and the object under the seeds. Empty otherwise.
    std::shared_ptr<const BinaryMask> base;  ///< selection before the first seed; nullptr = nothing
    std::vector<Pixel> add;                  ///< seeds on the object
    std::vector<Pixel> remove;               ///< seeds beside it
};

/// Everything the user can edit, a value: copying is cheap, images are shared and immutable.
struct Scene {
    std::shared_ptr<const Photo> photo;
    std::vector<Segment> segments;  ///< sorted by label, one for every label that occurs
    DepthFilterParams depthFilter;
    EnvironmentParams environment;
    std::string backDepthPath;                ///< "" = invented by each segment's method
    std::shared_ptr<const ImageF> backDepth;  ///< planar z [m], replaces the invented back side; 0 = none
    RenderParams render;
    std::shared_ptr<const PixelSelection> selection;  ///< nullptr = nothing is selected

    [[nodiscard]] const Segment* findSegment(std::uint16_t label) const;
    [[nodiscard]] Segment* findSegment(std::uint16_t label);
    /// By number ("2") or by name ("vase"); nullptr when there is none.
    [[nodiscard]] Segment* findSegment(const std::string& labelOrName);

    /// Same values and the same (not only equal) images.
    bool operator==(const Scene&) const = default;
};

/// The scene without the edits of segments that are not visible: what is analysed and rendered.
[[nodiscard]] Scene visibleScene(const Scene& scene);

/// One segment per label in `labels` that has no segment yet (named "segment 7"), sorted by label.
void addMissingSegments(Scene& scene);

}  // namespace core
