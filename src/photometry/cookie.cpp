// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie.h"

#include <algorithm>
#include <glm/common.hpp>

#include "litfog/photometry/cube_face.h"
#include "model/float_limit.h"
#include "model/require.h"

namespace litfog {
namespace {

constexpr int kFaceCount = 6;

std::size_t texel_count(int size) { return kFaceCount * std::size_t(size) * std::size_t(size); }

std::optional<ValueError> check_size(int size) {
  if (size >= 1 && size <= kMaxCookieSize) return std::nullopt;
  return ValueError{"size", double(size), "must be in [1, 4096]"};
}

}  // namespace

std::optional<ValueError> find_error(const Cookie& cookie) {
  if (const auto error = check_size(cookie.size)) return error;
  if (cookie.texels.size() != texel_count(cookie.size)) {
    return ValueError{"texels", double(cookie.texels.size()), "must be 6 * size * size"};
  }
  for (const float texel : cookie.texels) {
    if (!is_within(double(texel), 0, 1)) return ValueError{"texel", double(texel), "must be in [0, 1]"};
  }
  return std::nullopt;
}

Cookie make_cookie(int size, const std::function<double(const glm::dvec3& direction)>& fraction_towards) {
  require(check_size(size));
  const auto texel_centre = [size](int i) { return (2 * i + 1) / double(size) - 1; };
  Cookie cookie{.size = size, .texels = {}};
  cookie.texels.reserve(texel_count(size));
  for (int face = 0; face < kFaceCount; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const glm::dvec3 direction = cube_direction({face, texel_centre(column), texel_centre(row)});
        cookie.texels.push_back(float(fraction_towards(direction)));
      }
    }
  }
  return cookie;
}

Cookie bake_cookie(const IntensityDistribution& distribution, int size, const glm::dvec3& axis) {
  const double peak = find_peak(distribution).intensity;
  return make_cookie(size, [&, rotation = luminaire_from_light(axis)](const glm::dvec3& direction) {
    return intensity_at(distribution, rotation * direction) / peak;
  });
}

double cookie_at(const Cookie& cookie, const glm::dvec3& direction) {
  const CubePosition position = cube_position(direction);
  const int last = cookie.size - 1;
  const double x = std::clamp((position.u + 1) / 2 * cookie.size - 0.5, 0.0, double(last));
  const double y = std::clamp((position.v + 1) / 2 * cookie.size - 0.5, 0.0, double(last));
  const int left = int(x), top = int(y);
  const auto texel = [&](int column, int row) {
    const auto line = std::size_t(position.face * cookie.size + std::min(row, last));
    return snapped(double(cookie.texels[line * std::size_t(cookie.size) + std::size_t(std::min(column, last))]), 0, 1);
  };
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

Cookie resize_cookie(const Cookie& cookie, int size) {
  return make_cookie(size, [&](const glm::dvec3& direction) { return cookie_at(cookie, direction); });
}

}  // namespace litfog
