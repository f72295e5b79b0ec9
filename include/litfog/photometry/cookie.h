// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "litfog/value_error.h"

namespace litfog {

/// Largest number of texels along the edge of a cookie: 400 MB of texels.
inline constexpr int kMaxCookieSize = 4096;

/// A light's full angular shape as a cube map (Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights
/// in OpenGL"), looked up by directions in the light's frame: the axis is -z, like a placed light's default direction,
/// and +y is up.
struct Cookie {
  int size = 0;  ///< texels along an edge, [1, kMaxCookieSize]
  /// Intensity over the light's peak, [0, 1]: 6 * size * size texels, faces +x -x +y -y +z -z, with rows and columns in
  /// the order of glTexImage2D (OpenGL 4.6, table 8.19).
  std::vector<float> texels;
};

/// What is wrong with a cookie, or nothing.
std::optional<ValueError> find_error(const Cookie& cookie);

/// Samples a function at the centres of a cube map's texels.
///
/// size               [1, kMaxCookieSize]
/// fraction_towards   intensity over the peak, [0, 1], towards a direction of length 1 to sqrt(3)
/// throws             std::invalid_argument naming field, value and rule
Cookie make_cookie(int size, const std::function<double(const glm::dvec3& direction)>& fraction_towards);

/// The cookie of a measured light with an axis, in the frame of luminaire_from_light(axis).
///
/// size       [1, kMaxCookieSize]
/// axis       luminaire frame, of any length but 0
/// throws     std::invalid_argument naming field, value and rule
Cookie bake_cookie(const IntensityDistribution& distribution, int size, const glm::dvec3& axis = kPhotometricAxis);

/// Intensity over the light's peak towards a direction: bilinear between the four nearest texels of its face, like a
/// cube map without seamless filtering.
///
/// cookie     must pass find_error(); not checked here
/// direction  of any length but 0
double cookie_at(const Cookie& cookie, const glm::dvec3& direction);

/// A cookie resampled to another size, by cookie_at() at the new texels' centres.
Cookie resize_cookie(const Cookie& cookie, int size);

}  // namespace litfog
