// SPDX-License-Identifier: Apache-2.0
#include "litfog/updater.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/allocation_count.h"
#include "core/updater_mirror.h"
#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

constexpr Fog kMist{FogMode::exp, 0.01};

FogLightInstance instance_of(const FogUpdater& updater, FogLightHandle handle) {
  return updater.instances()[updater.instance_of(handle)];
}

const FogLightKind& kind_of(const FogUpdater& updater, FogLightHandle handle) {
  return updater.kinds()[updater.kind_of(handle)];
}

float stored_intensity(const FogUpdater& updater, FogLightHandle handle) {
  return kind_of(updater, handle).cone_scale_intensity.w;
}

TEST(FogUpdater, CallersBufferStaysRightThroughAnyCalls) {
  Random random(51);
  std::size_t skipped = 0;
  for (const double budget : {0., 0.5, 20.}) {
    for (int sequence = 0; sequence < 60; ++sequence) {
      Mirror mirror(budget);
      if (sequence % 3 == 1) run_random_calls(mirror, random, 100, 3, 0.3);
      if (sequence % 3 > 0) mirror.updater.solve_sources();
      run_random_calls(mirror, random, 400, 3, random.pick(std::array{0.3, 0.6, 0.9}));
      if (HasFatalFailure()) return;
      if (budget == 0) {
        ASSERT_EQ(mirror.skipped, 0u);
      } else {
        skipped += mirror.skipped;
      }
    }
  }
  EXPECT_GT(skipped, 1000u);
}

TEST(FogUpdater, CallersBufferStaysRightThroughManyLights) {
  Random random(52);
  Mirror mirror(0.5);
  run_random_calls(mirror, random, 30000, 1000, 0.2);
  EXPECT_GT(mirror.lights.size(), 5000u);
}

TEST(FogUpdater, LightAboveTheBudgetIsNotSkipped) {
  Random random(53);
  std::size_t checked = 0;
  std::size_t dim = 0;
  std::size_t skipped = 0;
  for (int round = 0; round < 400; ++round) {
    const double budget_255 = random.log_uniform(1e-3, 30);
    FogUpdater updater(budget_255);
    std::vector<PlacedLight> lights;
    std::vector<FogLightHandle> handles;
    const bool is_wide = round % 4 == 0;
    for (int i = 0; i < 500; ++i) {
      SolveCase c = draw_ordinary_case(random, FogMode::exp);
      if (is_wide) {
        const auto draw = [&] { return random.chance(0.2) ? 0 : random.log_uniform(1e-30, 1e30); };
        c = {{draw(), draw(), random.log_uniform(1e-30, 1e30)}, {}, random.log_uniform(1e-30, 0.99)};
      }
      PlacedLight light = carried_light(c.attenuation, glm::dvec3{0.1, random.log_uniform(0.1, 100), 0.1});
      light.light.threshold = c.threshold;
      lights.push_back(light);
      handles.push_back(updater.add(light));
    }
    for (int step = 0; step < 10; ++step) {
      const Fog fog{random.pick(kModes), is_wide ? random.log_uniform(1e-30, 1e30) : random.log_uniform(1e-6, 1)};
      updater.set_fog(fog);
      for (std::size_t i = 0; i < lights.size(); ++i) {
        const float stored = stored_intensity(updater, handles[i]);
        const double intensity = solve_fog_intensity(lights[i].light, fog).intensity;
        const double part = intensity * double(brightness_of(lights[i], true)) / (budget_255 / 255);
        ++checked;
        if (part < 1 && float(intensity) > 0) ++dim;
        if (is_within_one_ulp(stored, float(intensity))) continue;
        ASSERT_EQ(stored, 0);
        ASSERT_LT(part, 1) << to_string(SolveCase{lights[i].light.attenuation, fog, lights[i].light.threshold});
        ++skipped;
      }
    }
  }
  std::printf("fog updater: %zu lights, %.2f %% below their budget, %.2f %% of these skipped\n", checked,
              100. * double(dim) / double(checked), 100. * double(skipped) / double(dim));
  EXPECT_GT(double(skipped), 0.5 * double(dim));
}

TEST(FogUpdater, KindIsSolvedOnceHoweverManyLightsItHas) {
  FogUpdater updater;
  for (int i = 0; i < 1000; ++i) updater.add(carried_light({1, 0.1 * (1 + i % 3), 0.01}));
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_solved, 3u);
  EXPECT_EQ(updater.statistics().kinds_skipped, 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 0u);
  EXPECT_EQ(updater.statistics().bytes_dirty, 3 * sizeof(FogLightKind) + 1000 * sizeof(FogLightInstance));
}

