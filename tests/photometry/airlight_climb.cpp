// SPDX-License-Identifier: Apache-2.0
// litfog_airlight_climb [STARTS STEPS [SEED]]: searches for the largest errors of the airlight, and for rays that come
// nearest to its upper bounds, by climbing: from 3 starts of 400 steps for each function and kind of lamp, fog and
// scattering, or as many as are given. Prints them as CSV, a row a function and kind, and exits with 1 where a bound
// does not hold. `litfog_airlight_climb 20 600 > data/benchmarks/airlight-climb.csv` makes what docs/accuracy.md shows.
//
// function     airlight; bound_airlight, of a cone of rays; litfog_airlight_bound, of a stretch of a ray; and
//              litfog_largest_airlight, of a whole ray, both of the shaders' text in double
// lamps, fog, lamp_leg, g  the kind
// rays         tried
// bound        of airlight the stated error in steps of 1/255; else 1
// worst        found: of airlight its error in such steps; else the airlight over its bound

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "airlight/airlight_text.h"
#include "litfog/formulas.h"
#include "litfog/photometry/cookie_airlight.h"
#include "photometry/smooth_cookie.h"
#include "reference/airlight_climb.h"

namespace litfog::test {
namespace {

double reference_of(const AirlightCase& c) { return reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); }

/// An error in steps of 1/255 of the lamp's colour, or of the airlight where that is brighter.
double steps(double fast, double expected) { return 255 * std::abs(fast - expected) / std::max(expected, 1.0); }

double error_of_airlight(const AirlightCase& c) {
  return steps(airlight(c.light, c.atmosphere, c.ray, c.lamp_leg), reference_of(c));
}

double error_of_cookie(const Cookie& cookie, const AirlightCase& c) {
  const glm::dvec3& axis = c.light.direction;
  const glm::dvec3 right =
      glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
  const glm::dmat3 turn = glm::transpose(glm::dmat3(right, glm::cross(right, axis), -axis));
  return steps(airlight(c.light, cookie, turn, c.atmosphere, c.ray, c.lamp_leg),
               reference_airlight(c.light, cookie, turn, c.atmosphere, c.ray, c.lamp_leg));
}

double over(double airlight, double bound) { return airlight > 0 ? airlight / bound : 0; }

/// The airlight over its bound in a cone of rays, of which the case's is the one nearest to the lamp.
double ratio_to_cone_bound(const AirlightCase& c) {
  const double half_angle = std::numbers::pi * c.spread * c.spread;
  const glm::dvec3 away(c.light.position.x < 0 ? 1 : -1, 0, 0);
  const glm::dvec3 axis = glm::normalize(std::cos(half_angle) * c.ray.direction + std::sin(half_angle) * away);
  return over(reference_of(c),
              bound_airlight(c.light, c.atmosphere, c.ray.origin, axis, half_angle + 1e-12, c.lamp_leg));
}

/// The airlight over its bound on the stretch of a ray that is lit, but for what lies beyond the stretch's end in the
/// fog: 2 % of the airlight, or 1e-6 where the stretch may be empty.
double ratio_to_stretch_bound(const AirlightCase& c) {
  const airlight_text::NoCookie no_cookie;
  airlight_text::Text<double, airlight_text::NoCookie> text{no_cookie, c.atmosphere.profile};
  const Light& light = c.light.light;
  const auto air = text.seen_along(c.light, compute_extent(light.attenuation, light.threshold), c.atmosphere.fog, c.ray,
                                   c.lamp_leg, phase_text::pack<double>(c.atmosphere.phase));
  return over(0.98 * reference_of(c) - 1e-6, text.litfog_airlight_bound(air, text.litfog_airlight_stretch(air)));
}

/// The airlight of a point in isotropic fog that dims both legs over its bound along any ray that comes as near.
double ratio_to_ray_bound(const AirlightCase& c) {
  const auto [constant, linear, quadratic] = c.light.light.attenuation;
  const double eye_range = glm::length(c.light.position);
  const Fog& fog = c.atmosphere.fog;
  const double weight = formulas::litfog_largest_fog_weight(
      double(fog.mode), fog.density, fog.density * 2 * eye_range / 3, fog.density * eye_range / 3);
  const double offset = std::abs(c.light.position.x) * (1 - 1e-12);
  const double bound =
      formulas::litfog_largest_airlight(weight, formulas::denominator(offset, constant, linear, quadratic), quadratic,
                                        2 * compute_extent(c.light.light.attenuation, c.light.light.threshold));
  return over((1 - 1e-9) * reference_of(c), bound);
}

/// A function that is climbed, and the kinds for which it is.
struct Climb {
  const char* function;
  std::optional<double> bound;  ///< absent: the error that is stated for the kind
  std::vector<LampShape> shapes;
  std::function<double(const AirlightCase&)> measure;
  bool knows_layers = false;
  bool needs_isotropic_fog_on_both_legs = false;

