// SPDX-License-Identifier: Apache-2.0
#include "scene/hash_random.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace scene;

namespace {

// Models and materials, and so all pictures, follow from these figures.
TEST(HashRandom, SequenceIsTheSameOnEveryMachine) {
  HashRandom random(1);
  EXPECT_EQ(random.bits(), 1492470133u);
  EXPECT_EQ(random.bits(), 3529208806u);
  EXPECT_EQ(random.unit(), 0x1.95ffc6p-1f);
  EXPECT_EQ(random.between(-1.0f, 3.0f), 0x1.48c0acp+1f);
}

TEST(HashRandom, UnitFloatIsBelowOne) {
  EXPECT_EQ(unit_float(0), 0.0f);
  EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 0x1p-24f);
}

}  // namespace
}  // namespace litfog::test
