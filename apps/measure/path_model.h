// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "litfog/airlight.h"
#include "litfog/multiple_scattering.h"
#include "measure/reference_light.h"
#include "measure/reference_shadow.h"
#include "render/gpu/geometry_buffer.h"
#include "render/renderer.h"

namespace litfog::measure {

/// A point of a surface as the Basic model takes it (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", section
/// 5.2).
struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;  ///< unit
  glm::dvec3 to_eye;  ///< unit
  glm::dvec3 emissive;
  glm::dvec3 ambient;  ///< reflectance of ambient light
  glm::dvec3 diffuse;
  glm::dvec3 specular;  ///< 0 if the path has no highlights
  double shininess;
  double vertex_moon_cosine;  ///< normal . moon direction at the vertices, interpolated
};

/// A ray from a light to a position.
struct LightRay {
  glm::dvec3 direction;  ///< unit
  double range;          ///< metres
};
inline constexpr double kAnyRange = std::numeric_limits<double>::infinity();
/// The ray to a position within a range. Nothing for positions beyond, or at the light, where there is no direction.
std::optional<LightRay> ray_within(double range, const ReferenceLight& light, const glm::dvec3& position);

/// The fog before a position: over(colour) is the colour behind it as the eye sees it.
struct Veil {
  glm::dvec3 color;
  double opacity;

  glm::dvec3 over(const glm::dvec3& color_behind) const { return glm::mix(color_behind, color, opacity); }
};

/// The formulas of a renderer's lighting path in double, as in the papers: no maps, no tessellation, no skipping. Every
/// light is evaluated at every sample, except airlight that is proved to be negligible.
class PathModel {
 public:
  /// renderer  must outlive this object
  explicit PathModel(const render::Renderer& renderer);

  const std::vector<ReferenceLight>& lights() const { return lights_; }
  const render::LightingPath& path() const { return path_; }
  const scene::Environment& environment() const { return environment_; }

  /// sample  of a surface, not the sky
  SurfacePoint surface_point(const render::GeometrySample& sample) const;

  /// Radiance of a surface towards the eye, before fog: without_lamps + sum of color * emitted * falloff * reflectance
  /// over the lights that no shadow hides.
  glm::dvec3 surface_color(const SurfacePoint& point) const;
  /// A surface's emissive, ambient, directional and scattered light.
  glm::dvec3 without_lamps(const SurfacePoint& point) const;
  /// A light's attenuation by the path's range law and, by airlight, by the fog between the light and a height at that
  /// range; 0 beyond its extent.
  double falloff(const ReferenceLight& light, double height, double range) const;
  /// The fraction of the light from a unit direction that the surface reflects.
  glm::dvec3 reflectance(const SurfacePoint& point, const glm::dvec3& to_light) const;
  /// The specular part of reflectance(), as if the surface faced the light.
  glm::dvec3 highlight(const SurfacePoint& point, const glm::dvec3& to_light) const;

  /// Whether a point is in a light's shadow.
  bool is_in_shadow(const SurfacePoint& point, const ReferenceLight& light) const {
    return light.casts_shadows && shadows_->is_dark(light, point.position);
  }
  /// Whether a point is so near to a shadow's edge that a shadow map may put it on the other side.
  bool is_at_shadow_edge(const SurfacePoint& point, const ReferenceLight& light) const {
    return light.casts_shadows && shadows_->is_at_edge(light, point.position, point.normal);
  }

  /// Whether a point is in the directional light's shadow, or at its edge.
  bool is_in_moon_shadow(const SurfacePoint& point) const {
    return shadows_ && shadows_->is_dark_to_moon(point.position);
  }
  bool is_at_moon_shadow_edge(const SurfacePoint& point) const {
    return shadows_ && shadows_->is_at_moon_edge(point.position, point.normal);
  }
  /// The directional light that a surface reflects, ignoring shadows.
  glm::dvec3 moonlight(const SurfacePoint& point) const;

