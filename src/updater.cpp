// SPDX-License-Identifier: Apache-2.0
#include "litfog/updater.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <glm/vec3.hpp>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <vector>

#include "litfog/batch.h"
#include "require.h"
#include "unchecked.h"

namespace litfog {
namespace {

constexpr std::uint32_t kNotCarried = 0;      // the kind of lights not carried
constexpr std::uint32_t kLargestPage = 1024;  // entries: 80 KiB, beside which an upload call costs nothing
constexpr std::size_t kJoinedGap = 128;       // entries: 10 KiB take about as long to upload as one more call, 1 us

float brightness_of(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

struct KindKey {
  Attenuation attenuation;
  double threshold;
  double density_scale;

  friend bool operator==(const KindKey&, const KindKey&) = default;
};
struct KindKeyHash {
  std::size_t operator()(const KindKey& key) const {
    std::size_t hash = 0;
    for (const double value : {key.attenuation.constant, key.attenuation.linear, key.attenuation.quadratic,
                               key.threshold, key.density_scale}) {
      hash = (hash ^ std::hash<double>{}(value)) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio (Knuth, TAOCP 3, 6.4)
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Lights that share an intensity. Every lit one, that is on and not black, has `intensity` in its entry, others 0.
struct Kind {
  KindKey key;
  IntensityBound bound;
  double extent;
  float intensity = 0;
  float brightest = 0;                ///< largest colour component among the lit lights
  std::uint32_t brightest_count = 0;  ///< lit lights that have it; 0: to be found again
  std::uint32_t lit_count = 0;
  std::uint32_t light_count = 0;
  bool has_changed = true;  ///< any of its lights since the last set_fog
  bool is_stored = true;    ///< false while set_fog has yet to write the intensity to the entries
  std::vector<std::uint32_t> pages = {};
  std::vector<std::uint32_t> free_entries = {};  ///< of its pages
};

/// A run of entries of one kind, or of none.
struct Page {
  std::uint32_t begin;
  std::uint32_t end;  ///< begin + a power of 2
  std::uint32_t dirty_begin;
  std::uint32_t dirty_end;  ///< at most dirty_begin where none is dirty
  std::uint32_t kind;       ///< the last that it was given to

  void mark_dirty(std::uint32_t first, std::uint32_t last) {
    dirty_begin = std::min(dirty_begin, first);
    dirty_end = std::max(dirty_end, last);
  }
  void mark_clean() {
    dirty_begin = end;
    dirty_end = begin;
  }
};

struct Record {
  std::uint32_t generation = 1;
  std::uint32_t kind = 0;
  std::uint32_t entry = 0;
  glm::vec3 color{0};  ///< as stored when on
  bool is_on = false;
  bool is_held = false;
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

}  // namespace

/// Everything of the updater; its public face forwards to the public calls here, which are documented there.
class FogUpdater::Store {
 public:
  explicit Store(double skip_budget_255);

  FogLightHandle add(const PlacedLight& light);
  void change(FogLightHandle handle, const PlacedLight& light);
  void switch_light(FogLightHandle handle, bool is_on);
  void remove(FogLightHandle handle);
  std::span<const EntryRange> set_fog(const Fog& fog);
  std::span<const FogLight> entries() const { return entries_; }
  std::size_t entry_of(FogLightHandle handle) const { return records_[slot_of(handle)].entry; }
  const FogUpdateStatistics& statistics() const { return statistics_; }

 private:
  std::uint32_t slot_of(FogLightHandle handle) const;
  std::uint32_t find_or_add_kind(const PlacedLight& placed);
  void enter(Record& record, std::uint32_t kind_index);
  void leave(const Record& record);
  void pack(Record& record, const PlacedLight& placed);
  void show(const Record& record);
  void hide(const Record& record);
  void add_page(std::uint32_t kind_index);
  Page& page_of(std::uint32_t entry);
  bool is_below_budget(Kind& kind, const Fog& seen_fog) const;
  void find_brightest(Kind& kind) const;
  static void set_intensity(Kind& kind, float intensity);
  void store_intensity(Page& page);
  std::span<const EntryRange> update_entries();

  double skip_budget_;
  Fog fog_;
  bool has_changed_ = false;  // any light since the last set_fog
  std::vector<FogLight> entries_;
  std::vector<Page> pages_;                    // in the order of their entries
  std::vector<std::uint32_t> free_pages_[11];  // by the logarithm of the size
  std::vector<Kind> kinds_;                    // the first is that of lights not carried: never solved, intensity 0
  std::vector<std::uint32_t> free_kinds_;
  std::unordered_map<KindKey, std::uint32_t, KindKeyHash> kind_of_key_;
  std::vector<Record> records_;
  std::vector<std::uint32_t> free_records_;
  std::size_t light_count_ = 0;
  Columns columns_;
  std::vector<EntryRange> ranges_;  // room for a range a page
  FogUpdateStatistics statistics_;
};

FogUpdater::Store::Store(double skip_budget_255) : skip_budget_(skip_budget_255 / 255) {
  if (!is_finite_and_not_negative(skip_budget_255)) {
    require(ValueError{"skip_budget_255", skip_budget_255, "must be finite and >= 0"});
  }
  kinds_.push_back({.key = {}, .bound = {Attenuation{}, kDefaultThreshold}, .extent = 0});
}

FogLightHandle FogUpdater::Store::add(const PlacedLight& light) {
  require(check(light));
  const std::uint32_t kind = find_or_add_kind(light);
  if (free_records_.empty()) {
    free_records_.push_back(std::uint32_t(records_.size()));
    records_.emplace_back();
  }
  const std::uint32_t slot = free_records_.back();
  free_records_.pop_back();
  Record& record = records_[slot];
  record.is_held = true;
  record.is_on = true;
  enter(record, kind);
  pack(record, light);
  ++light_count_;
  return {slot, record.generation};
}

void FogUpdater::Store::change(FogLightHandle handle, const PlacedLight& light) {
  Record& record = records_[slot_of(handle)];
  require(check(light));
  const std::uint32_t kind = find_or_add_kind(light);
  hide(record);
  if (kind != record.kind) {
    leave(record);
    enter(record, kind);
  }
  pack(record, light);
}

void FogUpdater::Store::switch_light(FogLightHandle handle, bool is_on) {
  Record& record = records_[slot_of(handle)];
  if (is_on == record.is_on) return;
  hide(record);
  record.is_on = is_on;
  show(record);
}

void FogUpdater::Store::remove(FogLightHandle handle) {
  Record& record = records_[slot_of(handle)];
  hide(record);
  leave(record);
  record.is_held = false;
  ++record.generation;
  free_records_.push_back(handle.slot);
  --light_count_;
}

std::span<const EntryRange> FogUpdater::Store::set_fog(const Fog& fog) {
  require(check(fog));
  const bool is_new_fog = fog != fog_;
  fog_ = fog;
  statistics_ = {.kinds_solved = 0,
                 .kinds_skipped = kinds_.size() - 1 - free_kinds_.size(),
                 .lights_skipped = light_count_,
                 .entries_dirty = 0};
  if (!is_new_fog && !has_changed_) return {};
  has_changed_ = false;
  std::size_t solved = 0;
  for (std::uint32_t i = kNotCarried + 1; i < kinds_.size(); ++i) {
    Kind& kind = kinds_[i];
    const bool is_due = is_new_fog || kind.has_changed;
    kind.has_changed = false;
    kind.is_stored = true;
    if (!is_due || kind.lit_count == 0) continue;
    const Fog seen_fog = unchecked::scaled(fog, kind.key.density_scale);
    if (is_below_budget(kind, seen_fog)) {
      set_intensity(kind, 0);
      continue;
    }
    columns_.constant[solved] = kind.key.attenuation.constant;
    columns_.linear[solved] = kind.key.attenuation.linear;
    columns_.quadratic[solved] = kind.key.attenuation.quadratic;
    columns_.threshold[solved] = kind.key.threshold;
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
  for (std::size_t i = 0; i < solved; ++i) {
    set_intensity(kinds_[columns_.kind[i]], float(columns_.intensity[i]));
  }
  return update_entries();
}

std::uint32_t FogUpdater::Store::slot_of(FogLightHandle handle) const {
  if (handle.slot >= records_.size() || !records_[handle.slot].is_held ||
      records_[handle.slot].generation != handle.generation) {
    require(ValueError{"handle.slot", double(handle.slot), "must be that of a light held"});
  }
  return handle.slot;
}

std::uint32_t FogUpdater::Store::find_or_add_kind(const PlacedLight& placed) {
  if (!placed.carried) return kNotCarried;
  const Light& light = placed.light;
  const KindKey key{light.attenuation, light.threshold, light.density_scale};
  if (const auto found = kind_of_key_.find(key); found != kind_of_key_.end()) return found->second;
  const Kind kind{.key = key,
                  .bound = {light.attenuation, light.threshold},
                  .extent = unchecked::compute_extent(light.attenuation, light.threshold)};
  std::uint32_t index = std::uint32_t(kinds_.size());
  if (free_kinds_.empty()) {
    kinds_.push_back(kind);
    columns_.resize(kinds_.size());
  } else {
    index = free_kinds_.back();
    free_kinds_.pop_back();
    kinds_[index] = kind;
  }
  kind_of_key_.emplace(key, index);
  return index;
}

/// Gives a light one of the entries of a kind.
void FogUpdater::Store::enter(Record& record, std::uint32_t kind_index) {
  Kind& kind = kinds_[kind_index];
  if (kind.free_entries.empty()) add_page(kind_index);
  record.kind = kind_index;
  record.entry = kind.free_entries.back();
  kind.free_entries.pop_back();
  ++kind.light_count;
}

/// Empties a light's entry. A kind's last light takes the kind with it; what is left of it is written over by the next.
void FogUpdater::Store::leave(const Record& record) {
  entries_[record.entry] = {};
  Kind& kind = kinds_[record.kind];
  kind.free_entries.push_back(record.entry);
  if (--kind.light_count > 0 || record.kind == kNotCarried) return;
  for (const std::uint32_t page : kind.pages)
    free_pages_[std::countr_zero(pages_[page].end - pages_[page].begin)].push_back(page);
  kind_of_key_.erase(kind.key);
  free_kinds_.push_back(record.kind);
}

/// Writes the entry of a hidden light.
void FogUpdater::Store::pack(Record& record, const PlacedLight& placed) {
  const Light& light = placed.light;
  const double extent =
      placed.carried ? kinds_[record.kind].extent : unchecked::compute_extent(light.attenuation, light.threshold);
  FogLight& entry = entries_[record.entry];
  entry =
      unchecked::pack_fog_light(placed, {.intensity = 0, .peak_range = 0, .extent = extent, .status = SolveStatus::ok});
  record.color = glm::vec3(entry.color_intensity);
  show(record);
}

/// Writes a light's colour and intensity, and counts it where it is lit.
void FogUpdater::Store::show(const Record& record) {
  Kind& kind = kinds_[record.kind];
  const glm::vec3 color = record.is_on ? record.color : glm::vec3{0};
  const float brightness = brightness_of(color);
  if (brightness > 0) {
    ++kind.lit_count;
    if (brightness > kind.brightest) {
      kind.brightest = brightness;
      kind.brightest_count = 1;
    } else if (brightness == kind.brightest) {
      ++kind.brightest_count;
    }
  }
  entries_[record.entry].color_intensity = {color, brightness > 0 ? kind.intensity : 0};
  page_of(record.entry).mark_dirty(record.entry, record.entry + 1);
  kind.has_changed = true;
  has_changed_ = true;
}

/// Undoes show's counting; the light leaves its entry, or is shown again.
void FogUpdater::Store::hide(const Record& record) {
  Kind& kind = kinds_[record.kind];
  const float brightness = record.is_on ? brightness_of(record.color) : 0;
  if (brightness > 0) {
    --kind.lit_count;
    if (brightness == kind.brightest) --kind.brightest_count;
  }
  page_of(record.entry).mark_dirty(record.entry, record.entry + 1);
  kind.has_changed = true;
  has_changed_ = true;
}

/// Adds a quarter to a kind's entries, down to a power of 2; at least 1 and at most the largest page.
void FogUpdater::Store::add_page(std::uint32_t kind_index) {
  Kind& kind = kinds_[kind_index];
  const std::uint32_t wanted = std::clamp(std::bit_floor(kind.light_count / 4), 1u, kLargestPage);
  std::vector<std::uint32_t>& free_pages = free_pages_[std::countr_zero(wanted)];
  if (free_pages.empty()) {
    const std::uint32_t begin = std::uint32_t(entries_.size());
    free_pages.push_back(std::uint32_t(pages_.size()));
    entries_.resize(begin + wanted);
    const std::uint32_t end = begin + wanted;
    pages_.push_back({.begin = begin, .end = end, .dirty_begin = begin, .dirty_end = end, .kind = kNotCarried});
    ranges_.reserve(pages_.capacity());
  }
  const std::uint32_t index = free_pages.back();
  free_pages.pop_back();
  kind.pages.push_back(index);
  pages_[index].kind = kind_index;
  for (std::uint32_t entry = pages_[index].end; entry-- > pages_[index].begin;) kind.free_entries.push_back(entry);
}

Page& FogUpdater::Store::page_of(std::uint32_t entry) {
  return *std::prev(std::ranges::upper_bound(pages_, entry, {}, &Page::begin));
}

bool FogUpdater::Store::is_below_budget(Kind& kind, const Fog& seen_fog) const {
  if (kind.brightest_count == 0) find_brightest(kind);
  return kind.bound.at(seen_fog) * kind.brightest < skip_budget_;
}

void FogUpdater::Store::find_brightest(Kind& kind) const {
  kind.brightest = 0;
  for (const std::uint32_t page : kind.pages) {
    for (std::uint32_t i = pages_[page].begin; i < pages_[page].end; ++i) {
      const float brightness = brightness_of(entries_[i].color_intensity);
      if (brightness > kind.brightest) {
        kind.brightest = brightness;
        kind.brightest_count = 0;
      }
      if (brightness > 0 && brightness == kind.brightest) ++kind.brightest_count;
    }
  }
}

void FogUpdater::Store::set_intensity(Kind& kind, float intensity) {
  kind.is_stored = intensity == kind.intensity;
  kind.intensity = intensity;
}

void FogUpdater::Store::store_intensity(Page& page) {
  Kind& kind = kinds_[page.kind];
  if (kind.is_stored) return;
  std::uint32_t first = page.end;
  std::uint32_t last = page.begin;
  for (std::uint32_t i = page.begin; i < page.end; ++i) {
    glm::vec4& color_intensity = entries_[i].color_intensity;
    if (!(brightness_of(color_intensity) > 0)) continue;
    color_intensity.w = kind.intensity;
    first = std::min(first, i);
    last = i + 1;
  }
  page.mark_dirty(first, last);
}

/// In the order of memory: kind by kind takes twice as long where kinds lie between each other.
std::span<const EntryRange> FogUpdater::Store::update_entries() {
  ranges_.clear();
  for (Page& page : pages_) {
    store_intensity(page);
    if (page.dirty_begin >= page.dirty_end) continue;
    if (!ranges_.empty() && page.dirty_begin - ranges_.back().end <= kJoinedGap) {
      ranges_.back().end = page.dirty_end;
    } else {
      ranges_.push_back({page.dirty_begin, page.dirty_end});
    }
    page.mark_clean();
  }
  for (const EntryRange& range : ranges_) statistics_.entries_dirty += range.end - range.begin;
  return ranges_;
}

FogUpdater::FogUpdater(double skip_budget_255) : store_(std::make_unique<Store>(skip_budget_255)) {}
FogUpdater::~FogUpdater() = default;
FogUpdater::FogUpdater(FogUpdater&&) noexcept = default;
FogUpdater& FogUpdater::operator=(FogUpdater&&) noexcept = default;

FogLightHandle FogUpdater::add(const PlacedLight& light) { return store_->add(light); }
void FogUpdater::change(FogLightHandle handle, const PlacedLight& light) { store_->change(handle, light); }
void FogUpdater::switch_light(FogLightHandle handle, bool is_on) { store_->switch_light(handle, is_on); }
void FogUpdater::remove(FogLightHandle handle) { store_->remove(handle); }
std::span<const EntryRange> FogUpdater::set_fog(const Fog& fog) { return store_->set_fog(fog); }
std::span<const FogLight> FogUpdater::entries() const { return store_->entries(); }
std::size_t FogUpdater::entry_of(FogLightHandle handle) const { return store_->entry_of(handle); }
const FogUpdateStatistics& FogUpdater::statistics() const { return store_->statistics(); }

}  // namespace litfog
