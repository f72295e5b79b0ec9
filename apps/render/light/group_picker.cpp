// SPDX-License-Identifier: Apache-2.0
#include "render/light/group_picker.h"

#include <limits>

#include "render/light/hidden_range.h"

namespace litfog::render {
namespace {

constexpr double kMostGroupError = 0.25;  // of a step of the display, about, for each light of a group
constexpr double kMostSteps = 4;          // steps that each may make: a surface may turn away from some of them
constexpr double kGrazing = 25;           // 1 / (4 cos^2) of an incidence of 84 degrees

/// The largest second derivative of a cone by the angle.
double bend_of(const Cone& cone) {
  switch (cone.profile) {
    case ConeProfile::cosine:
      return cone.exponent;
    case ConeProfile::smoothstep:
      return 6 / ((cone.outer - cone.inner) * (cone.outer - cone.inner));
    case ConeProfile::none:
      break;
  }
  return 0;
}

}  // namespace

double group_error(const LightGroup& group, const Cone& cone, const Fog& fog, double shininess, double range) {
  if (range < 2 * group.radius) return std::numeric_limits<double>::infinity();
  if (group.spread == 0) return 0;
  const double x = fog.density * range;
  const double fog_bend = fog.mode == FogMode::exp ? x * x : 4 * x * x * x * x;
  const double bend = 6 + fog_bend + bend_of(cone) + kGrazing * shininess;
  return 0.5 * bend * (group.spread / range) * (group.spread / range);
}

void GroupPicker::pick(std::vector<std::int32_t>& list, std::size_t first, const GroupedSurface& surface,
                       const Fog& fog, double step) {
  const LightGroups& groups = lights_.groups();
  ++list_number_;
  std::size_t end = first;
  for (std::size_t i = first; i < list.size(); ++i) {
    std::int32_t largest = -1;
    // To the top, though a group may be too near: all its lights have to find the same.
    for (std::int32_t group = groups.parents[std::size_t(list[i])]; group >= 0;
         group = groups.groups[std::size_t(group)].parent) {
      if (!use(group, surface, fog, step).is_near) largest = group;
    }
    if (largest < 0) {
      list[end++] = list[i];
      continue;
    }
    bool& is_listed = uses_[std::size_t(largest)].is_listed;
    if (!is_listed) list[end++] = std::int32_t(lights_.size()) + largest;
    is_listed = true;
  }
  list.resize(end);
}

GroupPicker::Use& GroupPicker::use(std::int32_t index, const GroupedSurface& surface, const Fog& fog, double step) {
  Use& use = uses_[std::size_t(index)];
  if (use.list == list_number_) return use;
  const LightGroup& group = lights_.groups().groups[std::size_t(index)];
  const Light& one = lights_.lights()[std::size_t(lights_.groups().lights_of(group).front())].light;
  const auto radius = float(group.radius);
  const scene::Bounds around{surface.bounds.low - radius, surface.bounds.high + radius};
  const double brightness = surface.reflectance * largest_component(one.color) * surface.through *
                            largest_irradiance(one, group.position, std::numeric_limits<double>::infinity(), fog,
                                               FogLighting::airlight, path_, around);
  const double error = group_error(group, one.cone, scaled(fog, one.density_scale), surface.shininess,
                                   nearest_distance(group.position, surface.bounds));
  const bool is_far = brightness <= kMostSteps * step && brightness * error <= kMostGroupError * step;
  use = {.list = list_number_, .is_near = !is_far};
  return use;
}

}  // namespace litfog::render
