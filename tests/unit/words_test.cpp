// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"

#include <gtest/gtest.h>

#include <set>

#include "core/scene/scene.h"

namespace core {
namespace {

template <class E>
class WordsOfEnumeration : public testing::Test {};

using Enumerations = testing::Types<Fresnel, ScatteringModel, DriveSource, DepthKind, BackSideMethod, EnvironmentUse,
                                    EnvironmentFill, DiffusionQuality>;
TYPED_TEST_SUITE(WordsOfEnumeration, Enumerations);

TYPED_TEST(WordsOfEnumeration, AreUniqueAndReadBack) {
    std::set<std::string> seen;
    for (const auto& [value, key, label] : Words<TypeParam>::table) {
        EXPECT_TRUE(seen.insert(key).second) << key;
        EXPECT_STREQ(wordOf(value), key);
        EXPECT_STREQ(labelOf(value), label);
        EXPECT_EQ(findWord<TypeParam>(key), value) << key;
    }
    EXPECT_EQ(wordsOf<TypeParam>().size(), seen.size());
}

TEST(Words, UnknownWordsAndValuesAreNotFound) {
    EXPECT_EQ(findWord<Fresnel>("schlick"), Fresnel::Schlick);
    EXPECT_EQ(findWord<Fresnel>("Schlick"), std::nullopt);
    EXPECT_EQ(findWord<Fresnel>(""), std::nullopt);
    EXPECT_STREQ(wordOf(static_cast<Fresnel>(99)), "");
}

}  // namespace
}  // namespace core
