// SPDX-License-Identifier: Apache-2.0
#include "litfog/updater.h"

#include <algorithm>
#include <array>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "litfog/batch.h"
#include "model/require.h"
#include "model/unchecked.h"

namespace litfog {
namespace {

constexpr std::size_t kJoinedBytes = 10 * 1024;  // these take about as long to upload as one more call, 1 us

float brightness_of(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

/// All that lights of a kind agree in. -0 is 0.
using KindKey = std::array<double, 7 + kMaxConeParameters>;

KindKey key_of(const PlacedLight& placed) {
  const Light& light = placed.light;
  const auto& [constant, linear, quadratic] = light.attenuation;
  KindKey key{constant,
              linear,
              quadratic,
              light.threshold,
              light.density_scale,
              double(placed.carried),
              double(light.cone.profile)};
  std::size_t i = 7;
  for (const ConeParameter& parameter : facts_of(light.cone.profile).parameters) {
    key[i++] = light.cone.*parameter.member;
  }
  return key;
}

struct KindKeyHash {
  std::size_t operator()(const KindKey& key) const {
    std::uint64_t hash = 0;
    for (const double value : key) {
      hash = (hash ^ std::hash<double>{}(value)) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio (Knuth, TAOCP 3, 6.4)
      hash ^= hash >> 32;
    }
    return std::size_t(hash);
  }
};

/// Lights that share an entry of the table of kinds.
struct Kind {
  Attenuation attenuation;
  double threshold;
  double density_scale;
  double half_angle;
  IntensityBound bound;
  std::size_t lit_count = 0;  ///< lights that are on and not black
  float brightest = 0;        ///< the first light's brightness: fetching that light takes longer than solving the kind
  bool is_carried;
  bool has_changed = true;  ///< any of its lights since the last set_fog
  bool is_dirty = true;
  bool is_source_dirty = true;
  std::vector<std::uint32_t> lights = {};  ///< slots; a binary heap, the brightest first
  KindKey key;
};

constexpr std::uint32_t kSteady = 0xffffffff;

/// The flash of a light that flashes.
struct FlashingLight {
  std::uint32_t slot;
  Flash flash;
};

/// So that the next push_back() allocates nothing.
template <typename T>
void make_room(std::vector<T>& entries) {
  if (entries.size() == entries.capacity()) entries.reserve(std::max<std::size_t>(2 * entries.size(), 4));
}

/// A light; its slot is its index among the instances.
struct Record {
  std::uint32_t generation = 1;
  std::uint32_t kind = 0;
  std::uint32_t heap_index = 0;  ///< among its kind's lights
  float brightness = 0;          ///< largest colour component in its brightest flash; 0 where it is off
  glm::vec3 color{0};            ///< when on, but for its flash
  float flash_factor = 1;
  std::uint32_t flashing = kSteady;  ///< index among those that flash
  bool is_on = false;
  bool is_held = false;
  bool is_dirty = false;
};

/// Arguments and result of the batch solve, with room for every kind.
struct Columns {
  std::vector<double> constant, linear, quadratic, threshold, density, intensity;
  std::vector<std::uint32_t> kind;

  void resize(std::size_t size) {
    for (auto* column : {&constant, &linear, &quadratic, &threshold, &density, &intensity}) column->resize(size);
    kind.resize(size);
  }
};

/// Dirty entries of a table as ranges.
class RangeList {
 public:
  explicit RangeList(std::size_t entry_bytes) : entry_bytes_(entry_bytes), joined_gap_(kJoinedBytes / entry_bytes) {}

  /// So that add() allocates nothing for a table of as many entries.
  void make_room(std::size_t entries) { ranges_.reserve(entries / joined_gap_ + 1); }
  void clear() { ranges_.clear(); }
  /// entry  greater than each added before
  void add(std::size_t entry) {
    if (!ranges_.empty() && entry - ranges_.back().end <= joined_gap_) {
      ranges_.back().end = entry + 1;
    } else {
      ranges_.push_back({entry, entry + 1});
    }
  }
  std::span<const EntryRange> ranges() const { return ranges_; }
  std::size_t bytes() const {
    std::size_t entries = 0;
    for (const EntryRange& range : ranges_) entries += range.end - range.begin;
    return entries * entry_bytes_;
  }

 private:
  std::size_t entry_bytes_;
  std::size_t joined_gap_;
  std::vector<EntryRange> ranges_;
};

/// What sources depend on besides their kind.
struct SourceAir {
  Fog thickest = {};
  double phase_cosine = 0;

  friend bool operator==(const SourceAir&, const SourceAir&) = default;
};

/// As a float, at most the largest.
float rounded(double value) { return float(std::min(value, double(std::numeric_limits<float>::max()))); }

}  // namespace

/// Everything of the updater; its public face forwards to the public calls here, which are documented there.
class FogUpdater::Store {
 public:
  explicit Store(double skip_budget_255);

