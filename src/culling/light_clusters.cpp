// SPDX-License-Identifier: Apache-2.0
#include "litfog/light_clusters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "cluster_runs.h"
#include "model/require.h"

namespace litfog {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kClusterWords = 4;

template <typename Visit>
void for_each_column(const ClusterRun& run, const Visit& visit) {
  for (std::uint64_t rest = run.columns; rest != 0; rest &= rest - 1) visit(std::size_t(std::countr_zero(rest)));
}

/// Binary logarithm of the factor by which slices grow from the second on.
double octaves_per_slice(const ClusterGrid& grid, const View& view) {
  return std::log2(view.farthest / grid.first_depth) / (grid.slices - 1);
}

}  // namespace

std::optional<ValueError> find_error(const ClusterGrid& grid) {
  const std::pair<const char*, std::uint32_t> parts[] = {
      {"columns", grid.columns}, {"rows", grid.rows}, {"slices", grid.slices}};
  for (const auto& [name, count] : parts) {
    if (!(count >= 1 && count <= kMaxParts)) return ValueError{name, double(count), "must be in [1, 64]"};
  }
  if (!(grid.first_depth >= kMinFirstDepth && is_within(grid.first_depth, 0, kMaxPosition))) {
    return ValueError{"first_depth", grid.first_depth, "must be in [1e-12, 16777216]"};
  }
  return std::nullopt;
}

double slice_depth(const ClusterGrid& grid, const View& view, std::uint32_t slice) {
  if (slice == 0) return view.nearest;
  if (slice == grid.slices) return view.farthest;
  return grid.first_depth * std::exp2((slice - 1) * octaves_per_slice(grid, view));
}

/// The implementation of LightClusters, which forwards its public calls to the public calls here.
class LightClusters::Store {
 public:
  explicit Store(const ClusterGrid& grid) : grid_(grid) {
    require(find_error(grid));
    clusters_.resize(std::size_t(grid.columns) * grid.rows * grid.slices);
    begins_.resize(clusters_.size());
    table_.resize(kHeaderWords + kClusterWords * clusters_.size());
    table_size_ = table_.size();
  }

  const ClusterGrid& grid() const { return grid_; }
  void resize(std::size_t count);
  std::size_t size() const { return bounds_.size(); }
  void set_light(std::size_t light, const LightBounds& bounds);
  bool update(const View& view);
  std::span<const Cluster> clusters() const { return clusters_; }
  std::span<const std::uint32_t> light_list() const { return lists().first(statistics_.entries); }
  std::span<const std::uint32_t> lights_along(std::size_t cluster) const;
  std::span<const std::uint32_t> table() const { return std::span(table_).first(table_size_); }
  ClusterLookup lookup() const;
  std::optional<std::size_t> cluster_at(const glm::dvec3& point) const;
  View part_of_view(std::size_t cluster) const;
  const ClusterStatistics& statistics() const { return statistics_; }

 private:
  /// The runs of neighbouring lights, in `runs_`.
  struct Block {
    std::size_t first_run = 0;
    std::size_t run_count = 0;
    std::size_t lights_in_view = 0;
    bool has_changed = true;
  };

  void find_runs(const View& view, bool is_new_view);
  std::size_t find_first_runs();
  void list_lights();
  bool write_lookup();
  std::span<const std::uint32_t> lists() const {
    return std::span(table_).subspan(kHeaderWords + kClusterWords * clusters_.size());
  }
  void require_cluster(std::size_t cluster) const {
    if (cluster >= clusters_.size()) {
      require(ValueError{"cluster", double(cluster), "must be below the number of clusters"});
    }
  }

