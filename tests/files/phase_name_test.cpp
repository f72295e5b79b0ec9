// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/phase_name.h"

#include <gtest/gtest.h>

namespace litfog::test {
namespace {

using files::phase_named;

TEST(PhaseName, NamesAreThoseOfTheRule) {
  EXPECT_EQ(phase_named("isotropic"), Phase{});
  EXPECT_EQ(phase_named("hg:0.85"), Phase::henyey_greenstein(0.85));
  EXPECT_EQ(phase_named("hg:-0.5"), Phase::henyey_greenstein(-0.5));
  EXPECT_EQ(phase_named("droplets:20"), Phase::droplets(20));
  for (const char* wrong : {"", "hg", "hg:", "hg:1", "hg:nan", "hg:0.5 ", "droplets:4.9", "droplets:51", "droplets:x",
                            "Isotropic", "rayleigh"}) {
    EXPECT_FALSE(phase_named(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace litfog::test
