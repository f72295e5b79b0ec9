// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "litfog/atmosphere.h"
#include "render/light/scene_lights.h"
#include "render/plan/view.h"

namespace litfog::render {

// How a light that is seen from afar is drawn as a point by peak: shaders/light_point.vert. Chosen by eye.
inline constexpr float kFullBrightness = 1 / 2000.f;  ///< attenuation at which a point has its full brightness: at
///< night an eye sees a light long before a surface lit by it
inline constexpr float kBrightestPoint = 1.5f;     ///< limit of a point's brightness, so that its core is white
inline constexpr float kHaloBrightness = 0.25f;    ///< in the middle, where the core has 1
inline constexpr float kPointPictureHeight = 720;  ///< pixels: picture height at which kPointRadius holds
inline constexpr float kPointRadius = 1.3f;        ///< pixels, at full brightness
inline constexpr float kMaxGlare = 8;              ///< largest radius with glare, in kPointRadius
inline constexpr float kPointRadii = 5;            ///< size of a point in radii: beyond 2.5 nothing of it is left

/// How a lamp is drawn by airlight (shaders/lamp_disc.vert): half of the width of its disc's edge in pixels. With this
/// one the pixels of the smallest discs, of a pixel's radius, add up to the same within 0.6 % wherever they lie.
inline constexpr float kDiscEdge = 1.25f;

/// The local lights whose points a frame draws.
struct PointList {
  std::vector<std::int32_t> lights;
  double hidden_by = 0;  ///< metres from the eye: no surface that is farther away hides a part of one of them
  std::size_t outside_view = 0;
  std::size_t hidden = 0;
};

/// Where points are seen from.
struct PointView {
  glm::dvec3 eye;
  glm::dvec3 forward;  ///< the camera's axis; unit
  Frustum frustum;
  double pixels_per_radian;  ///< at the picture's middle
  int height;                ///< of the picture, pixels
  double least_seen = 0;     ///< illuminance at the eye in the unit of colours; by airlight, dimmer lamps are left out
};

/// Leaves out lights outside the view, and lights whose points together add less than a budget to any pixel even if all
/// lie over each other. By peak a point is at most its brightness times 1 in its core and times kHaloBrightness in its
/// halo; by airlight a disc is nowhere brighter than the smallest one with its light. A cookie counts as 1 in the
/// brightness.
///
/// budget  linear light
PointList list_points(const SceneLights& lights, const Atmosphere& atmosphere, FogLighting fog_lighting,
                      const PointView& view, double budget);

/// Sums light by octaves of brightness, to leave out the dimmest octaves up to a budget.
class Octaves {
 public:
  void add(double light) { sums_[octave_of(light)] += light; }

  /// The largest limit, a power of 2, below which all light together is at most the budget.
  double least_kept(double budget) const {
    double sum = 0;
    std::size_t octave = 0;
    while (octave < sums_.size() && (sum += sums_[octave]) <= budget) ++octave;
    return std::ldexp(1.0, int(octave) + kFirst);
  }

 private:
  static constexpr int kFirst = -64;
  static std::size_t octave_of(double light) { return std::size_t(std::clamp(std::ilogb(light) - kFirst, 0, 95)); }

  std::array<double, 96> sums_{};
};

}  // namespace litfog::render
