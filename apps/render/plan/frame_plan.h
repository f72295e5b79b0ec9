// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "litfog/atmosphere.h"
#include "render/airlight/airlight_list.h"
#include "render/airlight/airlight_tiles.h"
#include "render/airlight/far_airlight_list.h"
#include "render/airlight/scattered_light_bound.h"
#include "render/light/point_list.h"
#include "render/light/scene_lights.h"
#include "render/plan/frame_counts.h"
#include "render/plan/view.h"
#include "render/render_settings.h"
#include "render/surface/surface_list.h"
#include "scene/scene.h"

namespace litfog::render {

/// A surface that a frame draws.
struct PlannedSurface {
  const Surface* surface;
  bool is_fog_alone;  ///< fog hides the surface: it is drawn as fog alone, which hides what is behind it
  int list_first;     ///< the surface's lights are list_count entries of the plan's light list from here on
  int list_count;
};

/// What a frame draws.
struct FramePlan {
  std::vector<PlannedSurface> surfaces;
  /// Instances of SceneLights: the carried lights, then the lights whose points are drawn, with the bits of their
  /// source radii behind them, then each surface's lights.
  std::vector<std::int32_t> light_list;
  int point_first = 0;
  int point_count = 0;
  AirlightList airlights;         ///< airlight within the lights' extents
  AirlightTiles airlight_tiles;   ///< tiles of airlights
  FarAirlightList far_airlights;  ///< airlight beyond the lights' extents
  HigherOrders higher_orders;     ///< for all lights
  FrameCounts counts;

  std::span<const std::int32_t> points() const {
    return std::span(light_list).subspan(std::size_t(point_first), std::size_t(point_count));
  }
  std::span<const std::int32_t> lights_of(const PlannedSurface& surface) const {
    return std::span(light_list).subspan(std::size_t(surface.list_first), std::size_t(surface.list_count));
  }
};

/// Exposures that culling must respect, EV: [-kMaxExposure, kMaxExposure].
struct FrameExposures {
  double surfaces;  ///< also for sky and points
  double airlight;

  friend bool operator==(const FrameExposures&, const FrameExposures&) = default;
};

/// The view of a frame.
struct FrameView {
  scene::Camera camera;  ///< relative to SceneLights::origin(), as are the matrix and the slope
  glm::mat4 clip_from_world;
  double highest_slope;      ///< largest y of the unit directions from the eye into the picture
  glm::ivec2 picture_size;   ///< pixels
  double pixels_per_radian;  ///< at the picture's centre
  FrameExposures exposures;

  friend bool operator==(const FrameView&, const FrameView&) = default;
};

/// Plans frames of a scene. Leaves out what is outside the view, out of reach or hidden by fog, so that no pixel of the
/// display changes by more than a step, 1/255 (hidden_range.h divides the step). Calls no GL.
///
/// A surface sends the eye at most this radiance: its own light, plus each lamp's light at the surface's point nearest
/// to the lamp, plus the light that fog scatters on it (ScatteredLightBound), all times f at its nearest distance from
/// the eye.
///
/// If this is below kHiddenShare, only the fog before the surface is drawn, at the surface's depth, so everything
/// before and behind it looks the same. The surface is left out altogether if airlight, points, sky and brighter
/// surfaces behind it are invisible too: the picture's background is the colour of the fog.
///
/// Hales's term depends on the position. So nothing is left out where the cone of a carried light meets the rays
/// through the surface, at the surface or behind it. The picture would change: seen from the light, two points of a ray
/// at ranges of at least r are up to delta / r apart, where delta is the distance from the eye to the light. For a
/// headlight 1 m beside the eye, with a slope of some 10 a radian, an eighth of a step would need r > 100 km.
///
/// Fog hides neither surfaces nor their lights on paths without this bound (LightingPath::has_light_bound), nor where
/// lights have an ambient colour, which the bound does not cover. Where light maps light the fog before a surface, the
/// surface is drawn whole, because fog alone uses the cones' formula.
class FramePlanner {
 public:
  /// scene, lights, surfaces  must outlive this object
  FramePlanner(const scene::Scene& scene, const SceneLights& lights, const SurfaceList& surfaces,
               const RenderSettings& settings);

  /// Sets the atmosphere. Must also be called after a change of lights or surfaces.
  ///
  /// is_fog_lit     whether carried lights light the fog by their intensity
  /// shaft_casters  as in list_airlight(); must stay valid until the next call
  void set_atmosphere(const Atmosphere& atmosphere, bool is_fog_lit, std::span<const std::int32_t> shaft_casters);

  /// Plans a frame. Without a change of view or environment the plan stays the same, and has_changed() is false. Valid
  /// until the next call.
  const FramePlan& plan(const FrameView& view);
  /// Forces the next plan() to make a new plan.
  void forget() { view_.reset(); }
  /// Counts the scene's lights by how the last plan uses them.
  LightCounts count_lights() const;
  bool has_changed() const { return has_changed_; }

  /// A plan of all surfaces in view, without lights.
  FramePlan plan_geometry(const glm::mat4& clip_from_world) const;

 private:
  /// Cached per surface: upper bound of the light that it sends to the eye, without the fog before it.
  struct SurfaceFogState {
    unsigned fog_number = 0;  // fog_number_ for which the state holds
    float brightness = 0;
  };

  struct SurfaceInView {
    std::size_t surface;
    double nearest, farthest, hidden_range;  // metres from the eye
  };

  void make_plan(const FrameView& view);
  void plan_airlight(const FrameView& view);
  void plan_everything();
  void plan_visible(const FrameView& view);
  void add_points(const PointList& points);
  std::vector<SurfaceInView> find_surfaces_in_view(const glm::dvec3& eye, const Frustum& frustum);
  /// The cached brightness of a surface. Also updates its strengths_.
  double brightness_of(std::size_t surface);
  /// Uniform fog no thicker than the air between a height and a box.
  Fog fog_before(double height, const scene::Bounds& box) const;
  /// Whether carried lights can light the fog by their intensity on a ray through the surface, beyond a range.
  bool can_be_lit_from(const glm::dvec3& eye, const Surface& surface, double range) const;
  /// PointView::least_seen.
  double least_seen() const;
  double airlight_end_from(const glm::dvec3& eye, double budget) const;
  double sky_brightness() const;
  /// Upper bound of the directional light's airlight along any ray; 0 if it lights no fog.
  double moonlight_in_fog() const;
  /// Appends the surface's lights that fog does not hide to the plan's list.
  PlannedSurface list_lights(std::size_t surface, double most_left_out);

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const SurfaceList& surfaces_;
  RenderSettings settings_;
  Atmosphere atmosphere_;
  bool is_fog_lit_ = false;
  std::span<const std::int32_t> shaft_casters_;
  unsigned fog_number_ = 1;
  ScatteredLightBound scattered_bound_;  // for surfaces
  double step_ = 0;
  std::vector<SurfaceFogState> fog_states_;  // one a surface
  std::vector<float> strengths_;  // light by each entry of SurfaceList::lists(), before the fog towards the eye
  std::vector<float> sorted_;     // scratch
  std::optional<FrameView> view_;
  scene::Environment environment_;  // the last plan's
  bool has_changed_ = false;
  FramePlan plan_;
};

}  // namespace litfog::render
