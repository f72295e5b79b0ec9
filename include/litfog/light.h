// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/value_error.h"

namespace litfog {

/// A kind of light: what a light file holds.
struct Light {
  std::string name;
  glm::dvec3 color{1.0};  ///< linear RGB, finite, >= 0; 1 is the display's white
  Attenuation attenuation;
  double threshold = kDefaultThreshold;  ///< (0, 1): attenuation at which the light ends
  Cone cone;
  double density_scale = 1;  ///< finite, >= 0: its class sees this share of the fog's density; 0 sees through all fog
};

/// A light in a scene. Positions are world space, metres.
struct PlacedLight {
  Light light;
  glm::dvec3 position{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit axis of the cone
  bool carried = false;  ///< by the eye's vehicle: such lights, and only they, light the fog by Hales's term
};

/// What is wrong with a light, or nothing.
std::optional<ValueError> check(const Light& light);

}  // namespace litfog
