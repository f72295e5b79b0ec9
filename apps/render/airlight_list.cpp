// SPDX-License-Identifier: Apache-2.0
#include "render/airlight_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "litfog/attenuation.h"
#include "litfog/cone.h"

namespace litfog::render {
namespace {

constexpr double kMostBend = 1 / 1000.0;  // of linear values: a quarter of a step of the display where it is brightest
constexpr double kFarthestReach = 1e9;    // metres, for lights without an end: floats hold its square
constexpr double kThinBeam = 0.17;        // radians: half the angle of a beam that grids may miss

/// Range at which the attenuation's denominator has a value; 0 where it is above it everywhere.
double level_range(const Attenuation& attenuation, double denominator) {
  return denominator > 1 ? compute_extent(attenuation, 1 / denominator) : 0;
}

/// Half angle at which a beam has half its brightness or less: radians, at most a right angle's half.
double beam_angle(const Cone& cone) {
  constexpr double kWide = 0.25 * std::numbers::pi;
  if (cone.profile == ConeProfile::none) return kWide;
  const double angle =
      cone.profile == ConeProfile::smoothstep ? cone.outer : std::acos(std::exp2(-1 / std::max(cone.exponent, 1e-3)));
  return std::min({angle, cutoff_angle(cone), kWide});
}

/// Bounds of what the fog shows of a light. litfog/shaders/glow.glsl has the proofs.
class GlowBound {
 public:
  /// eye_range   metres from the eye to the light
  /// brightness  of the largest component of its colour, in the direction in which the fog scatters most
  GlowBound(const Light& light, double extent, const Fog& fog, double eye_range, double brightness)
      : attenuation_(light.attenuation), extent_(extent), brightness_(brightness) {
    density_ = std::min(fog.density * light.density_scale, 1e6);
    const double x = std::min(density_ * eye_range, 80.0);
    weight_ = density_ * (fog.mode == FogMode::exp ? std::exp(-x) : 1.2131 * std::exp(-std::min(x * x / 3, 80.0)));
  }

  /// Range beyond which it is below a budget; 0 where it is so everywhere.
  double reach(double budget) const {
    const double share = budget / brightness_;
    const double integral = share / std::max(weight_, 1e-300);  // that of the attenuation may not exceed
    double denominator = std::min(1 / share, 2 * extent_ / integral);
    if (attenuation_.quadratic > 0) {
      denominator = std::min(denominator, 16 / (attenuation_.quadratic * integral * integral));
    }
    if (!(denominator > std::max(attenuation_.constant, 1.0))) return 0;
    return std::min({level_range(attenuation_, denominator), extent_, kFarthestReach});
  }

  /// Metres: the falloff's.
  double width() const { return level_range(attenuation_, 2 * std::max(attenuation_.constant, 1.0)); }

  /// Metres within which it is flat: the falloff's width, or less in dense fog.
  double flat_range() const { return std::min(width(), 0.5 / density_); }

  /// k, where at a distance h it is about k / h. Metres.
  double k() const {
    const double slope = std::max(attenuation_.quadratic, attenuation_.linear / std::max(width(), 1e-3));
    return brightness_ * weight_ * 4 / std::max(slope, 1e-30);
  }

 private:
  Attenuation attenuation_;
  double extent_;
  double brightness_;
  double density_;
  double weight_;
};

}  // namespace

AirlightList list_airlight(const SceneLights& lights, const Fog& fog, const Scattering& scattering,
                           const glm::dvec3& eye, double pixels_per_radian, double budget,
                           std::span<const std::int32_t> casters) {
  struct Found {
    std::pair<int, bool> kind;  // profile, has_shafts
    AirlightEntry entry;
  };
  std::vector<Found> found;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& placed = lights.lights()[i];
    const glm::dvec3& color = placed.light.color;
    const double brightness = largest_phase(scattering) * std::max({color.r, color.g, color.b});
    if (!(brightness > 0)) continue;
    const double eye_range = std::max(glm::distance(eye, placed.position), 1e-6);
    const GlowBound bound(placed.light, lights.extents()[i], fog, eye_range, brightness);
    const double reach = bound.reach(budget);
    if (!(reach > 0)) continue;
    // At h pixels from the light (k / h)'' = 2 k / h^3. With the light's middle cut out, as airlight.frag does it, three
    // times that is where it bends most; an eighth of it is missed.
    const double pixel = eye_range / pixels_per_radian;
    const double bend_range = std::cbrt(0.75 * bound.k() / pixel / kMostBend) * pixel;
    // Up to this range a thin beam is thinner than a few texels of a grid.
    const double angle = beam_angle(placed.light.cone);
    const double thin_range = angle < kThinBeam ? 4 * pixel / std::tan(angle) : 0;
    found.push_back({{int(lights.instances()[i].axis_profile.w), !casters.empty() && casters[i] >= 0},
                     {.light = float(i),
                      .reach = float(reach),
                      .bend_range = float(std::min(std::max(bend_range, thin_range), eye_range / 2)),
                      .width = float(thin_range > bend_range ? 0 : bound.flat_range())}});
  }
  std::ranges::stable_sort(found, {}, &Found::kind);
  AirlightList list;
  for (const auto& [kind, entry] : found) {
    if (list.entries.empty() || std::pair(list.ranges.back().profile, list.ranges.back().has_shafts) != kind) {
      list.ranges.push_back(
          {.profile = kind.first, .has_shafts = kind.second, .first = unsigned(list.entries.size()), .count = 0});
    }
    list.entries.push_back(entry);
    ++list.ranges.back().count;
  }
  return list;
}

}  // namespace litfog::render
