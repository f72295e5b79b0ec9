// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "measure/reference_light.h"
#include "measure/triangle_tree.h"
#include "render/renderer.h"

namespace litfog::measure {

/// The shadows of a renderer's lamps and of its directional light by rays in double: no maps, so sharp edges.
class ReferenceShadows {
 public:
  /// How far a shadow map may move a shadow's edge, in texels: three fit around the position compared, and a surface
  /// narrower than a texel may be missed.
  static constexpr double kEdgeTexels = 2.5;

  /// renderer  its settings have shadows
  explicit ReferenceShadows(const render::Renderer& renderer);

  /// Whether a surface blocks a lamp's light to a position.
  bool is_dark(const ReferenceLight& light, const glm::dvec3& position) const;
  /// Whether a shadow's edge lies within kEdgeTexels of a position on its surface, or the caster is closer to the
  /// surface than a map resolves. There a picture may have any fraction of the lamp's light.
  ///
  /// normal  the surface's, for positions beside every triangle; unit
  bool is_at_edge(const ReferenceLight& light, const glm::dvec3& position, const glm::dvec3& normal) const;
  /// The directional light's shadow, and its edges.
  bool is_dark_to_moon(const glm::dvec3& position) const;
  bool is_at_moon_edge(const glm::dvec3& position, const glm::dvec3& normal) const;
  /// The segments of a ray from the eye on which a lamp's light reaches the fog: metres from the eye. Segments shorter
  /// than 1 / kStretchSteps of the lamp's part of the ray may be missed.
  std::vector<std::pair<double, double>> lit_stretches(const ReferenceLight& light, const EyeRay& ray) const;
  static constexpr int kStretchSteps = 1024;

 private:
  /// The comparison at a texel beside a position: a ray from the light to the plane of the surface.
  struct Probe {
    glm::dvec3 origin;
    glm::dvec3 direction;
    double first, distance;  // metres
  };
  bool is_met(const Probe& probe, double before_plane) const;
  /// probe_at  the probe at an offset from the position, in texels across the light's ray; nothing if the plane is seen
  ///           edge-on
  template <typename ProbeAt>
  bool is_at_edge(const ProbeAt& probe_at, double contact) const;
  glm::dvec3 plane_at(const Probe& probe, const glm::dvec3& normal) const;

  TriangleTree triangles_;
  glm::dvec3 to_moon_;
  std::vector<render::MoonMap> moon_maps_;
  double map_size_;  // texels along a side
};

}  // namespace litfog::measure
