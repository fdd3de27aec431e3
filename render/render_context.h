// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "gpu/command_encoder.h"
#include "gpu/device.h"
#include "render/dropped_samples.h"
#include "render/passes/composite_pass.h"
#include "render/passes/diffusion_pass.h"
#include "render/passes/filter_pass.h"
#include "render/passes/reshade_pass.h"
#include "render/passes/segment_targets.h"
#include "render/passes/silhouette_pass.h"
#include "render/passes/translucency_pass.h"
#include "render/scene_geometry.h"
#include "render/slice_sizer.h"

namespace render {

/// What all sums record with: the device, its kernels, the scene on it, the pictures.
struct RenderContext {
    explicit RenderContext(gpu::Device d)
        : device(std::move(d)),
          geometry(device),
          reshade(device, geometry.layout()),
          translucency(device, geometry.layout()),
          diffusion(device, geometry.layout()),
          filter(device, geometry.layout()),
          composite(device, geometry.layout()),
          silhouette(device, geometry.layout()),
          sizer(device),
          dropped(device) {
        paths.dropped = dropped.buffer();
    }

    gpu::Device device;
    SceneGeometry geometry;
    ReshadePass reshade;
    TranslucencyPass translucency;
    DiffusionPass diffusion;
    FilterPass filter;
    CompositePass composite;
    SilhouettePass silhouette;
    SliceSizer sizer;
    DroppedSamples dropped;
    PathInputs paths;
    Targets targets;
};

/// Where a slice is recorded, and the device time it may take [s].
struct Slice {
    RenderContext& context;
    const gpu::CommandEncoder& encoder;
    double seconds;
};

/// Assumed cost of one path before any was measured [s]: that of a slow processor, so that first slices are short
/// everywhere.
inline constexpr double kPathGuess = 4e-6;

}  // namespace render
