// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>

#include "gpu/shader_module.h"
#include "kernels/build_pyramid.h"
#include "kernels/check_brdf.h"
#include "kernels/composite.h"
#include "kernels/depth_filter.h"
#include "kernels/diffusion_combine.h"
#include "kernels/diffusion_gather.h"
#include "kernels/diffusion_splat.h"
#include "kernels/fill_shepard.h"
#include "kernels/filter.h"
#include "kernels/fit_surface.h"
#include "kernels/irradiance.h"
#include "kernels/march_rays.h"
#include "kernels/relax_membrane.h"
#include "kernels/reshade.h"
#include "kernels/silhouette.h"
#include "shaders/shared/build_pyramid_block.h"
#include "shaders/shared/check_brdf_block.h"
#include "shaders/shared/composite_block.h"
#include "shaders/shared/depth_filter_block.h"
#include "shaders/shared/diffusion_blocks.h"
#include "shaders/shared/fill_shepard_block.h"
#include "shaders/shared/filter_block.h"
#include "shaders/shared/fit_surface_block.h"
#include "shaders/shared/geometry_block.h"
#include "shaders/shared/irradiance_block.h"
#include "shaders/shared/march_block.h"
#include "shaders/shared/path.h"
#include "shaders/shared/relax_membrane_block.h"
#include "shaders/shared/reshade_block.h"
#include "shaders/shared/silhouette_block.h"
#include "tests/gpu/render_support.h"

