// SPDX-License-Identifier: Apache-2.0
#include "scene/model/parameter_list.h"
#include "core/value_errors.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace litfog::test {
using namespace scene;

namespace {

struct Lamp {
  float height_m = 0.12f;
  int bulbs = 3;

  void describe(ParameterList& list) {
    list.add("height_m", height_m, 0.1, 40);
    list.add("bulbs", bulbs, 1, 1e6);
    list.add_rule([this]() -> std::optional<std::string> {
      if (bulbs < 10 || height_m > 1) return std::nullopt;
      return "bulbs = 10: must be less on a low lamp";
    });
  }
};

std::string error_of(const ModelParameters& parameters) {
  Lamp lamp;
  ParameterList list;
  lamp.describe(list);
  return sentence_of<std::invalid_argument>([&] { list.set(parameters); });
}

TEST(ParameterList, DefaultIsTheShortestDecimalOfTheMember) {
  Lamp lamp;
  ParameterList list;
  lamp.describe(list);
  const std::vector<ParameterInfo> infos = list.infos();
  ASSERT_EQ(infos.size(), 2u);
  EXPECT_EQ(infos[0].name, "height_m");
  EXPECT_EQ(infos[0].default_value, 0.12);
  EXPECT_FALSE(infos[0].is_whole);
  EXPECT_EQ(infos[1].default_value, 3);
  EXPECT_TRUE(infos[1].is_whole);
}

TEST(ParameterList, GivenParametersReplaceDefaults) {
  Lamp lamp;
  ParameterList list;
  lamp.describe(list);
  list.set({{"height_m", 7.5}});
  EXPECT_EQ(lamp.height_m, 7.5f);
  EXPECT_EQ(lamp.bulbs, 3);
}

TEST(ParameterList, ErrorNamesParameterValueAndRule) {
  EXPECT_EQ(error_of({{"height_m", 0.1}, {"bulbs", 9}}), "no error");
  EXPECT_EQ(error_of({{"height_m", 0.05}}), "height_m = 0.05: must be in [0.1, 40]");
  EXPECT_EQ(error_of({{"height_m", std::numeric_limits<double>::quiet_NaN()}}), "height_m = nan: must be in [0.1, 40]");
  EXPECT_EQ(error_of({{"bulbs", 2e6}}), "bulbs = 2000000: must be in [1, 1000000]");
  EXPECT_EQ(error_of({{"bulbs", 1.5}}), "bulbs = 1.5: must be a whole number");
  EXPECT_EQ(error_of({{"wings", 2}}), "wings = 2: must be a parameter of the model");
  EXPECT_EQ(error_of({{"bulbs", 10}}), "bulbs = 10: must be less on a low lamp");
}

}  // namespace
}  // namespace litfog::test
