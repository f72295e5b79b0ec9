// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "litfog/light_clusters.h"
#include "reference/random_bounds.h"

namespace litfog::test {

inline std::span<const std::uint32_t> lights_of(const LightClusters& clusters, std::size_t cluster) {
  const Cluster& list = clusters.clusters()[cluster];
  return clusters.light_list().subspan(list.first, list.count);
}

/// A list of table(), by the words of a cluster from `word` on.
inline std::span<const std::uint32_t> list_of_table(const LightClusters& clusters, std::size_t cluster,
                                                    std::size_t word) {
  const auto words = clusters.table().subspan(5 + 4 * cluster + word, 2);
  return clusters.table().subspan(words[0], words[1]);
}

inline bool has_light(const LightClusters& clusters, std::size_t cluster, std::size_t light) {
  return std::ranges::binary_search(lights_of(clusters, cluster), std::uint32_t(light));
}

inline ClusterGrid draw_grid(Random& random, const View& view) {
  const auto parts = [&] {
    return std::uint32_t(random.chance(0.2) ? 1 : random.chance(0.1) ? 64 : 1 + random.below(30));
  };
  ClusterGrid grid{.columns = parts(), .rows = parts(), .slices = parts()};
  const double growth = view.farthest / view.nearest;
  grid.first_depth = std::max(view.nearest * std::pow(growth, random.uniform(0.05, 0.9)), kMinFirstDepth);
  return grid;
}

inline void set_lights(LightClusters& clusters, const std::vector<LightBounds>& lights) {
  clusters.resize(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) clusters.set_light(i, lights[i]);
}

inline LightClusters clusters_of(const std::vector<LightBounds>& lights, const View& view,
                                 const ClusterGrid& grid = {}) {
  LightClusters clusters(grid);
  set_lights(clusters, lights);
  clusters.update(view);
  return clusters;
}

/// Holds random lights in a view against points that they light. Returns how many points lie in it.
inline int expect_complete(Random& random, const View& view) {
  LightClusters clusters(draw_grid(random, view));
  std::vector<LightBounds> lights;
  for (int k = 0; k < 100; ++k) lights.push_back(draw_bounds(random, view));
  set_lights(clusters, lights);
  EXPECT_TRUE(clusters.update(view));
  int points = 0;
  for (std::size_t light = 0; light < lights.size(); ++light) {
    for (int k = 0; k < 30; ++k) {
      const glm::dvec3 point = draw_point_in(random, lights[light], 3 * view.farthest);
      const auto cluster = clusters.cluster_at(point);
      EXPECT_EQ(cluster.has_value(), is_in(view, point));
      if (!cluster) continue;
      ++points;
      EXPECT_TRUE(has_light(clusters, *cluster, light)) << to_string(view, lights[light]);
    }
  }
  return points;
}

struct Lists {
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> lights;

  explicit Lists(const LightClusters& from)
      : clusters(from.clusters().begin(), from.clusters().end()),
        lights(from.light_list().begin(), from.light_list().end()) {}
  friend bool operator==(const Lists&, const Lists&) = default;
};

}  // namespace litfog::test