namespace {

using Offsets = std::map<std::string, std::size_t>;

/// Compares the offsets of a struct in the SPIR-V with those of the C++ compiler.
void expectLayout(std::span<const std::uint32_t> code, const std::string& name, const Offsets& expected,
                  std::size_t size) {
    const gpu::ShaderModule module =
        test::device().createShaderModule({.label = "block layout of " + name, .code = code});
    const gpu::BlockLayout layout = module.blockLayout(name);
    Offsets actual;
    for (const gpu::BlockMember& member : layout.members) actual[member.name] = member.offset;
    EXPECT_EQ(actual, expected) << name;
    EXPECT_LE(layout.size, size) << name;
    EXPECT_GT(layout.size + 16, size) << name;
}

#define MEMBER(type, member) \
    { #member, offsetof(kernel::type, member) }

TEST(KernelBlocks, HaveTheSameLayoutInBothLanguages) {
    expectLayout(check_brdf_spv, "CheckBrdfBlock",
                 {MEMBER(CheckBrdfBlock, mode), MEMBER(CheckBrdfBlock, first), MEMBER(CheckBrdfBlock, count),
                  MEMBER(CheckBrdfBlock, perCase), MEMBER(CheckBrdfBlock, side), MEMBER(CheckBrdfBlock, pad0),
                  MEMBER(CheckBrdfBlock, pad1), MEMBER(CheckBrdfBlock, pad2)},
                 sizeof(kernel::CheckBrdfBlock));
    expectLayout(check_brdf_spv, "CheckBrdfCase", {MEMBER(CheckBrdfCase, brdf), MEMBER(CheckBrdfCase, wo)},
                 sizeof(kernel::CheckBrdfCase));
    expectLayout(check_brdf_spv, "CheckBrdfSample", {MEMBER(CheckBrdfSample, wi), MEMBER(CheckBrdfSample, weight)},
                 sizeof(kernel::CheckBrdfSample));
    expectLayout(check_brdf_spv, "CheckBrdfSums",
                 {MEMBER(CheckBrdfSums, value), MEMBER(CheckBrdfSums, square), MEMBER(CheckBrdfSums, fault),
                  MEMBER(CheckBrdfSums, other)},
                 sizeof(kernel::CheckBrdfSums));
    expectLayout(build_pyramid_spv, "BuildPyramidBlock",
                 {MEMBER(BuildPyramidBlock, step), MEMBER(BuildPyramidBlock, width), MEMBER(BuildPyramidBlock, height),
                  MEMBER(BuildPyramidBlock, sourceWidth), MEMBER(BuildPyramidBlock, sourceHeight),
                  MEMBER(BuildPyramidBlock, finest), MEMBER(BuildPyramidBlock, blocks), MEMBER(BuildPyramidBlock, rows),
                  MEMBER(BuildPyramidBlock, minW), MEMBER(BuildPyramidBlock, scale), MEMBER(BuildPyramidBlock, pad0),
                  MEMBER(BuildPyramidBlock, pad1)},
                 sizeof(kernel::BuildPyramidBlock));
    expectLayout(
        depth_filter_spv, "DepthFilterBlock",
        {MEMBER(DepthFilterBlock, width), MEMBER(DepthFilterBlock, height), MEMBER(DepthFilterBlock, first),
         MEMBER(DepthFilterBlock, count), MEMBER(DepthFilterBlock, curveFirst), MEMBER(DepthFilterBlock, cellsPerUnit),
         MEMBER(DepthFilterBlock, colorFactor), MEMBER(DepthFilterBlock, pad0)},
        sizeof(kernel::DepthFilterBlock));
    expectLayout(
        fit_surface_spv, "FitSurfaceBlock",
        {MEMBER(FitSurfaceBlock, camera), MEMBER(FitSurfaceBlock, width), MEMBER(FitSurfaceBlock, height),
         MEMBER(FitSurfaceBlock, first), MEMBER(FitSurfaceBlock, count), MEMBER(FitSurfaceBlock, tapCount),
         MEMBER(FitSurfaceBlock, hasKnown), MEMBER(FitSurfaceBlock, relativeNoise), MEMBER(FitSurfaceBlock, sign)},
        sizeof(kernel::FitSurfaceBlock));
    expectLayout(relax_membrane_spv, "RelaxMembraneBlock",
                 {MEMBER(RelaxMembraneBlock, width), MEMBER(RelaxMembraneBlock, height),
                  MEMBER(RelaxMembraneBlock, parity), MEMBER(RelaxMembraneBlock, overRelaxation)},
                 sizeof(kernel::RelaxMembraneBlock));
    expectLayout(fill_shepard_spv, "FillShepardBlock",
                 {MEMBER(FillShepardBlock, levelCount), MEMBER(FillShepardBlock, first),
                  MEMBER(FillShepardBlock, count), MEMBER(FillShepardBlock, opening), MEMBER(FillShepardBlock, minCube),
                  MEMBER(FillShepardBlock, pad0), MEMBER(FillShepardBlock, pad1), MEMBER(FillShepardBlock, pad2)},
                 sizeof(kernel::FillShepardBlock));
    expectLayout(march_rays_spv, "MarchBlock",
                 {MEMBER(MarchBlock, rayCount), MEMBER(MarchBlock, share), MEMBER(MarchBlock, stepSize),
                  MEMBER(MarchBlock, maxDistance), MEMBER(MarchBlock, without), MEMBER(MarchBlock, workers),
                  MEMBER(MarchBlock, groupsPerWorker), MEMBER(MarchBlock, pad0)},
                 sizeof(kernel::MarchBlock));
    expectLayout(
        march_rays_spv, "GeometryBlock",
        {MEMBER(GeometryBlock, camera), MEMBER(GeometryBlock, width), MEMBER(GeometryBlock, height),
         MEMBER(GeometryBlock, pyramidTop), MEMBER(GeometryBlock, environmentWidth),
         MEMBER(GeometryBlock, environmentHeight), MEMBER(GeometryBlock, tableColumns),
         MEMBER(GeometryBlock, tableRows), MEMBER(GeometryBlock, tableCell), MEMBER(GeometryBlock, meanLuminance),
         MEMBER(GeometryBlock, environmentSampled), MEMBER(GeometryBlock, pyramidFinest),
         MEMBER(GeometryBlock, pyramidRows), MEMBER(GeometryBlock, pyramidBlocks), MEMBER(GeometryBlock, minW),
         MEMBER(GeometryBlock, maxW), MEMBER(GeometryBlock, pad0)},
        sizeof(kernel::GeometryBlock));
    expectLayout(reshade_spv, "ReshadeBlock",
                 {MEMBER(ReshadeBlock, firstPixel), MEMBER(ReshadeBlock, pixelCount), MEMBER(ReshadeBlock, firstSample),
                  MEMBER(ReshadeBlock, sampleCount), MEMBER(ReshadeBlock, seed), MEMBER(ReshadeBlock, bounces),
                  MEMBER(ReshadeBlock, pad0), MEMBER(ReshadeBlock, pad1)},
                 sizeof(kernel::ReshadeBlock));
    expectLayout(reshade_spv, "BrdfParams",
                 {MEMBER(BrdfParams, albedo),
                  MEMBER(BrdfParams, specular),
                  MEMBER(BrdfParams, eta),
                  MEMBER(BrdfParams, k),
                  MEMBER(BrdfParams, values),
                  MEMBER(BrdfParams, values2),
                  MEMBER(BrdfParams, values3),
                  MEMBER(BrdfParams, type),
                  MEMBER(BrdfParams, file),
                  {"pad0", 120},
                  {"pad1", 124}},
                 sizeof(kernel::BrdfParams));
    expectLayout(reshade_spv, "SegmentShading",
                 {MEMBER(SegmentShading, brdf), MEMBER(SegmentShading, diffuse), MEMBER(SegmentShading, blend),
                  MEMBER(SegmentShading, drives)},
                 sizeof(kernel::SegmentShading));
    expectLayout(reshade_spv, "Drive",
                 {MEMBER(Drive, from), MEMBER(Drive, to), MEMBER(Drive, range), MEMBER(Drive, slot),
                  MEMBER(Drive, offset), MEMBER(Drive, origin), MEMBER(Drive, stride)},
                 sizeof(kernel::Drive));
    expectLayout(irradiance_spv, "IrradianceBlock",
                 {MEMBER(IrradianceBlock, firstPoint), MEMBER(IrradianceBlock, pointCount),
                  MEMBER(IrradianceBlock, firstRay), MEMBER(IrradianceBlock, rayCount), MEMBER(IrradianceBlock, label),
                  MEMBER(IrradianceBlock, seed), MEMBER(IrradianceBlock, bounces), MEMBER(IrradianceBlock, eta)},
                 sizeof(kernel::IrradianceBlock));
    expectLayout(irradiance_spv, "SurfacePoint", {MEMBER(SurfacePoint, position), MEMBER(SurfacePoint, normal)},
                 sizeof(kernel::SurfacePoint));
    expectLayout(diffusion_splat_spv, "DiffusionGridBlock",
                 {MEMBER(DiffusionGridBlock, firstBrick), MEMBER(DiffusionGridBlock, brickCount),
                  MEMBER(DiffusionGridBlock, levelFirst), MEMBER(DiffusionGridBlock, scale)},
                 sizeof(kernel::DiffusionGridBlock));
    expectLayout(diffusion_combine_spv, "DiffusionCombineBlock",
                 {MEMBER(DiffusionCombineBlock, narrow), MEMBER(DiffusionCombineBlock, wide),
                  MEMBER(DiffusionCombineBlock, firstBrick), MEMBER(DiffusionCombineBlock, brickCount),
                  MEMBER(DiffusionCombineBlock, coarser), MEMBER(DiffusionCombineBlock, pad0)},
                 sizeof(kernel::DiffusionCombineBlock));
    expectLayout(diffusion_gather_spv, "DiffusionGatherBlock",
                 {MEMBER(DiffusionGatherBlock, corner), MEMBER(DiffusionGatherBlock, flatSurface),
                  MEMBER(DiffusionGatherBlock, tolerance), MEMBER(DiffusionGatherBlock, firstPixel),
                  MEMBER(DiffusionGatherBlock, pixelCount), MEMBER(DiffusionGatherBlock, level),
                  MEMBER(DiffusionGatherBlock, known)},
                 sizeof(kernel::DiffusionGatherBlock));
    expectLayout(filter_spv, "FilterBlock",
                 {MEMBER(FilterBlock, firstPixel), MEMBER(FilterBlock, pixelCount), MEMBER(FilterBlock, level),
                  MEMBER(FilterBlock, normalPower), MEMBER(FilterBlock, depthSigma),
                  MEMBER(FilterBlock, luminanceSigma), MEMBER(FilterBlock, temporalSamples), MEMBER(FilterBlock, pad0)},
                 sizeof(kernel::FilterBlock));
    expectLayout(composite_spv, "CompositeBlock",
                 {MEMBER(CompositeBlock, firstPixel), MEMBER(CompositeBlock, pixelCount),
                  MEMBER(CompositeBlock, filtered), MEMBER(CompositeBlock, blendNew),
                  MEMBER(CompositeBlock, blendOriginal), MEMBER(CompositeBlock, translucentWeight),
                  MEMBER(CompositeBlock, eta), MEMBER(CompositeBlock, translucent), MEMBER(CompositeBlock, firstDrive),
                  MEMBER(CompositeBlock, driveCount), MEMBER(CompositeBlock, pad0), MEMBER(CompositeBlock, pad1)},
                 sizeof(kernel::CompositeBlock));
    expectLayout(silhouette_spv, "MixedPixel",
                 {MEMBER(MixedPixel, pixel), MEMBER(MixedPixel, source), MEMBER(MixedPixel, coverage),
                  MEMBER(MixedPixel, pad0), MEMBER(MixedPixel, kept), MEMBER(MixedPixel, keptOriginal)},
                 sizeof(kernel::MixedPixel));
    expectLayout(silhouette_spv, "SilhouetteBlock",
                 {MEMBER(SilhouetteBlock, pixelCount), MEMBER(SilhouetteBlock, blendOriginal),
                  MEMBER(SilhouetteBlock, firstDrive), MEMBER(SilhouetteBlock, driveCount)},
                 sizeof(kernel::SilhouetteBlock));
}

}  // namespace
