// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
using namespace render;

namespace {

using glm::dvec3;
using test::Random;
using test::WorstError;

constexpr int kSize = 32;
constexpr double kHalfStep = 0.5 / 65535;
constexpr Attenuation kLamp{1, 0, 19.0 / 10'000};  // extent 100 m at 0.05

double stored(const MapTexels& texels, int i, int j = 0, int k = 0, int size = kSize) {
  const auto at = (std::size_t(k) * std::size_t(size) + std::size_t(j)) * std::size_t(size) + std::size_t(i);
  return texels[at] / 65535.0;
}

/// Hales's coordinate of a texel, as a vector from the light in extents.
double coordinate(int i, int size = kSize) { return (double(i) / (size - 1) - 0.5) / 0.5; }

TEST(LightMap, VolumeHoldsTheAttenuationInsideTheExtentAndNothingBeyond) {
  const MapTexels map = make_range_volume(range_profile(kLamp, 100), kSize);
  ASSERT_EQ(map.size(), std::size_t(kSize) * kSize * kSize);
  for (int k = 1; k < kSize - 1; ++k) {
    for (int j = 1; j < kSize - 1; ++j) {
      for (int i = 1; i < kSize - 1; ++i) {
        const double range = 100 * glm::length(dvec3(coordinate(i), coordinate(j), coordinate(k)));
        ASSERT_NEAR(stored(map, i, j, k), range > 100 ? 0 : attenuation_at(kLamp, range), kHalfStep + 1e-6);
      }
    }
  }
}

TEST(LightMap, VolumesBoundariesAreDark) {
  for (const Attenuation& attenuation : {kLamp, Attenuation{2, 0, 0}}) {
    const double reach = compute_extent(attenuation, 0.05);
    const MapTexels map = make_range_volume(range_profile(attenuation, reach), kSize);
    for (int a = 0; a < kSize; ++a) {
      for (int b = 0; b < kSize; ++b) {
        for (const int side : {0, kSize - 1}) {
          EXPECT_EQ(stored(map, side, a, b), 0);
          EXPECT_EQ(stored(map, a, side, b), 0);
          EXPECT_EQ(stored(map, a, b, side), 0);
        }
      }
    }
  }
}

TEST(LightMap, PairGivesTheDistanceInThePlaneAndThenTheAttenuation) {
  const MapTexels distance = make_distance_map(kSize);
  const MapTexels range = make_range_map(range_profile(kLamp, 100), kSize);
  for (int j = 1; j < kSize - 1; ++j) {
    for (int i = 1; i < kSize - 1; ++i) {
      const double in_plane = std::hypot(coordinate(i), coordinate(j));
      EXPECT_NEAR(stored(distance, i, j), std::min(0.5 + 0.5 * in_plane, 1.0), kHalfStep);
      EXPECT_NEAR(stored(range, i, j), in_plane > 1 ? 0 : attenuation_at(kLamp, 100 * in_plane), kHalfStep + 1e-6);
    }
  }
  for (int i = 0; i < kSize; ++i) EXPECT_EQ(stored(range, i, kSize - 1) + stored(range, kSize - 1, i), 0);
}

TEST(LightMap, SquaresAddUpToTheSquareOfTheDistance) {
  const MapTexels plane = make_square_map(kSize);
  const MapTexels line = make_square_ramp(kSize);
  for (int j = 0; j < kSize; ++j) {
    for (int i = 0; i < kSize; ++i) {
      const double expected = std::min(1.0, coordinate(i) * coordinate(i) + coordinate(j) * coordinate(j));
      EXPECT_NEAR(stored(plane, i, j), expected, kHalfStep);
    }
    EXPECT_NEAR(stored(line, j), coordinate(j) * coordinate(j), kHalfStep);
  }
}

TEST(LightMap, LightsOfOneShapeShareTheirRangeProfile) {
  for (const double reach : {3.0, 50.0, 447.2}) {
    const Attenuation scaled{1, 0, 19 / (reach * reach)};
    EXPECT_EQ(range_profile(scaled, compute_extent(scaled, 0.05)), (RangeProfile{1, 0, 19})) << reach;
  }
  const Attenuation linear{1, 0.5, 0};
  EXPECT_EQ(range_profile(linear, compute_extent(linear, 0.05)), (RangeProfile{1, 19, 0}));
  const Attenuation constant{2, 0, 0};
  EXPECT_EQ(range_profile(constant, compute_extent(constant, 0.05)), (RangeProfile{2, 0, 0}));
}

/// A texel of a face, by OpenGL's rule for cube maps, looked up at a direction; the nearest one.
double nearest_texel(const MapTexels& cube, const dvec3& d, int size) {
  const dvec3 a = glm::abs(d);
  int face;
  double s, t, m;
  if (a.x >= a.y && a.x >= a.z) {
    face = d.x > 0 ? 0 : 1, m = a.x, s = d.x > 0 ? -d.z : d.z, t = -d.y;
  } else if (a.y >= a.z) {
    face = d.y > 0 ? 2 : 3, m = a.y, s = d.x, t = d.y > 0 ? d.z : -d.z;
  } else {
    face = d.z > 0 ? 4 : 5, m = a.z, s = d.z > 0 ? d.x : -d.x, t = -d.y;
  }
  const auto index = [&](double u) { return std::min(int((u / m + 1) / 2 * size), size - 1); };
  return stored(cube, index(s), index(t), face, size);
}

class ConeCube : public testing::TestWithParam<Cone> {};

TEST_P(ConeCube, EvenCubeHoldsTheConeAboutItsAxisForEveryDirection) {
  constexpr int kSide = 256;
  const Cone cone = GetParam();
  const double scale = cone_coordinate_scale(cone, kSide, ConeMaps::even);
  for (const CubeAxis axis : {CubeAxis::plus_x, CubeAxis::minus_z}) {
    const MapTexels cube = make_cone_cube(cone, axis, kSide, ConeMaps::even);
    Random random(6);
    double flux = 0;
    for (int i = 0; i < 20'000; ++i) {
      const double u = random.uniform(0, std::min(cutoff_angle(cone) * 1.2, std::numbers::pi));
      const double around = random.uniform(0, 2 * std::numbers::pi);
      const dvec3 along(std::cos(u), std::sin(u) * std::cos(around), std::sin(u) * std::sin(around));
      const dvec3 drawn_in(along.x, scale * along.y, scale * along.z);
      const double found =
          nearest_texel(cube, axis == CubeAxis::plus_x ? drawn_in : dvec3(drawn_in.y, drawn_in.z, -drawn_in.x), kSide);
      // Half a texel away in each direction; at the middle of a drawn-in face a texel is 2 tan(half angle) / 255.
      const double texel = is_scaled(cone, ConeMaps::even) ? 2 * std::tan(cutoff_angle(cone)) / 255 : 2.0 / 256;
      const double away = 0.75 * texel;
      const double high = cone_at(cone, std::cos(std::max(u - away, 0.0)));
      const double low = cone_at(cone, std::cos(std::min(u + away, std::numbers::pi)));
      ASSERT_GE(found, low - 1e-4) << u;
      ASSERT_LE(found, high + 1e-4) << u;
      flux += found;
    }
    EXPECT_GT(flux, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(LightMap, ConeCube,
                         testing::Values(Cone::cosine(0.11, 1256), Cone::cosine(1.0, 0), Cone::cosine(1.396, 1),
                                         Cone::cosine(std::numbers::pi / 2, 3), Cone::smoothstep(0.02, 0.38),
                                         Cone::smoothstep(0.17, 1.92), Cone::smoothstep(1, std::numbers::pi)));

TEST(LightMap, NarrowedConesSpanTheirFaceAndLeaveTheOthersDark) {
  const Cone cone = Cone::cosine(0.3, 4);
  EXPECT_NEAR(cone_map_scale(cone, ConeMaps::scaled), std::tan(std::numbers::pi / 2 - 0.3), 1e-12);
  const MapTexels cube = make_cone_cube(cone, CubeAxis::plus_x, kSize, ConeMaps::scaled);
  for (int face = 1; face < 6; ++face) {
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) EXPECT_EQ(stored(cube, i, j, face), 0);
    }
  }
  EXPECT_GT(stored(cube, 1, kSize / 2), 0.8 * std::pow(std::cos(0.3), 4));  // next to the edge of the face and the cone
  EXPECT_EQ(stored(cube, 0, kSize / 2), 0);                                 // at it
}

/// Hales's texel: its coordinates s, t from 0 to 1 give y/x and z/x, those COSA, and that the attenuation.
double hales_texel(double half_angle, double exponent, double s, double t) {
  const double b = 2 / std::tan(std::numbers::pi / 2 - half_angle);
  const double y = b * (s - 0.5);
  const double z = b * (t - 0.5);
  const double cosa = 1 / std::sqrt(y * y + z * z + 1);
  return cosa > std::cos(half_angle) ? std::pow(cosa, exponent) : 0;
}

TEST(LightMap, ScaledCubeHasHalessTexelsBelow90Degrees) {
  for (const double degrees : {1.0, 30.0, 60.0, 75.0, 80.0, 89.0, 89.99}) {
    const double half_angle = degrees * std::numbers::pi / 180;
    const MapTexels cube = make_cone_cube(Cone::cosine(half_angle, 3), CubeAxis::plus_x, kSize, ConeMaps::scaled);
    double lit = 0;
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        // OpenGL's +x face has s along -z and t along -y.
        const double expected = hales_texel(half_angle, 3, 1 - double(j) / (kSize - 1), 1 - double(i) / (kSize - 1));
        EXPECT_NEAR(stored(cube, i, j), expected, 2 * kHalfStep) << degrees << ", " << i << ", " << j;
        lit += stored(cube, i, j);
      }
    }
    EXPECT_EQ(lit > 0, degrees < 89.9) << degrees;  // in the end no texel is near enough to the axis
    for (std::size_t i = kSize * kSize; i < cube.size(); ++i) ASSERT_EQ(cube[i], 0) << degrees;
  }
}

/// Largest error of a bilinear look-up along the axis's plane, from the axis to the half angle less two texels.
double look_up_error(double half_angle, int size) {
  const Cone cone = Cone::cosine(half_angle, 1);
  const MapTexels cube = make_cone_cube(cone, CubeAxis::plus_x, size, ConeMaps::scaled);
  double worst = 0;
  for (double s = 0.5; s < 1 - 2.0 / (size - 1); s += 0.1 / size) {
    const double at = s * (size - 1);
    const int low = int(at);
    const int middle = size / 2;  // and middle - 1: t = 0.5 lies half way
    double found = 0;
    for (const auto& [i, weight] : {std::pair{low, low + 1 - at}, {low + 1, at - low}}) {
      found += weight * 0.5 * (stored(cube, i, middle, 0, size) + stored(cube, i, middle - 1, 0, size));
    }
    const double angle = std::atan((2 * s - 1) * std::tan(half_angle));
    worst = std::max(worst, std::abs(found - std::cos(angle)));
  }
  return worst;
}

// Beyond 60 degrees the texels of a scaled map are far apart where the light is brightest.
TEST(LightMap, ScaledConesErrBeyond60DegreesByTheirMiddleTexels) {
  const std::pair<double, double> largest[] = {{30, 0.0001}, {60, 0.0003}, {70, 0.0006},
                                               {80, 0.0025}, {85, 0.01},   {89, 0.16}};
  for (const auto& [degrees, bound] : largest) {
    const double error = look_up_error(degrees * std::numbers::pi / 180, 128);
    std::printf("cone of %2.0f degrees in 128 texels: error %.5f of %.5f\n", degrees, error, bound);
    EXPECT_LE(error, bound);
    EXPECT_GT(error, bound / 10);
  }
}

TEST(LightMap, OneDiscIsTheConesCutoffWhateverItsProfile) {
  EXPECT_EQ(mapped_cone(Cone::smoothstep(0.1, 0.7), ConeMaps::one_disc), Cone::cosine(0.7, 0));
  EXPECT_EQ(mapped_cone(Cone::cosine(1.2, 8), ConeMaps::one_disc), Cone::cosine(1.2, 0));
  EXPECT_EQ(mapped_cone(Cone::smoothstep(0.1, 1.9), ConeMaps::one_disc), Cone::smoothstep(0.1, 1.9));
  EXPECT_EQ(mapped_cone(Cone{}, ConeMaps::one_disc), Cone{});
}

TEST(LightMap, ConeMapOfAPointLightIsWhite) {
  for (const std::uint16_t texel : make_cone_cube(Cone{}, CubeAxis::plus_x, 1, ConeMaps::scaled))
    EXPECT_EQ(texel, 65535);
}

/// What an ideal sampler reads between a volume's texels.
double trilinear(const MapTexels& map, const dvec3& place_in_extents, int size) {
  const dvec3 at = (0.5 + 0.5 * place_in_extents) * double(size - 1);
  const glm::ivec3 low = glm::min(glm::ivec3(at), size - 2);
  const dvec3 f = at - dvec3(low);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 d(c & 1, c >> 1 & 1, c >> 2);
    const double weight = (d.x ? f.x : 1 - f.x) * (d.y ? f.y : 1 - f.y) * (d.z ? f.z : 1 - f.z);
    sum += weight * stored(map, low.x + d.x, low.y + d.y, low.z + d.z, size);
  }
  return sum;
}

