// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "litfog/multiple_scattering.h"
#include "litfog/updater.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {

inline PlacedLight carried_light(const Attenuation& attenuation = {1, 0.1, 0.01},
                                 const glm::dvec3& color = glm::dvec3{1}) {
  PlacedLight light;
  light.light.color = color;
  light.light.attenuation = attenuation;
  light.carried = true;
  return light;
}

/// What the updater has to store.
inline FogLightKind expected_kind(const PlacedLight& light, double intensity) {
  const double light_extent = compute_extent(light.light.attenuation, light.light.threshold);
  return pack_fog_light_kind(light, {.intensity = intensity, .peak_range = 0, .extent = light_extent, .status = {}});
}
inline FogLightInstance expected_instance(const PlacedLight& light, bool is_on, std::size_t kind, float factor = 1) {
  FogLightInstance instance = pack_fog_light_instance(light, kind);
  instance.color *= is_on ? factor : 0;
  return instance;
}

inline float intensity_of(const PlacedLight& light, const Fog& fog) {
  return expected_kind(light, solve_fog_intensity(light.light, fog).intensity).cone_scale_intensity.w;
}

inline FogLightSource source_of(const PlacedLight& light, const Atmosphere& air) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const ScatteringSource source = scattering_source(light.light, air);
  return {float(std::min(source.intensity, kLargest)), float(std::min(source.soft_range, kLargest))};
}

inline float brightness_of(const PlacedLight& light, bool is_on) {
  const glm::vec4 color = expected_instance(light, is_on, 0, float(largest_flash(light.light.flash))).color;
  return std::max({color.r, color.g, color.b});
}

inline bool is_within_one_ulp(float a, float b) {
  return a >= std::nextafter(b, -1.0f) && a <= std::nextafter(b, 2.0f);  // the batch errs by 2 ulp of double
}

template <typename Entry>
bool is_same(const Entry& a, const Entry& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Whether lights have to share a kind.
inline bool are_of_one_kind(const PlacedLight& a, const PlacedLight& b) {
  return a.carried == b.carried && a.light.attenuation == b.light.attenuation &&
         a.light.threshold == b.light.threshold && a.light.density_scale == b.light.density_scale &&
         a.light.cone == b.light.cone;
}

/// A caller's copy of a table, that is brought up to date by the ranges to upload and nothing else.
template <typename Entry>
class UploadedTable {
 public:
  const std::vector<Entry>& entries() const { return entries_; }

  void upload(std::span<const Entry> table, std::span<const EntryRange> ranges) {
    Entry garbage;
    std::memset(static_cast<void*>(&garbage), 0xa5, sizeof garbage);
    entries_.resize(table.size(), garbage);
    bytes = 0;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_LT(ranges[i].begin, ranges[i].end);
      ASSERT_LE(ranges[i].end, table.size());
      if (i > 0) {
        ASSERT_GT(ranges[i].begin, ranges[i - 1].end);
      }
      const auto part = table.subspan(ranges[i].begin, ranges[i].end - ranges[i].begin);
      std::ranges::copy(part, entries_.begin() + std::ptrdiff_t(ranges[i].begin));
      bytes += part.size_bytes();
    }
    ASSERT_TRUE(std::ranges::equal(entries_, table, is_same<Entry>));
  }

  std::size_t bytes = 0;  // size of the last upload

 private:
  std::vector<Entry> entries_;
};

/// The updater's lights once more, and the buffers of a caller that uploads what set_fog tells and nothing else.
class Mirror {
 public:
  explicit Mirror(double skip_budget_255) : updater(skip_budget_255), budget_(skip_budget_255 / 255) {}

  struct Held {
    FogLightHandle handle;
    PlacedLight light;
    bool is_on = true;
  };

  void add(const PlacedLight& light) { lights.push_back({updater.add(light), light}); }

  void change(std::size_t i, const PlacedLight& light) {
    updater.change(lights[i].handle, light);
    lights[i].light = light;
  }

