// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/message.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/error.h"

namespace {

using core::Message;

/// A language in which every word of the patterns is one of another.
std::string inOtherWords(const Message& message) {
    static const std::map<std::string, std::string> kWords{{"Cannot read \"%1\": %2.", "%2 hindert an %1!"},
                                                           {"it is empty", "Leere"}};
    return message.text([](const char*, const std::string& pattern) {
        const auto found = kWords.find(pattern);
        return found == kWords.end() ? pattern : found->second;
    });
}

TEST(Message, FillsItsPlacesInAnyOrder) {
    const Message message = Message("test", "Cannot read \"%1\": %2.").with("a.png", Message("test", "it is empty"));
    EXPECT_EQ(message.english(), "Cannot read \"a.png\": it is empty.");
    EXPECT_EQ(inOtherWords(message), "Leere hindert an a.png!");
}

TEST(Message, ValuesAreNoPatterns) {
    const Message message = Message("test", "Cannot read \"%1\": %2.").with("100%2 it is empty", "%1");
    EXPECT_EQ(message.english(), "Cannot read \"100%2 it is empty\": %1.");
    EXPECT_EQ(inOtherWords(Message("it is empty")), "it is empty") << "a text has no translation";
}

TEST(Message, NumbersAndPercentSigns) {
    EXPECT_EQ(Message("test", "%1 % of %2, %3, %4").with(5, 0.25, 1e-7f).english(), "5 % of 0.25, 1e-07, %4");
}

TEST(Message, ListsItsItems) {
    EXPECT_TRUE(core::listed({}).empty());
    const std::vector<Message> items{"a", "b", "c"};
    EXPECT_EQ(core::listed(items).english(), "a, b, c");
}

TEST(Error, KeepsMessageContextAndSetting) {
    const core::Error inner(core::ErrorKind::Usage, Message("test", "No unit.").about(core::Setting::DepthUnit));
    const core::Error error = inner.as(core::ErrorKind::Input).withContext("While loading.");
    EXPECT_STREQ(error.what(), "No unit. While loading.");
    EXPECT_EQ(error.kind(), core::ErrorKind::Input);
    EXPECT_EQ(error.message().setting(), core::Setting::DepthUnit);
}

}  // namespace