  Veil veil(const glm::dvec3& position) const;
  /// The directional light's airlight before a position, without shafts.
  glm::dvec3 moon_airlight(const glm::dvec3& position) const;
  /// The same along a ray to the sky with a length in the fog, metres: up to where moonlight enters.
  glm::dvec3 moon_airlight_before_sky(const glm::dvec3& direction, double range) const;
  /// The opacity of the fog between the eye and a position.
  double opacity_before(const glm::dvec3& position) const;
  const glm::dvec3& eye() const { return eye_; }  ///< relative to the renderer's origin
  /// The renderer's atmosphere, its heights relative to the renderer's origin.
  const Atmosphere& atmosphere() const { return atmosphere_; }
  /// Whether a light lights the fog. Only then is it visible in `veil`.
  bool lights_fog(const ReferenceLight& light) const { return path_.has_lit_fog && light.fog_intensity > 0; }
  /// The airlight of all lights along a ray from the eye, by the definition's integral, minus shafts of shadow; 0 if
  /// the renderer lights the fog otherwise. All that it leaves out is less than kAirlightBudget of the renderer's
  /// white; all that the lights' ends cut off is less than kCutOff of it.
  ///
  /// direction  unit
  glm::dvec3 airlight(const glm::dvec3& direction, double length) const;
  static constexpr double kAirlightBudget = 1e-6;

 private:
  /// The light of all lamps that the fog scatters onto a point.
  glm::dvec3 scattered_light(const SurfacePoint& point) const;
  /// The airlight of a light of colour 1.
  double airlight(const ReferenceLight& light, const EyeRay& ray) const;

  const render::RenderSettings& settings_;
  const render::LightingPath& path_;
  const scene::Environment& environment_;
  Atmosphere atmosphere_;
  std::vector<scene::Material> materials_;
  std::vector<ReferenceLight> lights_;
  std::optional<ScatteringTable> scattering_;  // higher orders
  Atmosphere moonlit_air_;
  bool is_fog_moonlit_;
  double airlight_budget_;
  std::optional<ReferenceShadows> shadows_;
  glm::dvec3 eye_;
  glm::dvec3 forward_;  // unit: the camera's axis
};

/// Finds the samples whose side of a jump of the model depends on the rounding of floats: at a light's extent, at the
/// edge of a cosine cone, where a surface with highlights just turns away, and where fog seen from above ends at the
/// horizon; or on the texels of a shadow map, near a shadow's edge (ReferenceShadows::kEdgeTexels). Jumps too small to
/// be seen do not count.
class JumpWatch {
 public:
  /// model  must outlive this object
  explicit JumpWatch(const PathModel& model) : model_(model) {}

  /// Whether the light that a surface sends to the eye jumps.
  bool is_at_jump(const SurfacePoint& point) const;
  /// Whether the fog before a position jumps.
  bool is_at_jump(const Veil& veil, const glm::dvec3& position) const;
  /// Whether the fog before the sky jumps in a direction: whether rounding decides its side of the horizon. The fog's
  /// top is `fog_above_eye` metres above the eye.
  bool is_at_fog_horizon(double fog_above_eye, const glm::dvec3& direction) const;

 private:
  bool is_at_jump(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const;
  bool is_at_shadow_edge(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const;

  const PathModel& model_;
};

/// The range of colours that a path with light maps may give a surface. A look-up lies between the light's values at
/// the texels around it. So the colour lies between the formulas' results for a light slightly nearer or farther, and
/// slightly nearer to its axis or farther from it.
class LookupBounds {
 public:
  /// model  of a path with light maps; must outlive this object
  LookupBounds(const PathModel& model, const render::PaperSettings& settings)
      : model_(model), cone_maps_(settings.cone_maps), texel_(2.0 / (settings.map_size - 1)) {}

  struct Interval {
    glm::dvec3 least;
    glm::dvec3 most;
  };
  /// Radiance of a surface towards the eye, before fog.
  Interval surface_color(const SurfacePoint& point) const;
  /// The colour of the fog before a position, on a path whose maps light the fog (LightingPath::has_mapped_fog).
  Interval fog_color(const glm::dvec3& position) const;

 private:
  struct Fractions {
    double least;
    double most;
  };
  Fractions emitted(const ReferenceLight& light, const glm::dvec3& direction) const;

  const PathModel& model_;
  render::ConeMaps cone_maps_;
  double texel_;  // size in a map's coordinates, which run from -1 to 1
};

}  // namespace litfog::measure
