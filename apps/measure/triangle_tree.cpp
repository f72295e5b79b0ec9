// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_tree.h"

#include <algorithm>
#include <limits>

namespace litfog::measure {
namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles

/// Metres along a ray to a triangle (Tomas Möller and Ben Trumbore 1997, "Fast, Minimum Storage Ray/Triangle
/// Intersection").
std::optional<double> distance_to(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& origin,
                                  const glm::dvec3& direction) {
  const glm::dvec3 e1 = triangle[1] - triangle[0];
  const glm::dvec3 e2 = triangle[2] - triangle[0];
  const glm::dvec3 p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0) return std::nullopt;  // seen edge on
  const glm::dvec3 t = origin - triangle[0];
  const double u = glm::dot(t, p) / determinant;
  const glm::dvec3 q = glm::cross(t, e1);
  const double v = glm::dot(direction, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
  return glm::dot(e2, q) / determinant;
}

/// Whether a ray is within a box somewhere between two distances.
bool meets(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& origin, const glm::dvec3& direction,
           double first, double last) {
  for (glm::length_t i = 0; i < 3; ++i) {
    if (direction[i] == 0) {
      if (origin[i] < low[i] || origin[i] > high[i]) return false;
      continue;
    }
    const double a = (low[i] - origin[i]) / direction[i];
    const double b = (high[i] - origin[i]) / direction[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last * (1 + 4 * std::numeric_limits<double>::epsilon());
}

}  // namespace

TriangleTree::TriangleTree(const scene::Scene& scene) {
  for (const scene::Instance& instance : scene.instances) {
    for (const scene::Part& part : scene.models[instance.model]) {
      const std::vector<std::uint32_t>& indices = part.mesh.indices;
      for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        Triangle& triangle = triangles_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::dvec4 position(part.mesh.vertices[indices[i + k]].position, 1);
          triangle[k] = glm::dmat4(instance.world_from_model) * position;
        }
      }
    }
  }
  if (!triangles_.empty()) build(0, std::uint32_t(triangles_.size()));
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
  const auto begin = triangles_.begin() + first;
  const auto end = begin + count;
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (auto triangle = begin; triangle != end; ++triangle) {
    for (const glm::dvec3& corner : *triangle) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  const std::size_t node = nodes_.size();
  nodes_.push_back({low, high, first, count});
  if (count <= kLeaf) return;
  const glm::dvec3 size = high - low;
  const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const Triangle& a, const Triangle& b) {
    return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
  });
  build(first, half);
  nodes_[node].count = 0;
  nodes_[node].first = std::uint32_t(nodes_.size());
  build(first + half, count - half);
}

template <typename Found>
void TriangleTree::search(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last,
                          const Found& found) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 64> open;  // 2^32 triangles make 30 levels
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Node& node = nodes_[index];
    if (!meets(node.low, node.high, origin, direction, first, last)) continue;
    if (node.count == 0) {
      open[count++] = node.first;
      open[count++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::optional<double> distance = distance_to(triangles_[i], origin, direction);
      if (distance && *distance >= first && *distance <= last) last = found(triangles_[i], *distance);
    }
  }
}

std::optional<TriangleTree::Hit> TriangleTree::nearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                                       double first, double last) const {
  std::optional<Hit> hit;
  search(origin, direction, first, last, [&](const Triangle& triangle, double distance) {
    hit = {distance, glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]))};
    return distance;
  });
  return hit;
}

bool TriangleTree::is_met(const glm::dvec3& origin, const glm::dvec3& direction, double first, double last) const {
  bool is_met = false;
  search(origin, direction, first, last, [&](const Triangle&, double) {
    is_met = true;
    return -std::numeric_limits<double>::infinity();
  });
  return is_met;
}

}  // namespace litfog::measure
