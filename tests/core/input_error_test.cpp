// SPDX-License-Identifier: Apache-2.0
#include "litfog/input_error.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace litfog::test {
namespace {

static_assert(std::is_nothrow_copy_constructible_v<InputError>);

TEST(InputError, SentenceBeginsWithTheLocation) {
  const InputError error({"lamps.json", 7, 12}, "threshold", "7", "must be in (0, 1)");
  EXPECT_STREQ(error.what(), "lamps.json:7:12: threshold = 7: must be in (0, 1)");
  EXPECT_EQ(error.location().file, "lamps.json");
  EXPECT_EQ(error.location().line, 7u);
  EXPECT_EQ(error.location().column, 12u);
}

TEST(InputError, UnknownLineAndColumnAreLeftOut) {
  EXPECT_STREQ(InputError({"lamp.ies", 3}, "ends within a number").what(), "lamp.ies:3: ends within a number");
  EXPECT_STREQ(InputError({"lamp.ies"}, "is a folder").what(), "lamp.ies: is a folder");
  EXPECT_EQ(to_string(InputLocation{"lamp.ies", 0, 7}), "lamp.ies") << "a column of no line";
}

TEST(InputError, EmptyValueIsLeftOut) {
  EXPECT_STREQ(InputError({"lamp.json", 1, 1}, "range", "", "is missing").what(), "lamp.json:1:1: range: is missing");
}

TEST(InputError, ValueErrorKeepsItsSentence) {
  const InputError error({"lamp.json", 2, 3}, ValueError{"threshold", 7, "must be in (0, 1)"});
  EXPECT_STREQ(error.what(), "lamp.json:2:3: threshold = 7: must be in (0, 1)");
}

}  // namespace
}  // namespace litfog::test
