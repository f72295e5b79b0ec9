// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "litfog/light_clusters.h"

namespace litfog {

/// Largest number of columns, rows or slices: one bit each in an integer.
inline constexpr std::size_t kMaxParts = 64;
/// Room for the planes around all parts, and for whole vectors from any of these planes.
using PlaneColumn = std::array<float, 2 * kMaxParts + 1>;

/// The bounds of lights as floats, for the tests, one column per parameter.
struct LightColumns {
  // Positions are sums of two floats, so that distances from the eye are as exact far from the origin as near it.
  std::vector<float> x, y, z;
  std::vector<float> x_rest, y_rest, z_rest;
  std::vector<float> axis_x, axis_y, axis_z;
  std::vector<float> range;
  std::vector<float> cos_half_angle, sin_half_angle;

  std::size_t size = 0;
  void resize(std::size_t count);
  void set(std::size_t light, const LightBounds& bounds);
  /// set() without the sines, for a change of the range only.
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

/// A view and its clusters, as floats for the tests of lights.
struct ClusterPlanes {
  ClusterPlanes(const ClusterGrid& grid, const View& view);

  float eye[3];
  float eye_rest[3];  ///< as in LightColumns
  float right[3];
  float up[3];
  float forward[3];
  float farthest_corner;  ///< distance from the eye
  EdgePlanes columns;
  EdgePlanes rows;
  std::uint32_t slices;
  PlaneColumn depths{};  ///< slice i lies between depths i and i + 1
};

/// Depth at which a slice begins and the one before ends, for slices 0 to grid.slices.
double slice_depth(const ClusterGrid& grid, const View& view, std::uint32_t slice);

/// The clusters in a row that a light is in: bit i of `columns` is column i.
struct ClusterRun {
  std::uint32_t light;
  std::uint32_t row;  ///< slice * rows + row
  std::uint64_t columns;

  friend bool operator==(const ClusterRun&, const ClusterRun&) = default;
};

/// Number of lights that are tested together.
inline constexpr std::size_t kLightBlock = 64;

/// Appends the runs of the lights [begin, begin + kLightBlock), in their order.
///
/// returns  number of lights in any cluster
std::size_t append_cluster_runs(const ClusterPlanes& planes, const LightColumns& lights, std::size_t begin,
                                std::vector<ClusterRun>& runs);

}  // namespace litfog
