// SPDX-License-Identifier: Apache-2.0
#include "reference/digits50.h"

#include <gtest/gtest.h>

namespace litfog::test {
namespace {

TEST(Digits50, UlpsBelowAPowerOfTwoAreHalfOfThoseAbove) {
  const Digits50 tiny("1e-40");  // less than a double near 1 can show
  EXPECT_DOUBLE_EQ(ulp_error(1 + 0x1p-52, Digits50(1 + tiny)), 1);
  EXPECT_DOUBLE_EQ(ulp_error(1 + 0x1p-52, Digits50(1)), 1);
  EXPECT_DOUBLE_EQ(ulp_error(1 + 0x1p-52, Digits50(1 - tiny)), 2);
  EXPECT_DOUBLE_EQ(ulp_error(1 - 0x1p-53, Digits50(1 - tiny)), 1);
}

}  // namespace
}  // namespace litfog::test
