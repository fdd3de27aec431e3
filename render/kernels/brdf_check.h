// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/material/brdf_file.h"
#include "gpu/device.h"

namespace render {

/// Measured behaviour of a BRDF with white colours, for one set of its parameters and one view direction.
struct BrdfFinding {
    std::string parameters;  ///< "alpha = 0.01"; "" = all initial values
    double angle = 0;        ///< between view direction and normal [degrees]
    double deviation = 0;    ///< chi² test of samples against the density, in standard deviations; large = they differ
    double density = 0;      ///< integral of the density over the hemisphere; 1 minus absorption
    core::Vector3f albedo;   ///< reflected share of uniform white light, by quadrature
    double albedoError = 0;  ///< standard error of its largest channel
    core::Vector3f sampled;  ///< the same by samples, as in the renderer
    double sampledError = 0;
    double asymmetry = 0;  ///< |f(wo, wi) − f(wi, wo)| relative to the albedo; 0 = reciprocal
    std::string problem;   ///< "" = none, otherwise a sentence
    int line = 1;          ///< line of the responsible function in the user's file
};

/// Tests a BRDF with the initial, smallest and largest values of its parameters from several directions: samples follow
/// the density (chi²) and are unit vectors, the density integrates to at most 1, values are finite and not negative, no
/// more is reflected than received, and nothing is reflected into directions that sampling leaves out. `file`: origin
/// of `brdf`, nullptr for a built-in one. Works in short dispatches. Throws core::Error(Input) for a text that does not
/// compile or takes too long, and gpu::Error.
[[nodiscard]] std::vector<BrdfFinding> checkBrdf(const gpu::Device& device, const core::BrdfInfo& brdf,
                                                 const std::shared_ptr<const core::BrdfFile>& file = nullptr);

/// Throws core::Error(Input) "PATH:LINE: REASON" for a user's BRDF that fails the test.
void requireSound(const gpu::Device& device, const std::shared_ptr<const core::BrdfFile>& file);

/// The same for core::setUserBrdfCheck, on a device that gpu::Instance::requestAdapter chooses and that lives as long
/// as one check. A failing device is an Error(Input), too.
[[nodiscard]] core::UserBrdfCheck userBrdfCheck(const std::string& deviceWish);

}  // namespace render