// Linear interpolation errs by at most h^2 / 8 times the sum of the second derivatives along the axes, which of a
// function of the distance is at most |a''| + 2 |a'| / r: 6 q at the light itself for a = 1 / (1 + q r^2), and less
// elsewhere. Within a texel's diagonal of the extent, where the map steps to 0, it errs by at most the threshold more.
TEST(LightMap, VolumeErrsBetweenItsTexelsByItsSecondDerivative) {
  constexpr double kQ = 19;
  for (const int size : {16, 32, 64, 128}) {
    const MapTexels map = make_range_volume(range_profile(kLamp, 100), size);
    const double h = 2.0 / (size - 1);
    const double bound = h * h / 8 * 6 * kQ + kHalfStep;
    char name[64];
    std::snprintf(name, sizeof name, "range map %d^3, shares of %.4f", size, bound);
    WorstError inside("3-D lookup", name, bound, "absolute");
    WorstError edge("3-D lookup", "at the extent", bound + 0.05, "absolute");
    Random random(7);
    for (int i = 0; i < 50'000; ++i) {
      const dvec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const double r = glm::length(p);
      const double exact = r > 1 ? 0 : 1 / (1 + kQ * r * r);
      const double error = std::abs(trilinear(map, p, size) - exact);
      const auto text = [&] { return std::to_string(r); };
      const bool is_at_edge =
          std::abs(r - 1) < std::sqrt(3.0) * h || glm::any(glm::greaterThan(glm::abs(p), dvec3(1 - h)));
      (is_at_edge ? edge : inside).add(error, text);
    }
    inside.check();
    edge.check();
  }
}

}  // namespace

}  // namespace litfog::test
