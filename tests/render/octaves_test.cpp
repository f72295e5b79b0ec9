// SPDX-License-Identifier: Apache-2.0
#include "render/light/point_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/random_light.h"

namespace litfog::test {
namespace {

TEST(Octaves, WhatIsBelowTheLeastKeptIsWithinTheBudgetAndAnOctaveMoreIsNot) {
  Random random(5);
  for (int step = 0; step < 2000; ++step) {
    std::vector<double> lights{0};
    render::Octaves octaves;
    octaves.add(0);
    for (int i = 0; i < 40; ++i) {
      lights.push_back(std::exp2(random.uniform(-40, 20)));
      octaves.add(lights.back());
    }
    const double budget = std::exp2(random.uniform(-45, 30));
    const double least = octaves.least_kept(budget);
    double below = 0;
    double an_octave_more = 0;
    for (const double light : lights) {
      if (light < least) below += light;
      if (light < 2 * least) an_octave_more += light;
    }
    ASSERT_LE(below, budget);
    if (below < an_octave_more) {
      ASSERT_GT(an_octave_more, budget);
    }
  }
}

}  // namespace
}  // namespace litfog::test
