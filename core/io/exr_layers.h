// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace core {

// Which channels of an EXR file are what. A channel is named layer.component, and a layer may have dots of its own
// ("ViewLayer.Depth.Z"); in a file of several parts, the part's name comes first where the channel does not repeat it.
// OpenEXR itself gives a meaning only to R, G, B, A, Y and Z without a layer. All other rules are those of the
// renderers that write the files: Blender, V-Ray, Redshift, Arnold, RenderMan, Nuke. Names are compared without case.

struct ExrChannel {
    int part = 0;
    int index = 0;  ///< within the part
    std::string layer;
    std::string component;

    /// "layer.component", or the component alone.
    [[nodiscard]] std::string name() const { return layer.empty() ? component : layer + "." + component; }
};

/// All channels of a file whose parts have these headers, in the file's order.
[[nodiscard]] std::vector<ExrChannel> exrChannels(const std::vector<OIIO::ImageSpec>& parts);

struct ExrColor {
    int part = 0;
    std::array<int, 3> channels{};  ///< red, green, blue within the part
    std::string layer;
    std::vector<std::string> others;  ///< layers that could have been meant as well
};
/// Plain R, G, B; otherwise the layer Combined; otherwise beauty and its other names; otherwise the first layer with
/// red, green and blue. Nullopt = the file has no such layer.
[[nodiscard]] std::optional<ExrColor> exrColor(const std::vector<ExrChannel>& channels);

/// Distance from the camera plane: Z, a layer or component called depth (ZDepth, VRayZDepth, Pz), or Z of a layer that
/// has no X and Y. Never a component of normals, positions or vectors, and no mist. That of the view or
/// render layer of exrColor first. Nullopt = the file has none.
[[nodiscard]] std::optional<ExrChannel> exrDepth(const std::vector<ExrChannel>& channels);

/// Numbers of objects: IndexOB, otherwise another layer of that kind. Nullopt = the file has none.
[[nodiscard]] std::optional<ExrChannel> exrIndices(const std::vector<ExrChannel>& channels);

[[nodiscard]] bool hasCryptomatte(const std::vector<ExrChannel>& channels);

/// The channels' names with commas, at most 24 of them.
[[nodiscard]] std::string exrChannelNames(const std::vector<ExrChannel>& channels);

}  // namespace core