  ClusterGrid grid_;
  View view_;
  bool has_view_ = false;
  bool has_changed_ = false;  // any light since the last update
  std::vector<LightBounds> bounds_;
  LightColumns columns_;
  std::vector<Block> blocks_;
  std::vector<ClusterRun> runs_;  // in the order of their lights
  std::vector<ClusterRun> previous_runs_;
  std::vector<ClusterRun> first_runs_;  // each light's first cluster in each tile of the picture
  std::vector<Cluster> clusters_;
  std::vector<Cluster> begins_;       // the lights that begin in a cluster: tile by tile, slices from the eye
  std::vector<std::uint32_t> table_;  // grows only; ends with the light list and that of lights_along()
  std::size_t table_size_;
  ClusterStatistics statistics_;
};

void LightClusters::Store::resize(std::size_t count) {
  const std::size_t most = ((1u << 31) - (1u << 20)) / clusters_.size();
  if (count > most) fail_count("count", count, "must be at most (2^31 - 2^20) / clusters");
  if (count == bounds_.size()) return;
  const std::size_t before = bounds_.size();
  const std::size_t first_changed = std::min(count, before) / kLightBlock;
  const std::size_t blocks = (count + kLightBlock - 1) / kLightBlock;
  columns_.resize(count);
  blocks_.reserve(blocks);
  bounds_.resize(count, {.range = 0});  // last to need memory: if there is none, nothing has changed
  for (std::size_t light = before; light < count; ++light) columns_.set(light, bounds_[light]);
  blocks_.resize(blocks);
  for (std::size_t block = first_changed; block < blocks_.size(); ++block) blocks_[block].has_changed = true;
  has_changed_ = true;
}

void LightClusters::Store::set_light(std::size_t light, const LightBounds& bounds) {
  if (light >= bounds_.size()) require(ValueError{"light", double(light), "must be below the number of lights"});
  require(find_error(bounds));
  LightBounds& held = bounds_[light];
  if (bounds == held) return;
  held.range = bounds.range;
  if (bounds == held) {  // as when the fog changes
    columns_.set_range(light, bounds.range);
  } else {
    held = bounds;
    columns_.set(light, bounds);
  }
  blocks_[light / kLightBlock].has_changed = true;
  has_changed_ = true;
}

bool LightClusters::Store::update(const View& view) {
  require(find_error(view));
  if (!(grid_.first_depth < view.farthest)) {
    require(ValueError{"farthest", view.farthest, "must be above the grid's first_depth"});
  }
  if (!(grid_.slices == 1 || grid_.first_depth > view.nearest)) {
    require(ValueError{"nearest", view.nearest, "must be below the grid's first_depth"});
  }
  statistics_.lights_tested = 0;
  const bool is_first = !has_view_;
  const bool is_new_view = is_first || view != view_;
  if (!is_new_view && !has_changed_) return false;
  has_view_ = false;  // if this call runs out of memory, the next one rebuilds the lists
  find_runs(view, is_new_view);
  const bool are_same = runs_ == previous_runs_;
  if (!are_same || is_first) list_lights();
  view_ = view;
  has_view_ = true;
  has_changed_ = false;
  return write_lookup() || is_first || !are_same;
}

void LightClusters::Store::find_runs(const View& view, bool is_new_view) {
  const ClusterPlanes planes(grid_, view);
  std::swap(runs_, previous_runs_);
  runs_.clear();
  statistics_.lights_in_view = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    const std::size_t first = runs_.size();
    if (is_new_view || block.has_changed) {
      block.has_changed = false;
      block.lights_in_view = append_cluster_runs(planes, columns_, i * kLightBlock, runs_);
      statistics_.lights_tested += std::min(kLightBlock, bounds_.size() - i * kLightBlock);
    } else {
      const auto begin = previous_runs_.begin() + std::ptrdiff_t(block.first_run);
      runs_.insert(runs_.end(), begin, begin + std::ptrdiff_t(block.run_count));
    }
    block.first_run = first;
    block.run_count = runs_.size() - first;
    statistics_.lights_in_view += block.lights_in_view;
  }
}

