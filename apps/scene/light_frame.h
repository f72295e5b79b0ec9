// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace litfog::scene {

/// A viewpoint's attitude in the world, radians. Heading to the right of -Z, pitch up, roll to the right.
struct Attitude {
  double heading = 0;
  double pitch = 0;
  double roll = 0;
};

/// A direction seen from a viewpoint: radians. Azimuth to its right, elevation up.
struct Bearing {
  double azimuth = 0;
  double elevation = 0;
};
/// The bearing of a light's direction in the world, for a light without a viewpoint of its own.
///
/// direction  unit
Bearing bearing_of(const glm::dvec3& direction);

/// Rotation into a viewpoint's coordinates: x ahead, y to its left, z up.
glm::dmat3 viewpoint_from_world(const Attitude& viewpoint);

/// Rotation into light coordinates: x in the direction of the light, y to its left, z up. "Typically a spot light may
/// be defined relative to a viewpoint, with an azimuth and elevation. The viewpoint also may have heading, pitch, and
/// roll." (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Embedding Angle Attenuation
/// in a Texture Map")
glm::dmat3 light_from_world(const Bearing& light, const Attitude& viewpoint);

/// Rotation into the orthonormal basis of a light: x to its right, y up, -z along its direction (Ronald Frazier 2000,
/// "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", section "Filtering a Point Light into a Spot Light").
///
/// direction  unit
glm::dmat3 basis_from_world(const glm::dvec3& direction);

/// Rotation into the frame of a light's cookie: basis_from_world(), rolled about the direction, to the right as seen
/// along it.
///
/// direction  unit
/// roll       radians
glm::dmat3 cookie_from_world(const glm::dvec3& direction, double roll);

}  // namespace litfog::scene
