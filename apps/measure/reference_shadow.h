// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "measure/reference_light.h"
#include "measure/triangle_tree.h"
#include "render/renderer.h"

namespace litfog::measure {

/// The shadows of a renderer's lamps by rays in double: without maps, so with sharp edges.
class ReferenceShadows {
 public:
  /// How far a shadow map may put the edge of a shadow beside its place, in texels of the map: three fit around the
  /// place that is compared, and a surface narrower than a texel may be missed.
  static constexpr double kEdgeTexels = 2.5;

  /// renderer  whose settings have shadows
  explicit ReferenceShadows(const render::Renderer& renderer);

  /// Whether a surface keeps a lamp's light from a position.
  bool is_dark(const ReferenceLight& light, const glm::dvec3& position) const;
  /// Whether the edge of such a shadow lies within kEdgeTexels of the position, on its surface, or what casts it is
  /// nearer to the surface than a map can tell. There a picture may have any part of the lamp's light.
  ///
  /// normal  of the surface, for positions beside every triangle; unit
  bool is_at_edge(const ReferenceLight& light, const glm::dvec3& position, const glm::dvec3& normal) const;
  /// The stretches of a ray from the eye on which a lamp's light reaches the fog: metres from the eye. What is
  /// shorter than a kStretchSteps-th of the lamp's part of the ray may be missed.
  std::vector<std::pair<double, double>> lit_stretches(const ReferenceLight& light, const EyeRay& ray) const;
  static constexpr int kStretchSteps = 1024;

 private:
  TriangleTree triangles_;
  double map_size_;  // texels a side
};

}  // namespace litfog::measure
