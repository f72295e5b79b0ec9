// SPDX-License-Identifier: Apache-2.0
#include "measure/quantile.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace measure;

namespace {

TEST(Quantile, LiesBetweenNeighboursInProportionWhateverTheOrder) {
  const std::vector<double> values{40, 10, 30, 20, 50};
  EXPECT_EQ(quantile(values, 0), 10);
  EXPECT_EQ(quantile(values, 0.5), 30);
  EXPECT_DOUBLE_EQ(quantile(values, 0.1), 14);
  EXPECT_DOUBLE_EQ(quantile(values, 0.9), 46);
  EXPECT_EQ(quantile(values, 1), 50);
}

TEST(Quantile, MedianOfTwoValuesIsTheirMean) { EXPECT_EQ(quantile({3, 1}, 0.5), 2); }

TEST(Quantile, OneValueIsEachOfItsQuantiles) {
  for (const double fraction : {0.0, 0.3, 1.0}) EXPECT_EQ(quantile({7}, fraction), 7) << fraction;
}

}  // namespace

}  // namespace litfog::test
