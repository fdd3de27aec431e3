// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/io/image_io.h"

namespace core {

/// One opened image file whose header has been checked: known format (by content, not by name), sane size.
/// Deep EXR images are flattened.
/// Used by image_io.cpp only; every failure is an Error(Input) that names the file.
class ImageReader {
  public:
    /// How a palette picture is read.
    enum class Palette { Colors, Indices };

    explicit ImageReader(const std::string& path, Palette palette = Palette::Colors);
    explicit ImageReader(EmbeddedImage image);
    ~ImageReader();
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    /// Format by content: "openexr", "png", "tiff", "jpeg", "pnm", "hdr".
    [[nodiscard]] const std::string& format() const { return format_; }
    [[nodiscard]] const OIIO::ImageSpec& spec() const { return spec_; }
    /// Size of the display window: what every other image of the photograph has to match.
    [[nodiscard]] int width() const { return spec_.full_width; }
    [[nodiscard]] int height() const { return spec_.full_height; }
    /// EXIF orientation 1..8; 1 = as stored.
    [[nodiscard]] int orientation() const;

    /// The headers of all parts of an EXR file, at most 64 of them; goes to the first.
    [[nodiscard]] std::vector<OIIO::ImageSpec> parts();
    /// Goes to a part of `parts()`.
    void goToPart(int part);
    /// The scale factor in the header of a PFM, of which only the sign is used; 1 for other formats.
    [[nodiscard]] float ignoredScale() const { return format_ == "pnm" ? headerFactor_ : 1.0f; }

    /// One channel over the display window, zero outside the data window; stored values (integers are not normalised).
    [[nodiscard]] ImageF readChannel(int channel);
    /// Three channels at once; channels may repeat. Integers are normalised to [0, 1].
    [[nodiscard]] ImageRgb readRgb(int red, int green, int blue);
    /// Factor from OpenImageIO's normalised [0, 1] to the stored integers, 1, 2, 4, 10 and 12-bit ones included; 1 for
    /// floats.
    [[nodiscard]] float integerScale() const;

    [[noreturn]] void fail(const Message& reason) const;

  private:
    void open(const std::string& name, Palette palette);
    void checkHeader() const;
    [[nodiscard]] std::string readAll() const;
    [[nodiscard]] int pngBits() const;
    void readHeaderFactor();
    void readRegion(int channelBegin, int channelEnd, float* target);
    [[nodiscard]] bool dataFillsDisplay() const;

    Message subject_;   ///< the file's name in messages
    std::string path_;  ///< empty for an embedded image
    std::string format_;
    std::size_t fileSize_ = 0;
    std::string memory_;  ///< an embedded image, or a rewritten file (indexed PNG); empty otherwise
    std::unique_ptr<OIIO::Filesystem::IOMemReader> proxy_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    float headerFactor_ = 1;  ///< of a PFM or HDR file: what the library multiplied by, or left in the values
};

/// A palette picture (PNG colour type 3) rewritten as a grey one, so that its indices can be read as numbers. Returns
/// false, leaving `bytes`, when it is no such file.
[[nodiscard]] bool indexedPngToGrey(std::string& bytes);
/// The same for a TIFF whose first page has a palette (photometric interpretation 3) or counts from white (0).
[[nodiscard]] bool indexedTiffToGrey(std::string& bytes);

}  // namespace core
