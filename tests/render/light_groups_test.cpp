// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "render/light/group_picker.h"
#include "render/light/hidden_range.h"
#include "render/plan/lighting_path.h"

namespace litfog::test {
using namespace render;

namespace {

PlacedLight white_lamp(const glm::dvec3& position) {
  return {.light = {.name = "lamp", .attenuation = {1, 0, 0.01}, .threshold = 0.001, .cone = {}}, .position = position};
}

std::vector<glm::dvec3> places_of(const LightGroups& groups, const LightGroup& group,
                                  const std::vector<PlacedLight>& lights) {
  std::vector<glm::dvec3> places;
  for (const std::int32_t i : groups.lights_of(group)) places.push_back(lights[std::size_t(i)].position);
  return places;
}

TEST(LightGroups, RowsOfLampsFallApartIntoRowsThenIntoLamps) {
  std::vector<PlacedLight> lights;
  for (const double z : {0.0, -30.0, -60.0}) {
    for (int i = 0; i < 4; ++i) lights.push_back(white_lamp({double(i), 2, z}));
  }
  const LightGroups found = group_lights(lights, std::vector(lights.size(), 0));
  ASSERT_EQ(found.groups.size(), lights.size() - 1);
  EXPECT_EQ(found.groups[0].parent, -1);
  EXPECT_EQ(found.groups[0].position, glm::dvec3(1.5, 2, -30));
  int rows = 0;
  for (const LightGroup& group : found.groups) {
    const auto places = places_of(found, group, lights);
    const bool is_in_a_row =
        std::ranges::all_of(places, [&](const glm::dvec3& place) { return place.z == places.front().z; });
    EXPECT_EQ(is_in_a_row, group.count <= 4);
    if (group.count != 4) continue;
    ++rows;
    EXPECT_DOUBLE_EQ(group.radius, 1.5);
    EXPECT_DOUBLE_EQ(group.spread, std::sqrt(1.25));
  }
  EXPECT_EQ(rows, 3);
}

TEST(LightGroups, EveryLightIsInAllGroupsAboveIt) {
  Random random(41);
  std::vector<PlacedLight> lights;
  std::vector<int> kinds;
  for (int i = 0; i < 500; ++i) {
    lights.push_back(white_lamp(draw_direction(random) * random.log_uniform(1, 1000)));
    if (random.chance(0.2)) lights.back().position = lights[lights.size() / 2].position;
    lights.back().light.color = glm::dvec3(random.chance(0.5) ? 1 : 2);
    kinds.push_back(random.chance(0.1) ? -1 : random.chance(0.5) ? 3 : 7);
  }
  const LightGroups found = group_lights(lights, kinds);
  std::vector<int> sizes(found.groups.size(), 0);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    EXPECT_EQ(found.parents[i] < 0, kinds[i] < 0);
    for (std::int32_t at = found.parents[i]; at >= 0; at = found.groups[std::size_t(at)].parent) {
      const LightGroup& group = found.groups[std::size_t(at)];
      ++sizes[std::size_t(at)];
      EXPECT_EQ(std::ranges::count(found.lights_of(group), std::int32_t(i)), 1);
      const auto first = std::size_t(found.lights_of(group).front());
      EXPECT_EQ(kinds[i], kinds[first]);
      EXPECT_EQ(lights[i].light.color, lights[first].light.color);
      EXPECT_LE(glm::distance(lights[i].position, group.position), group.radius * (1 + 1e-12));
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_EQ(sizes[i], found.groups[i].count);
}

/// The Basic model (The Cg Tutorial, 5.2.1), white: half diffuse, or without a highlight all of it.
double reflected(const glm::dvec3& normal, const glm::dvec3& to_eye, const glm::dvec3& to_light, double shininess) {
  const double facing = glm::dot(normal, to_light);
  if (facing <= 0) return 0;
  if (shininess == 0) return facing;
  const double highlight = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
  return 0.5 * facing + 0.5 * std::pow(highlight, shininess);
}

/// The error of one light in the place of five, on a surface at the origin, over its estimate; none where that is
/// infinite, fog lets nothing through or the surface does not face all of them.
std::optional<double> error_over_estimate(Random& random, const Cone& cone, double shininess) {
  const Fog fog{random.pick(kModes), random.log_uniform(1e-5, 0.1)};
  const double range = random.log_uniform(1, 1000);
  const glm::dvec3 normal = draw_direction(random);
  const auto above = [&] {
    glm::dvec3 direction = draw_direction(random);
    if (glm::dot(direction, normal) < 0) direction = -direction;
    return glm::normalize(direction + normal * random.uniform(-0.1, 0.3));
  };
  const glm::dvec3 to_eye = above();
  const glm::dvec3 middle = above() * range;
  std::vector<PlacedLight> lights;
  const double size = range * random.log_uniform(0.001, 0.3);
  for (int j = 0; j < 5; ++j) {
    lights.push_back(white_lamp(middle + draw_direction(random) * (size * random.uniform(0, 1))));
  }
  const glm::dvec3 axis = glm::normalize(-middle / range + random.uniform(0, 1.2) * draw_direction(random));
  const auto shown = [&](const glm::dvec3& place) {
    const double distance = glm::length(place);
    return attenuation_at(lights[0].light.attenuation, distance) * fog_factor_at(fog, distance) *
           cone_at(cone, glm::dot(-place / distance, axis)) * reflected(normal, to_eye, place / distance, shininess);
  };
  const LightGroup group = group_lights(lights, std::vector(lights.size(), 0)).groups[0];
  const double estimate = group_error(group, cone, fog, shininess, glm::length(group.position));
  const auto is_faced = [&](const PlacedLight& light) { return glm::dot(light.position, normal) > 0; };
  if (std::isinf(estimate) || !std::ranges::all_of(lights, is_faced)) return {};
  double by_lights = 0;
  for (const PlacedLight& light : lights) by_lights += shown(light.position) / 5;
  const double nearest = glm::length(group.position) - group.radius;
  const double most = attenuation_at(lights[0].light.attenuation, nearest) * fog_factor_at(fog, nearest);
  if (!(most > 0)) return {};  // lost in fog
  return std::abs(by_lights - shown(group.position)) / most / estimate;
}

TEST(LightGroups, OneLightForAGroupErrsAboutAsEstimated) {
  Random random(42);
  const auto draw_cone = [&](ConeProfile profile) {
    if (profile == ConeProfile::cosine) return Cone::cosine(1.5, random.log_uniform(0.5, 200));
    if (profile == ConeProfile::smoothstep)
      return Cone::smoothstep(random.uniform(0.1, 0.3), random.uniform(0.35, 1.2));
    return Cone{};
  };
  for (const ConeProfile profile : {ConeProfile::none, ConeProfile::cosine, ConeProfile::smoothstep}) {
    for (const bool has_highlight : {false, true}) {
      std::vector<double> ratios;
      while (ratios.size() < 10'000) {
        const double shininess = has_highlight ? random.log_uniform(5, 200) : 0;
        const auto ratio = error_over_estimate(random, draw_cone(profile), shininess);
        if (ratio) ratios.push_back(*ratio);
      }
      std::ranges::sort(ratios);
      const auto at = [&](double fraction) { return ratios[std::size_t(fraction * double(ratios.size() - 1))]; };
      std::printf("cone %d, highlight %d: error over its estimate: median %.4f, 95 %% %.3f, 99 %% %.2f, most %.1f\n",
                  int(profile), int(has_highlight), at(0.5), at(0.95), at(0.99), at(1));
      EXPECT_LE(at(0.99), 1) << int(profile);
      EXPECT_GT(at(0.99), has_highlight ? 0.03 : 0.3) << "an estimate far above all errors groups too few lights";
    }
  }
}

TEST(GroupPicker, EveryLightIsListedOnceAloneOrInAGroup) {
  Random random(43);
  scene::Scene scene;
  for (int i = 0; i < 200; ++i) {
    PlacedLight light = white_lamp({random.uniform(-300, 300), 5, 30 * std::floor(random.uniform(-20, 20))});
    light.light.color = glm::dvec3(random.chance(0.8) ? 1 : 0.5);
    scene.lights.push_back(light);
  }
  const SceneLights lights(scene, {.fog_lighting = FogLighting::airlight});
  ASSERT_FALSE(lights.groups().groups.empty());
  GroupPicker picker(lights, lighting_paths().front());
  std::size_t fewest = lights.size();
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 low = glm::vec3(draw_direction(random) * random.log_uniform(1, 3000));
    const scene::Bounds box{low, low + glm::vec3(20, 1, 20)};
    std::vector<std::int32_t> asked{7, 7, 7};  // of another surface, which stay
    std::vector<int> times(lights.size(), 0);
    for (std::size_t light = 0; light < lights.size(); ++light) {
      if (random.chance(0.9)) asked.push_back(std::int32_t(light));
    }
    std::vector<std::int32_t> list = asked;
    picker.pick(list, 3, {.bounds = box, .reflectance = 0.3, .shininess = 10, .through = 0.5}, {FogMode::exp, 0.002},
                visible_step(0));
    ASSERT_EQ(std::vector(list.begin(), list.begin() + 3), std::vector<std::int32_t>(3, 7));
    for (const std::int32_t& instance : std::span(list).subspan(3)) {
      for (const std::int32_t light : lights.lights_of(instance)) ++times[std::size_t(light)];
    }
    for (const std::int32_t light : std::span(asked).subspan(3)) EXPECT_EQ(times[std::size_t(light)], 1) << light;
    EXPECT_LE(std::ranges::max(times), 1);
    fewest = std::min(fewest, list.size() - 3);
    most = std::max(most, list.size() - 3);
  }
  EXPECT_LT(fewest, 10u) << "far from all lights";
  EXPECT_GT(most, 100u) << "among them";
}

TEST(GroupPicker, InstanceOfAGroupIsInItsMiddleAndAsBrightAsAllItsLights) {
  scene::Scene scene;
  scene.lights = {white_lamp({0, 0, 0}), white_lamp({1, 0, 0}), white_lamp({5, 0, 0})};
  for (PlacedLight& light : scene.lights) light.light.color = {1, 0.5, 0.25};
  const SceneLights lights(scene, {.fog_lighting = FogLighting::airlight});
  ASSERT_EQ(lights.instances().size(), 5u);
  const FogLightInstance& all = lights.instances()[3];
  EXPECT_EQ(glm::vec3(all.position_kind), glm::vec3(2, 0, 0));
  EXPECT_EQ(glm::vec3(all.color), glm::vec3(3, 1.5, 0.75));
  EXPECT_EQ(all.position_kind.w, lights.instances()[0].position_kind.w);
  EXPECT_EQ(all.axis_profile, lights.instances()[0].axis_profile);
}

TEST(GroupPicker, NoGroupsWhereNothingIsSkippedOrLightsEndOrCastShadows) {
  scene::Scene scene;
  scene.lights = {white_lamp({0, 0, 0}), white_lamp({1, 0, 0})};
  const RenderSettings by_airlight{.fog_lighting = FogLighting::airlight};
  EXPECT_EQ(SceneLights(scene, by_airlight).groups().groups.size(), 1u);
  RenderSettings whole = by_airlight;
  whole.skipping = Skipping::off;
  RenderSettings shadowed = by_airlight;
  shadowed.shadows = Shadows::surfaces;
  for (const RenderSettings& settings : {whole, shadowed, RenderSettings{.fog_lighting = FogLighting::peak}}) {
    EXPECT_TRUE(SceneLights(scene, settings).groups().groups.empty());
  }
}

}  // namespace
}  // namespace litfog::test
