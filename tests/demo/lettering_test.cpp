// SPDX-License-Identifier: Apache-2.0
#include "drawing/lettering.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace drawing;
using namespace render;

namespace {

TEST(FittedText, TextThatFitsIsUnchanged) {
  EXPECT_EQ(fitted_text("room, clear air", 15, 480), "room, clear air");
  EXPECT_EQ(fitted_text("", 15, 480), "");
}

TEST(FittedText, LongTextIsItsBeginningAndAnEllipsis) {
  const std::string fitted = fitted_text(std::string(500, 'n'), 15, 480);
  const std::size_t letters = fitted.find_first_not_of('n');
  EXPECT_GT(letters, 30u);
  EXPECT_LT(letters, 100u);
  EXPECT_EQ(fitted.substr(letters), "\u2026");
}

TEST(FittedText, LetterOfSeveralBytesIsNotCut) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "\u00fc";
  for (const int width : {100, 105, 110}) {
    const std::string fitted = fitted_text(text, 15, width);
    EXPECT_EQ((fitted.size() - 3) % 2, 0u) << fitted;
  }
}

}  // namespace

}  // namespace litfog::test