/// Keeps, of each light's runs, the columns in which no nearer slice has the light; runs are ordered by slice from the
/// eye. Returns the number of entries of both lists.
std::size_t LightClusters::Store::find_first_runs() {
  std::size_t entries = 0;
  first_runs_.clear();
  std::array<std::uint64_t, kMaxParts> columns{};
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    ClusterRun run = runs_[i];
    entries += std::size_t(std::popcount(run.columns));
    if (i == 0 || run.light != runs_[i - 1].light) std::fill_n(columns.begin(), grid_.rows, 0);
    std::uint64_t& before = columns[run.row % grid_.rows];
    run.columns &= ~before;
    before |= run.columns;
    entries += std::size_t(std::popcount(run.columns));
    if (run.columns != 0) first_runs_.push_back(run);
  }
  return entries;
}

/// Sorts the runs' lights by cluster, by counting: all for the light list, the first ones for lights_along().
void LightClusters::Store::list_lights() {
  const std::size_t entries = find_first_runs();
  const auto start = std::uint32_t(kHeaderWords + kClusterWords * clusters_.size());
  if (table_.size() < start + entries) table_.resize(start + entries);
  table_size_ = start + entries;
  const auto for_each_begin = [this](const ClusterRun& run, const auto& visit) {
    const std::size_t tile = std::size_t(run.row % grid_.rows) * grid_.columns;
    const std::size_t slice = run.row / grid_.rows;
    for_each_column(run, [&](std::size_t column) { visit(begins_[(tile + column) * grid_.slices + slice]); });
  };
  const auto for_each_cluster = [this](const ClusterRun& run, const auto& visit) {
    const std::size_t row = std::size_t(run.row) * grid_.columns;
    for_each_column(run, [&](std::size_t column) { visit(clusters_[row + column]); });
  };
  std::ranges::fill(clusters_, Cluster{});
  std::ranges::fill(begins_, Cluster{});
  for (const ClusterRun& run : runs_) for_each_cluster(run, [](Cluster& list) { ++list.count; });
  for (const ClusterRun& run : first_runs_) for_each_begin(run, [](Cluster& list) { ++list.count; });
  const auto make_room = [](std::vector<Cluster>& lists) {
    std::uint32_t first = 0;
    for (Cluster& list : lists) {
      list.first = first;
      first += std::exchange(list.count, 0);
    }
    return first;
  };
  statistics_.entries = make_room(clusters_);
  make_room(begins_);
  const auto along_start = std::uint32_t(start + statistics_.entries);
  for (const ClusterRun& run : runs_) {
    for_each_cluster(run, [&](Cluster& list) { table_[start + list.first + list.count++] = run.light; });
  }
  for (const ClusterRun& run : first_runs_) {
    for_each_begin(run, [&](Cluster& list) { table_[along_start + list.first + list.count++] = run.light; });
  }
  const std::size_t tiles = begins_.size() / grid_.slices;
  std::uint32_t* words = table_.data() + kHeaderWords;
  for (std::size_t cluster = 0, slice = 0; slice < grid_.slices; ++slice) {
    for (std::size_t tile = 0; tile < tiles; ++tile, ++cluster, words += kClusterWords) {
      const Cluster* along = &begins_[tile * grid_.slices];
      words[0] = start + clusters_[cluster].first;
      words[1] = clusters_[cluster].count;
      words[2] = along_start + along->first;
      words[3] = along[slice].first + along[slice].count - along->first;
    }
  }
}

/// Writes the look-up. Returns whether it has changed.
bool LightClusters::Store::write_lookup() {
  const ClusterLookup found = lookup();
  const std::array<std::uint32_t, kHeaderWords> words{grid_.columns, grid_.rows, grid_.slices,
                                                      std::bit_cast<std::uint32_t>(found.slice_scale),
                                                      std::bit_cast<std::uint32_t>(found.slice_bias)};
  const bool has_changed = !std::ranges::equal(words, std::span(table_).first(kHeaderWords));
  std::ranges::copy(words, table_.begin());
  return has_changed;
}

