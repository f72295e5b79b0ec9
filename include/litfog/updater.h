// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/fog.h"
#include "litfog/fog_light_block.h"
#include "litfog/intensity_bound.h"  // for callers: lights are skipped by this bound
#include "litfog/light.h"
#include "litfog/light_clusters.h"

namespace litfog {

/// A light that a FogUpdater holds. Valid until the light is removed; later calls with it throw.
struct FogLightHandle {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;  ///< 0: no light

  friend bool operator==(const FogLightHandle&, const FogLightHandle&) = default;
};

/// Entries [begin, end) of a table.
struct EntryRange {
  std::size_t begin;
  std::size_t end;

  friend bool operator==(const EntryRange&, const EntryRange&) = default;
};

/// What all orders of scattering take of the lights of a kind: members of their ScatteringSource
/// (litfog/multiple_scattering.h), rounded, at most the largest float.
struct FogLightSource {
  float intensity = 0;   ///< m^2; 0 of kinds of which no light is on
  float soft_range = 0;  ///< metres

  friend bool operator==(const FogLightSource&, const FogLightSource&) = default;
};

/// The ranges of each table that must be uploaded again: sorted, disjoint, joined over gaps that cost less than a call.
struct FogLightChanges {
  std::span<const EntryRange> kinds;
  std::span<const EntryRange> instances;
  std::span<const EntryRange> sources;  ///< none unless they are solved

  bool empty() const { return kinds.empty() && instances.empty() && sources.empty(); }
};

/// What the last set_atmosphere or set_fog did.
struct FogUpdateStatistics {
  std::size_t kinds_solved = 0;
  std::size_t kinds_skipped = 0;   ///< the other kinds held: not carried, unchanged, dark, or bounded below the budget
  std::size_t lights_skipped = 0;  ///< lights switched off, black, or of a skipped kind
  std::size_t bytes_dirty = 0;     ///< size of the ranges returned, in all tables
  std::size_t sources_solved = 0;  ///< kinds whose source was solved
};

/// Default skip budget, in 1/255: half a step of an 8-bit picture.
inline constexpr double kDefaultSkipBudget255 = 0.5;

/// Default step that all lights together stay below where they are left out: half a step of an 8-bit picture.
inline constexpr double kDefaultReachStep = kDefaultSkipBudget255 / 255;

/// Keeps the lights of a scene as the shaders' tables (litfog/fog_light_block.h), which follow every change of the
/// visibility at a cost for each kind of light, not for each light.
///
/// The caller adds, changes, switches and removes lights, then calls set_atmosphere or set_fog once a frame and uploads
/// the ranges that it returns, by litfog::gl or otherwise. Lights that agree in all but name, colour, flash, position
/// and direction share a kind, which the updater finds by itself and drops with the last of its lights.
/// - A change of the fog or its layers touches kinds and their sources alone, one of the phase function sources alone.
///   A kind is solved once, however many lights it has.
/// - A change of the time touches the instances whose lamps begin or end a flash: their colour. Nothing is solved.
/// - An instance is touched only where its light is added, changed, switched, removed or flashes. It keeps its index
///   among the instances until it is removed, whatever its kind; then the index goes to the next light added. Instances
///   and kinds that are not used are all zero; such an instance is a black light.
/// - Kinds that are not carried have no intensity (see pack_fog_light_kind); it is never solved.
/// - A kind is not solved, and stores intensity 0, where IntensityBound times the largest colour component among its
///   lights that are on, in the brightest of their flashes, is below the budget: a pixel loses less than the budget for
///   each such light.
///
/// memory   add(), change() and bound_lights() alone allocate. One that throws std::bad_alloc has changed nothing
/// threads  different updaters: any at once. One updater: its const calls at once, every other call alone
class FogUpdater {
 public:
  /// skip_budget_255  1/255, finite, >= 0; 0 skips no kind that is carried and has a light that is on and not black
  /// throws           std::invalid_argument naming field, value and rule
  explicit FogUpdater(double skip_budget_255 = kDefaultSkipBudget255);
  ~FogUpdater();

