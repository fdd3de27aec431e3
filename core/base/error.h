// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace core {

/// What went wrong, as far as a caller has to act on it; the command line's exit codes follow from it.
enum class ErrorKind {
    Usage,      ///< the request is wrong (exit code 2)
    Input,      ///< a file or value from outside cannot be used (exit code 3)
    Output,     ///< a result could not be written (exit code 5)
    Cancelled,  ///< the user stopped it; no result, nothing changed
};

/// Failure of the world outside (a file, a value, a disk), never a bug. The message is a full sentence that names the
/// file, what was expected and what was found; context is appended from inner to outer.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] ErrorKind kind() const { return kind_; }
    /// The same error with a sentence of context appended, for example `While loading "desk.patina".`
    [[nodiscard]] Error withContext(const std::string& sentence) const { return {kind_, what() + (" " + sentence)}; }

  private:
    ErrorKind kind_;
};

[[noreturn]] void assertionFailed(const char* condition, const char* message, const char* file, int line);

}  // namespace core

/// Internal invariant; a violation is a bug in this program. Active in dev and test builds.
#ifdef PATINA_ASSERTS
#define CORE_ASSERT(condition, message) \
    ((condition) ? void() : ::core::assertionFailed(#condition, message, __FILE__, __LINE__))
#else
#define CORE_ASSERT(condition, message) void()
#endif
