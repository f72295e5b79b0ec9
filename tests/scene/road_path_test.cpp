// SPDX-License-Identifier: Apache-2.0
#include "scene/model/road_path.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/model/model_catalogue.h"

namespace litfog::test {
using namespace scene;

namespace {

TEST(RoadPath, BendTighterThanARadiusOf100MetresIsAnError) {
  EXPECT_NO_THROW(make_model("road", {{"length_m", 100.0}, {"bend_m", 50.0}}));
  EXPECT_THROW(make_model("road", {{"length_m", 100.0}, {"bend_m", 51.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace litfog::test
