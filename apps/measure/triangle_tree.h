// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace litfog::measure {

/// The triangles of a scene in a tree of boxes, all in double, for rays that ask what they meet. Both sides of a
/// triangle count.
class TriangleTree {
 public:
  explicit TriangleTree(const scene::Scene& scene);

  struct Hit {
    double distance;    ///< metres along the ray
    glm::dvec3 normal;  ///< the triangle's: unit, of either side
  };
  /// The nearest triangle that a ray meets between two distances.
  ///
  /// direction    unit
  /// first, last  metres; none where last < first
  std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last) const;
  /// Whether there is one.
  bool is_met(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last) const;

 private:
  using Triangle = std::array<glm::dvec3, 3>;
  struct Node {
    glm::dvec3 low, high;
    std::uint32_t first;  // of its triangles; of an inner node, the second child: the first one follows the node
    std::uint32_t count;  // 0: an inner node
  };

  void build(std::uint32_t first, std::uint32_t count);
  /// Calls found(triangle, distance) for what the ray meets; it returns the distance up to which to go on.
  template <typename Found>
  void search(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last,
              const Found& found) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace litfog::measure
