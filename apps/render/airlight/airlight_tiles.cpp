// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "litfog/light.h"
#include "litfog/light_clusters.h"
#include "litfog/view_frustum.h"

namespace litfog::render {
namespace {

constexpr int kTile = 32;                // pixels a side, about
constexpr std::uint32_t kMaxTiles = 32;  // a side: more tiles cost more than their shorter lists save
constexpr double kNearest = 1e-5;        // metres

/// The view that tiles of a size show together.
litfog::View tiled_view(const scene::Camera& camera, glm::ivec2 picture_size, glm::ivec2 size) {
  const scene::CameraAxes axes = scene::axes_of(camera);
  const double top = std::tan(double(camera.field_of_view) / 2);
  const double pixel = 2 * top / picture_size.y;
  const double left = -0.5 * pixel * picture_size.x;
  return {.eye = camera.position,
          .forward = axes.forward,
          .up = axes.up,
          .left = left,
          .right = left + pixel * size.x,
          .bottom = -top,
          .top = pixel * size.y - top,
          .nearest = kNearest,
          .farthest = kMaxPosition};
}

/// Adds each tile's entries, in order.
void add_lists(AirlightTiles& tiles, std::span<const AirlightList::Range> ranges, std::span<const Cluster> clusters,
               std::span<const std::uint32_t> entries) {
  const auto first_entry = std::int32_t(2 * ranges.size() * clusters.size());
  tiles.lists.reserve(std::size_t(first_entry) + entries.size());
  for (const AirlightList::Range& range : ranges) {
    for (const Cluster& cluster : clusters) {
      const auto listed = entries.subspan(cluster.first, cluster.count);
      for (const unsigned end : {range.first, range.first + range.count}) {
        const auto place = std::int32_t(std::ranges::lower_bound(listed, end) - listed.begin());
        tiles.lists.push_back(first_entry + std::int32_t(cluster.first) + place);
      }
    }
  }
  tiles.lists.insert(tiles.lists.end(), entries.begin(), entries.end());
}

}  // namespace

AirlightTiles list_airlight_tiles(const AirlightList& list, const scene::Camera& camera, glm::ivec2 picture_size,
                                  int beyond) {
  AirlightTiles tiles{.count = {1, 1}, .size = picture_size + beyond, .lists = {}};
  const litfog::View view = tiled_view(camera, picture_size, tiles.size);
  if (find_error(view)) {
    std::vector<std::uint32_t> all(list.entries.size());
    std::iota(all.begin(), all.end(), 0u);
    const Cluster whole{.first = 0, .count = std::uint32_t(all.size())};
    add_lists(tiles, list.ranges, {&whole, 1}, all);
    return tiles;
  }
  const auto across = [](int pixels) { return std::min(std::uint32_t(pixels + kTile - 1) / kTile, kMaxTiles); };
  LightClusters clusters({.columns = across(tiles.size.x), .rows = across(tiles.size.y), .slices = 1});
  clusters.resize(list.bounds.size());
  for (std::size_t i = 0; i < list.bounds.size(); ++i) clusters.set_light(i, list.bounds[i]);
  clusters.update(view);
  tiles.count = {clusters.grid().columns, clusters.grid().rows};
  add_lists(tiles, list.ranges, clusters.clusters(), clusters.light_list());
  return tiles;
}

}  // namespace litfog::render
