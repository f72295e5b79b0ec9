// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "litfog/light_clusters.h"

namespace litfog {

/// Most columns, rows or slices: their bits fit an integer.
inline constexpr std::size_t kMaxParts = 64;
/// Room for the planes around them, and for whole vectors from any of these.
using PlaneColumn = std::array<float, 2 * kMaxParts + 1>;

/// The bounds of lights as the floats that they are tested in, a column a parameter.
struct LightColumns {
  // Positions as the sums of two floats: a float's distance from the eye is then as good far from the origin as near.
  std::vector<float> x, y, z;
  std::vector<float> x_rest, y_rest, z_rest;
  std::vector<float> axis_x, axis_y, axis_z;
  std::vector<float> range;
  std::vector<float> cos_half_angle, sin_half_angle;

  std::size_t size = 0;
  void resize(std::size_t count);
  void set(std::size_t light, const LightBounds& bounds);
  /// set() where only the range has changed, without its sines.
  void set_range(std::size_t light, double metres);
};

/// The planes that bound columns (x) or rows (y) of clusters, all through the eye: plane i bounds part i from below and
/// part i - 1 from above.
struct EdgePlanes {
  EdgePlanes(std::uint32_t parts, double low, double high);

  std::uint32_t parts;
  PlaneColumn tangent{};
  // The unit normal towards larger x or y: its component along x or y, and along the depth.
  PlaneColumn across{};
  PlaneColumn along{};
};

/// A view and its clusters as lights are tested against them.
struct ClusterPlanes {
  ClusterPlanes(const ClusterGrid& grid, const View& view);

  float eye[3];
  float eye_rest[3];  ///< as in LightColumns
  float right[3];
  float up[3];
  float forward[3];
  float farthest_corner;  ///< its distance from the eye
  EdgePlanes columns;
  EdgePlanes rows;
  std::uint32_t slices;
  PlaneColumn depths{};  ///< slice i lies between depths i and i + 1
};

/// Depth at which a slice begins and the one before ends, 0 to grid.slices.
double slice_depth(const ClusterGrid& grid, const View& view, std::uint32_t slice);

/// Clusters of a row that a light is in: bit i of `columns` is the cluster's column.
struct ClusterRun {
  std::uint32_t light;
  std::uint32_t row;  ///< slice * rows + row
  std::uint64_t columns;

  friend bool operator==(const ClusterRun&, const ClusterRun&) = default;
};

/// How many lights are tested together.
inline constexpr std::size_t kLightBlock = 64;

/// Appends the runs of the lights [begin, begin + kLightBlock), in their order.
///
/// returns  how many of them are in any cluster
std::size_t append_cluster_runs(const ClusterPlanes& planes, const LightColumns& lights, std::size_t begin,
                                std::vector<ClusterRun>& runs);

}  // namespace litfog