TEST(FogUpdater, ChangeOfTheFogIsAChangeOfKindsAlone) {
  FogUpdater updater;
  for (int i = 0; i < 1000; ++i) updater.add(carried_light({1, 0.1 * (1 + i % 3), 0.01}));
  updater.set_fog(kMist);
  const FogLightChanges changes = updater.set_fog({FogMode::exp, 0.02});
  ASSERT_EQ(changes.kinds.size(), 1u);
  EXPECT_EQ(changes.kinds[0], (EntryRange{0, 3}));
  EXPECT_TRUE(changes.instances.empty());
}

Atmosphere air_of_layer(double top) {
  const FogLayer layer{.top = top, .transition = 10, .visibility = 150};
  return {.fog = {FogMode::exp, 1e-4}, .profile = make_density_profile(std::span(&layer, 1))};
}

std::vector<EntryRange> list(std::span<const EntryRange> ranges) { return {ranges.begin(), ranges.end()}; }

TEST(FogUpdater, ChangeOfLayersIsAChangeOfKindsAndOneOfThePhaseOfSourcesAlone) {
  FogUpdater updater;
  updater.solve_sources();
  for (int i = 0; i < 1000; ++i) updater.add(carried_light({1, 0.1 * (1 + i % 3), 0.01}));
  constexpr double kEye = 105;
  const std::vector<EntryRange> all{{0, 3}}, none;
  updater.set_atmosphere(air_of_layer(100), kEye);
  Atmosphere air = air_of_layer(102);  // more fog at the eye, and the same where it is densest
  FogLightChanges changes = updater.set_atmosphere(air, kEye);
  EXPECT_EQ(list(changes.kinds), all);
  EXPECT_TRUE(changes.instances.empty() && changes.sources.empty());
  EXPECT_EQ(updater.statistics().kinds_solved, 3u);
  EXPECT_EQ(updater.statistics().sources_solved, 0u);
  EXPECT_EQ(updater.statistics().bytes_dirty, 3 * sizeof(FogLightKind));

  EXPECT_TRUE(updater.set_atmosphere(air, kEye).empty());
  EXPECT_EQ(list(updater.set_atmosphere(air, kEye - 1).kinds), all) << "the eye sinks into the layer";
  EXPECT_EQ(updater.kinds()[0].cone_scale_intensity.w,
            intensity_of(carried_light({1, 0.1, 0.01}), air.fog_at(kEye - 1)));

  air.phase = Phase::droplets(20);
  changes = updater.set_atmosphere(air, kEye - 1);
  EXPECT_TRUE(changes.kinds.empty() && changes.instances.empty());
  EXPECT_EQ(list(changes.sources), all);
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().sources_solved, 3u);
}

TEST(FogUpdater, SourceIsSolvedOnceAKindWhenTheAirChangesAndNeverAFrame) {
  FogUpdater updater;
  std::vector<PlacedLight> lights;
  for (int i = 0; i < 1000; ++i) {
    PlacedLight light = carried_light({1, 0.1 * (1 + i % 3), 0.01});
    light.carried = i % 2 == 0;
    light.light.flash = {2, 1, {{{0.5, 0.5, 5}}}};
    updater.add(light);
    lights.push_back(light);
  }
  updater.set_fog(kMist);
  EXPECT_TRUE(updater.sources().empty()) << "nobody has asked";
  EXPECT_EQ(updater.statistics().sources_solved, 0u);

  updater.solve_sources();
  const FogLightChanges first = updater.set_fog(kMist);
  EXPECT_TRUE(first.kinds.empty() && first.instances.empty());
  EXPECT_EQ(updater.statistics().sources_solved, 6u);
  EXPECT_EQ(updater.statistics().bytes_dirty, 6 * sizeof(FogLightSource));

  const Fog thicker{FogMode::exp, 0.02};
  const FogLightChanges changes = updater.set_fog(thicker);
  EXPECT_EQ(list(changes.sources), (std::vector<EntryRange>{{0, 6}}));
  EXPECT_TRUE(changes.instances.empty());
  EXPECT_EQ(updater.statistics().kinds_solved, 3u) << "those carried";
  EXPECT_EQ(updater.statistics().sources_solved, 6u);
  Atmosphere layered = air_of_layer(100);
  layered.phase = Phase::droplets(10);
  for (const Atmosphere& air : {Atmosphere{.fog = thicker}, layered}) {
    updater.set_atmosphere(air, 300);  // above all layers
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const auto kind = std::size_t(updater.instances()[i].position_kind.w);
      ASSERT_EQ(updater.sources()[kind], source_of(lights[i], air));
      ASSERT_GT(updater.sources()[kind].soft_range, 0);
    }
  }

  updater.set_time(0.7);
  EXPECT_TRUE(updater.set_atmosphere(layered, 300).sources.empty());
  EXPECT_EQ(updater.statistics().sources_solved, 0u) << "of a flash";
  updater.set_fog({FogMode::exp2, 0.02});
  for (const FogLightSource& source : updater.sources()) EXPECT_EQ(source, FogLightSource{});
}

