// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>

#include "core/base/message.h"

namespace core {

/// Kind of failure, for callers that act on it; the command line derives its exit codes from it.
enum class ErrorKind {
    Usage,      ///< the request is wrong (exit code 2)
    Input,      ///< a file or value from outside cannot be used (exit code 3)
    Output,     ///< a result could not be written (exit code 5)
    Cancelled,  ///< the user stopped it; no result, nothing changed
};

/// Failure of the world outside (a file, a value, a disk), never a bug. Its message is a full sentence that names the
/// file, what was expected and what was found; sentences of context follow from inner to outer.
class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, Message message);

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    /// The message, which what() has in English.
    [[nodiscard]] const Message& message() const { return *message_; }
    /// The same error with a sentence of context appended, for example `While loading "desk.patina".`
    [[nodiscard]] Error withContext(const Message& sentence) const;
    /// The same message as an error of another kind.
    [[nodiscard]] Error as(ErrorKind kind) const { return {kind, *message_}; }

  private:
    ErrorKind kind_;
    std::shared_ptr<const Message> message_;  ///< shared, because copying an exception must not throw
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
