// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/image.h"
#include "core/base/message.h"
#include "core/base/shared_image.h"
#include "core/io/image_io.h"
#include "core/io/import/import_format.h"
#include "core/scene/scene.h"

namespace core {

/// The files of a photograph as they were read, before anybody decides what the numbers in them mean.
struct PhotoFiles {
    std::string colorPath;
    std::string depthPath;  ///< "" = inside the colour file
    ImageInfo info;         ///< of the colour
    /// What an import format found, without colour and depth, which are below; nullopt = the colour is a plain picture.
    std::optional<ImportedPhoto> imported;
    /// What the file `depthPath` says about its depth when it is another photograph that carries depth; without images,
    /// and with its camera for the colour of this one.
    std::optional<ImportedPhoto> depthImported;
    SharedImage<Vector3f> color;  ///< scene-linear Rec.709; empty until `readColor`
    Notes colorRemarks;
    Notes depthRemarks;
    /// Stored values in the photograph's layout, at their own resolution; empty = there is no depth.
    ImageF depth;
    StoredFormat depthFormat;  ///< of a separate depth map

    /// What a file of photograph and depth says about the depth; null when it is a plain map.
    [[nodiscard]] const ImportedPhoto* depthStatements() const {
        if (depthPath.empty()) return imported ? &*imported : nullptr;
        return depthImported ? &*depthImported : nullptr;
    }
    [[nodiscard]] bool hasDepth() const { return !depth.empty(); }
    /// The file that the depth comes from.
    [[nodiscard]] const std::string& depthFile() const { return depthPath.empty() ? colorPath : depthPath; }
};

/// Reads the depth of a photograph: the map `depth`, or with "" what is inside `color`. `depth` may also be a
/// photograph that carries its depth, of the same shape: what a phone took, where `color` was developed from it. Throws
/// Error(Input) for files that cannot be read, and for a map of another shape; a photograph without depth is none.
[[nodiscard]] PhotoFiles readStoredDepth(const std::string& color, const std::string& depth);

/// Reads the colour if it is not there yet. Throws Error(Input).
void readColor(PhotoFiles& files);

/// A map of stored values [any unit] that belongs to the photograph of `camera`, in the photograph's orientation.
/// `what` and `colorPath` name both in messages. A larger map is reduced to the photograph's size, without blending.
/// Throws Error(Input).
[[nodiscard]] ImageF readMapFile(const std::string& path, const Camera& camera, int colorOrientation,
                                 const Message& colorPath, const Message& what, Notes* remarks = nullptr);

/// The value of the map's pixel at the centre of each pixel of the photograph: never a mixture.
template <class T>
[[nodiscard]] Image<T> resampleNearest(Image<T> map, const Camera& camera);

/// Turns a map to the photograph's orientation, still at its own resolution. A map without an orientation tag is turned
/// when it has the shape of the photograph as stored. Throws Error(Input) when it does not fit.
template <class T>
[[nodiscard]] Image<T> matchOrientation(Image<T> map, const std::string& path, const Message& what,
                                        const Camera& camera, int mapOrientation, int colorOrientation,
                                        const Message& colorPath);

/// Whether the unit of the depth has to be given because nothing in the files suggests one: 8-bit integers, and
/// integers that are no lengths.
[[nodiscard]] bool needsUnit(const PhotoFiles& files, DepthKind kind);

/// The unit [m] with which the median of the stored depth is `metres` away. 1 when no value is a depth.
[[nodiscard]] double unitForMedian(const PhotoFiles& files, DepthKind kind, double metres);

}  // namespace core