TEST(FogUpdater, KindsDifferByEverythingButColorPositionAndDirection) {
  FogUpdater updater;
  std::array<PlacedLight, 13> lights;
  lights.fill(carried_light());
  lights[1].light.attenuation.constant = 2;
  lights[2].light.attenuation.linear = 0.2;
  lights[3].light.attenuation.quadratic = 0.02;
  lights[4].light.threshold = 0.2;
  lights[5].light.density_scale = 0.4;
  lights[6].light.cone = Cone::cosine(1, 2);
  lights[7].light.cone = Cone::cosine(1, 0.5);
  lights[8].light.cone = Cone::cosine(0.5, 2);
  lights[9].light.cone = Cone::smoothstep(0.5, 2);
  lights[10].light.cone = Cone::smoothstep(0.5, 1);
  lights[11].light.cone = Cone::smoothstep(0.25, 2);
  lights[12].carried = false;
  for (const PlacedLight& light : lights) updater.add(light);
  EXPECT_EQ(updater.kinds().size(), 13u);
  PlacedLight of_first_kind = lights[0];
  of_first_kind.light.name = "another";
  of_first_kind.light.color = {0.5, 0, 0};
  of_first_kind.light.cone.half_angle = 1;  // which a cone without profile does not have
  of_first_kind.position = {1, 2, 3};
  of_first_kind.direction = {0, 1, 0};
  EXPECT_EQ(updater.kind_of(updater.add(of_first_kind)), 0u);
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_solved, 12u);
}

// --- each reason to skip, alone ---

TEST(FogUpdater, LightsThatAreNotCarriedAreSkipped) {
  FogUpdater updater(0);
  PlacedLight light = carried_light();
  light.carried = false;
  const FogLightHandle handle = updater.add(light);
  EXPECT_FALSE(updater.set_fog(kMist).empty());  // the new light
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u);
  EXPECT_TRUE(updater.set_fog({FogMode::exp, 0.02}).empty());
  EXPECT_TRUE(is_same(kind_of(updater, handle), expected_kind(light, 0)));
}

TEST(FogUpdater, FlashWritesItsInstanceAloneAndSolvesNothing) {
  FogUpdater updater;
  PlacedLight strobe = carried_light();
  strobe.light.flash = {1, 1, {{{0.5, 0.125, 40}}}};
  updater.add(carried_light({1, 0.1, 0.01}));
  const FogLightHandle handle = updater.add(strobe);
  updater.set_fog(kMist);
  EXPECT_EQ(instance_of(updater, handle).color, glm::vec4(0));
  EXPECT_EQ(stored_intensity(updater, handle), intensity_of(strobe, kMist));
  for (const auto& [seconds, factor] : {std::pair{0.4, 0}, {0.5, 40}, {0.6, 40}, {0.625, 0}, {1e6 + 0.5, 40}}) {
    const bool is_new = instance_of(updater, handle).color.r != float(factor);
    updater.set_time(seconds);
    const FogLightChanges changes = updater.set_fog(kMist);
    EXPECT_EQ(instance_of(updater, handle).color, glm::vec4(factor, factor, factor, 0)) << seconds;
    EXPECT_EQ(updater.statistics().kinds_solved, 0u);
    EXPECT_TRUE(changes.kinds.empty());
    const std::size_t at = updater.instance_of(handle);
    const std::vector<EntryRange> expected(is_new ? 1 : 0, EntryRange{at, at + 1});
    EXPECT_TRUE(std::ranges::equal(changes.instances, expected));
  }
  for (const double seconds : {-1.0, 1.1e9, kNan}) EXPECT_THROW(updater.set_time(seconds), std::invalid_argument);
}

TEST(FogUpdater, KindIsMeasuredByItsBrightestFlash) {
  FogUpdater updater;
  PlacedLight strobe = carried_light({1, 0.1, 0.01}, glm::dvec3{1e-4});
  const FogLightHandle steady = updater.add(strobe);
  updater.set_fog(kMist);
  EXPECT_EQ(stored_intensity(updater, steady), 0);
  strobe.light.flash = {1, 2, {{{0.5, 0.1}, {0.6, 0.1, 1000}}}};
  updater.change(steady, strobe);
  updater.set_fog(kMist);
  EXPECT_EQ(stored_intensity(updater, steady), intensity_of(strobe, kMist));
}

