// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace litfog::scene {

/// A light's shape by direction, in place of a cone (Frazier 2000, "Neat Tricks Using the Spot Light"). The axis is -z,
/// y is up.
struct Cookie {
  int size = 0;  ///< texels along an edge
  /// Shares of the light, [0, 1]: 6 * size * size, faces +x -x +y -y +z -z, each with its rows and columns as
  /// glTexImage2D takes them.
  std::vector<float> texels;
};

/// The share that goes into a direction, between the nearest four texels of its face.
///
/// direction  not 0
double cookie_at(const Cookie& cookie, const glm::dvec3& direction);

/// Names of the patterns that need no file: a mirror ball's spots all around, and a beacon's two beams across its axis.
inline constexpr std::string_view kCookiePatterns[] = {"disco", "beacon"};

/// Paints one of them.
Cookie make_cookie(std::string_view pattern);

/// A cookie with other texels along an edge.
Cookie resized(const Cookie& cookie, int size);

/// Where cookies live on a light: right, up and back of its direction, turned about it to the right as seen along it.
///
/// direction  unit
/// roll       radians
glm::dmat3 cookie_from_world(const glm::dvec3& direction, double roll);

}  // namespace litfog::scene