  void switch_light(std::size_t i, bool is_on) {
    updater.switch_light(lights[i].handle, is_on);
    lights[i].is_on = is_on;
  }

  void set_time(double seconds) {
    updater.set_time(seconds);
    seconds_ = seconds;
  }

  void remove(std::size_t i) {
    updater.remove(lights[i].handle);
    lights[i] = lights.back();
    lights.pop_back();
  }

  void set_fog(const Fog& fog) { set_atmosphere({.fog = fog}, 0); }

  void set_atmosphere(const Atmosphere& air, double eye_height) {
    const FogLightChanges changes = updater.set_atmosphere(air, eye_height);
    ASSERT_NO_FATAL_FAILURE(kinds_.upload(updater.kinds(), changes.kinds));
    ASSERT_NO_FATAL_FAILURE(instances_.upload(updater.instances(), changes.instances));
    ASSERT_NO_FATAL_FAILURE(sources_.upload(updater.sources(), changes.sources));
    ASSERT_EQ(updater.statistics().bytes_dirty, kinds_.bytes + instances_.bytes + sources_.bytes);
    ASSERT_NO_FATAL_FAILURE(check_instances());
    ASSERT_NO_FATAL_FAILURE(check_kinds(air, air.fog_at(eye_height)));
  }

  FogUpdater updater;
  std::vector<Held> lights;
  std::size_t skipped = 0;  // kinds found dark by the budget alone, in all set_fog

 private:
  void check_instances() {
    std::vector<bool> is_used(instances_.entries().size());
    for (const Held& held : lights) {
      const std::size_t at = updater.instance_of(held.handle);
      ASSERT_LT(at, is_used.size());
      ASSERT_FALSE(is_used[at]);
      is_used[at] = true;
      const float factor = float(flash_at(held.light.light.flash, seconds_));
      const FogLightInstance expected = expected_instance(held.light, held.is_on, updater.kind_of(held.handle), factor);
      ASSERT_TRUE(is_same(instances_.entries()[at], expected));
    }
    for (std::size_t i = 0; i < is_used.size(); ++i) {
      ASSERT_TRUE(is_used[i] || is_same(instances_.entries()[i], FogLightInstance{})) << "instance " << i;
    }
  }

  void check_kinds(const Atmosphere& air, const Fog& fog) {
    struct Expected {
      const PlacedLight* light = nullptr;
      float brightness = 0;  // the largest
    };
    std::vector<Expected> expected(kinds_.entries().size());
    for (const Held& held : lights) {
      const std::size_t at = updater.kind_of(held.handle);
      ASSERT_LT(at, expected.size());
      Expected& kind = expected[at];
      if (!kind.light) kind.light = &held.light;
      ASSERT_TRUE(are_of_one_kind(*kind.light, held.light));
      kind.brightness = std::max(kind.brightness, brightness_of(held.light, held.is_on));
    }
    ASSERT_TRUE(sources_.entries().empty() || sources_.entries().size() == expected.size());
    std::vector<const PlacedLight*> found;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto& [light, brightness] = expected[i];
      FogLightKind stored = kinds_.entries()[i];
      if (!sources_.entries().empty()) {
        ASSERT_EQ(sources_.entries()[i], brightness > 0 ? source_of(*light, air) : FogLightSource{}) << "kind " << i;
      }
      if (!light) {
        ASSERT_TRUE(is_same(stored, FogLightKind{})) << "kind " << i;
        continue;
      }
      for (const PlacedLight* other : found) ASSERT_FALSE(are_of_one_kind(*light, *other));
      found.push_back(light);
      const Fog seen_fog = scaled(fog, light->light.density_scale);
      const IntensityBound bound(light->light.attenuation, light->light.threshold);
      const bool is_skipped = bound.at(seen_fog) * double(brightness) < budget_;
      const bool is_dark = brightness == 0 || is_skipped;
      const float solved = is_dark ? 0 : intensity_of(*light, fog);
      ASSERT_TRUE(is_within_one_ulp(stored.cone_scale_intensity.w, solved))
          << stored.cone_scale_intensity.w << " instead of " << solved;
      if (is_skipped && light->carried && brightness > 0) ++skipped;
      stored.cone_scale_intensity.w = 0;
      ASSERT_TRUE(is_same(stored, expected_kind(*light, 0)));
    }
    ASSERT_EQ(updater.statistics().kinds_solved + updater.statistics().kinds_skipped, found.size());
  }

  double budget_;
  double seconds_ = 0;
  UploadedTable<FogLightKind> kinds_;
  UploadedTable<FogLightInstance> instances_;
  UploadedTable<FogLightSource> sources_;
};

