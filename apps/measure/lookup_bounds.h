// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/model.h"

namespace litfog::measure {

/// What the light maps of a path leave open: a look-up lies between the light's values at the texels around it, so a
/// surface's colour lies between two that the formulas give for a light slightly nearer or farther, and slightly more
/// or less on its axis.
class LookupBounds {
 public:
  /// model     of a path with light maps; has to outlive this
  /// map_size  texels a side of its maps
  LookupBounds(const Model& model, int map_size) : model_(model), texel_(2.0 / (map_size - 1)) {}

  struct Interval {
    glm::dvec3 least;
    glm::dvec3 most;
  };
  /// What a surface sends to the eye, before fog.
  Interval surface_color(const SurfacePoint& point) const;

 private:
  struct Fractions {
    double least;
    double most;
  };
  Fractions emitted(const ReferenceLight& light, const glm::dvec3& direction) const;

  const Model& model_;
  double texel_;  // of a map's coordinates, which run from -1 to 1
};

}  // namespace litfog::measure
