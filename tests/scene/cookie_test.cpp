// SPDX-License-Identifier: Apache-2.0
#include "scene/file/cookie_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <numbers>

#include "command/exit_status.h"
#include "command/temporary_directory.h"
#include "reference/random_light.h"
#include "scene/cube_face.h"

namespace litfog::test {
using namespace scene;
using namespace command;

namespace {

using glm::dvec3;
using litfog::test::Random;

TEST(CubeFace, PlacesAreThoseOfTheirDirections) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const int face = i % 6;
    const double u = random.uniform(-0.99, 0.99);
    const double v = random.uniform(-0.99, 0.99);
    const CubePlace place = cube_place(cube_direction(face, u, v) * random.uniform(0.1, 9));
    EXPECT_EQ(place.face, face);
    EXPECT_NEAR(place.u, u, 1e-14);
    EXPECT_NEAR(place.v, v, 1e-14);
  }
}

/// Texels that all differ.
Cookie counted(int size) {
  Cookie cookie{.size = size, .texels = {}};
  for (int i = 0; i < 6 * size * size; ++i) cookie.texels.push_back(float(i) / float(6 * size * size));
  return cookie;
}

TEST(Cookie, IsItsTexelsAtTheirMiddlesAndBetweenThemTheirMean) {
  const Cookie cookie = counted(4);
  const auto texel = [&](int face, int row, int column) {
    return double(cookie.texels[std::size_t(face * 16 + row * 4 + column)]);
  };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const double u = (column + 0.5) / 2 - 1;
        const double v = (row + 0.5) / 2 - 1;
        EXPECT_NEAR(cookie_at(cookie, cube_direction(face, u, v)), texel(face, row, column), 1e-7);
        EXPECT_NEAR(cookie_at(cookie, cube_direction(face, u + 0.25, v + 0.25)),
                    (texel(face, row, column) + texel(face, row, column + 1) + texel(face, row + 1, column) +
                     texel(face, row + 1, column + 1)) /
                        4,
                    1e-7);
      }
    }
    EXPECT_NEAR(cookie_at(cookie, cube_direction(face, -0.99, -0.99)), texel(face, 0, 0), 1e-7);  // held at the edges
    EXPECT_NEAR(cookie_at(cookie, cube_direction(face, 0.99, 0.99)), texel(face, 3, 3), 1e-7);
  }
}

TEST(Cookie, OfABeaconHasTwoBeamsAcrossItsAxis) {
  const Cookie beacon = make_cookie("beacon");
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(cookie_at(beacon, {side, 0, 0}), 1, 1e-6);
    EXPECT_EQ(cookie_at(beacon, {0, 0, side}), 0);
    EXPECT_EQ(cookie_at(beacon, {0, side, 0}), 0);
    EXPECT_NEAR(cookie_at(beacon, {side, 0, std::tan(glm::radians(7.0))}), 1, 1e-4);
    EXPECT_EQ(cookie_at(beacon, {side, std::tan(glm::radians(25.0)), 0}), 0);
  }
}

TEST(Cookie, OfAMirrorBallHasSpotsAllAround) {
  const Cookie disco = make_cookie("disco");
  Random random(9);
  int bright = 0;
  int dark = 0;
  constexpr int kRays = 20'000;
  int octants[8] = {};
  for (int i = 0; i < kRays; ++i) {
    dvec3 direction;
    do {
      direction = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    } while (glm::length(direction) > 1);
    const double share = cookie_at(disco, direction);
    ASSERT_TRUE(share >= 0 && share <= 1);
    if (share > 0.99) {
      ++bright;
      ++octants[(direction.x > 0) + 2 * (direction.y > 0) + 4 * (direction.z > 0)];
    }
    if (share < 0.01) ++dark;
  }
  // Spots of 0.26 ring widths to full brightness and 0.36 to darkness, about one a ring width squared.
  EXPECT_NEAR(double(bright) / kRays, std::numbers::pi * 0.26 * 0.26, 0.04);
  EXPECT_NEAR(double(dark) / kRays, 1 - std::numbers::pi * 0.36 * 0.36, 0.06);
  for (const int octant : octants) EXPECT_GT(octant, bright / 16);
}

TEST(Cookie, TurnsToTheRightAsSeenAlongItsAxis) {
  const dvec3 ahead(0, 0, -1);
  const glm::dmat3 level = cookie_from_world(ahead, 0);
  EXPECT_NEAR(glm::distance(level * dvec3(0, 1, 0), dvec3(0, 1, 0)), 0, 1e-15);
  const glm::dmat3 turned = cookie_from_world(ahead, std::numbers::pi / 2);
  EXPECT_NEAR(glm::distance(turned * dvec3(1, 0, 0), dvec3(0, 1, 0)), 0, 1e-15);  // its up is now on the right
  EXPECT_NEAR(glm::distance(turned * ahead, ahead), 0, 1e-15);
}

TEST(Cookie, ResizedIsTheSameBetweenItsTexels) {
  const Cookie beacon = make_cookie("beacon");
  const Cookie smaller = resized(beacon, 128);
  EXPECT_EQ(smaller.texels.size(), 6u * 128 * 128);
  Random random(10);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_NEAR(cookie_at(smaller, direction), cookie_at(beacon, direction), 0.02);
  }
}

class CookieFile : public testing::Test {
 protected:
  std::string write(const OIIO::ImageSpec& spec, const std::vector<float>& texels) {
    const std::string path = (directory_.path() / "cookie.exr").string();
    const auto output = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(output && output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, texels.data()) &&
                output->close());
    return path;
  }

  static std::string refusal(const std::string& path) {
    try {
      read_cookie(path);
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "accepted";
  }

 private:
  litfog::test::TemporaryDirectory directory_;
};

TEST_F(CookieFile, ReadsBackEveryTexel) {
  const Cookie cookie = counted(5);
  const std::string path = write(OIIO::ImageSpec(5, 30, 1, OIIO::TypeDesc::FLOAT), cookie.texels);
  EXPECT_EQ(read_cookie(path).size, 5);
  EXPECT_EQ(read_cookie(path).texels, cookie.texels);
}

TEST_F(CookieFile, RefusesWhatIsNoColumnOfSixFaces) {
  std::string path = write(OIIO::ImageSpec(5, 25, 1, OIIO::TypeDesc::FLOAT), std::vector<float>(125));
  EXPECT_EQ(refusal(path), path + ": size = 5x25: must be N x 6 N, six faces in a column, N at most 4096");
  path = write(OIIO::ImageSpec(2, 12, 3, OIIO::TypeDesc::FLOAT), std::vector<float>(72));
  EXPECT_EQ(refusal(path), path + ": channels = 3: must be 1");
}

TEST_F(CookieFile, RefusesTexelsThatAreNoShares) {
  for (const float wrong : {-0.1f, 1.5f, std::nanf("")}) {
    std::vector<float> texels(24, 0.5f);
    texels[7] = wrong;
    const std::string path = write(OIIO::ImageSpec(2, 12, 1, OIIO::TypeDesc::FLOAT), texels);
    EXPECT_EQ(refusal(path), path + ": texels: must be shares in [0, 1]") << wrong;
  }
}

TEST_F(CookieFile, RefusesAMissingFile) {
  EXPECT_EQ(refusal("no-such.exr").substr(0, 43), "no-such.exr: cannot be read as an image: Co");
}

}  // namespace

}  // namespace litfog::test
