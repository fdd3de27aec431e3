// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/analysis/kernels.h"
#include "core/analysis/segment/continued_supports.h"
#include "core/analysis/step_context.h"
#include "core/base/label_table.h"
#include "core/base/pixel.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// Bit c: the camera clipped channel c of a pixel (`Photo::clipLevel`).
[[nodiscard]] unsigned clippedChannels(const Photo& photo, int x, int y);

/// True if the photo's colour at a pixel is what any viewer sees there and not a mixture of two objects: the pixel has
/// depth, and so have all of its eight neighbours (at the border of the picture: those that exist), of the same label.
[[nodiscard]] bool isInterior(const LabelImage& labels, const ImageF& depth, int x, int y);

/// One glossy segment and everything its rays can meet.
struct ReflectanceInput {
    const Scene& scene;
    const Surface& front;
    const Surface& back;
    AnalysisKernels::RayMarcher& marcher;  ///< through `front` and `back`
    const Image<std::uint8_t>& distant;    ///< 1 = the pixel shows distant light (`findDistantPixels`)
    const ContinuedSupports& continued;
    const LabelTable<bool>& glossy;  ///< true: the segment's colours in the photo depend on the viewer
    std::uint16_t label = 0;         ///< the segment
    int rows = 0;                    ///< of the directional maps
};

/// Where a ray from a pixel of the segment, or from its centre, ended.
struct RayEnd {
    enum class Kind : std::uint8_t {
        None,         ///< not traced
        Itself,       ///< hit the segment it started from
        Missed,       ///< left the picture: sees the environment
        OverSupport,  ///< left the picture but meets a support's continuation: does not see the environment
        Distant,      ///< left towards a distant pixel
        Known,        ///< hit a surface whose colour in the photo is true for every viewer
        Guessed,      ///< hit a back side, a glossy segment or an outline
    };
    Kind kind = Kind::None;
    Vector3f direction{0, 0, 0};  ///< unit; zero if not traced
    Vector3f color{0, 0, 0};      ///< colour of the hit or of the distant pixel, zero for the other kinds

    [[nodiscard]] bool showsLight() const { return kind == Kind::Missed || kind == Kind::Distant; }
    /// True if `color` is the radiance that arrives along the ray.
    [[nodiscard]] bool hasTrueColor() const { return kind == Kind::Known || kind == Kind::Distant; }
};

/// End of a ray that was marched to `hit`.
[[nodiscard]] RayEnd endOf(const ReflectanceInput& in, const MarchRay& ray, const std::optional<MarchHit>& hit);

/// The pixels of the segment whose mirrored rays are traced.
struct TracedPixels {
    std::vector<Pixel> pixels;        ///< row by row; interior ones only, unless there are none
    bool complete = true;             ///< false: the segment is so large that only every n-th pixel is traced
    std::size_t segmentSize = 0;      ///< pixels of the segment with depth, outlines included
    Eigen::Vector3d center{0, 0, 0};  ///< [m] mean of the segment's front and back; zero for an empty segment
};
[[nodiscard]] TracedPixels tracedPixels(const ReflectanceInput& in);

/// A pixel of the segment and the direction it mirrors.
struct Mirror {
    int x = 0, y = 0;
    Vector3f origin{0, 0, 0};     ///< [m], lifted off the surface
    Vector3f direction{0, 0, 0};  ///< mirrored view direction; zero at grazing angles, where it is unreliable
    RayEnd end;
    float sharpness = 1;  ///< weight in (0, 1], low where neighbouring rays diverge by more than a texel
};

/// What each pixel mirrors (docs/method.md#reflectance, cases A to D); one per traced pixel, in order.
[[nodiscard]] std::vector<Mirror> traceMirrors(const ReflectanceInput& in, const TracedPixels& pixels,
                                               const Progress& progress);

/// What arrives at the segment's centre from all directions, with the segment itself taken away. Empty for an empty
/// segment.
[[nodiscard]] std::vector<RayEnd> traceFromCenter(const ReflectanceInput& in, const TracedPixels& pixels,
                                                  const Progress& progress);

}  // namespace core::analysis
