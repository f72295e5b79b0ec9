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
#include "render/light/point_list.h"
#include "render/light/scene_lights.h"
#include "render/plan/frame_counts.h"
#include "render/plan/frustum.h"
#include "render/render_settings.h"
#include "render/surface/surface_list.h"
#include "scene/scene.h"

namespace litfog::render {

/// A surface that a frame draws.
struct PlannedSurface {
  const Surface* surface;
  bool is_fog_alone;  ///< the fog hides it: only what it hides is seen of it
  int list_first;     ///< in the plan's light list: the lights that light it, of which there are
  int list_count;
};

/// What a frame draws.
struct FramePlan {
  std::vector<PlannedSurface> surfaces;
  /// Instances of SceneLights: the carried lights, then those whose points are drawn, then the lights of each
  /// surface.
  std::vector<std::int32_t> light_list;
  int point_first = 0;
  int point_count = 0;
  AirlightList airlights;         ///< within the lights' extents
  AirlightTiles airlight_tiles;   ///< of them
  FarAirlightList far_airlights;  ///< beyond them
  FrameCounts counts;

  std::span<const std::int32_t> points() const {
    return std::span(light_list).subspan(std::size_t(point_first), std::size_t(point_count));
  }
  std::span<const std::int32_t> lights_of(const PlannedSurface& surface) const {
    return std::span(light_list).subspan(std::size_t(surface.list_first), std::size_t(surface.list_count));
  }
};

/// At which exposures a picture is shown as far as what it may leave out is concerned, EV: [-kMaxExposure,
/// kMaxExposure].
struct FrameExposures {
  double surfaces;  ///< and sky and points
  double airlight;

  friend bool operator==(const FrameExposures&, const FrameExposures&) = default;
};

/// Where a frame is seen from.
struct FrameView {
  scene::Camera camera;  ///< relative to SceneLights::origin(), as is what follows
  glm::mat4 clip_from_world;
  double highest_slope;       ///< largest y of a unit direction from the eye into the picture
  double point_depth_factor;  ///< point_list.h
  glm::ivec2 picture_size;    ///< pixels
  double pixels_per_radian;   ///< at the picture's middle
  FrameExposures exposures;

  friend bool operator==(const FrameView&, const FrameView&) = default;
};

/// Plans frames of a scene: what is outside the view, out of reach or hidden by fog is left out, so that no pixel of
/// the display changes by more than a step, 1/255 (hidden_range.h has the shares). Calls no GL.
///
/// Surfaces. What a surface sends to the eye is at most its own light and that of each lamp at the point nearest to the
/// lamp, times f at its nearest distance from the eye. If that is below the share, its fog alone is drawn, with its own
/// depth, so that all that is seen before and behind it stays as it is. If airlight and points from behind cannot be
/// seen either, nor sky or brighter surfaces, it is left out: the picture's background is the colour of the fog.
/// Hales's term depends on the position, so that nothing is left out where the cone of a carried light meets the rays
/// through the surface, there or behind it. Within a cone the picture would change: seen from the light, two points of
/// a ray at a range r or more are up to delta / r apart, delta from the eye to the light. A headlight 1 m beside the
/// eye, with a slope of some 10 a radian, would take r of more than 100 km for an eighth of a step.
/// Fog hides neither surfaces nor their lights on paths without such a bound (LightingPath::has_light_bound), nor where
/// lights have an ambient colour, which the bound leaves out. A surface before which light maps light the fog is drawn
/// whole, because fog alone has the cones' formula.
class FramePlanner {
 public:
  /// scene, lights, surfaces  have to outlive this
  FramePlanner(const scene::Scene& scene, const SceneLights& lights, const SurfaceList& surfaces,
               const RenderSettings& settings);

  /// Takes a change of the atmosphere, and of the lights and surfaces where they have changed.
  ///
  /// is_fog_lit     whether carried lights light it by their intensity
  /// shaft_casters  as list_airlight() takes them; have to outlive this or the next call
  void set_atmosphere(const Atmosphere& atmosphere, bool is_fog_lit, std::span<const std::int32_t> shaft_casters);

  /// Valid until the next call; the same where neither view nor environment has changed, with has_changed() false.
  const FramePlan& plan(const FrameView& view);
  /// Makes the next plan anew.
  void forget() { view_.reset(); }
  /// What the last plan makes of the lights that the scene has on.
  LightCounts count_lights() const;
  bool has_changed() const { return has_changed_; }

  /// All surfaces in view, without lights.
  FramePlan plan_geometry(const glm::mat4& clip_from_world) const;

 private:
  /// What a surface is in the fog.
  struct Foggy {
    unsigned fog = 0;  // number of the fog and the exposure
    float hidden_range = 0;
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
  /// From where on a surface is hidden, and how much each of its lights gives.
  double hidden_range_of(std::size_t surface);
  /// Whether carried lights can light the fog by their intensity on a ray through the surface, from a range on.
  bool can_be_lit_from(const glm::dvec3& eye, const Surface& surface, double range) const;
  double airlight_end_from(const glm::dvec3& eye, double budget) const;
  double sky_brightness() const;
  /// Appends a surface's lights to the plan's list except those that fog hides.
  PlannedSurface list_lights(std::size_t surface, double most_left_out);

  const scene::Scene& scene_;
  const SceneLights& lights_;
  const SurfaceList& surfaces_;
  RenderSettings settings_;
  Atmosphere atmosphere_;
  bool is_fog_lit_ = false;
  std::span<const std::int32_t> shaft_casters_;
  unsigned fog_number_ = 1;
  double step_ = 0;
  std::vector<Foggy> foggy_;      // one a surface
  std::vector<float> strengths_;  // of the surfaces' lists: what each light gives, before the fog on the eye's leg
  std::vector<float> sorted_;     // scratch
  std::optional<FrameView> view_;
  scene::Environment environment_;  // for which the last plan was made
  bool has_changed_ = false;
  FramePlan plan_;
};

}  // namespace litfog::render