TEST(FogUpdater, LightsThatAreOffAreSkipped) {
  FogUpdater updater(0);
  const FogLightHandle handle = updater.add(carried_light());
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_solved, 1u);
  updater.switch_light(handle, false);
  EXPECT_FALSE(updater.set_fog(kMist).empty());
  EXPECT_EQ(instance_of(updater, handle).color, glm::vec4(0));
  EXPECT_EQ(stored_intensity(updater, handle), 0);
  EXPECT_TRUE(updater.set_fog({FogMode::exp, 0.02}).empty());
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().kinds_skipped, 1u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u);
  updater.switch_light(handle, true);
  EXPECT_FALSE(updater.set_fog({FogMode::exp, 0.02}).empty());
  EXPECT_EQ(stored_intensity(updater, handle), intensity_of(carried_light(), {FogMode::exp, 0.02}));
}

TEST(FogUpdater, BlackLightsAreSkipped) {
  FogUpdater updater(0);
  updater.add(carried_light({1, 0.1, 0.01}, glm::dvec3{0}));
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u);
  EXPECT_EQ(updater.kinds()[0].cone_scale_intensity.w, 0);
}

TEST(FogUpdater, LightsBelowTheBudgetAreSkipped) {
  const PlacedLight light = carried_light();
  const Fog thin_mist{FogMode::exp, 1e-4};
  const double intensity_255 = 255 * double(intensity_of(light, thin_mist));
  FogUpdater updater(1.01 * intensity_255);
  const FogLightHandle handle = updater.add(light);
  updater.set_fog(thin_mist);
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().kinds_skipped, 1u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u);
  EXPECT_EQ(stored_intensity(updater, handle), 0);
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_solved, 1u);
  EXPECT_GT(stored_intensity(updater, handle), 0);
  EXPECT_FALSE(updater.set_fog(thin_mist).empty());
  EXPECT_EQ(stored_intensity(updater, handle), 0);
}

TEST(FogUpdater, KindIsMeasuredInTheFogThatItsClassSees) {
  PlacedLight light = carried_light();
  const Fog thin_mist{FogMode::exp, 1e-4};
  FogUpdater updater(1.01 * 255 * double(intensity_of(light, thin_mist)));
  light.light.density_scale = 2.5;
  const FogLightHandle handle = updater.add(light);
  updater.set_fog(thin_mist);
  EXPECT_EQ(updater.statistics().kinds_solved, 1u);
  light.light.density_scale = 0.4;
  updater.change(handle, light);
  updater.set_fog({FogMode::exp, 2e-4});
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
}

TEST(FogUpdater, KindIsMeasuredByItsBrightestLight) {
  const Fog thin_mist{FogMode::exp, 1e-4};
  const double intensity_255 = 255 * double(intensity_of(carried_light(), thin_mist));
  FogUpdater updater(2 * intensity_255);
  updater.add(carried_light());
  const FogLightHandle bright = updater.add(carried_light({1, 0.1, 0.01}, {0, 3, 0}));
  const FogLightHandle as_bright = updater.add(carried_light({1, 0.1, 0.01}, {0, 0, 3}));
  const auto kinds_solved = [&] {
    updater.set_fog(thin_mist);
    return updater.statistics().kinds_solved;
  };
  EXPECT_EQ(kinds_solved(), 1u);
  updater.switch_light(bright, false);
  EXPECT_EQ(kinds_solved(), 1u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u) << "the one that is off";
  updater.remove(as_bright);
  EXPECT_EQ(kinds_solved(), 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 2u);
  updater.switch_light(bright, true);
  EXPECT_EQ(kinds_solved(), 1u);
  updater.change(bright, carried_light({1, 0.1, 0.01}, {0, 1.5, 0}));
  EXPECT_EQ(kinds_solved(), 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 2u);
}

TEST(FogUpdater, BudgetOfZeroSkipsNothing) {
  FogUpdater updater(0);
  updater.add(carried_light());
  updater.add(carried_light({30, 0, 0}));  // without extent: intensity 0
  updater.set_fog({FogMode::exp2, 1e-200});
  EXPECT_EQ(updater.statistics().kinds_solved, 2u);
  EXPECT_EQ(updater.statistics().lights_skipped, 0u);
}

TEST(FogUpdater, UnchangedFogIsSkipped) {
  FogUpdater updater;
  updater.add(carried_light());
  EXPECT_FALSE(updater.set_fog(kMist).empty());
  EXPECT_TRUE(updater.set_fog(kMist).empty());
  EXPECT_EQ(updater.statistics().kinds_solved, 0u);
  EXPECT_EQ(updater.statistics().kinds_skipped, 1u);
  EXPECT_EQ(updater.statistics().lights_skipped, 1u);
  EXPECT_EQ(updater.statistics().bytes_dirty, 0u);
  EXPECT_FALSE(updater.set_fog({FogMode::exp2, kMist.density}).empty());
}

