// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace litfog::measure {
namespace {

constexpr std::uint32_t kLeaf = 4;  // most triangles in a leaf

/// Wraps a texel's index into [0, size).
int wrapped(int i, int size, scene::Sampling::Wrap wrap) {
  switch (wrap) {
    case scene::Sampling::Wrap::repeat:
      return (i % size + size) % size;
    case scene::Sampling::Wrap::mirror: {
      const int turned = (i % (2 * size) + 2 * size) % (2 * size);
      return turned < size ? turned : 2 * size - 1 - turned;
    }
    default:
      return std::clamp(i, 0, size - 1);
  }
}

/// A picture's alpha, with OpenGL's magnification filter (OpenGL 3.3, 3.8.11).
double alpha_at(const scene::Texels& texels, const glm::dvec2& uv) {
  const auto alpha = [&](int x, int y) {
    x = wrapped(x, texels.width, texels.sampling.wrap_u);
    y = wrapped(y, texels.height, texels.sampling.wrap_v);
    return texels.rgba[4 * (std::size_t(y) * std::size_t(texels.width) + std::size_t(x)) + 3] / 255.0;
  };
  const glm::dvec2 texel = uv * glm::dvec2(texels.width, texels.height);
  if (texels.sampling.magnified == scene::Sampling::Filter::nearest) {
    return alpha(int(std::floor(texel.x)), int(std::floor(texel.y)));
  }
  const glm::dvec2 low = glm::floor(texel - 0.5);
  const glm::dvec2 part = texel - 0.5 - low;
  const int x = int(low.x);
  const int y = int(low.y);
  return std::lerp(std::lerp(alpha(x, y), alpha(x + 1, y), part.x),
                   std::lerp(alpha(x, y + 1), alpha(x + 1, y + 1), part.x), part.y);
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

/// The point where a ray crosses a triangle.
struct TriangleTree::Crossing {
  double distance;  // metres along the ray
  double u, v;      // barycentric coordinates: weights of the second and of the third corner
};

/// Tomas Möller and Ben Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
std::optional<TriangleTree::Crossing> TriangleTree::crossing_of(const Corners& corners, const glm::dvec3& origin,
                                                                const glm::dvec3& direction) {
  const glm::dvec3 e1 = corners[1] - corners[0];
  const glm::dvec3 e2 = corners[2] - corners[0];
  const glm::dvec3 p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0) return std::nullopt;  // edge-on
  const glm::dvec3 t = origin - corners[0];
  const double u = glm::dot(t, p) / determinant;
  const glm::dvec3 q = glm::cross(t, e1);
  const double v = glm::dot(direction, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
  return Crossing{glm::dot(e2, q) / determinant, u, v};
}

bool TriangleTree::is_kept(const Triangle& triangle, const Crossing& crossing) const {
  if (triangle.mask == kNoMask) return true;
  const Mask& mask = masks_[triangle.mask];
  const std::array<glm::dvec3, 3>& at = mask.uv_coverage;
  const glm::dvec3 uv_coverage = at[0] + (at[1] - at[0]) * crossing.u + (at[2] - at[0]) * crossing.v;
  const scene::Material& material = *mask.material;
  const double alpha =
      material.plain_albedo ? 1 : alpha_at(*material.albedo, glm::dvec2(uv_coverage) / double(material.size_m));
  return alpha * uv_coverage.z >= double(*material.least_coverage);
}

TriangleTree::TriangleTree(const scene::Scene& scene, const glm::dvec3& origin) {
  for (const scene::Instance& instance : scene.instances) {
    const glm::dmat4 world_from_model = placed_relative_to(origin, instance);
    for (const scene::Part& part : scene.models[instance.model]) {
      const auto material = std::ranges::find(scene.materials, part.material, &scene::Material::name);
      const bool is_masked = material != scene.materials.end() && material->least_coverage;
      const std::vector<std::uint32_t>& indices = part.mesh.indices;
      for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        Triangle& triangle = triangles_.emplace_back(
            Triangle{{}, is_masked ? masks_.size() : kNoMask, std::uint32_t(material - scene.materials.begin())});
        if (is_masked) masks_.push_back({&*material, {}});
        for (std::size_t k = 0; k < 3; ++k) {
          const scene::Vertex& vertex = part.mesh.vertices[indices[i + k]];
          triangle.corners[k] = world_from_model * glm::dvec4(vertex.position, 1);
          if (is_masked) {
            masks_.back().uv_coverage[k] = glm::dvec3(vertex.uv, detail_of(part.mesh, indices[i + k]).color.a);
          }
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
    for (const glm::dvec3& corner : triangle->corners) {
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
    return a.corners[0][axis] + a.corners[1][axis] + a.corners[2][axis] <
           b.corners[0][axis] + b.corners[1][axis] + b.corners[2][axis];
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
      const std::optional<Crossing> crossing = crossing_of(triangles_[i].corners, origin, direction);
      const bool is_between = crossing && crossing->distance >= first && crossing->distance <= last;
      if (is_between && is_kept(triangles_[i], *crossing)) last = found(triangles_[i], crossing->distance);
    }
  }
}

std::optional<TriangleTree::Hit> TriangleTree::nearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                                       double first, double last) const {
  std::optional<Hit> hit;
  search(origin, direction, first, last, [&](const Triangle& triangle, double distance) {
    const auto& [a, b, c] = triangle.corners;
    hit = {distance, glm::normalize(glm::cross(b - a, c - a)), triangle.material};
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