std::span<const std::uint32_t> LightClusters::Store::lights_along(std::size_t cluster) const {
  require_cluster(cluster);
  const std::uint32_t* words = table_.data() + kHeaderWords + kClusterWords * cluster;
  return std::span(table_).subspan(words[2], words[3]);
}

ClusterLookup LightClusters::Store::lookup() const {
  if (grid_.slices == 1) return {};
  const double scale = 1 / octaves_per_slice(grid_, view_);
  return {float(scale), float(1 - scale * std::log2(grid_.first_depth))};
}

std::optional<std::size_t> LightClusters::Store::cluster_at(const glm::dvec3& point) const {
  const glm::dvec3 seen = glm::transpose(axes_of(view_)) * (point - view_.eye);
  const double depth = seen.z;
  if (!(depth >= view_.nearest && depth <= view_.farthest)) return std::nullopt;
  const double x = (seen.x / depth - view_.left) / (view_.right - view_.left);
  const double y = (seen.y / depth - view_.bottom) / (view_.top - view_.bottom);
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return std::nullopt;
  const auto part = [](double position, std::uint32_t parts) {
    return std::size_t(std::clamp(std::floor(position), 0.0, parts - 1.0));
  };
  const std::size_t column = part(x * grid_.columns, grid_.columns);
  const std::size_t row = part(y * grid_.rows, grid_.rows);
  const double position =
      grid_.slices == 1 ? 0 : 1 + std::log2(depth / grid_.first_depth) / octaves_per_slice(grid_, view_);
  return (part(position, grid_.slices) * grid_.rows + row) * grid_.columns + column;
}

View LightClusters::Store::part_of_view(std::size_t cluster) const {
  require_cluster(cluster);
  const std::size_t column = cluster % grid_.columns;
  const std::size_t row = cluster / grid_.columns % grid_.rows;
  const auto slice = std::uint32_t(cluster / grid_.columns / grid_.rows);
  const auto edge = [](double low, double high, std::size_t part, std::size_t parts) {
    return std::lerp(low, high, double(part) / double(parts));
  };
  View part = view_;
  part.left = edge(view_.left, view_.right, column, grid_.columns);
  part.right = edge(view_.left, view_.right, column + 1, grid_.columns);
  part.bottom = edge(view_.bottom, view_.top, row, grid_.rows);
  part.top = edge(view_.bottom, view_.top, row + 1, grid_.rows);
  part.nearest = slice_depth(grid_, view_, slice);
  part.farthest = slice_depth(grid_, view_, slice + 1);
  return part;
}

LightClusters::LightClusters(const ClusterGrid& grid) : store_(std::make_unique<Store>(grid)) {}
LightClusters::~LightClusters() = default;
LightClusters::LightClusters(LightClusters&&) noexcept = default;
LightClusters& LightClusters::operator=(LightClusters&&) noexcept = default;

const ClusterGrid& LightClusters::grid() const { return store_->grid(); }
void LightClusters::resize(std::size_t count) { store_->resize(count); }
std::size_t LightClusters::size() const { return store_->size(); }
void LightClusters::set_light(std::size_t light, const LightBounds& bounds) { store_->set_light(light, bounds); }
bool LightClusters::update(const View& view) { return store_->update(view); }
std::span<const Cluster> LightClusters::clusters() const { return store_->clusters(); }
std::span<const std::uint32_t> LightClusters::light_list() const { return store_->light_list(); }
std::span<const std::uint32_t> LightClusters::lights_along(std::size_t cluster) const {
  return store_->lights_along(cluster);
}
std::span<const std::uint32_t> LightClusters::table() const { return store_->table(); }
ClusterLookup LightClusters::lookup() const { return store_->lookup(); }
std::optional<std::size_t> LightClusters::cluster_at(const glm::dvec3& point) const {
  return store_->cluster_at(point);
}
View LightClusters::part_of_view(std::size_t cluster) const { return store_->part_of_view(cluster); }
const ClusterStatistics& LightClusters::statistics() const { return store_->statistics(); }

}  // namespace litfog
