// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"

namespace ui {

/// Pictures the canvas can show. Result comes from the renderer, the others are made here.
enum class ViewLayer { Result, Original, Depth, Normals, Segments, BackDepth, Coverage };
inline constexpr std::array kViewLayers = {ViewLayer::Result,  ViewLayer::Original, ViewLayer::Depth,
                                           ViewLayer::Normals, ViewLayer::Segments, ViewLayer::BackDepth,
                                           ViewLayer::Coverage};

/// Untranslated key ("depth", object names) and translated title of a layer.
[[nodiscard]] QString layerKey(ViewLayer layer);
[[nodiscard]] QString layerTitle(ViewLayer layer);

struct LayerPicture {
    core::ImageRgb pixels;
    bool displayEncoded = false;  ///< false colour: shown as it is, without exposure and transfer function
};

/// Picture of a layer other than Result, the photograph's size; the photograph itself where `analysis` is still needed.
/// Depth and back depth share one colour scale (near = yellow); coverage colours each surface pixel by the number of
/// observations in the environment at its mirrored view direction.
[[nodiscard]] LayerPicture makeLayerPicture(ViewLayer layer, const core::Photo& photo, const core::Analysis* analysis);

}  // namespace ui
