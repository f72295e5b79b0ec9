// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_map.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "litfog/formulas.h"
#include "litfog/photometry/cube_face.h"

namespace litfog::render {
namespace {

std::uint16_t texel(double fraction) { return std::uint16_t(std::lround(std::clamp(fraction, 0.0, 1.0) * 65535)); }

/// The coordinate of texel i as P / E: -1 to 1.
double coordinate(int i, int size) { return 2.0 * i / (size - 1) - 1; }

bool is_boundary(int i, int size) { return i == 0 || i == size - 1; }

/// The attenuation at a fraction of the extent, 0 beyond it.
double attenuation(const RangeProfile& profile, double fraction) {
  if (fraction > 1) return 0;
  return formulas::attenuation(fraction, double(profile.constant), double(profile.linear), double(profile.quadratic));
}

}  // namespace

RangeProfile range_profile(const Attenuation& attenuation, double extent) {
  if (std::isinf(extent)) return {float(attenuation.constant), 0, 0};
  return {float(attenuation.constant), float(attenuation.linear * extent),
          float(attenuation.quadratic * extent * extent)};
}

MapTexels make_range_volume(const RangeProfile& profile, int size) {
  MapTexels texels;
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const bool is_dark = is_boundary(i, size) || is_boundary(j, size) || is_boundary(k, size);
        const glm::dvec3 p(coordinate(i, size), coordinate(j, size), coordinate(k, size));
        texels.push_back(is_dark ? 0 : texel(attenuation(profile, glm::length(p))));
      }
    }
  }
  return texels;
}

MapTexels make_distance_map(int size) {
  MapTexels texels;
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i)
      texels.push_back(texel(0.5 + 0.5 * std::hypot(coordinate(i, size), coordinate(j, size))));
  }
  return texels;
}

MapTexels make_range_map(const RangeProfile& profile, int size) {
  MapTexels texels;
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      const bool is_dark = is_boundary(i, size) || is_boundary(j, size);
      texels.push_back(is_dark ? 0 : texel(attenuation(profile, std::hypot(coordinate(i, size), coordinate(j, size)))));
    }
  }
  return texels;
}

int pair_size(int volume_size) { return int(std::sqrt(0.5 * volume_size * volume_size * volume_size)); }

MapTexels make_square_map(int size) {
  MapTexels texels;
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      texels.push_back(texel(coordinate(i, size) * coordinate(i, size) + coordinate(j, size) * coordinate(j, size)));
    }
  }
  return texels;
}

MapTexels make_square_ramp(int size) {
  MapTexels texels;
  for (int i = 0; i < size; ++i) texels.push_back(texel(coordinate(i, size) * coordinate(i, size)));
  return texels;
}

bool is_scaled(const Cone& cone, ConeMaps maps) {
  constexpr double kWidestEven = std::numbers::pi / 3;
  const double cutoff = cutoff_angle(cone);
  return maps == ConeMaps::even ? cutoff <= kWidestEven : cutoff < std::numbers::pi / 2;
}

double cone_map_scale(const Cone& cone, ConeMaps maps) {
  return is_scaled(cone, maps) ? std::tan(std::numbers::pi / 2 - cutoff_angle(cone)) : 1.0;
}

Cone mapped_cone(const Cone& cone, ConeMaps maps) {
  return maps == ConeMaps::one_disc && is_scaled(cone, maps) ? Cone::cosine(cutoff_angle(cone), 0) : cone;
}

MapTexels make_cone_cube(const Cone& cone, CubeAxis axis, int size, ConeMaps maps) {
  const double scale = cone_map_scale(cone, maps);
  const auto across = [&](int i) { return is_scaled(cone, maps) ? coordinate(i, size) : (2.0 * i + 1) / size - 1; };
  MapTexels texels;
  for (int face = 0; face < 6; ++face) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const glm::dvec3 looked_up = cube_direction({face, across(i), across(j)});
        const glm::dvec3 direction = axis == CubeAxis::plus_x
                                         ? glm::dvec3(looked_up.x, looked_up.y / scale, looked_up.z / scale)
                                         : glm::dvec3(-looked_up.z, looked_up.x / scale, looked_up.y / scale);
        texels.push_back(texel(cone_at(cone, direction.x / glm::length(direction))));
      }
    }
  }
  return texels;
}

MapTexels make_cookie_cube(const Cookie& cookie) {
  MapTexels texels;
  for (const float fraction : cookie.texels) texels.push_back(texel(double(fraction)));
  return texels;
}

double cone_coordinate_scale(const Cone& cone, int size, ConeMaps maps) {
  return is_scaled(cone, maps) ? cone_map_scale(cone, maps) * (size - 1) / size : 1.0;
}

}  // namespace litfog::render
