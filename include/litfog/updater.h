// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "litfog/fog.h"
#include "litfog/fog_light_block.h"
#include "litfog/intensity_bound.h"  // by which lights are skipped: for callers to ask the same
#include "litfog/light.h"

namespace litfog {

/// A light that a FogUpdater holds. Valid until the light is removed; later calls with it throw.
struct FogLightHandle {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;  ///< 0: of no light

  friend bool operator==(const FogLightHandle&, const FogLightHandle&) = default;
};

/// Entries [begin, end) of FogUpdater::entries().
struct EntryRange {
  std::size_t begin;
  std::size_t end;

  friend bool operator==(const EntryRange&, const EntryRange&) = default;
};

/// What the last set_fog did. A kind is a distinct (attenuation, threshold, density scale) of carried lights.
struct FogUpdateStatistics {
  std::size_t kinds_solved = 0;
  std::size_t kinds_skipped = 0;   ///< the other kinds held: unchanged, dark, or bounded below the budget
  std::size_t lights_skipped = 0;  ///< lights not carried, switched off, black, or of a skipped kind
  std::size_t entries_dirty = 0;   ///< entries in the ranges returned
};

/// Skip budget unless the updater is told otherwise, in 1/255: half a step of an 8-bit picture.
inline constexpr double kDefaultSkipBudget255 = 0.5;

/// The lights of a scene as the shaders' parameters, kept up to date through every change of the visibility.
///
/// The caller adds, changes, switches and removes lights, then calls set_fog once a frame and uploads the entries of
/// the ranges it returns to a uniform, texture or storage buffer. It works only on what can change:
/// - each kind is solved once, however many lights it has, and not where nothing of it or of the fog has changed;
/// - lights that are not carried store no intensity (see pack_fog_light) and are never visited;
/// - a kind is not solved, and its lights store intensity 0, where IntensityBound times the largest colour component
///   among its lights that are on is below the budget: a pixel loses less than the budget for each such light;
/// - entries are touched only where the float that is stored changes.
/// A light keeps its entry until it is removed or changed into another kind. Entries of a kind lie together in pages
/// that grow with the kind (1, 2, 4, ... 1024 entries), so that a change of a kind dirties few ranges in any order of
/// adding, and the fewest if lights are added kind by kind. Kinds of up to eight lights leave no entry empty, others at
/// most a quarter; a removed light's entry goes to the next of its kind. Entries that hold no light are all zero, which
/// is a black light.
///
/// Different updaters may be used on different threads at once.
class FogUpdater {
 public:
  /// skip_budget_255  1/255, finite, >= 0; 0 skips no light that is on, carried and not black
  /// throws           std::invalid_argument naming field, value and rule
  explicit FogUpdater(double skip_budget_255 = kDefaultSkipBudget255);
  ~FogUpdater();

  /// A moved-from updater may only be assigned to or destroyed.
  FogUpdater(FogUpdater&&) noexcept;
  FogUpdater& operator=(FogUpdater&&) noexcept;

  /// Adds a light, switched on. Its entry is valid after the next set_fog; this holds for every change below, too.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  FogLightHandle add(const PlacedLight& light);

  /// Replaces a light. If it is switched off, it stays so.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  void change(FogLightHandle handle, const PlacedLight& light);

  /// The entry of a light that is off holds the colour black and intensity 0.
  ///
  /// throws  std::invalid_argument if the handle is of no light held
  void switch_light(FogLightHandle handle, bool is_on);

  /// throws  std::invalid_argument if the handle is of no light held
  void remove(FogLightHandle handle);

  /// Brings the entries up to date with the fog (clear air before the first call) and with all changes of lights since
  /// the last call. Allocates nothing.
  ///
  /// returns  what must be uploaded: sorted, disjoint ranges that cover every entry that has changed or is new since
  /// the
  ///          last call; joined over gaps that cost less than an upload call; valid until the next call
  /// throws   std::invalid_argument naming field, value and rule
  std::span<const EntryRange> set_fog(const Fog& fog);

  /// Grows with the lights; does not shrink.
  std::span<const FogLight> entries() const;

  /// Index of a light among the entries.
  ///
  /// throws  std::invalid_argument if the handle is of no light held
  std::size_t entry_of(FogLightHandle handle) const;

  const FogUpdateStatistics& statistics() const;

 private:
  class Store;
  std::unique_ptr<Store> store_;
};

}  // namespace litfog
