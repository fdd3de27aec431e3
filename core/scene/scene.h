// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/material/material.h"

namespace core {

/// Meaning of stored depth values. Z: planar; Distance: along the ray; Disparity, Inverse: 1/z in 1/unit (Disparity is
/// what phones store, Inverse what networks give; both are read as 1/z here).
enum class DepthKind { Z, Distance, Disparity, Inverse };

/// Where the photograph came from; written to the project so that it can be loaded again.
struct PhotoSource {
    std::string color;     ///< path
    std::string depth;     ///< path, "" when the depth is inside the colour file
    std::string segments;  ///< path, "" = none
    DepthKind depthKind = DepthKind::Z;
    double depthUnit = 1;  ///< metres per stored unit
    bool operator==(const PhotoSource&) const = default;
};

/// The input photograph, immutable once loaded. All images have the camera's size.
struct Photo {
    PhotoSource source;
    Camera camera;
    ImageRgb color;     ///< scene-linear, finite and ≥ 0
    ImageF depth;       ///< planar z [m]; 0 = no valid depth (distant)
    LabelImage labels;  ///< 0 = no segment
    /// Photograph pixels per pixel of the stored depth map, ≥ 1; more than 1 when a smaller map was enlarged: its noise
    /// is smooth over that many pixels.
    float depthSampleSpacing = 1;
    /// Radiance at and above which the camera clipped; infinite for floating-point photographs.
    float clipLevel = std::numeric_limits<float>::infinity();
};

/// Ways to invent the unseen back side of a segment (paper section 3.2).
enum class BackSideMethod {
    Automatic,       ///< whichever of the others has the lowest penalty
    Offset,          ///< front depth plus a constant
    ParallelMirror,  ///< front mirrored at a plane parallel to the image
    PcaMirror,       ///< front mirrored at a plane found by principal component analysis
    SpannedMirror,   ///< front mirrored along the rays at a surface spanned into the outline
    FlatFaces,       ///< hidden faces at right angles to the flat faces that end at the outline
};

struct BackSideParams {
    BackSideMethod method = BackSideMethod::Automatic;
    float offset = 0.05f;         ///< [m], Offset only
    float planeShift = 0;         ///< [m], mirrors only: moves the plane or surface that was found away from the camera
    float thicknessScale = 1;     ///< stretches what was invented: back = front + thicknessScale·(invented − front)
    float minThickness = 0.002f;  ///< [m], z_back ≥ z_front + minThickness
    bool operator==(const BackSideParams&) const = default;
};

struct Segment {
    std::uint16_t label = 0;  ///< value in the label image, > 0
    std::string name;         ///< unique, never empty
    bool glossy = false;      ///< the user says: what it shows are reflections
    BackSideParams backSide;
    std::optional<Vector3f> reflectance;  ///< set by the user: replaces the estimated ρ
    std::optional<float> lobeWidth;       ///< set by the user: replaces the estimated GGX width, (0, 1]
    /// Set by the user [px]: bumps and dents of the surface narrower than about this are smoothed away; 0 = none;
    /// nullopt = follows the noise of the depth. Without the depth filter nothing is smoothed.
    std::optional<float> smoothing;
    std::optional<Material> edit;  ///< nullopt = untouched
    bool operator==(const Segment&) const = default;
};

/// Joint bilateral filter of the depth map (docs/method.md#depth).
struct DepthFilterParams {
    bool enabled = true;
    bool automatic = true;      ///< the three widths follow the measured noise; the values below are not used
    float spatialSigma = 2.0f;  ///< [px]
    float colorSigma = 0.1f;    ///< in display-encoded colour, [0, 1]
    float depthSigma = 0.01f;   ///< relative depth difference |Δz|/z
    bool operator==(const DepthFilterParams&) const = default;
};

/// What a map given by the user does: takes the place of the recovered one, or fills the directions in which nothing
/// was observed.
enum class EnvironmentUse { Replace, Complete };

/// How unobserved directions are filled (docs/method.md#environment): the paper's Shepard interpolation with angular
/// distance, or a membrane on the sphere (Laplace's equation), which is smooth and keeps a small bright light from
/// spreading.
enum class EnvironmentFill { Shepard, Membrane };

/// The light: recovered from the photograph, or a map given by the user.
struct EnvironmentParams {
    std::string path;  ///< "" = recovered
    EnvironmentUse use = EnvironmentUse::Replace;
    EnvironmentFill fill = EnvironmentFill::Membrane;
    std::shared_ptr<const ImageRgb> image;  ///< loaded from `path`; latitude-longitude, camera frame
    float rotation = 0;                     ///< about the camera's y axis [rad]
    float scale = 1;                        ///< radiance factor
    int height = 128;                       ///< rows of the recovered maps; width is twice that
    bool operator==(const EnvironmentParams&) const = default;
};

/// How exactly light below a surface is summed over its samples (core/shading/diffusion_grid.h).
enum class DiffusionQuality : std::uint8_t { Draft, Standard, Fine };

struct RenderParams {
    int samples = 64;      ///< paths per pixel at which accumulation stops
    double timeLimit = 0;  ///< [s] of rendering after which it stops, too, the first picture excepted; 0 = none. For
                           ///< the view only: a project's final picture has all samples.
    std::uint32_t seed = 1;
    int bounces = 4;              ///< surfaces a path may visit; 1 = the paper
    bool filter = true;           ///< edge-aware filter of the result
    int surfaceSamples = 100000;  ///< translucency: samples on front and back of a segment
    int irradianceSamples = 8;    ///< translucency: rays per surface sample
    DiffusionQuality diffusionQuality = DiffusionQuality::Standard;
    bool operator==(const RenderParams&) const = default;
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

    [[nodiscard]] const Segment* findSegment(std::uint16_t label) const;
    [[nodiscard]] Segment* findSegment(std::uint16_t label);
    /// By number ("2") or by name ("vase"); nullptr when there is none.
    [[nodiscard]] Segment* findSegment(const std::string& labelOrName);

    /// Same values and the same (not only equal) images.
    bool operator==(const Scene&) const = default;
};

/// One segment per label in `labels` that has no segment yet (named "segment 7"), sorted by label.
void addMissingSegments(Scene& scene);

}  // namespace core