  /// A moved-from updater may only be assigned to or destroyed.
  FogUpdater(FogUpdater&&) noexcept;
  FogUpdater& operator=(FogUpdater&&) noexcept;

  /// Adds a light, switched on. It is in the tables after the next set_atmosphere or set_fog, like every change below.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  FogLightHandle add(const PlacedLight& light);

  /// Replaces a light. If it is switched off, it stays so.
  ///
  /// throws  std::invalid_argument naming field, value and rule
  void change(FogLightHandle handle, const PlacedLight& light);

  /// The instance of a light that is off is black. Allocates nothing.
  ///
  /// throws  std::invalid_argument if the handle is of no light held
  void switch_light(FogLightHandle handle, bool is_on);

  /// Moves the time, which is 0 before the first call: lights that flash take the colour that they have then. Allocates
  /// nothing. Takes time for each light that flashes.
  ///
  /// seconds  [0, kMaxFlashSeconds]
  /// throws   std::invalid_argument naming field, value and rule
  void set_time(double seconds);

  /// throws  std::invalid_argument if the handle is of no light held
  void remove(FogLightHandle handle);

  /// Brings the tables up to date with the air (clear before the first call) and with all changes of lights since the
  /// last call. Intensities of kinds are those in the fog at the eye's height, Atmosphere::fog_at(), which carried
  /// lamps light. Allocates nothing. Takes time for each kind and each changed light (`litfog-bench update`).
  ///
  /// eye_height  metres; it counts in layers alone
  /// returns     ranges that cover every entry that has changed or is new since the last call; valid until the next
  ///             call that is not const
  /// throws      std::invalid_argument naming field, value and rule
  FogLightChanges set_atmosphere(const Atmosphere& atmosphere, double eye_height = 0);

  /// The same in uniform fog that is isotropic, which counts for the sources alone.
  FogLightChanges set_fog(const Fog& fog) { return set_atmosphere({.fog = fog}); }

  /// The tables. They grow with the lights and do not shrink.
  std::span<const FogLightKind> kinds() const;
  std::span<const FogLightInstance> instances() const;

  /// Lets set_atmosphere and set_fog solve the source of each kind, too, carried or not, whatever the budget. Allocates
  /// nothing.
  void solve_sources();

  /// What scattering_source() has of each kind's lights: in layers, in the densest fog. Empty unless they are solved.
  std::span<const FogLightSource> sources() const;

  /// Index of a light among the instances.
  ///
  /// throws  std::invalid_argument if the handle is of no light held
  std::size_t instance_of(FogLightHandle handle) const;

  /// Index of a light's kind.
  ///
  /// throws  std::invalid_argument if the handle is of no light held
  std::size_t kind_of(FogLightHandle handle) const;

  /// The range of a kind's lights beyond which all lights together add less than a step to surfaces and airlight:
  /// light_reach() in the thinnest fog, by reach_budget() for the kind's brightest light, with colours and flashes
  /// as the floats that instances have. Not for litfog_light_fog(), which has no range.
  ///
  /// kind     below the number of kinds
  /// returns  metres, [0, extent]; 0 where no light of the kind is on
  /// throws   std::invalid_argument naming field, value and rule
  double reach_of_kind(std::size_t kind, const Atmosphere& atmosphere, double step = kDefaultReachStep,
                       LampLeg lamp_leg = LampLeg::fogged) const;

  /// Gives clusters the bounds of all instances, by their indices, each within the reach of its kind; lights that are
  /// off have a range of 0. Once a frame, before LightClusters::update().
  ///
  /// throws  std::invalid_argument naming field, value and rule
  void bound_lights(LightClusters& clusters, const Atmosphere& atmosphere, double step = kDefaultReachStep,
                    LampLeg lamp_leg = LampLeg::fogged) const;

  const FogUpdateStatistics& statistics() const;

 private:
  class Store;
  std::unique_ptr<Store> store_;
};

}  // namespace litfog
