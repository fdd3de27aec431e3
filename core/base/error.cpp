// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace core {

Error::Error(ErrorKind kind, Message message)
    : std::runtime_error(message.english()),
      kind_(kind),
      message_(std::make_shared<const Message>(std::move(message))) {}

Error Error::withContext(const Message& sentence) const {
    return {kind_, Message("messages", "%1 %2").with(*message_, sentence).about(message_->setting())};
}

void assertionFailed(const char* condition, const char* message, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, condition, message);
    std::abort();
}

}  // namespace core
