// SPDX-License-Identifier: Apache-2.0
#include "scene/model/primitive.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace litfog::scene {
namespace {

constexpr float kCosCrease = 0.766f;  // 40 degrees
constexpr float kTwoPi = glm::two_pi<float>();

/// A point of a profile with its normal (outside on the right of the walk) and the length walked.
struct ProfileRow {
  glm::vec2 point;
  glm::vec2 normal;
  float length;
};

/// Two rows per segment: neighbours share a normal if the corner is soft.
std::vector<ProfileRow> profile_rows(std::span<const glm::vec2> profile) {
  std::vector<glm::vec2> normals;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const glm::vec2 along = glm::normalize(profile[i + 1] - profile[i]);
    normals.emplace_back(along.y, -along.x);
  }
  const bool closed = profile.size() > 2 && glm::distance(profile.front(), profile.back()) < 1e-6f;
  const std::size_t count = normals.size();
  const auto joined = [&](std::size_t a, std::size_t b) {
    return glm::dot(normals[a], normals[b]) > kCosCrease ? glm::normalize(normals[a] + normals[b]) : normals[a];
  };
  std::vector<ProfileRow> rows;
  float length = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const bool has_previous = i > 0 || closed;
    const bool has_next = i + 1 < count || closed;
    rows.push_back({profile[i], has_previous ? joined(i, (i + count - 1) % count) : normals[i], length});
    length += glm::distance(profile[i], profile[i + 1]);
    rows.push_back({profile[i + 1], has_next ? joined(i, (i + 1) % count) : normals[i], length});
  }
  return rows;
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Stitches two rows of vertices: `low` and `high` are the first of each, the front is where they run to the right.
void add_strip(Mesh& mesh, std::uint32_t low, std::uint32_t high, std::uint32_t count) {
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    add_triangle(mesh, low + i, low + i + 1, high + i + 1);
    add_triangle(mesh, low + i, high + i + 1, high + i);
  }
}

}  // namespace

void add_face(Mesh& mesh, std::span<const glm::vec3> corners) {
  glm::vec3 area(0.0f);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const glm::vec3 normal = glm::normalize(area);
  const bool wall = std::abs(normal.y) < 0.999f;
  const glm::vec3 right =
      glm::normalize(wall ? glm::cross(glm::vec3(0, 1, 0), normal) : glm::vec3(1, 0, 0) - normal * normal.x);
  const glm::vec3 up = glm::cross(normal, right);
  const auto first = std::uint32_t(mesh.vertices.size());
  for (const glm::vec3& corner : corners) {
    mesh.vertices.push_back({corner, normal, glm::vec4(right, 1.0f), {glm::dot(corner, right), glm::dot(corner, up)}});
  }
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) add_triangle(mesh, first, first + i, first + i + 1);
}

Mesh make_box(const glm::vec3& size) {
  const float x = 0.5f * size.x;
  const float y = size.y;
  const float z = 0.5f * size.z;
  Mesh mesh;
  add_face(mesh, {{-x, 0, z}, {x, 0, z}, {x, y, z}, {-x, y, z}});
  add_face(mesh, {{x, 0, -z}, {-x, 0, -z}, {-x, y, -z}, {x, y, -z}});
  add_face(mesh, {{x, 0, z}, {x, 0, -z}, {x, y, -z}, {x, y, z}});
  add_face(mesh, {{-x, 0, -z}, {-x, 0, z}, {-x, y, z}, {-x, y, -z}});
  add_face(mesh, {{-x, y, z}, {x, y, z}, {x, y, -z}, {-x, y, -z}});
  add_face(mesh, {{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}});
  return mesh;
}

void add_box(Mesh& mesh, const glm::vec3& low, const glm::vec3& high, const glm::mat4& mesh_from_box) {
  append(mesh, make_box(high - low),
         glm::translate(mesh_from_box, glm::vec3(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z))));
}

