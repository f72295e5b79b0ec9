// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/value_errors.h"
#include "litfog/photometry/cube_face.h"
#include "reference/degree.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

/// OpenGL 4.6, section 8.13 and table 8.19: the face and texel that a direction selects, nearest filtering.
std::size_t selected_texel(const glm::dvec3& r, int size) {
  const glm::dvec3 m = glm::abs(r);
  int face;
  double sc, tc, ma;
  if (m.x >= m.y && m.x >= m.z) {
    face = r.x > 0 ? 0 : 1;
    sc = r.x > 0 ? -r.z : r.z, tc = -r.y, ma = m.x;
  } else if (m.y >= m.z) {
    face = r.y > 0 ? 2 : 3;
    sc = r.x, tc = r.y > 0 ? r.z : -r.z, ma = m.y;
  } else {
    face = r.z > 0 ? 4 : 5;
    sc = r.z > 0 ? r.x : -r.x, tc = -r.y, ma = m.z;
  }
  const auto texel = [size](double c) { return std::min(int((c + 1) / 2 * size), size - 1); };
  return std::size_t((face * size + texel(tc / ma)) * size + texel(sc / ma));
}

TEST(Cookie, TexelsHoldTheBeamWhereAGlCubeMapLooksItUp) {
  // Smooth, and different in all directions: no face or axis can be taken for another.
  IntensityDistribution beam;
  for (int c = 0; c <= 360; c += 2) beam.horizontal.push_back(c * kDegree);
  for (int g = 0; g <= 180; g += 2) beam.vertical.push_back(g * kDegree);
  for (const double c : beam.horizontal) {
    for (const double g : beam.vertical) {
      const glm::dvec3 d{std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g)};
      beam.intensity.push_back(100 + 30 * d.x + 20 * d.y - 40 * d.z);
    }
  }
  const double peak = find_peak(beam).intensity;
  constexpr int kSize = 32;
  // A texel's centre is at most half its diagonal away, sqrt(2) / 32 on the cube; the beam's gradient is at most
  // |(30, 20, 40)| < 54 a radian.
  const double bound = 54 * std::sqrt(2) / kSize / peak;
  Random random(8);
  for (const glm::dvec3& axis : {kPhotometricAxis, glm::dvec3(0.6, -0.3, 0.5), glm::dvec3(-1, 2, 0.2)}) {
    const Cookie cookie = bake_cookie(beam, kSize, axis);
    ASSERT_EQ(cookie.size, kSize);
    ASSERT_EQ(cookie.texels.size(), 6u * kSize * kSize);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, {0, 1, 0})), up = glm::normalize(glm::cross(right, axis));
    for (int i = 0; i < 3000; ++i) {
      const auto direction = draw_direction(random);
      const glm::dvec3 seen = direction.x * right + direction.y * up - direction.z * glm::normalize(axis);
      EXPECT_NEAR(cookie.texels[selected_texel(direction, kSize)], intensity_at(beam, seen) / peak, bound);
    }
  }
}

TEST(Cookie, PeakOfASpotIsInTheMiddleOfTheLastFace) {
  IntensityDistribution spot{.horizontal = {0}, .vertical = {}, .intensity = {}};
  for (int degrees = 0; degrees <= 30; ++degrees) {
    spot.vertical.push_back(degrees * kDegree);
    spot.intensity.push_back(9000 - 9000 * degrees * kDegree);
  }
  const Cookie cookie = bake_cookie(spot, 5);
  EXPECT_EQ(cookie.texels[5 * 25 + 12], 1);
  EXPECT_EQ(std::ranges::count(cookie.texels, 1.0f), 1);
  EXPECT_EQ(std::ranges::count(cookie.texels, 0.0f), 5 * 25 + 16);  // 30 degrees reach the inner nine texels
}