  double bound_of(const ClimbKind& kind) const { return bound.value_or(255 * stated_error(kind)); }
};

class Search {
 public:
  Search(int starts, int steps, std::uint64_t seed) : starts_(starts), steps_(steps), seed_(seed) {}

  /// Climbs, and prints a row a kind. Returns whether the bound holds in all.
  bool holds(const Climb& climb) {
    bool is_good = true;
    for (const LampShape shape : climb.shapes) {
      for (const bool is_directional : {false, true}) {
        for (const FogMode mode : kModes) {
          for (const LampLeg leg : kLampLegs) {
            if (climb.needs_isotropic_fog_on_both_legs && (is_directional || leg == LampLeg::clear)) continue;
            is_good &= holds(climb, {shape, is_directional, mode, leg});
            if (climb.knows_layers && mode == FogMode::exp) {
              is_good &= holds(climb, {shape, is_directional, mode, leg, true});
            }
          }
        }
      }
    }
    return is_good;
  }

 private:
  bool holds(const Climb& climb, const ClimbKind& kind) {
    const double bound = climb.bound_of(kind);
    Random random(seed_++);
    ClimbResult worst;
    int rays = 0;
    for (int i = 0; i < starts_; ++i) {
      const ClimbResult found = climb_airlight(random, kind, steps_, [&](const AirlightCase& c) {
        ++rays;
        return climb.measure(c);
      });
      if (found.error > worst.error) worst = found;
    }
    std::printf("%s,%s,%d,%g,%.4g\n", climb.function, to_string(kind).c_str(), rays, bound, worst.error);
    std::fflush(stdout);
    if (worst.error <= bound) return true;
    std::fprintf(stderr, "%s: the bound does not hold: %s\n", climb.function, to_string(worst.at).c_str());
    return false;
  }

  int starts_, steps_;
  std::uint64_t seed_;
};

bool check_all(int starts, int steps, std::uint64_t seed) {
  const Cookie cookie = make_smooth_cookie();
  const std::vector lamps{LampShape::point, LampShape::cosine, LampShape::smoothstep};
  Search search(starts, steps, seed);
  std::printf("function,lamps,fog,lamp_leg,g,rays,bound,worst\n");
  bool is_good = true;
  for (const Climb& climb :
       {Climb{"airlight", {}, lamps, error_of_airlight, true},
        Climb{"airlight",
              255 * kCookieAirlightMaxError,
              {LampShape::cookie},
              [&](const AirlightCase& c) { return error_of_cookie(cookie, c); }},
        Climb{"bound_airlight", 1, lamps, ratio_to_cone_bound, true},
        Climb{"litfog_airlight_bound", 1, lamps, ratio_to_stretch_bound, true},
        Climb{"litfog_largest_airlight", 1, {LampShape::point}, ratio_to_ray_bound, false, true}}) {
    is_good &= search.holds(climb);
  }
  return is_good;
}

}  // namespace
}  // namespace litfog::test

int main(int argc, char** argv) {
  const int starts = argc > 2 ? std::atoi(argv[1]) : 3;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 400;
  const int seed = argc > 3 ? std::atoi(argv[3]) : 1;
  if (argc == 2 || argc > 4 || starts < 1 || steps < 1 || seed < 0) {
    std::fprintf(stderr, "usage: litfog_airlight_climb [STARTS STEPS [SEED]]\n");
    return 1;
  }
  return litfog::test::check_all(starts, steps, std::uint64_t(seed)) ? 0 : 1;
}