TEST(FogUpdater, UnchangedStoredValueIsNotDirty) {
  FogUpdater updater;
  updater.add(carried_light());
  updater.set_fog(kMist);
  EXPECT_TRUE(updater.set_fog({FogMode::exp, kMist.density * (1 + 1e-12)}).empty());
  EXPECT_EQ(updater.statistics().kinds_solved, 1u);
  EXPECT_EQ(updater.statistics().bytes_dirty, 0u);
}

TEST(FogUpdater, LightSwitchedToWhatItIsIsNotDirty) {
  FogUpdater updater;
  const FogLightHandle handle = updater.add(carried_light());
  updater.set_fog(kMist);
  updater.switch_light(handle, true);
  EXPECT_TRUE(updater.set_fog(kMist).empty());
  updater.switch_light(handle, false);
  updater.set_fog(kMist);
  updater.switch_light(handle, false);
  EXPECT_TRUE(updater.set_fog(kMist).empty());
}

TEST(FogUpdater, ChangedLightSolvesItsKindOnly) {
  FogUpdater updater;
  for (int i = 0; i < 100; ++i) updater.add(carried_light({1, 0.1 * (1 + i / 10), 0.01}));
  const FogLightHandle handle = updater.add(carried_light());
  updater.set_fog(kMist);
  PlacedLight moved = carried_light();
  moved.position = {1, 2, 3};
  updater.change(handle, moved);
  const FogLightChanges changes = updater.set_fog(kMist);
  EXPECT_TRUE(changes.kinds.empty());
  ASSERT_EQ(changes.instances.size(), 1u);
  EXPECT_EQ(changes.instances[0], (EntryRange{100, 101}));
  EXPECT_EQ(updater.statistics().kinds_solved, 1u);
  EXPECT_EQ(updater.statistics().kinds_skipped, 9u);
}

// --- the tables ---

TEST(FogUpdater, LimitsOfFogAndAttenuationAreHeld) {
  const std::array attenuations{Attenuation{4, 0.1, 0}, Attenuation{0, 0.1, 0}, Attenuation{4, 0, 0},
                                Attenuation{30, 1, 0}};
  for (const FogMode mode : kModes) {
    FogUpdater updater;
    for (const Attenuation& attenuation : attenuations) updater.add(carried_light(attenuation));
    const auto intensities = [&](double density) {
      updater.set_fog({mode, density});
      std::array<float, 4> values;
      for (std::size_t i = 0; i < 4; ++i) values[i] = updater.kinds()[i].cone_scale_intensity.w;
      return values;
    };
    EXPECT_EQ(intensities(kInfinity), (std::array{0.25f, 1.0f, 0.25f, 0.0f}));
    EXPECT_EQ(intensities(1e-300), (std::array{0.0f, 0.0f, 0.25f, 0.0f}));
    EXPECT_EQ(intensities(0), (std::array{0.0f, 0.0f, 0.0f, 0.0f}));
  }
}

TEST(FogUpdater, InstancesAreInTheOrderOfAdding) {
  FogUpdater updater;
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(updater.instance_of(updater.add(carried_light({1, 0.1 * double(1 + i % 7), 0.01}))), i);
  }
  EXPECT_EQ(updater.instances().size(), 1000u);
  EXPECT_EQ(updater.kinds().size(), 7u);
}

TEST(FogUpdater, EntriesOfRemovedLightsAndKindsAreReused) {
  FogUpdater updater;
  for (int round = 0; round < 20; ++round) {
    std::vector<FogLightHandle> handles;
    for (int i = 0; i < 1000; ++i) handles.push_back(updater.add(carried_light({1, 0.1 * (1 + i % 4 + round), 0.01})));
    updater.set_fog(kMist);
    EXPECT_EQ(updater.statistics().kinds_solved + updater.statistics().kinds_skipped, 4u);
    EXPECT_EQ(updater.kinds().size(), 4u);
    EXPECT_EQ(updater.instances().size(), 1000u);
    for (const FogLightHandle handle : handles) updater.remove(handle);
  }
  updater.set_fog(kMist);
  EXPECT_EQ(updater.statistics().kinds_skipped, 0u);
  EXPECT_EQ(updater.statistics().lights_skipped, 0u);
}

TEST(FogUpdater, RangesAreJoinedOverSmallGapsOnly) {
  FogUpdater updater(0);
  std::vector<FogLightHandle> handles;
  for (int i = 0; i < 2000; ++i) handles.push_back(updater.add(carried_light({1, 0.1 * (1 + i), 0.01})));
  updater.set_fog(kMist);
  for (const std::size_t i : {0u, 200u, 1200u}) updater.switch_light(handles[i], false);
  const FogLightChanges changes = updater.set_fog(kMist);
  for (const auto ranges : {changes.kinds, changes.instances}) {
    ASSERT_EQ(ranges.size(), 2u);
    EXPECT_EQ(ranges[0], (EntryRange{0, 201}));
    EXPECT_EQ(ranges[1], (EntryRange{1200, 1201}));
  }
}

