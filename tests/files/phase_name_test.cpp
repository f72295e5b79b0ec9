// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/phase_name.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "reference/random_light.h"
#include "text/number_text.h"

namespace litfog::test {
namespace {

using files::phase_named;

TEST(PhaseName, NamesAreThoseOfTheRule) {
  EXPECT_EQ(phase_named("isotropic"), Phase{});
  EXPECT_EQ(phase_named("hg:0.85"), Phase::henyey_greenstein(0.85));
  EXPECT_EQ(phase_named("hg:-0.5"), Phase::henyey_greenstein(-0.5));
  EXPECT_EQ(phase_named("droplets:20"), Phase::droplets(20));
  EXPECT_EQ(phase_named("rayleigh"), (Phase{.first = {0, 1}}));
  EXPECT_EQ(phase_named("draine:-0.3,2.5e+1"), (Phase{.first = {-0.3, 25}}));
  EXPECT_EQ(phase_named("0.7*hg:0.8+0.3*hg:-0.2"), (Phase{{0.8, 0}, {-0.2, 0}, 0.7}));
  EXPECT_EQ(phase_named("1e-1*draine:0.5,1e+3+0.9*rayleigh"), (Phase{{0.5, 1000}, {0, 1}, 0.1}));
  EXPECT_EQ(phase_named("0*isotropic+1*hg:0.5"), (Phase{{}, {0.5, 0}, 0}));
  std::istringstream wrong(
      "hg hg: hg:1 hg:nan droplets:4.9 droplets:51 droplets:x Isotropic rayleigh:1 draine: draine:0.5 draine:0.5, "
      "draine:0.5,-1 draine:0.5,1e7 draine:1,0 draine:0.5,1,2 * + 0.5*hg:0.1 0.5*hg:0.1+ 0.5*hg:0.1+0.4*hg:0.2 "
      "0.5*hg:0.1+hg:0.2 1.5*hg:0.1+-0.5*hg:0.2 0.5*droplets:10+0.5*hg:0.2 nan*hg:0.1+nan*hg:0.2 "
      "0.2*hg:0.1+0.3*hg:0.2+0.5*hg:0.3");
  for (std::string name; wrong >> name;) EXPECT_FALSE(phase_named(name)) << name;
  for (const char* name : {"", "hg:0.5 ", " hg:0.5"}) EXPECT_FALSE(phase_named(name)) << name;
}

TEST(PhaseName, AnyTwoLobesHaveAName) {
  Random random(17);
  for (int i = 0; i < 1000; ++i) {
    const Phase phase{{random.uniform(-1, 1), random.log_uniform(1e-6, 1e6)},
                      {random.uniform(-1, 1), random.chance(0.5) ? 0 : random.log_uniform(1e-6, 1e6)},
                      random.uniform(0, 1)};
    const auto term = [](double weight, const PhaseLobe& lobe) {
      return number_text(weight) + "*draine:" + number_text(lobe.asymmetry) + "," + number_text(lobe.alpha);
    };
    const std::string name = term(phase.weight, phase.first) + "+" + term(1 - phase.weight, phase.second);
    EXPECT_EQ(phase_named(name), phase) << name;
  }
}

}  // namespace
}  // namespace litfog::test
