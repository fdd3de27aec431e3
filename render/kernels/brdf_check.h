// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/material/brdf_file.h"
#include "gpu/device.h"

namespace render {

/// What a BRDF was found to do, with white colours, for one set of its parameters and one view direction.
struct BrdfFinding {
    std::string parameters;  ///< "alpha = 0.01"; "" = all have their initial values
    double angle = 0;        ///< of the view direction from the normal [degrees]
    double deviation = 0;    ///< chi² test of samples against the density, in standard deviations; large = they differ
    double density = 0;      ///< integral of the density over the hemisphere; 1 less what is absorbed
    core::Vector3f albedo;   ///< reflected part of white light from everywhere, by quadrature
    double albedoError = 0;  ///< standard error of its largest channel
    core::Vector3f sampled;  ///< the same from samples, as the renderer does it
    double sampledError = 0;
    double asymmetry = 0;  ///< |f(wo, wi) − f(wi, wo)| as part of the albedo; 0 = reciprocal
    std::string problem;   ///< "" = none, else a sentence
    int line = 1;          ///< of the user's file: the function to blame
};

/// Tries a BRDF with the initial, least and greatest values of its parameters from several directions: samples follow
/// the density (chi²) and are unit vectors, the density integrates to at most 1, values are finite and not negative, no
/// more is reflected than received, and nothing is reflected into directions that sampling leaves out. `file`: what
/// `brdf` is from, nullptr for one of the list. The work is cut so that no piece takes long. Throws core::Error(Input)
/// for a text that does not compile or takes too long, gpu::Error.
[[nodiscard]] std::vector<BrdfFinding> checkBrdf(const gpu::Device& device, const core::BrdfInfo& brdf,
                                                 const std::shared_ptr<const core::BrdfFile>& file = nullptr);

/// Throws core::Error(Input) "PATH:LINE: REASON" for a BRDF by the user that does not pass.
void requireSound(const gpu::Device& device, const std::shared_ptr<const core::BrdfFile>& file);

/// For core::setUserBrdfCheck: the same on a device of its own, chosen as gpu::Instance::requestAdapter does, which
/// lives as long as a check. A failing device is an Error(Input), too.
[[nodiscard]] core::UserBrdfCheck userBrdfCheck(const std::string& deviceWish);

}  // namespace render
