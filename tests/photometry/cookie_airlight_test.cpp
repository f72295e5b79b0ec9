// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie_airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <glm/geometric.hpp>

#include "photometry/smooth_cookie.h"
#include "reference/random_airlight.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

/// Rotations that turn the light's axis to -z.
glm::dmat3 cookie_from_world_of(const AirlightCase& c, Random& random) {
  const glm::dvec3 right = draw_perpendicular(random, c.light.direction);
  return glm::transpose(glm::dmat3(right, glm::cross(right, c.light.direction), -c.light.direction));
}

TEST(CookieAirlight, WhiteCookieIsAPointLight) {
  Random random(81);
  const Cookie white = make_cookie(3, [](const glm::dvec3&) { return 1.0; });
  for (int i = 0; i < 300; ++i) {
    const AirlightCase c = draw_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    const glm::dmat3 turn = cookie_from_world_of(c, random);
    const double expected = reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
    EXPECT_LE(std::abs(reference_airlight(c.light, white, turn, c.atmosphere, c.ray, c.lamp_leg) - expected),
              kReferenceAirlightMaxError * expected + 1e-19)
        << to_string(c);
    EXPECT_NEAR(airlight(c.light, white, turn, c.atmosphere, c.ray, c.lamp_leg), expected, kCookieAirlightMaxError)
        << to_string(c);
  }
}

TEST(CookieAirlight, SmoothCookieHasItsStatedError) {
  Random random(82);
  const Cookie cookie = make_smooth_cookie();
  WorstError error("airlight", "cookies", kCookieAirlightMaxError * 255, "/255");
  for (int i = 0; i < 1000; ++i) {
    AirlightCase c = draw_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    c.light.direction = draw_direction(random);
    const glm::dmat3 turn = cookie_from_world_of(c, random);
    const double expected = reference_airlight(c.light, cookie, turn, c.atmosphere, c.ray, c.lamp_leg);
    error.add(std::abs(airlight(c.light, cookie, turn, c.atmosphere, c.ray, c.lamp_leg) - expected) * 255,
              [&] { return to_string(c); });
  }
  error.check();
}

TEST(CookieAirlight, ReferenceFollowsEachTexel) {
  Random random(83);
  const Cookie noise = make_cookie(5, [&](const glm::dvec3&) { return random.uniform(0, 1); });
  for (int i = 0; i < 20; ++i) {
    AirlightCase c;
    c.light.light.attenuation = {2, 0, 0};
    c.atmosphere.fog = {FogMode::exp, 0.3};
    c.ray = {{0, 0, 0}, draw_direction(random), 5};
    c.lamp_leg = LampLeg::clear;
    c.light.position = draw_direction(random) * 1.5;
    const glm::dmat3 turn = cookie_from_world_of(c, random);
    const auto direction_at = [&](double s) { return turn * (s * c.ray.direction - c.light.position); };
    const auto integrand = [&](double s) { return 0.3 * std::exp(-0.3 * s) / 2 * cookie_at(noise, direction_at(s)); };
    const auto face_at = [&](double s) {
      const glm::dvec3 to = direction_at(s);
      const glm::dvec3 size = glm::abs(to);
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      return 2 * axis + (to[axis] < 0 ? 1 : 0);
    };
    const auto integral = [&](double from, double to) {
      return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(integrand, from, to, 15, 1e-12);
    };
    double expected = 0;
    double from = 0;
    for (int j = 0; j < 1000; ++j) {
      const double to = (j + 1) * 0.005;
      double jump = to;  // where the ray passes from one face of the cookie's cube to another
      if (face_at(from) != face_at(to)) {
        double before = from;
        for (int halving = 0; halving < 60; ++halving) {
          const double middle = 0.5 * (before + jump);
          (face_at(middle) == face_at(from) ? before : jump) = middle;
        }
        expected += integral(from, before);
      }
      expected += integral(jump == to ? from : jump, to);
      from = to;
    }
    EXPECT_LE(relative_error(reference_airlight(c.light, noise, turn, c.atmosphere, c.ray, c.lamp_leg), expected),
              kReferenceAirlightMaxError);
    EXPECT_LE(relative_error(picture_airlight(c.light, noise, turn, c.atmosphere, c.ray, c.lamp_leg), expected),
              kPictureAirlightMaxError);
  }
}

// A beam of cos^n has the mean 1 / (2 n + 2) and the mean cosine (n + 1) / (n + 2). A narrow one spans few texels.
TEST(CookieAirlight, CookieHasTheFluxAndTheMeanCosineOfItsBeam) {
  for (const auto& [size, n] : {std::pair{64, 4.0}, {65, 4.0}, {128, 1000.0}, {512, 10'000.0}, {700, 1e5}}) {
    const Cookie cookie =
        make_cookie(size, [n = n](const glm::dvec3& d) { return std::pow(std::max(-glm::normalize(d).z, 0.0), n); });
    const BeamMoments moments = beam_moments(cookie);
    EXPECT_NEAR(moments[0] * (2 * n + 2), 1, kCookieMomentMaxError) << size << " " << n;
    EXPECT_NEAR((1 - moments[1] / moments[0]) * (n + 2), 1, kCookieMomentMaxError) << size << " " << n;
  }
}

}  // namespace
}  // namespace litfog::test
