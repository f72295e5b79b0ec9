// SPDX-License-Identifier: Apache-2.0
#include "scene/model/road_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace litfog::scene {

void RoadPath::describe(ParameterList& list) {
  list.add("length_m", length_m, 10, 4000);
  list.add("bend_m", bend_m, -200, 200);
  list.add_rule([this]() -> std::optional<std::string> {
    constexpr double kMinRadius_m = 100.0;
    const double most = 0.5 * double{length_m} * double{length_m} / kMinRadius_m;
    if (std::abs(double{bend_m}) <= most * (1.0 + 1e-6)) return std::nullopt;
    return fmt::format("bend_m = {}: must be at most length_m^2 / 200 = {} in magnitude, a radius of 100 m", bend_m,
                       most);
  });
}

glm::vec3 RoadPath::point(float along, float offset) const {
  const glm::vec3 d = direction(along);
  const float t = along / length_m;
  return glm::vec3(bend_m * t * std::abs(t), 0.0f, -along) + offset * glm::vec3(-d.z, 0.0f, d.x);
}

glm::vec3 RoadPath::direction(float along) const {
  return glm::normalize(glm::vec3(2.0f * bend_m * std::abs(along) / (length_m * length_m), 0.0f, -1.0f));
}

float RoadPath::yaw(float along) const {
  const glm::vec3 d = direction(along);
  return std::atan2(-d.x, -d.z);
}

float RoadPath::offset_of(float x, float z) const {
  const glm::vec3 d = direction(-z);
  return (x - point(-z).x) * -d.z;
}

std::vector<glm::vec3> RoadPath::line(float from, float to, float step, float offset, float height) const {
  const int pieces = std::max(1, int(std::ceil((to - from) / step)));
  std::vector<glm::vec3> points;
  for (int i = 0; i <= pieces; ++i) {
    const float along = from + (to - from) * float(i) / float(pieces);
    points.push_back(point(along, offset) + glm::vec3(0.0f, height, 0.0f));
  }
  return points;
}

}  // namespace litfog::scene
