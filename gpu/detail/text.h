// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>

#include "gpu/error.h"

namespace gpu::detail {

/// The arguments streamed one after the other.
template <class... Args>
[[nodiscard]] std::string text(const Args&... args) {
    std::ostringstream stream;
    (stream << ... << args);
    return stream.str();
}

/// A label as messages show it.
[[nodiscard]] inline std::string quoted(const std::string& label) {
    return label.empty() ? std::string("(no label)") : '"' + label + '"';
}

/// Throws Error(Validation) unless `condition` holds; the message is only built on failure.
template <class... Args>
void require(bool condition, const Args&... message) {
    if (!condition) throw Error(ErrorKind::Validation, text(message...));
}

}  // namespace gpu::detail
