// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/far_airlight_list.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "render/airlight/airlight_bound.h"
#include "render/light/hidden_range.h"
#include "render/plan/fog_top.h"

namespace litfog::render {

FarAirlightList list_far_airlight(const SceneLights& lights, const Atmosphere& atmosphere, const glm::dvec3& eye,
                                  double exposure, const HigherOrders& higher_orders,
                                  std::span<const std::int32_t> casters, bool beyond_extents) {
  FarAirlightList list;
  const double density = atmosphere.thickest_fog().density;
  if (!(density > 0) || std::isinf(density)) return list;
  // For lights, for what is too far away of all, and for what is too far away of some.
  list.visible_step = visible_step(exposure);
  const double budget = kFarShare / 3 * list.visible_step;
  const ScatteringBound scattering(atmosphere.phase);
  const double phase = scattering.largest_from(FarAirlightList::kPeakAngle);
  struct Candidate {
    std::int32_t light;
    bool is_single;  // beyond its extent it adds airlight
    int profile;
    int sections;  // in which it matters
    const AirlightBound* bound;
    double most;  // that it adds from somewhere on
  };
  const auto most_from = [&](const Candidate& each, double depth) {
    return (each.is_single ? phase * each.bound->beyond_extent(depth) : 0) + each.bound->higher_orders(depth);
  };
  std::vector<AirlightBound> bounds;
  bounds.reserve(lights.size());  // candidates point at them
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const double extent = lights.extents()[i];
    const bool is_single = beyond_extents && std::isfinite(extent) && (casters.empty() || casters[i] < 0);
    if (!is_single && !higher_orders.table) continue;
    const AirlightBound& bound =
        bounds.emplace_back(lights.lights()[i], extent, atmosphere, scattering, eye, higher_orders.of(i));
    Candidate& each = candidates.emplace_back(Candidate{
        std::int32_t(i), is_single, int(lights.instances()[i].axis_profile.w), FarAirlightList::kSections, &bound, 0});
    each.most = most_from(each, 0);
  }
  std::ranges::sort(candidates, {}, &Candidate::most);
  double left_out = 0;
  std::erase_if(candidates, [&](const Candidate& each) { return (left_out += each.most) <= budget; });
  if (candidates.empty()) return list;

  const auto is_enough = [&](double depth) {
    double beyond = 0;
    for (const Candidate& each : candidates) {
      if ((beyond += most_from(each, depth)) > budget) return false;
    }
    return true;
  };
  // Any depth at which it is enough will do.
  const auto depth_of = [](int step) { return kSkyDistance * std::pow(1.25, -step); };
  int enough = 0, too_near = 49;  // less than a metre
  while (too_near - enough > 1) {
    const int middle = (enough + too_near) / 2;
    (is_enough(depth_of(middle)) ? enough : too_near) = middle;
  }
  list.depth = depth_of(enough);

  double left_out_far = 0;
  const int sections = atmosphere.profile.count > 0 ? 1 : FarAirlightList::kSections;  // in layers the last may be near
  for (int section = 1; section < sections; ++section) {
    for (Candidate& each : candidates) each.most = most_from(each, list.section_begin(section));
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
    list.lights.push_back(each.is_single ? each.light : -1 - each.light);
    for (int section = 0; section < each.sections; ++section) ++list.ranges.back().counts[std::size_t(section)];
  }
  return list;
}

}  // namespace litfog::render
