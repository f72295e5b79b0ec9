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

// How FogLighting::peak draws a distant light as a point (shaders/light_point.vert). Chosen by eye.
inline constexpr float kFullBrightness = 1 / 2000.f;  ///< attenuation at which a point has its full brightness: at
///< night an eye sees a light long before a surface lit by it
inline constexpr float kBrightestPoint = 1.5f;     ///< limit of a point's brightness, so that its core is white
inline constexpr float kHaloBrightness = 0.25f;    ///< at the centre, where the core has 1
inline constexpr float kPointPictureHeight = 720;  ///< pixels: picture height at which kPointRadius holds
inline constexpr float kPointRadius = 1.3f;        ///< pixels, at full brightness
inline constexpr float kMaxGlare = 8;              ///< largest radius with glare, in kPointRadius
inline constexpr float kPointRadii = 5;            ///< size of a point in radii: beyond 2.5 it is black

/// Half the width of the edge of a lamp's disc by airlight, pixels (shaders/lamp_disc.vert). With this width the pixels
/// of the smallest discs, one pixel in radius, add up to the same sum within 0.6 % at any subpixel position.
inline constexpr float kDiscEdge = 1.25f;

/// The local lights whose points a frame draws.
struct PointList {
  std::vector<std::int32_t> lights;
  double hidden_by = 0;  ///< metres from the eye; surfaces farther away hide no part of any of these points
  std::size_t outside_view = 0;
  std::size_t hidden = 0;
};

/// The view in which points are drawn.
struct PointView {
  glm::dvec3 eye;
  glm::dvec3 forward;  ///< the camera's axis; unit
  Frustum frustum;
  double pixels_per_radian;  ///< at the picture's centre
  int height;                ///< the picture's, pixels
  double least_seen = 0;     ///< illuminance at the eye in the unit of colours; by airlight, dimmer lamps are left out
};

/// Leaves out lights outside the view, and lights whose points together add less than a budget to any pixel even if
/// they all overlap. By peak a point adds at most its brightness times 1 in its core and times kHaloBrightness in its
/// halo. By airlight a disc is nowhere brighter than the smallest disc with the same light. A cookie counts as 1.
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
