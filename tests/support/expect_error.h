// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "core/base/error.h"

namespace test {

/// Expects `action` to throw a core::Error of this kind whose message contains all of `parts`.
template <class Action>
void expectError(core::ErrorKind kind, const std::vector<std::string>& parts, Action&& action) {
    try {
        action();
        FAIL() << "no error";
    } catch (const core::Error& error) {
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
        for (const std::string& part : parts) EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
}

}  // namespace test