Mesh make_bevelled_box(const glm::vec3& size, float bevel) {
  const glm::vec3 half = 0.5f * size;
  const glm::vec3 lift(0.0f, half.y, 0.0f);
  Mesh mesh;
  // A corner (signs) has one point on each of the three faces that meet there: full out on `axis`, cut on the others.
  const auto point = [&](const glm::vec3& signs, int axis) {
    glm::vec3 p = signs * (half - bevel);
    p[axis] = signs[axis] * half[axis];
    return p + lift;
  };
  const auto add_outward = [&](std::vector<glm::vec3> corners) {
    const glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::dot(normal, corners[0] - lift) < 0.0f) std::reverse(corners.begin(), corners.end());
    add_face(mesh, corners);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    for (const float side : {-1.0f, 1.0f}) {
      const auto signs = [&](float sb, float sc) {
        glm::vec3 s;
        s[axis] = side;
        s[b] = sb;
        s[c] = sc;
        return s;
      };
      add_outward(
          {point(signs(-1, -1), axis), point(signs(1, -1), axis), point(signs(1, 1), axis), point(signs(-1, 1), axis)});
      // The edge between this face and the next axis's, running along c.
      for (const float sb : {-1.0f, 1.0f}) {
        add_outward(
            {point(signs(sb, -1), axis), point(signs(sb, 1), axis), point(signs(sb, 1), b), point(signs(sb, -1), b)});
      }
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 signs(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
    add_outward({point(signs, 0), point(signs, 1), point(signs, 2)});
  }
  return mesh;
}

Mesh make_beam(const glm::vec3& from, const glm::vec3& to, float width, float height, const glm::vec3& up) {
  const glm::vec3 along = glm::normalize(to - from);
  const glm::vec3 right = glm::normalize(glm::cross(along, up));
  const glm::vec3 above = glm::cross(right, along);
  const glm::mat4 turned(glm::vec4(right, 0.0f), glm::vec4(along, 0.0f), glm::vec4(above, 0.0f), glm::vec4(from, 1.0f));
  Mesh mesh;
  append(mesh, make_box({width, glm::distance(from, to), height}), turned);
  return mesh;
}

Mesh make_plate(std::span<const glm::vec2> outline, float thickness) {
  Mesh mesh;
  std::vector<glm::vec3> front;
  std::vector<glm::vec3> back;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    front.emplace_back(outline[i], 0.0f);
    back.emplace_back(outline[count - 1 - i], -thickness);
    const glm::vec3 here(outline[i], 0.0f);
    const glm::vec3 next(outline[(i + 1) % count], 0.0f);
    const glm::vec3 behind(0.0f, 0.0f, -thickness);
    add_face(mesh, {here, here + behind, next + behind, next});
  }
  add_face(mesh, front);
  add_face(mesh, back);
  return mesh;
}

Mesh make_cylinder(const Cylinder& cylinder) {
  std::vector<glm::vec2> profile;
  profile.emplace_back(0.0f, 0.0f);
  profile.emplace_back(cylinder.bottom_radius, 0.0f);
  if (cylinder.top_radius > 0.0f) profile.emplace_back(cylinder.top_radius, cylinder.height);
  profile.emplace_back(0.0f, cylinder.height);
  return make_lathe(profile, cylinder.segments);
}

Mesh make_lathe(std::span<const glm::vec2> profile, int segments) {
  Mesh mesh;
  const std::vector<ProfileRow> rows = profile_rows(profile);
  float widest = 0.0f;
  for (const glm::vec2& point : profile) widest = std::max(widest, point.x);
  // A whole number of metres or of sixteenths around would be needed for a seam that tiles; the seam faces +Z at angle
  // 0, which builders turn away.
  const auto columns = std::uint32_t(segments + 1);
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const ProfileRow& row : {rows[i], rows[i + 1]}) {
      const bool cap = std::abs(row.normal.y) > 0.95f;
      for (std::uint32_t k = 0; k < columns; ++k) {
        const float turn = kTwoPi * float(k) / float(segments);
        const float sine = std::sin(turn);
        const float cosine = std::cos(turn);
        const glm::vec3 position(row.point.x * sine, row.point.y, row.point.x * cosine);
        const glm::vec2 uv = cap ? glm::vec2(position.x, -position.z) : glm::vec2(widest * turn, row.length);
        mesh.vertices.push_back(
            {position, glm::normalize(glm::vec3(row.normal.x * sine, row.normal.y, row.normal.x * cosine)), {}, uv});
      }
    }
    // At the axis one triangle of each quad has no area.
    for (std::uint32_t k = 0; k + 1 < columns; ++k) {
      if (rows[i].point.x > 1e-6f) add_triangle(mesh, first + k, first + k + 1, first + columns + k + 1);
      if (rows[i + 1].point.x > 1e-6f) add_triangle(mesh, first + k, first + columns + k + 1, first + columns + k);
    }
  }
  compute_tangents(mesh);
  return mesh;
}

