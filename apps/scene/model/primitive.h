// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <span>

#include "scene/mesh.h"

namespace litfog::scene {

// Every mesh here has its tangents. Boxes, cylinders and lathes stand on y = 0 in the middle of x and z.

/// Adds a flat convex polygon, counter-clockwise seen from its front. uv is the position laid flat (walls: v = height,
/// u to the viewer's right; floors: u = x, v = -z), so that neighbours in one plane join without a seam.
void add_face(Mesh& mesh, std::span<const glm::vec3> corners);
inline void add_face(Mesh& mesh, std::initializer_list<glm::vec3> corners) {
  add_face(mesh, std::span<const glm::vec3>(corners.begin(), corners.size()));
}

Mesh make_box(const glm::vec3& size);

/// Adds a box between two corners.
void add_box(Mesh& mesh, const glm::vec3& low, const glm::vec3& high, const glm::mat4& mesh_from_box);

/// A box whose edges and corners are cut off at 45 degrees. bevel < half of the smallest side.
Mesh make_bevelled_box(const glm::vec3& size, float bevel);

/// A squared bar from one point to another; `up` (not parallel to it) is the direction of its height. v runs along
/// it, as grain does.
Mesh make_beam(const glm::vec3& from, const glm::vec3& to, float width, float height,
               const glm::vec3& up = glm::vec3(0, 1, 0));

struct Cylinder {
  float bottom_radius = 0.5f;
  float top_radius = 0.5f;  ///< 0: a cone
  float height = 1.0f;
  int segments = 12;
};
Mesh make_cylinder(const Cylinder& cylinder);

/// Turns a profile of (radius, y) points, in order with the outside on the right (upwards for a post), about the Y
/// axis. Corners sharper than 40 degrees stay sharp.
Mesh make_lathe(std::span<const glm::vec2> profile, int segments);
inline Mesh make_lathe(std::initializer_list<glm::vec2> profile, int segments) {
  return make_lathe(std::span<const glm::vec2>(profile.begin(), profile.size()), segments);
}

/// Centred on the origin.
Mesh make_sphere(float radius, int segments);

/// Sweeps a profile of (right, up) points, in order with the outside on the right, along a path. `up` must not be
/// parallel to it. Corners of the profile sharper than 40 degrees stay sharp. u runs to the right, v along.
Mesh make_sweep(std::span<const glm::vec2> profile, std::span<const glm::vec3> path,
                const glm::vec3& up = glm::vec3(0, 1, 0));
inline Mesh make_sweep(std::initializer_list<glm::vec2> profile, std::span<const glm::vec3> path,
                       const glm::vec3& up = glm::vec3(0, 1, 0)) {
  return make_sweep(std::span<const glm::vec2>(profile.begin(), profile.size()), path, up);
}

/// A round pipe along a path with one radius per point; both ends are closed unless the radius is 0 there.
Mesh make_tube(std::span<const glm::vec3> path, std::span<const float> radii, int segments);
Mesh make_tube(std::span<const glm::vec3> path, float radius, int segments);

/// A smooth surface through a grid of points (row by row); seen from its front, columns go to the right and rows
/// upwards. uv from the lengths along rows and columns.
Mesh make_surface(std::span<const glm::vec3> points, int columns);

/// A flat plate with its front at z = 0, facing +Z: a convex outline, counter-clockwise, and its rim and back.
Mesh make_plate(std::span<const glm::vec2> outline, float thickness);

}  // namespace litfog::scene
