// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_groups.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace litfog::render {
namespace {

constexpr double kEqualGaps = 0.7;  // of the widest

class Grouping {
 public:
  Grouping(std::span<const PlacedLight> lights, std::span<const int> kinds) : lights_(lights) {
    found_.lights.resize(lights.size());
    std::iota(found_.lights.begin(), found_.lights.end(), 0);
    found_.parents.resize(lights.size(), -1);
    const auto key = [&](std::int32_t i) {
      const PlacedLight& placed = lights[std::size_t(i)];
      const glm::dvec3& to = placed.direction;
      const glm::dvec3& color = placed.light.color;
      return std::tuple(kinds[std::size_t(i)], to.x, to.y, to.z, color.r, color.g, color.b);
    };
    std::ranges::stable_sort(found_.lights, {}, key);
    for (std::size_t first = 0; first < lights.size();) {
      std::size_t end = first + 1;
      while (end < lights.size() && key(found_.lights[end]) == key(found_.lights[first])) ++end;
      if (kinds[std::size_t(found_.lights[first])] >= 0) group(first, end - first, -1);
      first = end;
    }
  }

  LightGroups found() && { return std::move(found_); }

 private:
  void group(std::size_t first, std::size_t count, std::int32_t parent) {
    if (count == 1) {
      found_.parents[std::size_t(found_.lights[first])] = parent;
      return;
    }
    const auto index = std::int32_t(found_.groups.size());
    found_.groups.push_back(measured(first, count, parent));
    const std::size_t half = split(std::span(found_.lights).subspan(first, count));
    group(first, half, index);
    group(first + half, count - half, index);
  }

  LightGroup measured(std::size_t first, std::size_t count, std::int32_t parent) const {
    LightGroup group{.first = std::int32_t(first),
                     .count = std::int32_t(count),
                     .parent = parent,
                     .position{},
                     .spread = 0,
                     .radius = 0};
    for (const std::int32_t i : found_.lights_of(group)) group.position += place(i) / double(count);
    for (const std::int32_t i : found_.lights_of(group)) {
      const double distance = glm::distance(place(i), group.position);
      group.spread += distance * distance / double(count);
      group.radius = std::max(group.radius, distance);
    }
    group.spread = std::sqrt(group.spread);
    return group;
  }

  /// Sorts them along their longest axis. Returns how many of them are before the gap.
  std::size_t split(std::span<std::int32_t> members) const {
    glm::dvec3 low = place(members.front());
    glm::dvec3 high = low;
    for (const std::int32_t i : members) {
      low = glm::min(low, place(i));
      high = glm::max(high, place(i));
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::ranges::stable_sort(members, {}, [&](std::int32_t i) { return place(i)[axis]; });
    const auto gap = [&](std::size_t i) { return place(members[i])[axis] - place(members[i - 1])[axis]; };
    double widest = 0;
    for (std::size_t i = 1; i < members.size(); ++i) widest = std::max(widest, gap(i));
    const std::size_t middle = members.size() / 2;
    for (std::size_t away = 0;; ++away) {
      if (middle > away && gap(middle - away) >= kEqualGaps * widest) return middle - away;
      if (middle + away < members.size() && gap(middle + away) >= kEqualGaps * widest) return middle + away;
    }
  }

  const glm::dvec3& place(std::int32_t light) const { return lights_[std::size_t(light)].position; }

  std::span<const PlacedLight> lights_;
  LightGroups found_;
};

}  // namespace

LightGroups group_lights(std::span<const PlacedLight> lights, std::span<const int> kinds) {
  return Grouping(lights, kinds).found();
}

}  // namespace litfog::render
