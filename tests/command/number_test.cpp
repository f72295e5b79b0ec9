// SPDX-License-Identifier: Apache-2.0
#include "command/number.h"

#include <gtest/gtest.h>

#include <limits>

#include "reference/double_limits.h"

namespace litfog::test {
using namespace command;

namespace {

TEST(Number, WholeTokenIsReadExactly) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("-2.5e3"), -2500.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("2147483647"), 2147483647);
}

TEST(Number, InfinityIsReadInAnyCase) {
  for (const char* text : {"inf", "INF", "infinity", "Infinity"}) EXPECT_EQ(parse_number(text), kInfinity) << text;
  EXPECT_EQ(parse_number("-inf"), -kInfinity);
}

TEST(Number, TextThatIsNotOneNumberIsAnError) {
  for (const char* text : {"",      " ",  " 1", "1 ", "+1", "0x10", "nan",   "NaN",   "-nan",   "nan(1)", "1,5",
                           "1.5.2", "1e", "e5", ".",  "-",  "1m",   "infin", "1e999", "-1e999", "1e-999", "\xD9\xA1"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << '"' << text << '"';
  }
  for (const char* text : {"", "1.0", "+1", " 1", "1 ", "2147483648", "0x1", "1e3"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << '"' << text << '"';
  }
}

TEST(Number, PartsBetweenCommasMayBeEmpty) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split_at_commas("1,-2, 3"), (Parts{"1", "-2", " 3"}));
  EXPECT_EQ(split_at_commas(",1,,"), (Parts{"", "1", "", ""}));
  EXPECT_EQ(split_at_commas(""), Parts{""});
}

}  // namespace

}  // namespace litfog::test