/// A light of one of some kinds, two of their attenuations corners, with one of few colours, or of a kind of its own.
inline PlacedLight draw_light(Random& random) {
  static const std::array<Attenuation, 4> attenuations{{{1, 0.1, 0.01}, {0.5, 0, 1e-4}, {1, 0, 0}, {30, 1, 1}}};
  PlacedLight light = carried_light(random.pick(attenuations));
  if (random.chance(0.2)) light.light.attenuation = draw_ordinary_case(random, FogMode::exp).attenuation;
  light.light.threshold = random.chance(0.8) ? 0.05 : 0.01;
  light.light.density_scale = random.pick(std::array{1., 1., 0.4, 0.});
  light.light.color = glm::dvec3{random.pick(std::array{0., 0.01, 0.5, 1., 1., 30.})} * glm::dvec3{0.5, 1, 0.25};
  light.light.cone = random.pick(std::array{Cone{}, Cone::cosine(0.5, 3), Cone::smoothstep(0.5, 3)});
  if (random.chance(0.3)) light.light.flash = {2, 2, {{{random.uniform(0, 0.4), 0.5, 5}, {1, random.uniform(0.1, 1)}}}};
  light.position = {random.uniform(-100, 100), random.uniform(-100, 100), 2};
  light.carried = random.chance(0.8);
  return light;
}

inline Fog draw_fog(Random& random, const Fog& last) {
  if (random.chance(0.1)) return last;
  if (random.chance(0.1)) return {last.mode, last.density * (1 + 1e-12)};
  if (random.chance(0.1)) return {random.pick(kModes), random.pick(std::array{0., 1e-300, 1e300, kInfinity})};
  return {random.pick(kModes), random.log_uniform(1e-7, 1)};
}

/// Air of a fog, half of it with a layer and droplets.
inline Atmosphere draw_air(Random& random, const Fog& fog) {
  Atmosphere air{.fog = fog};
  if (fog.mode == FogMode::exp2 || random.chance(0.5)) return air;
  const FogLayer layer{
      .base = 0, .top = random.uniform(5, 50), .transition = 10, .visibility = random.log_uniform(10, 1e4)};
  air.profile = make_density_profile(std::span(&layer, 1));
  air.phase = random.pick(std::array{Phase{}, Phase::droplets(10)});
  return air;
}

/// Random calls; set_atmosphere is one in calls_per_fog.
inline void run_random_calls(Mirror& mirror, Random& random, int calls, double calls_per_fog, double removed_fraction) {
  Fog fog;
  for (int call = 0; call < calls; ++call) {
    if (random.chance(1 / calls_per_fog)) {
      fog = draw_fog(random, fog);
      ASSERT_NO_FATAL_FAILURE(mirror.set_atmosphere(draw_air(random, fog), random.uniform(-10, 70)));
    }
    if (random.chance(0.1)) mirror.set_time(random.uniform(0, 100));
    if (mirror.lights.empty() || random.chance(0.4)) {
      mirror.add(draw_light(random));
      continue;
    }
    const std::size_t i = std::size_t(random.uniform(0, double(mirror.lights.size())));
    if (random.chance(removed_fraction)) {
      mirror.remove(i);
    } else if (random.chance(0.5)) {
      mirror.switch_light(i, random.chance(0.5));
    } else {
      mirror.change(i, draw_light(random));
    }
  }
  ASSERT_NO_FATAL_FAILURE(mirror.set_fog(fog));
}

}  // namespace litfog::test
