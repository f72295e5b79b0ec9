// SPDX-License-Identifier: Apache-2.0
#include "text/shown_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace litfog::test {
namespace {

TEST(ShownNumber, WrittenNumberIsShownAsWritten) {
  EXPECT_EQ(shown_number(0.3), "0.3");
  EXPECT_EQ(shown_number(450.125), "450.125");
  EXPECT_EQ(shown_number(132.287566), "132.287566");
  EXPECT_EQ(shown_number(1234567), "1234567");
  EXPECT_EQ(shown_number(200000), "200000") << "2e+05 is shorter, but nobody writes it";
  EXPECT_EQ(shown_number(-12.5), "-12.5");
  EXPECT_EQ(shown_number(0), "0");
  EXPECT_EQ(shown_number(9.5e-5), "9.5e-05");
  EXPECT_EQ(shown_number(1e30), "1e+30");
}

TEST(ShownNumber, ComputedNumberHasSixDigitsOrIsAnInteger) {
  EXPECT_EQ(shown_number(0.1 + 0.2), "0.3");
  EXPECT_EQ(shown_number(1.0 / 3), "0.333333");
  EXPECT_EQ(shown_number(std::sqrt(12345.678)), "111.111");
  EXPECT_EQ(shown_number(1234567 + 1.0 / 3), "1234567");
  EXPECT_EQ(shown_number(1e11 / 3), "33333333300");
  EXPECT_EQ(shown_number(1e-5 / 3), "3.33333e-06");
  EXPECT_EQ(shown_number(9.999999999999998), "10");
}

TEST(ShownNumber, RoundedNumberHasItsDigitsOrIsAnInteger) {
  EXPECT_EQ(shown_rounded(100, 2), "100") << "not 1e+02";
  EXPECT_EQ(shown_rounded(99.96, 2), "100");
  EXPECT_EQ(shown_rounded(-1749.6, 3), "-1750");
  EXPECT_EQ(shown_rounded(12.345, 3), "12.3");
  EXPECT_EQ(shown_rounded(0.00123456, 3), "0.00123");
  EXPECT_EQ(shown_rounded(5.52e-5, 2), "5.5e-05");
  EXPECT_EQ(shown_rounded(123456789, 2), "123456789");
  EXPECT_EQ(shown_rounded(1e300, 2), "1e+300");
  EXPECT_EQ(shown_rounded(-0.0, 3), "0");
}

TEST(ShownNumber, ChangeHasItsSign) {
  EXPECT_EQ(shown_change(100, 2), "+100");
  EXPECT_EQ(shown_change(-0.125, 2), "-0.12");
  EXPECT_EQ(shown_change(0, 2), "+0");
}

TEST(ShownNumber, NumbersWithoutAValueHaveNames) {
  EXPECT_EQ(shown_number(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(shown_number(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(shown_number(std::numeric_limits<double>::quiet_NaN()), "nan");
}

}  // namespace
}  // namespace litfog::test
