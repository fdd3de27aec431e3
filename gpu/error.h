// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace gpu {

/// The kinds of failure WebGPU knows, and the one it calls "no adapter".
enum class ErrorKind { Validation, OutOfMemory, Internal, DeviceLost, NoAdapter };

/// Failure at a creation, recording or submission boundary; the message names the object's label, what was given and
/// what was expected.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] ErrorKind kind() const { return kind_; }

  private:
    ErrorKind kind_;
};

/// Spelled-out kind for logs, for example "out of memory".
[[nodiscard]] const char* toString(ErrorKind kind);

}  // namespace gpu
