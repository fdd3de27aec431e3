// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/scene/scene.h"

namespace core {

/// A file that may hold a photograph together with its depth, for the import formats to look at.
class ImportFile {
  public:
    /// Throws Error(Input) when there is no such regular file, or it is empty.
    explicit ImportFile(std::string path);

    [[nodiscard]] const std::string& path() const { return path_; }
    /// The first kHeadBytes bytes, fewer when the file is shorter.
    [[nodiscard]] const std::string& head() const { return head_; }
    /// The whole file, read at the first call. Throws Error(Input) when it is larger than kMaxBytes.
    [[nodiscard]] const std::string& bytes() const;

    /// Throws Error(Input): `Cannot read "PATH": REASON.`
    [[noreturn]] void fail(const Message& reason) const;

    static constexpr std::size_t kHeadBytes = 256;
    static constexpr std::size_t kMaxBytes = std::size_t{2} << 30U;

  private:
    std::string path_;
    std::string head_;
    mutable std::string bytes_;
};

/// Contents of a file as an import format found them.
struct ImportedPhoto {
    ImageRgb color;                  ///< scene-linear, as displayed
    float clipLevel = 1;             ///< linear value of the largest code; infinite for floating-point colour
    int orientation = 1;             ///< EXIF orientation that has been applied to `color`
    std::optional<float> focal35mm;  ///< 35 mm equivalent focal length [mm]
    float pixelAspect = 1;           ///< width of a pixel over its height
    std::string device;              ///< maker and model of the camera; "" = not stated, or as in the picture's EXIF
    ImageF depth;                    ///< as displayed, may be smaller than `color`; empty = the file has no depth
    ImageF coverage;                 ///< [0, 1], share of each pixel of `depth` that is covered; empty = all of it
    std::optional<DepthKind> kind;   ///< kind of `depth`; nullopt = not stated
    double unit = 1;                 ///< metres per unit of `depth`
    Message assumedUnit;             ///< sentence for the user when `unit` is an assumption; empty = the file states it
    std::optional<Camera> camera;    ///< for `color`, as displayed; nullopt = not stated
    Notes remarks;                   ///< further sentences for the user
};

/// A kind of file that holds colour and depth.
struct ImportFormat {
    const char* name;  ///< for messages: where the depth is, `depth channel of an EXR file`
    /// Decides by content. Throws Error(Input) only if the file is too damaged for that.
    bool (*recognises)(const ImportFile& file);
    /// Throws Error(Input) that names the file, what was expected and what was found.
    ImportedPhoto (*read)(const ImportFile& file);
};

/// The import formats, one a line, in the order in which they are asked. `X` is a constant defined in a file of its
/// own.
#define PATINA_IMPORT_FORMATS(X) \
    X(exrDepthFormat)            \
    X(jpegGdepthFormat)          \
    X(jpegXdmFormat)             \
    X(jpegDynamicDepthFormat)    \
    X(jpegMpfFormat)             \
    X(heifDepthFormat)           \
    X(pcdFormat)

#define PATINA_DECLARE(format) extern const ImportFormat format;
PATINA_IMPORT_FORMATS(PATINA_DECLARE)
#undef PATINA_DECLARE

[[nodiscard]] std::span<const ImportFormat* const> importFormats();

/// The first that recognises the file; nullptr when none does.
[[nodiscard]] const ImportFormat* findImportFormat(const ImportFile& file);

}  // namespace core
