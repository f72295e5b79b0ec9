// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace litfog::measure {

/// A bounding volume hierarchy of a scene's triangles for ray queries, all in double. Triangles are two-sided. Masks
/// cut them by the base texture itself, without mipmaps. Of Debian's libraries, Embree is in float, and CGAL's tree is
/// under the GPL.
class TriangleTree {
 public:
  /// scene   its materials must outlive this object
  /// origin  of all positions
  explicit TriangleTree(const scene::Scene& scene, const glm::dvec3& origin = glm::dvec3(0));

  struct Hit {
    double distance;       ///< metres along the ray
    glm::dvec3 normal;     ///< the triangle's, on either side; unit
    std::size_t material;  ///< index in the scene's; past its end if the scene has none of that name
  };
  /// The nearest triangle that a ray meets between two distances.
  ///
  /// direction    unit
  /// first, last  metres; no triangle if last < first
  std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last) const;
  /// Whether nearest() finds one.
  bool is_met(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last) const;

 private:
  using Corners = std::array<glm::dvec3, 3>;
  struct Triangle {
    Corners corners;
    std::size_t mask;  // kNoMask: none
    std::uint32_t material;
  };
  static constexpr auto kNoMask = std::size_t(-1);
  struct Mask {
    const scene::Material* material;
    std::array<glm::dvec3, 3> uv_coverage;  // u, v and the vertex's coverage at each corner
  };
  struct Crossing;
  struct Node {
    glm::dvec3 low, high;
    std::uint32_t first;  // leaf: first triangle; inner node: second child, the first one follows the node
    std::uint32_t count;  // 0: an inner node
  };

  void build(std::uint32_t first, std::uint32_t count);
  static std::optional<Crossing> crossing_of(const Corners& corners, const glm::dvec3& origin,
                                             const glm::dvec3& direction);
  /// Whether the triangle has no mask, or its mask keeps the crossing.
  bool is_kept(const Triangle& triangle, const Crossing& crossing) const;
  /// Calls found(triangle, distance) for what the ray meets. It returns the distance up to which to search on.
  template <typename Found>
  void search(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last,
              const Found& found) const;

  std::vector<Triangle> triangles_;
  std::vector<Mask> masks_;
  std::vector<Node> nodes_;
};

}  // namespace litfog::measure
