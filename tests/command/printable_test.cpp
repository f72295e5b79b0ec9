// SPDX-License-Identifier: Apache-2.0
#include "command/printable.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace command;

namespace {

TEST(Printable, PlainTextStaysUnchanged) {
  for (const char* text : {"", "lamp 7", "\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x92\xA1", "\\x1b"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ControlCharactersAreEscaped) {
  EXPECT_EQ(printable("a\x1B[31mred\x07"), "a\\x1b[31mred\\x07");
  EXPECT_EQ(printable(std::string("a\0b\n\x7F", 5)), "a\\x00b\\x0a\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\u009b31m")
      << "a terminal may take U+009B as ESC [";
}

TEST(Printable, BytesThatAreNoUtf8AreEscaped) {
  EXPECT_EQ(printable("caf\xE9"), "caf\\xe9");
  EXPECT_EQ(printable("\xE2\x82!"), "\\xe2\\x82!");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
}

TEST(Printable, NoncharactersAreEscaped) {
  EXPECT_EQ(printable("\xEF\xBF\xBE\xEF\xBF\xBF"), "\\ufffe\\uffff");
  EXPECT_EQ(printable("\xEF\xBF\xBD"), "\xEF\xBF\xBD");
}

TEST(Printable, LinesKeepTheirLineFeedsOnly) { EXPECT_EQ(printable_lines("a\nb\rc\n"), "a\nb\\x0dc\n"); }

}  // namespace

}  // namespace litfog::test