TEST(FogUpdater, SwitchingLightsAllocatesNothingHoweverManyRangesItMakes) {
  FogUpdater updater;
  std::vector<FogLightHandle> handles;
  for (int i = 0; i < 100'000; ++i) {
    handles.push_back(updater.add(carried_light()));
    if (i % 100 == 0) updater.set_fog(kMist);
  }
  updater.set_fog(kMist);
  const std::size_t before = allocation_count();
  for (std::size_t i = 0; i < handles.size(); i += 300) updater.switch_light(handles[i], false);
  const FogLightChanges changes = updater.set_fog(kMist);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(changes.instances.size(), 334u);
}

TEST(FogUpdater, SetFogAllocatesNothing) {
  Random random(54);
  FogUpdater updater;
  std::vector<FogLightHandle> handles;
  for (int i = 0; i < 5000; ++i) handles.push_back(updater.add(draw_light(random)));
  const std::size_t before = allocation_count();
  Fog fog;
  for (int step = 0; step < 200; ++step) {
    if (step == 100) updater.solve_sources();
    fog = draw_fog(random, fog);
    updater.set_fog(fog);
    for (int i = 0; i < 10; ++i) updater.switch_light(random.pick(handles), random.chance(0.5));
    updater.set_time(random.uniform(0, 100));
  }
  EXPECT_EQ(allocation_count(), before);
  FogUpdater().add(carried_light());
  EXPECT_GT(allocation_count(), before);  // it does count
}

TEST(FogUpdater, CallThatRunsOutOfMemoryChangesNothing) {
  Random random(57);
  Mirror mirror(0.5);
  mirror.lights.reserve(300);
  std::size_t failed = 0;
  for (int i = 0; i < 300; ++i) {
    const PlacedLight light = draw_light(random);
    const bool is_added = mirror.lights.empty() || random.chance(0.6);
    const std::size_t at = is_added ? 0 : std::size_t(random.below(int(mirror.lights.size())));
    const Fog fog = draw_fog(random, kMist);
    failed += fail_each_allocation(
        [&] {
          try {
            is_added ? mirror.add(light) : mirror.change(at, light);
          } catch (const std::bad_alloc&) {
          }
        },
        [&] { mirror.set_fog(fog); });
    ASSERT_NO_FATAL_FAILURE(mirror.set_fog(fog)) << i;
    if (random.chance(0.7)) continue;
    const std::size_t before = allocation_count();
    mirror.remove(std::size_t(random.below(int(mirror.lights.size()))));
    EXPECT_EQ(allocation_count(), before);
  }
  EXPECT_GT(failed, 100u);
}

// --- handles ---

TEST(FogUpdater, HandleIsValidUntilItsLightIsRemoved) {
  FogUpdater updater;
  const FogLightHandle first = updater.add(carried_light());
  const FogLightHandle second = updater.add(carried_light());
  EXPECT_NE(first, second);
  updater.remove(first);
  const FogLightHandle third = updater.add(carried_light());
  EXPECT_EQ(third.slot, first.slot);
  EXPECT_NE(third, first);
  const std::string error = "handle.slot = 0: must be that of a light held";
  EXPECT_EQ(error_of([&] { updater.remove(first); }), error);
  EXPECT_EQ(error_of([&] { updater.change(first, carried_light()); }), error);
  EXPECT_EQ(error_of([&] { updater.switch_light(first, false); }), error);
  EXPECT_EQ(error_of([&] { (void)updater.instance_of(first); }), error);
  EXPECT_EQ(error_of([&] { (void)updater.kind_of(first); }), error);
  EXPECT_EQ(error_of([&] { updater.remove(FogLightHandle{}); }), error);
  EXPECT_EQ(error_of([&] { updater.remove({.slot = 7, .generation = 1}); }),
            "handle.slot = 7: must be that of a light held");
  updater.remove(third);
  EXPECT_EQ(error_of([&] { updater.remove(third); }), error);
  EXPECT_EQ(error_of([&] { updater.remove({.slot = third.slot, .generation = third.generation + 1}); }), error);
  updater.remove(second);
}

TEST(FogUpdater, LightKeepsItsInstanceUntilItIsRemoved) {
  FogUpdater updater;
  updater.add(carried_light());
  const FogLightHandle handle = updater.add(carried_light());
  std::vector<FogLightHandle> others;
  for (int i = 0; i < 1000; ++i) others.push_back(updater.add(carried_light({1, 0.1 * (1 + i % 3), 0.01})));
  updater.set_fog(kMist);
  updater.switch_light(handle, false);
  updater.change(handle, carried_light({1, 0.7, 0.01}, {0.5, 0.25, 1}));
  updater.switch_light(handle, true);
  for (const FogLightHandle other : others) updater.remove(other);
  updater.set_fog({FogMode::exp, 0.02});
  EXPECT_EQ(updater.instance_of(handle), 1u);
  updater.remove(handle);
  EXPECT_EQ(updater.instance_of(updater.add(carried_light())), 1u);
}