TEST(Cookie, CookieAboutAnAxisLooksAlongIt) {
  IntensityDistribution beam{.horizontal = {0}, .vertical = {}, .intensity = {}};
  for (int g = 0; g <= 180; g += 10) {
    beam.vertical.push_back(g * kDegree);
    beam.intensity.push_back(g);
  }
  const Cookie up = bake_cookie(beam, 3, -kPhotometricAxis), down = bake_cookie(beam, 3);
  EXPECT_EQ(up.texels[5 * 9 + 4], 1) << "the peak, at 180 degrees, in the middle of the face -z";
  EXPECT_EQ(down.texels[5 * 9 + 4], 0);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(up.texels[5 * 9 + i], down.texels[4 * 9 + i], 1e-6);
}

/// Texels that all differ.
Cookie counted(int size) {
  Cookie cookie{.size = size, .texels = {}};
  for (int i = 0; i < 6 * size * size; ++i) cookie.texels.push_back(float(i) / float(6 * size * size));
  return cookie;
}

TEST(Cookie, LookUpIsBilinearBetweenTheTexelsOfAFace) {
  const Cookie cookie = counted(4);
  const auto texel = [&](int face, int row, int column) {
    return double(cookie.texels[std::size_t(face * 16 + row * 4 + column)]);
  };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const double u = (column + 0.5) / 2 - 1;
        const double v = (row + 0.5) / 2 - 1;
        EXPECT_NEAR(cookie_at(cookie, cube_direction({face, u, v})), texel(face, row, column), 1e-7);
        EXPECT_NEAR(cookie_at(cookie, cube_direction({face, u + 0.25, v + 0.25})),
                    (texel(face, row, column) + texel(face, row, column + 1) + texel(face, row + 1, column) +
                     texel(face, row + 1, column + 1)) /
                        4,
                    1e-7);
      }
    }
    EXPECT_NEAR(cookie_at(cookie, cube_direction({face, -0.99, -0.99})), texel(face, 0, 0), 1e-7);  // held at the edges
    EXPECT_NEAR(cookie_at(cookie, cube_direction({face, 0.99, 0.99})), texel(face, 3, 3), 1e-7);
  }
}

TEST(Cookie, ResizedCookieIsTheSameBetweenItsTexels) {
  const auto wave = [](const glm::dvec3& d) { return 0.5 + 0.4 * std::sin(3 * glm::normalize(d).x); };
  const Cookie smaller = resize_cookie(make_cookie(256, wave), 128);
  EXPECT_FALSE(find_error(smaller));
  EXPECT_EQ(smaller.size, 128);
  Random random(10);
  for (int i = 0; i < 1000; ++i) {
    const auto direction = draw_direction(random);
    // The slope is at most 1.2 a radian; at a face's edge the nearest centre is half a texel away, 1/128.
    EXPECT_NEAR(cookie_at(smaller, direction), wave(direction), 1.2 / 128);
  }
}

TEST(Cookie, SizeMustBeFrom1To4096) {
  const IntensityDistribution lamp{.horizontal = {0}, .vertical = {0, 1}, .intensity = {1, 1}};
  EXPECT_EQ(error_of([&] { bake_cookie(lamp, 0); }), "size = 0: must be in [1, 4096]");
  EXPECT_EQ(error_of([&] { bake_cookie(lamp, 4097); }), "size = 4097: must be in [1, 4096]");
}

TEST(Cookie, CheckNamesWhatIsWrong) {
  const auto error_of = [](const Cookie& cookie) {
    const auto error = find_error(cookie);
    return error ? to_string(*error) : "none";
  };
  const std::vector<float> six(6, 0.5f);
  EXPECT_EQ(error_of({1, six}), "none");
  EXPECT_EQ(error_of({0, {}}), "size = 0: must be in [1, 4096]");
  EXPECT_EQ(error_of({2, six}), "texels = 6: must be 6 * size * size");
  EXPECT_EQ(error_of({1, {0, 0, 0, 0, 0, 2}}), "texel = 2: must be in [0, 1]");
  EXPECT_EQ(error_of({1, {std::numeric_limits<float>::infinity(), 0, 0, 0, 0, 0}}), "texel = inf: must be in [0, 1]");
  EXPECT_EQ(error_of({1, {std::numeric_limits<float>::quiet_NaN(), 0, 0, 0, 0, 0}}), "texel = nan: must be in [0, 1]");
}

}  // namespace
}  // namespace litfog::test
