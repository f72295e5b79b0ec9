// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie.h"

#include <array>

#include "require.h"

namespace litfog {
namespace {

/// A face as three axes: its direction, and where s and t grow (OpenGL 4.6, table 8.19).
struct CubeFace {
  glm::dvec3 outwards, s, t;
};

constexpr std::array<CubeFace, 6> kFaces{{
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
}};

}  // namespace

Cookie bake_cookie(const IntensityDistribution& distribution, int size) {
  if (!(size >= 1 && size <= 4096)) require(ValueError{"size", double(size), "must be in [1, 4096]"});
  const double peak = find_peak(distribution).intensity;
  const auto texel_centre = [size](int i) { return (2 * i + 1) / double(size) - 1; };
  Cookie cookie{.size = size, .texels = {}};
  cookie.texels.reserve(kFaces.size() * std::size_t(size) * std::size_t(size));
  for (const auto& [outwards, s, t] : kFaces) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto direction = outwards + s * texel_centre(column) + t * texel_centre(row);
        cookie.texels.push_back(float(intensity_at(distribution, direction) / peak));
      }
    }
  }
  return cookie;
}

}  // namespace litfog
