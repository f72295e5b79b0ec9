// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/far_airlight_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "litfog/attenuation.h"
#include "render/light/hidden_range.h"
#include "render/plan/fog_top.h"

namespace litfog::render {
namespace {

/// What a light adds to a ray beyond its extent, at most.
class FarBound {
 public:
  FarBound(const PlacedLight& placed, double extent, const Fog& fog, double largest_phase, const glm::dvec3& eye)
      : light_(&placed.light),
        extent_(extent),
        fog_(scaled(fog, placed.light.density_scale)),
        brightness_(largest_phase * largest_component(placed.light.color)),
        eye_range_(glm::distance(eye, placed.position)) {}

  /// From a distance from the eye on.
  double from(double distance) const {
    const double range = std::max(extent_, distance - eye_range_);
    const double beyond =
        attenuation_at(light_->attenuation, range) * fog_factor_at(fog_, range) * fog_factor_at(fog_, distance);
    if (!(light_->attenuation.quadratic > 0)) return brightness_ * beyond;
    const double both_legs =
        fog_.mode == FogMode::exp ? distance + range : std::sqrt(3 * (distance * distance / 2 + range * range));
    const double weight = largest_fog_weight(fog_, std::max(eye_range_, both_legs));
    return brightness_ * std::min(beyond, weight * std::numbers::pi / (light_->attenuation.quadratic * range));
  }

 private:
  const Light* light_;
  double extent_;
  Fog fog_;
  double brightness_;
  double eye_range_;
};

}  // namespace

FarAirlightList list_far_airlight(const SceneLights& lights, const Fog& fog, const Scattering& scattering,
                                  const glm::dvec3& eye, double exposure, std::span<const std::int32_t> casters) {
  FarAirlightList list;
  if (!(fog.density > 0) || std::isinf(fog.density)) return list;
  // For lights, for what is too far away of all, and for what is too far away of some.
  const double budget = kFarShare / 3 * visible_step(exposure);
  struct Candidate {
    std::int32_t light;
    int profile;
    int sections;  // in which it matters
    FarBound bound;
    double most;  // that it adds from somewhere on
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const double extent = lights.extents()[i];
    if (std::isinf(extent) || (!casters.empty() && casters[i] >= 0)) continue;
    const FarBound bound(lights.lights()[i], extent, fog, largest_phase(scattering), eye);
    candidates.push_back(
        {std::int32_t(i), int(lights.instances()[i].axis_profile.w), FarAirlightList::kSections, bound, bound.from(0)});
  }
  std::ranges::sort(candidates, {}, &Candidate::most);
  double left_out = 0;
  std::erase_if(candidates, [&](const Candidate& each) { return (left_out += each.most) <= budget; });
  if (candidates.empty()) return list;

  const auto is_enough = [&](double depth) {
    double beyond = 0;
    for (const Candidate& each : candidates) {
      if ((beyond += each.bound.from(depth)) > budget) return false;
    }
    return true;
  };
  // A bisection, since what is left out falls with the depth.
  const auto depth_of = [](int step) { return kSkyDistance * std::pow(1.25, -step); };
  int enough = 0, too_near = 49;  // less than a metre
  while (too_near - enough > 1) {
    const int middle = (enough + too_near) / 2;
    (is_enough(depth_of(middle)) ? enough : too_near) = middle;
  }
  list.depth = depth_of(enough);

  double left_out_far = 0;
  for (int section = 1; section < FarAirlightList::kSections; ++section) {
    for (Candidate& each : candidates) each.most = each.bound.from(list.section_begin(section));
    std::ranges::sort(candidates, {}, &Candidate::most);
    for (Candidate& each : candidates) {
      if (each.sections < section) continue;
      if (left_out_far + each.most > budget) break;
      left_out_far += each.most;
      each.sections = section;
    }
  }

  std::ranges::sort(candidates, {},
                    [](const Candidate& each) { return std::tuple(each.profile, -each.sections, each.light); });
  for (const Candidate& each : candidates) {
    if (list.ranges.empty() || list.ranges.back().profile != each.profile) {
      list.ranges.push_back({.profile = each.profile, .first = int(list.lights.size()), .counts = {}});
    }
    list.lights.push_back(each.light);
    for (int section = 0; section < each.sections; ++section) ++list.ranges.back().counts[std::size_t(section)];
  }
  return list;
}

}  // namespace litfog::render
