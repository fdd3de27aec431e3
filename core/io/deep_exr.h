// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace core {

/// Deep scan lines flattened: the named channels over the data window, interleaved. Colour and alpha are composited
/// front to back (premultiplied). Z and ZBack are those of the sample that brings the coverage to one half; 0 where
/// none does. `part` counts the parts of the file. Throws std::exception when the part has no Z and A, is tiled,
/// damaged, or has more samples in a row than fit in memory.
[[nodiscard]] std::vector<float> flattenDeepExr(const std::string& path, int part,
                                                const std::vector<std::string>& channels);

}  // namespace core