TEST(FogUpdater, BoundsAreThoseOfEachLightAndFollowTheFog) {
  FogUpdater updater;
  PlacedLight spot = carried_light({1, 0, 0.0001}, {3, 2, 1});
  spot.light.threshold = 1e-6;
  spot.light.cone = Cone::smoothstep(0.1, 0.4);
  spot.direction = {0.6, 0, -0.8};
  PlacedLight lamp = carried_light({1, 0, 1e-4});
  lamp.light.threshold = 1e-6;
  lamp.position = {10, 5, -200};
  lamp.light.density_scale = 0.5;
  PlacedLight flashing = lamp;  // dark at 0 s
  flashing.light.flash = {.period = 2, .count = 1};
  flashing.light.flash.flashes[0] = {.start = 1, .duration = 0.1};
  const PlacedLight placed[] = {spot, lamp, lamp, lamp, flashing};
  std::vector<FogLightHandle> handles;
  for (const PlacedLight& light : placed) handles.push_back(updater.add(light));
  updater.remove(handles[2]);
  updater.switch_light(handles[3], false);
  updater.set_time(0);
  LightClusters clusters;
  for (const double density : {0.1, 0.01, 0.0}) {
    const Atmosphere air{.fog = {FogMode::exp, density}, .phase = Phase::droplets(10)};
    updater.bound_lights(clusters, air, 0.01);
    clusters.update({});
    LightClusters expected;
    expected.resize(5);
    for (const std::size_t i : {0u, 1u, 4u}) {
      const double budget = reach_budget(0.01, 4, i == 0 ? 3 : 1, air);
      const double reach = light_reach(placed[i].light, air.fog, budget);
      EXPECT_EQ(updater.reach_of_kind(updater.kind_of(handles[i]), air, 0.01), reach);
      expected.set_light(i, bounds_of(placed[i], reach));
    }
    expected.update({});
    EXPECT_TRUE(std::ranges::equal(clusters.table(), expected.table())) << density;
    EXPECT_GT(clusters.light_list().size(), 0u);
  }
  const Atmosphere air;
  flashing.light.color = {1e34, 1, 1};
  flashing.light.flash.flashes[0] = {.start = 0, .duration = 1, .intensity = 1e6};  // more than floats hold
  updater.change(handles[4], flashing);
  updater.bound_lights(clusters, air, 0.01);
  EXPECT_EQ(updater.instances()[4].color.x, std::numeric_limits<float>::max());
  FogUpdater empty;
  EXPECT_EQ(error_of([&] { (void)updater.reach_of_kind(2, air); }), "kind = 2: must be below the number of kinds");
  for (const FogUpdater& any : {std::ref(updater), std::ref(empty)}) {
    EXPECT_EQ(error_of([&] { any.bound_lights(clusters, air, 0); }), "step = 0: must be finite and > 0");
  }
  updater.switch_light(handles[0], false);
  EXPECT_EQ(updater.reach_of_kind(updater.kind_of(handles[0]), air), 0);
}

