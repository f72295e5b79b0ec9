// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/scattered_light_bound.h"

#include <algorithm>

#include "render/light/light_threshold.h"

namespace litfog::render {
namespace {

constexpr std::size_t kGroupSize = 16;

}  // namespace

ScatteredLightBound::ScatteredLightBound(const SceneLights& lights, const HigherOrders& orders, double density) {
  for (const auto& row : orders.beams[HigherOrders::kPointBeam].texels) {
    most_of_flow_ = std::max(most_of_flow_, 0.75 + 0.25 / double(row[0].forward));
  }
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    density_ = std::max(density_, density * light.light.density_scale);
    const Lamp lamp{light.position, double(orders.sources[i].x) * largest_component(light.light.color)};
    lamps_.push_back(lamp);
    if (i % kGroupSize == 0) groups_.push_back({lamp.position, lamp.position, 0});
    Group& group = groups_.back();
    group = {glm::min(group.low, lamp.position), glm::max(group.high, lamp.position),
             group.brightness + lamp.brightness};
  }
}

double ScatteredLightBound::of_one(double range) const { return most_of_flow_ * std::min(density_, 1 / range) / range; }

double ScatteredLightBound::largest_irradiance(const scene::Bounds& box) const {
  const glm::dvec3 low = box.low, high = box.high;
  double sum = 0;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const double range = glm::length(glm::max(glm::max(low - group.high, group.low - high), 0.0));
    if (range > glm::distance(group.low, group.high)) {
      sum += group.brightness * of_one(range);
      continue;
    }
    const std::size_t end = std::min((i + 1) * kGroupSize, lamps_.size());
    for (std::size_t k = i * kGroupSize; k < end; ++k) {
      if (lamps_[k].brightness > 0) {
        sum += lamps_[k].brightness * of_one(scene::nearest_distance(lamps_[k].position, box));
      }
    }
  }
  return sum;
}

}  // namespace litfog::render
