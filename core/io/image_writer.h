// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

namespace core {

/// Writes one image atomically by the OpenImageIO plugin called `format`, whatever the file is called. `type` is that
/// of the interleaved `pixels`. Throws Error(Output) naming the file. For the writers of core/io only.
void writeImage(const std::string& path, const char* format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                const void* pixels);

}  // namespace core
