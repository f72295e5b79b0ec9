// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "litfog/light_bounds.h"
#include "litfog/value_error.h"
#include "litfog/view_frustum.h"

namespace litfog {

/// Smallest depth of a grid's first slice, metres: floats can hold squares of distances in a view of this size.
inline constexpr double kMinFirstDepth = 1e-12;

/// How a view is divided into clusters: columns and rows of equal size in the picture, and slices in depth. The first
/// slice begins at the view's nearest depth; the others grow in proportion to depth, from first_depth to the farthest.
struct ClusterGrid {
  std::uint32_t columns = 16;  ///< [1, 64]
  std::uint32_t rows = 9;      ///< [1, 64]
  std::uint32_t slices = 24;   ///< [1, 64]
  double first_depth = 5;      ///< metres, [kMinFirstDepth, farthest); above the nearest depth with two slices or more
};

/// What is wrong with a grid, or nothing.
std::optional<ValueError> find_error(const ClusterGrid& grid);

/// The lights of a cluster: `count` entries of the light list from `first` on, laid out as in a shader's buffer.
struct Cluster {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const Cluster&, const Cluster&) = default;
};

/// How a shader finds the cluster of a fragment, as litfog/shaders/light_clusters.glsl does:
///   column = floor(columns * x), row = floor(rows * y), with x and y from 0 to 1 over the picture, y up
///   slice = clamp(floor(slice_scale * log2(depth) + slice_bias), 0, slices - 1)
///   cluster = (slice * rows + row) * columns + column
struct ClusterLookup {
  float slice_scale = 0;
  float slice_bias = 0;
};

/// What the last LightClusters::update did.
struct ClusterStatistics {
  std::size_t lights_tested = 0;   ///< against the view; the other lights' clusters were kept
  std::size_t lights_in_view = 0;  ///< in at least one cluster
  std::size_t entries = 0;         ///< length of the light list
};

/// Lights are enlarged by this fraction of the sum of their range and their distance from the eye. It exceeds the
/// rounding of floats here and in a shader's look-up.
inline constexpr double kClusterSlack = 1e-5;

/// Largest fraction of entries whose light does not meet their cluster: in a city of 3,000 lights, and over 100 random
/// views together. A view with few lights may have a larger fraction.
inline constexpr double kClusterExcess = 0.1;

/// Lists the lights that can light each cluster, a small part of a view, so that a fragment loops over a short list
/// instead of all lights. For airlight it also lists those that can light anything between the eye and a cluster.
///
/// No light is missing from a cluster in which it can light a point. A light is in a cluster only if nothing of these
/// separates them: a plane of the grid, a plane that touches the light's cone, a ball around the light shrunk by the
/// cluster's planes. With many lights, at most kClusterExcess of the entries do not meet (light_clusters_test.cpp).
/// Lights are listed in the order of their indices. The lists depend only on the lights and the view, not on earlier
/// contents or on threads.
///
/// A light out of view costs one SIMD lane of arithmetic; in view, about ten vectors, and two for each row of clusters
/// that it may touch. Nothing is tested again while view and light stay the same.
/// Memory: 112 bytes per light, 48 per light and row of clusters that it is in, 4 per entry, 32 per cluster.
///
/// A call that throws std::bad_alloc changes nothing that a caller sees.
///
/// Different objects may be used on different threads concurrently.
class LightClusters {
 public:
  /// throws  std::invalid_argument naming field, value and rule
  explicit LightClusters(const ClusterGrid& grid = {});
  ~LightClusters();

  /// Moved-from clusters may only be assigned to or destroyed.
  LightClusters(LightClusters&&) noexcept;
  LightClusters& operator=(LightClusters&&) noexcept;

  const ClusterGrid& grid() const;

  /// Sets the number of lights; new lights have a range of 0.
  ///
  /// count   at most (2^31 - 2^20) / (columns * rows * slices), so that an int can index the table
  ///         (621,074 in the default grid)
  /// throws  std::invalid_argument naming field, value and rule
  void resize(std::size_t count);
  std::size_t size() const;

  /// Changes a light. Equal bounds are no change.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  void set_light(std::size_t light, const LightBounds& bounds);

  /// Brings the clusters up to date with a view and the changes of lights since the last call. If the view has changed,
  /// all lights are tested, otherwise only the changed ones and their neighbours by index. Allocates only for more than
  /// it has ever held.
  ///
  /// returns  whether table() has changed; true the first time
  /// throws   std::invalid_argument naming field, value and rule
  bool update(const View& view);

  /// The clusters: columns from left to right, in rows from the bottom up, in slices from the eye. Valid until the next
  /// update, like the light list.
  std::span<const Cluster> clusters() const;
  std::span<const std::uint32_t> light_list() const;

  /// The lights that can light any point of a ray from the eye to a cluster, ordered by the first slice that they can
  /// light, then by index. The ray's part before the view's nearest depth does not count. Valid until the next update.
  ///
  /// cluster  below the number of clusters
  /// throws   std::invalid_argument naming field, value and rule
  std::span<const std::uint32_t> lights_along(std::size_t cluster) const;

  /// The grid, the look-up and all lists as litfog/shaders/light_clusters.glsl reads them. Valid until the next update.
  ///   5 words  columns, rows, slices, and the bits of slice_scale and slice_bias
  ///   4 words per cluster: where its lights begin in the table, their number, and the same for lights_along()
  ///   the lists
  std::span<const std::uint32_t> table() const;

  /// The look-up for the view of the last update.
  ClusterLookup lookup() const;
  /// Index of the cluster in which a point lies, or nothing outside the view of the last update.
  std::optional<std::size_t> cluster_at(const glm::dvec3& point) const;

  /// A cluster's part of the view of the last update.
  ///
  /// cluster  below the number of clusters
  /// throws   std::invalid_argument naming field, value and rule
  View part_of_view(std::size_t cluster) const;

  const ClusterStatistics& statistics() const;

 private:
  class Store;
  std::unique_ptr<Store> store_;
};

}  // namespace litfog
