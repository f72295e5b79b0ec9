// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/path_model.h"

namespace litfog::measure {

/// The range of colours that a path with light maps may give a surface. A look-up is between the light's values at the
/// texels around it, so the colour is between two that the formulas give for a light slightly nearer or farther, and
/// slightly nearer to its axis or farther from it.
class LookupBounds {
 public:
  /// model  of a path with light maps; has to outlive this
  LookupBounds(const PathModel& model, const render::PaperSettings& settings)
      : model_(model), cone_maps_(settings.cone_maps), texel_(2.0 / (settings.map_size - 1)) {}

  struct Interval {
    glm::dvec3 least;
    glm::dvec3 most;
  };
  /// The light that a surface sends to the eye, before fog.
  Interval surface_color(const SurfacePoint& point) const;
  /// The colour of the fog before a position, by a path whose maps light it (LightingPath::has_mapped_fog).
  Interval fog_color(const glm::dvec3& position) const;

 private:
  struct Fractions {
    double least;
    double most;
  };
  Fractions emitted(const ReferenceLight& light, const glm::dvec3& direction) const;

  const PathModel& model_;
  render::ConeMaps cone_maps_;
  double texel_;  // size in a map's coordinates, which run from -1 to 1
};

}  // namespace litfog::measure
