// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_list.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "litfog/cone.h"
#include "render/airlight/airlight_bound.h"
#include "render/light/hidden_range.h"

namespace litfog::render {
namespace {

constexpr double kMaxError = 0.0005;  // of the display: an eighth of a step
constexpr double kSafety = 4;         // for airlight that bends more than k / h
// The fourth derivative of what a grid keeps of a beam, k / h (1 - (1 - t^2)^4 (1 + 4 t^2)), is 23 times as large as of
// others (kept_fraction() in airlight_light.glsl).
constexpr double kBeamBend = 1.9;  // 23^(1/5)

/// A beam as the eye sees it.
struct SeenBeam {
  double angle;      // half of it, on the picture: radians, at most a right angle
  double narrowing;  // of the width in which its airlight falls off: at most 1, less for a beam along the line of sight
};

/// to_eye  unit, from the light
SeenBeam see_beam(const PlacedLight& placed, const glm::dvec3& to_eye) {
  const Cone& cone = placed.light.cone;
  if (cone.is_point_light()) return {0.5 * std::numbers::pi, 1};
  const double half_angle = std::min(dim_angle(cone), 0.25 * std::numbers::pi);
  const double sine = glm::length(glm::cross(to_eye, placed.direction));
  return {std::asin(std::min(std::sin(half_angle) / std::max(sine, 1e-6), 1.0)),
          std::min(std::max(std::tan(half_angle), sine), 1.0)};
}

/// Slope of sRGB (IEC 61966-2-1), as a display shows it, at a linear value before exposure.
double display_slope(double value, double gain) {
  return gain * std::min(12.92, 0.4396 * std::pow(gain * value, 1 / 2.4 - 1));
}

/// How much more fog bends what a grid keeps of k / h at a distance h than clear air, where the range of
/// kept_fraction() (airlight_light.glsl) is x = d range: it is most at the light, where the grid keeps 35/16 k / range
/// and the fourth derivative of e^(-x) is 1, that of e^(-x^2) 12. Farther away, fog dims more than it bends.
double bend_by_fog(FogMode mode, double x) {
  return std::max(1.0, (mode == FogMode::exp ? 1 : 12) * 35 / 16.0 / 81 * std::pow(x, 4));
}

/// Range from a light where grids of all pixels may miss kMaxError of its airlight, about k / h at a distance h.
///
/// What a grid keeps of k / h has a fourth derivative of at most 81 k / range^5 (airlight_light.glsl), or bend_by_fog()
/// times that. Of that by the fourth power of the texels' distance, a cubic through four misses 3/128, and the
/// polynomial through six (airlight_fill.frag) half as much.
///
/// k_at  k at a distance
/// gain  of the exposure
double find_bend_range(const std::function<double(double)>& k_at, const Fog& fog, double pixel, double gain) {
  constexpr double kMissed = kSafety * 81 * 3 / 256;
  const double step = kCoarsestGrid * pixel;  // where d range matters most
  double range = step;
  for (int i = 0; i < 16; ++i) {
    const double k = k_at(range);
    const double missed = kMissed * k * std::pow(step, 4) * bend_by_fog(fog.mode, fog.density * range) *
                          display_slope(k / range, gain);
    range = std::pow(missed / kMaxError, 0.2);
  }
  return range / std::pow(double(kCoarsestGrid), 0.8);
}

}  // namespace

AirlightList list_airlight(const SceneLights& lights, const Atmosphere& atmosphere, const glm::dvec3& eye,
                           double pixels_per_radian, double exposure, const HigherOrders& higher_orders,
                           std::span<const std::int32_t> casters, bool beyond_extents) {
  if (lights.size() == 0 || !(atmosphere.thickest_fog().density > 0)) return {};
  const double budget = kAirlightShare * visible_step(exposure) / double(lights.size());
  const double gain = std::exp2(exposure);
  struct Found {
    AirlightKind kind;
    AirlightEntry entry;
    LightBounds bounds;
  };
  std::vector<Found> found;
  AirlightList list;
  const ScatteringBound scattering(atmosphere.phase);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& placed = lights.lights()[i];
    const double eye_range = std::max(glm::distance(eye, placed.position), 1e-6);
    const AirlightBound bound(placed, lights.extents()[i], atmosphere, scattering, eye, higher_orders.of(i));
    const bool has_shafts = !casters.empty() && casters[i] >= 0;
    const double far_peak_reach = beyond_extents && !has_shafts ? bound.far_peak_reach(budget) : 0;
    const double pixel = eye_range / pixels_per_radian;
    const SeenBeam beam = see_beam(placed, (eye - placed.position) / eye_range);
    const auto add = [&](const AirlightKind& kind, double reach) {
      if (!(reach > 0)) return;
      // A peak neither follows the cone nor falls off faster in fog, for that absorbs no light.
      const bool is_peak = kind.has_higher_orders;
      const auto k_at = [&](double range) {
        return is_peak ? bound.higher_orders_k(range) : beam.narrowing * bound.k(range);
      };
      const Fog fog{atmosphere.fog.mode, is_peak ? 0 : bound.density()};
      const double bend_range = std::min(find_bend_range(k_at, fog, pixel, gain), reach);
      const double most_bend_range = eye_range / 2;
      // Across its apex, a beam's airlight jumps, unless it is seen along its axis. Up to a range a thin one is thinner
      // than a few texels of a grid, too. Grids keep next to nothing of it there.
      const bool is_beam = !is_peak && beam.angle < 0.5 * std::numbers::pi;
      const double beam_range =
          is_beam ? std::max(4 * pixel / std::tan(beam.angle), std::min(kBeamBend * bend_range, most_bend_range)) : 0;
      found.push_back({kind,
                       {.light = float(i),
                        .reach = float(reach),
                        .bend_range = float(is_beam ? std::min(beam_range, AirlightBound::kFarthestReach)
                                                    : std::min(bend_range, most_bend_range)),
                        .width = float(is_beam ? 0 : beam.narrowing * bound.flat_range())},
                       is_peak || lights.cookie(i) ? LightBounds{.position = placed.position, .range = reach}
                                                   : bounds_of(placed, reach)});
    };
    const double reach = std::max(bound.reach(budget), far_peak_reach);
    const double peak_reach = bound.higher_orders_reach(budget);
    const auto profile = int(lights.instances()[i].axis_profile.w);
    add({.profile = profile,
         .has_shafts = has_shafts,
         .has_knee = (placed.light.attenuation.constant < 1),
         .has_far_peak = (far_peak_reach > 0)},
        reach);
    add({.has_higher_orders = true, .profile = std::min(profile, 1)}, peak_reach);
    list.light_count += reach > 0 || peak_reach > 0;
  }
  std::ranges::stable_sort(found, {}, &Found::kind);
  for (const auto& [kind, entry, bounds] : found) {
    if (list.ranges.empty() || list.ranges.back().kind != kind) {
      list.ranges.push_back({.kind = kind, .first = unsigned(list.entries.size()), .count = 0});
    }
    list.entries.push_back(entry);
    list.bounds.push_back(bounds);
    ++list.ranges.back().count;
  }
  return list;
}

}  // namespace litfog::render