  FogLightHandle add(const PlacedLight& light);
  void change(FogLightHandle handle, const PlacedLight& light);
  void switch_light(FogLightHandle handle, bool is_on);
  void set_time(double seconds);
  void remove(FogLightHandle handle);
  FogLightChanges set_atmosphere(const Atmosphere& atmosphere, double eye_height);
  std::span<const FogLightKind> kinds() const { return kind_table_; }
  std::span<const FogLightInstance> instances() const { return instances_; }
  void solve_sources();
  std::span<const FogLightSource> sources() const {
    return std::span(sources_).first(solves_sources_ ? sources_.size() : 0);
  }
  std::uint32_t slot_of(FogLightHandle handle) const;
  std::uint32_t kind_of(FogLightHandle handle) const { return records_[slot_of(handle)].kind; }
  double reach_of_kind(std::size_t kind, const Atmosphere& atmosphere, double step, LampLeg lamp_leg) const;
  void bound_lights(LightClusters& clusters, const Atmosphere& atmosphere, double step, LampLeg lamp_leg) const;
  const FogUpdateStatistics& statistics() const { return statistics_; }

 private:
  void make_room_for_one();
  std::uint32_t add_slot();
  std::uint32_t find_or_add_kind(const PlacedLight& placed);
  void enter(std::uint32_t slot, std::uint32_t kind_index);
  void leave(std::uint32_t slot);
  void pack(std::uint32_t slot, const PlacedLight& placed);
  void set_flash(std::uint32_t slot, const Flash& flash);
  void show(std::uint32_t slot);
  void write_color(std::uint32_t slot);
  void mark(std::uint32_t slot);
  void put(Kind& kind, std::size_t index, std::uint32_t slot);
  void sift(Kind& kind, std::size_t index);
  bool is_below_budget(const Kind& kind, const Fog& seen_fog) const;
  void set_intensity(std::uint32_t kind_index, float intensity);
  void set_source(std::uint32_t kind_index);
  FogLightChanges collect_changes();

