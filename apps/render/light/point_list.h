// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "litfog/fog.h"
#include "render/light/scene_lights.h"
#include "render/plan/frustum.h"

namespace litfog::render {

// How a light that is seen from afar is drawn as a point: shaders/light_point.vert. Chosen by eye.
inline constexpr float kFullBrightness = 1 / 2000.f;  ///< attenuation at which a point has its full brightness: at
///< night an eye sees a light long before a surface lit by it
inline constexpr float kBrightestPoint = 1.5f;     ///< limit of a point's brightness, so that its core is white
inline constexpr float kHaloBrightness = 0.25f;    ///< in the middle, where the core has 1
inline constexpr float kPointPictureHeight = 720;  ///< pixels: picture height at which kPointRadius holds
inline constexpr float kPointRadius = 1.3f;        ///< pixels, at full brightness
inline constexpr float kMaxGlare = 8;              ///< largest radius with glare, in kPointRadius
inline constexpr float kMaxWithoutGlare = 1.5f;    ///< largest radius without glare, in kPointRadius
inline constexpr float kPointRadii = 5;            ///< size of a point in radii: beyond 2.5 nothing of it is left

/// The local lights whose points a frame draws.
struct PointList {
  std::vector<std::int32_t> lights;
  double farthest = 0;  ///< metres from the eye to the farthest of them
  std::size_t outside_view = 0;
  std::size_t hidden = 0;
};

/// Leaves out lights outside the view, and lights whose points together add less than a budget to any pixel even if all
/// lie over each other. A point is at most its brightness times 1 in its core and times kHaloBrightness in its halo. A
/// cookie counts as 1 in the brightness.
///
/// budget  linear light
PointList list_points(const SceneLights& lights, const Fog& fog, const glm::dvec3& eye, const Frustum& frustum,
                      double budget);

/// A surface hides no part of a point that is nearer by this factor. All of a point is drawn at the depth of its
/// middle: the range times the cosine between its ray and the camera's axis. Within a point that spans h to either
/// side, as a tangent, the cosine changes by a factor of at most 1 + h.
///
/// field_of_view  vertical, radians
/// height         pixels
double point_depth_factor(double field_of_view, int height);

}  // namespace litfog::render