TEST(FogUpdater, WrongArgumentIsAnErrorAndChangesNothing) {
  EXPECT_EQ(error_of([] { FogUpdater(-1); }), "skip_budget_255 = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { FogUpdater(std::nan("")); }), "skip_budget_255 = nan: must be finite and >= 0");
  FogUpdater updater;
  const FogLightHandle handle = updater.add(carried_light());
  updater.set_fog(kMist);
  const FogLightInstance before = updater.instances()[0];
  const PlacedLight wrong = carried_light({-1, 0, 0});
  EXPECT_EQ(error_of([&] { updater.add(wrong); }), "attenuation.constant = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([&] { updater.change(handle, wrong); }), "attenuation.constant = -1: must be finite and >= 0");
  const PlacedLight wrong_color = carried_light({1, 0, 0}, {0, -1, 0});
  EXPECT_EQ(error_of([&] { updater.add(wrong_color); }), "color.g = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([&] { updater.change(handle, wrong_color); }), "color.g = -1: must be finite and >= 0");
  PlacedLight lost = carried_light();
  lost.position.y = kNan;
  EXPECT_EQ(error_of([&] { updater.add(lost); }), "position.y = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of([&] { updater.change(handle, lost); }), "position.y = nan: must be at most 16777216 in magnitude");
  PlacedLight short_axis = carried_light();
  short_axis.direction = {0, 0, -0.5};
  EXPECT_EQ(error_of([&] { updater.add(short_axis); }), "direction = 0.5: length must be 1 within 1e-6");
  EXPECT_EQ(error_of([&] { updater.change(handle, short_axis); }), "direction = 0.5: length must be 1 within 1e-6");
  EXPECT_EQ(error_of([&] { updater.set_fog({FogMode::exp, -1}); }), "fog.density = -1: must be >= 0");
  EXPECT_EQ(error_of([&] { updater.set_atmosphere({.albedo = 2}); }), "albedo = 2: must be in [0, 1]");
  EXPECT_EQ(error_of([&] { updater.set_atmosphere({}, kNan); }), "eye_height = nan: must be a number");
  EXPECT_TRUE(updater.set_fog(kMist).empty());
  EXPECT_TRUE(is_same(updater.instances()[0], before));
  EXPECT_EQ(updater.kinds().size(), 1u);
}

/// Lights of one kind, each with other zeros negative.
std::vector<PlacedLight> lights_with_negative_zeros(const Light& light) {
  std::vector<PlacedLight> lights;
  for (unsigned negative = 0; negative < 64; ++negative) {
    PlacedLight placed;
    placed.light = light;
    placed.carried = true;
    auto& [constant, linear, quadratic] = placed.light.attenuation;
    double* const fields[] = {&constant,
                              &linear,
                              &quadratic,
                              &placed.light.density_scale,
                              &placed.light.color.r,
                              &placed.light.cone.exponent};
    for (unsigned k = 0; k < 6; ++k) {
      if (*fields[k] == 0 && (negative >> k & 1) != 0) *fields[k] = -0.0;
    }
    lights.push_back(placed);
  }
  return lights;
}

TEST(FogUpdater, NegativeZeroIsZero) {
  for (const Attenuation& attenuation : {Attenuation{0, 0.1, 0}, Attenuation{0, 0, 0.01}, Attenuation{0, 0.1, 0.01},
                                         Attenuation{1, 0, 0.01}, Attenuation{0.5, 0, 0}}) {
    for (const double density_scale : {0.0, 1.0}) {
      Light light;
      light.color = {0, 1, 0.5};
      light.attenuation = attenuation;
      light.density_scale = density_scale;
      light.cone = Cone::cosine(0.5, 0);
      for (const FogMode mode : kModes) {
        for (const double density : {0.0, -0.0, 1e-3, 0.06, kInfinity}) {
          const Fog fog{mode, density};
          FogUpdater expected;
          const FogLightHandle positive = expected.add(lights_with_negative_zeros(light).front());
          expected.set_fog({mode, std::abs(density)});
          for (const PlacedLight& placed : lights_with_negative_zeros(light)) {
            FogUpdater updater;
            const FogLightHandle handle = updater.add(placed);
            updater.set_fog(fog);
            ASSERT_TRUE(is_same(kind_of(updater, handle), kind_of(expected, positive)));
            ASSERT_TRUE(is_same(instance_of(updater, handle), instance_of(expected, positive)));
            ASSERT_EQ(updater.statistics().kinds_solved, expected.statistics().kinds_solved);
          }
        }
      }
    }
  }
}

TEST(FogUpdater, MovedUpdaterKeepsItsLights) {
  FogUpdater first;
  const FogLightHandle handle = first.add(carried_light());
  first.set_fog(kMist);
  const FogLightInstance before = instance_of(first, handle);
  FogUpdater second = std::move(first);
  EXPECT_TRUE(is_same(instance_of(second, handle), before));
  EXPECT_TRUE(second.set_fog(kMist).empty());
  first = FogUpdater();
  EXPECT_EQ(error_of([&] { (void)first.instance_of(handle); }), "handle.slot = 0: must be that of a light held");
  first = std::move(second);
  EXPECT_TRUE(is_same(instance_of(first, handle), before));
}

TEST(FogUpdater, TwoUpdatersServeTwoThreads) {
  const auto run = [](Mirror& mirror) {
    Random random(55);
    run_random_calls(mirror, random, 1000, 5, 0.3);
  };
  std::array<Mirror, 3> mirrors{Mirror(0.5), Mirror(0.5), Mirror(0.5)};
  std::thread first(run, std::ref(mirrors[0]));
  std::thread second(run, std::ref(mirrors[1]));
  first.join();
  second.join();
  run(mirrors[2]);
  for (const Mirror* threads : {&mirrors[0], &mirrors[1]}) {
    EXPECT_TRUE(std::ranges::equal(threads->updater.kinds(), mirrors[2].updater.kinds(), is_same<FogLightKind>));
    EXPECT_TRUE(
        std::ranges::equal(threads->updater.instances(), mirrors[2].updater.instances(), is_same<FogLightInstance>));
  }
}

}  // namespace
}  // namespace litfog::test
