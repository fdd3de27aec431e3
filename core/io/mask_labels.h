// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/image.h"
#include "core/base/message.h"

namespace core {

/// The object in a mask that a picture program saved with its label map's one number in the alpha channel: the colours
/// are the same everywhere, or the same wherever they are not 0, and alpha varies. Labels are 0 where alpha is less
/// than half of `opaque`; where all values are 0, the object gets the label `opaque` (at most 65535).
/// `values` and `alpha` hold stored numbers and have the same size. Returns nullopt, leaving `values`, when the picture
/// is no such mask.
[[nodiscard]] std::optional<Message> takeObjectFromAlpha(ImageF& values, const ImageF& alpha, float opaque,
                                                         const std::string& path);

/// Makes a black-and-white mask with soft edges (antialiased, feathered) hard: values from half of `maximum` up become
/// `maximum`, the others 0. `maximum` is the largest value the file can store, 1 for floats. A mask is known by its
/// in-between values: they are fewer than the others, each lies between two of its neighbours, and hardly any covers an
/// area. Returns the remark for the user. Where soft edges lie between several objects, it changes nothing and only
/// remarks on that; nullopt for a label map.
[[nodiscard]] std::optional<Message> hardenMask(ImageF& values, float maximum, const std::string& path);

}  // namespace core