  double skip_budget_;
  Fog fog_;  // at the eye
  SourceAir source_air_;
  double seconds_ = 0;
  bool has_changed_ = false;  // any light since the last set_fog
  std::vector<Kind> kinds_;   // those without lights are free
  std::vector<FogLightKind> kind_table_;
  std::vector<FogLightSource> sources_;  // one a kind
  bool solves_sources_ = false;
  std::vector<std::uint32_t> free_kinds_;
  std::unordered_map<KindKey, std::uint32_t, KindKeyHash> kind_of_key_;
  std::vector<Record> records_;
  std::vector<FlashingLight> flashing_;
  std::vector<FogLightInstance> instances_;
  std::vector<std::uint32_t> free_slots_;
  std::vector<std::uint32_t> dirty_slots_;  // room for all
  std::size_t light_count_ = 0;
  Columns columns_;
  RangeList kind_ranges_{sizeof(FogLightKind)};
  RangeList instance_ranges_{sizeof(FogLightInstance)};
  RangeList source_ranges_{sizeof(FogLightSource)};
  FogUpdateStatistics statistics_;
};

FogUpdater::Store::Store(double skip_budget_255) : skip_budget_(skip_budget_255 / 255) {
  if (!is_finite_and_not_negative(skip_budget_255)) {
    require(ValueError{"skip_budget_255", skip_budget_255, "must be finite and >= 0"});
  }
}

FogLightHandle FogUpdater::Store::add(const PlacedLight& light) {
  require(find_error(light));
  make_room_for_one();
  const std::uint32_t kind = find_or_add_kind(light);
  const std::uint32_t slot = add_slot();
  Record& record = records_[slot];
  record.is_held = true;
  record.is_on = true;
  enter(slot, kind);
  pack(slot, light);
  ++light_count_;
  return {slot, record.generation};
}

void FogUpdater::Store::change(FogLightHandle handle, const PlacedLight& light) {
  const std::uint32_t slot = slot_of(handle);
  require(find_error(light));
  make_room_for_one();
  const std::uint32_t kind = find_or_add_kind(light);
  if (kind != records_[slot].kind) {
    leave(slot);
    enter(slot, kind);
  }
  pack(slot, light);
}

void FogUpdater::Store::switch_light(FogLightHandle handle, bool is_on) {
  const std::uint32_t slot = slot_of(handle);
  if (is_on == records_[slot].is_on) return;
  records_[slot].is_on = is_on;
  show(slot);
}

void FogUpdater::Store::set_time(double seconds) {
  require_time(seconds);
  seconds_ = seconds;
  for (const FlashingLight& light : flashing_) {
    Record& record = records_[light.slot];
    const float factor = float(flash_at(light.flash, seconds));
    if (std::exchange(record.flash_factor, factor) != factor && record.is_on) write_color(light.slot);
  }
}

void FogUpdater::Store::remove(FogLightHandle handle) {
  const std::uint32_t slot = slot_of(handle);
  leave(slot);
  set_flash(slot, {});
  instances_[slot] = {};
  mark(slot);
  Record& record = records_[slot];
  record.is_held = false;
  ++record.generation;
  free_slots_.push_back(slot);
  --light_count_;
}

FogLightChanges FogUpdater::Store::set_atmosphere(const Atmosphere& atmosphere, double eye_height) {
  require(find_error(atmosphere));
  if (std::isnan(eye_height)) require(ValueError{"eye_height", eye_height, "must be a number"});
  const Fog fog = atmosphere.fog_at(eye_height);
  const SourceAir source_air{atmosphere.thickest_fog(), mean_cosine(atmosphere.phase)};
  const bool is_new_fog = std::exchange(fog_, fog) != fog;
  const bool is_new_air = std::exchange(source_air_, source_air) != source_air && solves_sources_;
  statistics_ = {.kinds_solved = 0,
                 .kinds_skipped = kinds_.size() - free_kinds_.size(),
                 .lights_skipped = light_count_,
                 .bytes_dirty = 0,
                 .sources_solved = 0};
  if (!is_new_fog && !is_new_air && !has_changed_) return {};
  has_changed_ = false;
  std::size_t solved = 0;
  for (std::uint32_t i = 0; i < kinds_.size(); ++i) {
    Kind& kind = kinds_[i];
    const bool has_changed = std::exchange(kind.has_changed, false);
    if (solves_sources_ && (has_changed || is_new_air)) set_source(i);
    if (!kind.is_carried || !(has_changed || is_new_fog)) continue;
    const Fog seen_fog = unchecked::scaled(fog, kind.density_scale);
    if (kind.lit_count == 0 || is_below_budget(kind, seen_fog)) {
      set_intensity(i, 0);
      continue;
    }
    columns_.constant[solved] = kind.attenuation.constant;
    columns_.linear[solved] = kind.attenuation.linear;
    columns_.quadratic[solved] = kind.attenuation.quadratic;
    columns_.threshold[solved] = kind.threshold;
    columns_.density[solved] = seen_fog.density;
    columns_.kind[solved] = i;
    ++solved;
    statistics_.lights_skipped -= kind.lit_count;
  }
  statistics_.kinds_solved = solved;
  statistics_.kinds_skipped -= solved;
  const auto used = [solved](const std::vector<double>& column) { return std::span(column).first(solved); };
  solve_fog_intensities(fog.mode,
                        {.constant = used(columns_.constant),
                         .linear = used(columns_.linear),
                         .quadratic = used(columns_.quadratic),
                         .threshold = used(columns_.threshold),
                         .density = used(columns_.density)},
                        {.intensity = std::span(columns_.intensity).first(solved)});
  for (std::size_t i = 0; i < solved; ++i) set_intensity(columns_.kind[i], float(columns_.intensity[i]));
  return collect_changes();
}

std::uint32_t FogUpdater::Store::slot_of(FogLightHandle handle) const {
  if (handle.slot >= records_.size() || !records_[handle.slot].is_held ||
      records_[handle.slot].generation != handle.generation) {
    require(ValueError{"handle.slot", double(handle.slot), "must be that of a light held"});
  }
  return handle.slot;
}

/// Everywhere but in a kind and the table of keys, so that where memory is short nothing has changed, and that what
/// gives back, switches or updates needs none.
void FogUpdater::Store::make_room_for_one() {
  make_room(records_);
  make_room(instances_);
  make_room(flashing_);
  free_slots_.reserve(records_.capacity());
  dirty_slots_.reserve(records_.capacity());
  instance_ranges_.make_room(records_.capacity());
  make_room(kinds_);
  make_room(kind_table_);
  make_room(sources_);
  free_kinds_.reserve(kinds_.capacity());
  columns_.resize(kinds_.capacity());
  kind_ranges_.make_room(kinds_.capacity());
  source_ranges_.make_room(kinds_.capacity());
}

std::uint32_t FogUpdater::Store::add_slot() {
  if (!free_slots_.empty()) {
    const std::uint32_t slot = free_slots_.back();
    free_slots_.pop_back();
    return slot;
  }
  records_.emplace_back();
  instances_.emplace_back();
  return std::uint32_t(records_.size() - 1);
}

/// Returns the kind of a light, which has room for one more.
std::uint32_t FogUpdater::Store::find_or_add_kind(const PlacedLight& placed) {
  const KindKey key = key_of(placed);
  if (const auto found = kind_of_key_.find(key); found != kind_of_key_.end()) {
    make_room(kinds_[found->second].lights);
    return found->second;
  }
  const Light& light = placed.light;
  Kind kind{.attenuation = light.attenuation,
            .threshold = light.threshold,
            .density_scale = light.density_scale,
            .half_angle = cutoff_angle(light.cone),
            .bound = {light.attenuation, light.threshold},
            .is_carried = placed.carried,
            .key = key};
  make_room(kind.lights);
  const std::uint32_t index = free_kinds_.empty() ? std::uint32_t(kinds_.size()) : free_kinds_.back();
  kind_of_key_.emplace(key, index);
  if (free_kinds_.empty()) {
    kinds_.push_back(std::move(kind));
    kind_table_.emplace_back();
    sources_.emplace_back();
  } else {
    free_kinds_.pop_back();
    kinds_[index] = std::move(kind);
  }
  const double extent = unchecked::compute_extent(light.attenuation, light.threshold);
  kind_table_[index] = unchecked::pack_fog_light_kind(
      placed, {.intensity = 0, .peak_range = 0, .extent = extent, .status = SolveStatus::ok});
  return index;
}

/// Gives a light a kind that has room. It is dark until it is shown.
void FogUpdater::Store::enter(std::uint32_t slot, std::uint32_t kind_index) {
  Kind& kind = kinds_[kind_index];
  records_[slot].kind = kind_index;
  records_[slot].brightness = 0;
  kind.lights.emplace_back();
  put(kind, kind.lights.size() - 1, slot);
}

/// Takes a light out of its kind, and the kind with its last light.
void FogUpdater::Store::leave(std::uint32_t slot) {
  const Record& record = records_[slot];
  Kind& kind = kinds_[record.kind];
  if (record.brightness > 0) --kind.lit_count;
  kind.has_changed = true;
  const std::uint32_t last = kind.lights.back();
  kind.lights.pop_back();
  if (last != slot) {
    const std::uint32_t index = record.heap_index;
    put(kind, index, last);
    sift(kind, index);
  }
  if (!kind.lights.empty()) return;
  kind_of_key_.erase(kind.key);
  kind.is_dirty = true;
  kind_table_[record.kind] = {};
  free_kinds_.push_back(record.kind);
}

/// Writes the instance of a light.
void FogUpdater::Store::pack(std::uint32_t slot, const PlacedLight& placed) {
  instances_[slot] = unchecked::pack_fog_light_instance(placed, records_[slot].kind);
  records_[slot].color = glm::vec3(instances_[slot].color);
  set_flash(slot, placed.light.flash);
  show(slot);
}

/// Gives a light its flash, which may be that of a steady one.
void FogUpdater::Store::set_flash(std::uint32_t slot, const Flash& flash) {
  Record& record = records_[slot];
  if (record.flashing != kSteady) {
    const std::uint32_t hole = record.flashing;
    flashing_[hole] = flashing_.back();
    records_[flashing_[hole].slot].flashing = hole;
    record.flashing = kSteady;
    flashing_.pop_back();
  }
  if (flash.count > 0) {
    record.flashing = std::uint32_t(flashing_.size());
    flashing_.push_back({slot, flash});
  }
  record.flash_factor = float(flash_at(flash, seconds_));
}

/// Writes a light's colour at the time.
void FogUpdater::Store::write_color(std::uint32_t slot) {
  const Record& record = records_[slot];
  const glm::vec3 color = record.is_on ? record.flash_factor * record.color : glm::vec3{0};
  instances_[slot].color = glm::vec4(glm::min(color, std::numeric_limits<float>::max()), 0);
  mark(slot);
}

/// Writes a light's colour, and its brightness to its kind.
void FogUpdater::Store::show(std::uint32_t slot) {
  Record& record = records_[slot];
  Kind& kind = kinds_[record.kind];
  write_color(slot);
  if (record.brightness > 0) --kind.lit_count;
  const float largest = record.flashing == kSteady ? 1 : float(largest_flash(flashing_[record.flashing].flash));
  record.brightness = record.is_on ? rounded(double(largest) * double(brightness_of(record.color))) : 0;
  if (record.brightness > 0) ++kind.lit_count;
  kind.has_changed = true;
  sift(kind, record.heap_index);
}

void FogUpdater::Store::mark(std::uint32_t slot) {
  has_changed_ = true;
  if (std::exchange(records_[slot].is_dirty, true)) return;
  dirty_slots_.push_back(slot);
}

void FogUpdater::Store::put(Kind& kind, std::size_t index, std::uint32_t slot) {
  kind.lights[index] = slot;
  records_[slot].heap_index = std::uint32_t(index);
}

/// Restores the order of a kind's heap after a change of one light's brightness.
void FogUpdater::Store::sift(Kind& kind, std::size_t index) {
  const auto brightness_at = [&](std::size_t at) { return records_[kind.lights[at]].brightness; };
  const auto swap_with = [&](std::size_t other) {
    const std::uint32_t slot = kind.lights[index];
    put(kind, index, kind.lights[other]);
    put(kind, other, slot);
    index = other;
  };
  while (index > 0 && brightness_at(index) > brightness_at((index - 1) / 2)) swap_with((index - 1) / 2);
  for (;;) {
    std::size_t brightest = index;
    for (std::size_t child = 2 * index + 1; child < std::min(2 * index + 3, kind.lights.size()); ++child) {
      if (brightness_at(child) > brightness_at(brightest)) brightest = child;
    }
    if (brightest == index) break;
    swap_with(brightest);
  }
  kind.brightest = brightness_at(0);
}

double FogUpdater::Store::reach_of_kind(std::size_t kind, const Atmosphere& atmosphere, double step,
                                        LampLeg lamp_leg) const {
  if (kind >= kinds_.size()) require(ValueError{"kind", double(kind), "must be below the number of kinds"});
  const Kind& held = kinds_[kind];
  const double budget = reach_budget(step, light_count_, held.brightest, atmosphere);
  if (held.lit_count == 0) return 0;
  Light light;
  light.attenuation = held.attenuation;
  light.threshold = held.threshold;
  light.density_scale = held.density_scale;
  return light_reach(light, atmosphere.thinnest_fog(), budget, lamp_leg);
}

void FogUpdater::Store::bound_lights(LightClusters& clusters, const Atmosphere& atmosphere, double step,
                                     LampLeg lamp_leg) const {
  reach_budget(step, light_count_, 0, atmosphere);  // refuses the arguments even where there are no kinds
  std::vector<double> reaches;
  for (std::size_t i = 0; i < kinds_.size(); ++i) reaches.push_back(reach_of_kind(i, atmosphere, step, lamp_leg));
  clusters.resize(instances_.size());
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const Record& record = records_[i];
    if (!record.is_held || record.brightness == 0) {
      clusters.set_light(i, {.range = 0});
      continue;
    }
    clusters.set_light(i, {.position = glm::dvec3(instances_[i].position_kind),
                           .direction = glm::normalize(glm::dvec3(instances_[i].axis_profile)),
                           .range = reaches[record.kind],
                           .half_angle = kinds_[record.kind].half_angle});
  }
}

bool FogUpdater::Store::is_below_budget(const Kind& kind, const Fog& seen_fog) const {
  return kind.bound.at(seen_fog) * kind.brightest < skip_budget_;
}

void FogUpdater::Store::solve_sources() {
  solves_sources_ = true;
  has_changed_ = true;
  for (Kind& kind : kinds_) kind.has_changed = true;
}

void FogUpdater::Store::set_intensity(std::uint32_t kind_index, float intensity) {
  float& stored = kind_table_[kind_index].cone_scale_intensity.w;
  if (stored == intensity) return;
  stored = intensity;
  kinds_[kind_index].is_dirty = true;
}

void FogUpdater::Store::set_source(std::uint32_t kind_index) {
  Kind& kind = kinds_[kind_index];
  FogLightSource source;
  if (kind.lit_count > 0) {
    const Fog seen_fog = unchecked::scaled(source_air_.thickest, kind.density_scale);
    const auto found = unchecked::point_source(kind.attenuation, seen_fog, source_air_.phase_cosine);
    source = {.intensity = rounded(found.intensity), .soft_range = rounded(found.soft_range)};
    ++statistics_.sources_solved;
  }
  if (std::exchange(sources_[kind_index], source) != source) kind.is_source_dirty = true;
}

FogLightChanges FogUpdater::Store::collect_changes() {
  kind_ranges_.clear();
  source_ranges_.clear();
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (std::exchange(kinds_[i].is_dirty, false)) kind_ranges_.add(i);
    if (solves_sources_ && std::exchange(kinds_[i].is_source_dirty, false)) source_ranges_.add(i);
  }
  instance_ranges_.clear();
  std::ranges::sort(dirty_slots_);
  for (const std::uint32_t slot : dirty_slots_) {
    records_[slot].is_dirty = false;
    instance_ranges_.add(slot);
  }
  dirty_slots_.clear();
  statistics_.bytes_dirty = kind_ranges_.bytes() + instance_ranges_.bytes() + source_ranges_.bytes();
  return {.kinds = kind_ranges_.ranges(), .instances = instance_ranges_.ranges(), .sources = source_ranges_.ranges()};
}

