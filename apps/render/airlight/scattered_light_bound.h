// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/airlight/higher_orders.h"
#include "render/light/scene_lights.h"
#include "scene/mesh.h"

namespace litfog::render {

/// Bounds the light that fog scatters on surfaces, of all lamps together.
class ScatteredLightBound {
 public:
  /// Bounds no light where fog scatters once.
  ScatteredLightBound() = default;
  /// orders  of the lights; not empty
  ScatteredLightBound(const SceneLights& lights, const HigherOrders& orders, double density);

  /// What a surface within a box receives at most; infinity where a lamp is within the box.
  ///
  /// Proof. A cone scatters no more than a point lamp. Of that, with F = (1 - e^-depth) I / r^2 the flow and S = F / g
  /// the sum over all directions, a surface receives at most 3 F / 4 + S / 4 (litfog_diffuse_irradiance()). F falls
  /// with the range, and g is not below its least.
  double largest_irradiance(const scene::Bounds& box) const;

 private:
  struct Lamp {
    glm::dvec3 position;
    double brightness;  // effective intensity times the colour's largest component
  };
  struct Group {
    glm::dvec3 low, high;
    double brightness;
  };

  double of_one(double range) const;  // over the brightness

  double density_ = 0;       // the largest, 1/m
  double most_of_flow_ = 0;  // what a surface receives of a point lamp's flow F
  std::vector<Lamp> lamps_;
  std::vector<Group> groups_;  // of kGroupSize lamps each, which are mostly neighbours
};

}  // namespace litfog::render