Mesh make_sphere(float radius, int segments) {
  std::vector<glm::vec2> profile;
  const int rings = std::max(3, segments / 2);
  for (int i = 0; i <= rings; ++i) {
    const float angle = glm::pi<float>() * float(i) / float(rings);
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0.0f : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return make_lathe(profile, segments);
}

Mesh make_sweep(std::span<const glm::vec2> profile, std::span<const glm::vec3> path, const glm::vec3& up) {
  Mesh mesh;
  const std::vector<ProfileRow> rows = profile_rows(profile);
  const auto stations = std::uint32_t(path.size());
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const ProfileRow& row : {rows[i], rows[i + 1]}) {
      float length = 0.0f;
      for (std::uint32_t k = 0; k < stations; ++k) {
        if (k > 0) length += glm::distance(path[k - 1], path[k]);
        const glm::vec3 along = glm::normalize(path[std::min(k + 1, stations - 1)] - path[k > 0 ? k - 1 : 0]);
        const glm::vec3 right = glm::normalize(glm::cross(along, up));
        const glm::vec3 above = glm::cross(right, along);
        mesh.vertices.push_back({path[k] + right * row.point.x + above * row.point.y,
                                 glm::normalize(right * row.normal.x + above * row.normal.y),
                                 {},
                                 {-row.length, length}});
      }
    }
    add_strip(mesh, first, first + stations, stations);
  }
  compute_tangents(mesh);
  return mesh;
}

Mesh make_tube(std::span<const glm::vec3> path, std::span<const float> radii, int segments) {
  Mesh mesh;
  const std::size_t stations = path.size();
  const auto columns = std::uint32_t(segments + 1);
  glm::vec3 right(0.0f);
  float length = 0.0f;
  const auto ring = [&](std::size_t k, const glm::vec3& along, const glm::vec3* cap_normal) {
    const glm::vec3 forward = glm::cross(right, along);
    for (std::uint32_t i = 0; i < columns; ++i) {
      const float turn = kTwoPi * float(i) / float(segments);
      const glm::vec3 out = right * std::cos(turn) + forward * -std::sin(turn);
      mesh.vertices.push_back(
          {path[k] + out * radii[k],
           cap_normal ? *cap_normal : out,
           {},
           cap_normal ? radii[k] * glm::vec2(std::cos(turn), std::sin(turn)) : glm::vec2(radii[0] * turn, length)});
    }
  };
  const auto add_cap = [&](std::size_t k, const glm::vec3& along, bool end) {
    if (radii[k] <= 0.0f) return;
    const glm::vec3 normal = end ? along : -along;
    const auto first = std::uint32_t(mesh.vertices.size());
    ring(k, along, &normal);
    for (std::uint32_t i = 1; i + 2 < columns; ++i) {
      add_triangle(mesh, first, first + (end ? i : i + 1), first + (end ? i + 1 : i));
    }
  };
  for (std::size_t k = 0; k < stations; ++k) {
    const glm::vec3 along = glm::normalize(path[std::min(k + 1, stations - 1)] - path[k > 0 ? k - 1 : 0]);
    // The frame is carried along, so that the pipe does not twist where it turns vertical.
    if (k == 0) right = std::abs(along.y) < 0.9f ? glm::cross(along, glm::vec3(0, 1, 0)) : glm::vec3(1, 0, 0);
    right = glm::normalize(right - along * glm::dot(right, along));
    if (k > 0) length += glm::distance(path[k - 1], path[k]);
    if (k == 0) add_cap(k, along, false);
    const auto first = std::uint32_t(mesh.vertices.size());
    ring(k, along, nullptr);
    if (k == 0) continue;
    const std::uint32_t before = first - columns;
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
      if (radii[k - 1] > 0.0f) add_triangle(mesh, before + i, before + i + 1, first + i + 1);
      if (radii[k] > 0.0f) add_triangle(mesh, before + i, first + i + 1, first + i);
    }
    if (k + 1 == stations) add_cap(k, along, true);
  }
  compute_tangents(mesh);
  return mesh;
}

Mesh make_tube(std::span<const glm::vec3> path, float radius, int segments) {
  return make_tube(path, std::vector<float>(path.size(), radius), segments);
}

Mesh make_surface(std::span<const glm::vec3> points, int columns) {
  Mesh mesh;
  const int rows = int(points.size()) / columns;
  const auto at = [&](int column, int row) { return points[std::size_t(row * columns + column)]; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const glm::vec3 across = at(std::min(i + 1, columns - 1), j) - at(std::max(i - 1, 0), j);
      const glm::vec3 upwards = at(i, std::min(j + 1, rows - 1)) - at(i, std::max(j - 1, 0));
      const std::size_t here = mesh.vertices.size();
      const float u = i == 0 ? 0.0f : mesh.vertices[here - 1].uv.x + glm::distance(at(i - 1, j), at(i, j));
      const float v =
          j == 0 ? 0.0f : mesh.vertices[here - std::size_t(columns)].uv.y + glm::distance(at(i, j - 1), at(i, j));
      mesh.vertices.push_back({at(i, j), glm::normalize(glm::cross(across, upwards)), {}, {u, v}});
    }
  }
  for (int j = 0; j + 1 < rows; ++j) {
    add_strip(mesh, std::uint32_t(j * columns), std::uint32_t((j + 1) * columns), std::uint32_t(columns));
  }
  compute_tangents(mesh);
  return mesh;
}

}  // namespace litfog::scene