FogUpdater::FogUpdater(double skip_budget_255) : store_(std::make_unique<Store>(skip_budget_255)) {}
FogUpdater::~FogUpdater() = default;
FogUpdater::FogUpdater(FogUpdater&&) noexcept = default;
FogUpdater& FogUpdater::operator=(FogUpdater&&) noexcept = default;

FogLightHandle FogUpdater::add(const PlacedLight& light) { return store_->add(light); }
void FogUpdater::change(FogLightHandle handle, const PlacedLight& light) { store_->change(handle, light); }
void FogUpdater::switch_light(FogLightHandle handle, bool is_on) { store_->switch_light(handle, is_on); }
void FogUpdater::set_time(double seconds) { store_->set_time(seconds); }
void FogUpdater::remove(FogLightHandle handle) { store_->remove(handle); }
FogLightChanges FogUpdater::set_atmosphere(const Atmosphere& atmosphere, double eye_height) {
  return store_->set_atmosphere(atmosphere, eye_height);
}
std::span<const FogLightKind> FogUpdater::kinds() const { return store_->kinds(); }
std::span<const FogLightInstance> FogUpdater::instances() const { return store_->instances(); }
void FogUpdater::solve_sources() { store_->solve_sources(); }
std::span<const FogLightSource> FogUpdater::sources() const { return store_->sources(); }
std::size_t FogUpdater::instance_of(FogLightHandle handle) const { return store_->slot_of(handle); }
std::size_t FogUpdater::kind_of(FogLightHandle handle) const { return store_->kind_of(handle); }
double FogUpdater::reach_of_kind(std::size_t kind, const Atmosphere& atmosphere, double step, LampLeg lamp_leg) const {
  return store_->reach_of_kind(kind, atmosphere, step, lamp_leg);
}
void FogUpdater::bound_lights(LightClusters& clusters, const Atmosphere& atmosphere, double step,
                              LampLeg lamp_leg) const {
  store_->bound_lights(clusters, atmosphere, step, lamp_leg);
}
const FogUpdateStatistics& FogUpdater::statistics() const { return store_->statistics(); }

}  // namespace litfog
