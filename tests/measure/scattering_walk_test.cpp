// SPDX-License-Identifier: Apache-2.0
#include "measure/scattering_walk.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "measure/inverse_square_lamp.h"
#include "litfog/density_profile.h"

namespace litfog::test {
namespace {

using measure::Estimate;
using measure::walk_scattering;
using std::numbers::pi;

/// Within four standard errors, of which there are some hundred in this file.
void expect_near(const Estimate& estimate, double truth, double most_error, const std::string& name) {
  EXPECT_TRUE(std::abs(estimate.value - truth) <= 4 * estimate.error)
      << name << ": " << estimate.value << " +- " << estimate.error << " for " << truth;
  EXPECT_TRUE(estimate.error <= most_error * std::abs(truth)) << name << ": error " << estimate.error / truth;
}

Atmosphere fog_of(const Phase& phase, double albedo = 1) {
  return {.fog = {FogMode::exp, 1}, .phase = phase, .albedo = albedo};
}

measure::ScatteringWalk paths_of(std::uint64_t paths, std::uint64_t seed = 1) {
  measure::ScatteringWalk walk;
  walk.paths = paths;
  walk.seed = seed;
  return walk;
}

/// A horizontal plane below lamp and eye.
struct Ground : measure::Surroundings {
  double height, albedo;

  Ground(double at, double reflected) : height(at), albedo(reflected) {}
  std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction) const override {
    if (!(direction.y < 0)) return std::nullopt;
    return Hit{std::max(0.0, (height - origin.y) / direction.y), {0, 1, 0}, albedo};
  }
  bool is_hidden(const glm::dvec3&, const glm::dvec3&, bool) const override { return false; }
};

template <typename Function>
double integral(double low, double high, int panels, const Function& f) {
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double step = (high - low) / panels;
    sum += boost::math::quadrature::gauss<double, 20>::integrate(f, low + i * step, low + (i + 1) * step);
  }
  return sum;
}

/// Light of a point lamp of intensity 1 that fog of density 1 scatters twice, by quadrature in polar coordinates around
/// the direction to the lamp, over the angle at the lamp on the leg that leads to it.
double second_order(const Phase& phase, double range, double angle) {
  const double offset = range * std::sin(angle), approach = range * std::cos(angle);
  const auto from_place = [&](double v) {
    const double place = offset * std::sinh(v), distance = offset * std::cosh(v), s = place + approach;
    const double ahead = std::atan2(offset, -place);  // angle between the ray and the way to the lamp
    const auto over_angle = [&](double x) {
      const double alpha = pi * x * x;
      const double leg = integral(alpha, pi, 2, [&](double theta) {
        const double lamp_leg = distance * std::sin(alpha) / std::sin(theta);
        const double eye_leg = distance * std::sin(theta - alpha) / std::sin(theta);
        return phase_at(phase, std::cos(theta)) * std::exp(-lamp_leg - eye_leg) / distance;
      });
      double around = 0;
      constexpr int kAround = 48;
      for (int i = 0; i < kAround; ++i) {
        const double cosine = std::cos(ahead) * std::cos(alpha) +
                              std::sin(ahead) * std::sin(alpha) * std::cos(2 * pi * (i + 0.5) / kAround);
        around += phase_at(phase, cosine) * 2 * pi / kAround;
      }
      return around * leg / (4 * pi) * 2 * pi * x;
    };
    return integral(0, 1, 2, over_angle) * std::exp(-s) * distance;
  };
  return integral(std::asinh(-approach / offset), std::asinh(30 / offset), 8, from_place);
}

TEST(ScatteringWalk, FirstOrderIsTheReferenceAirlight) {
  struct Case {
    const char* name;
    PlacedLight light;
    Atmosphere air;
    EyeRay ray;
  };
  PlacedLight beam = lamp_ahead(2);
  beam.light.cone = Cone::cosine(0.4, 8);
  beam.direction = {std::sin(1.0), 0, std::cos(1.0)};
  PlacedLight wide = beam;
  wide.light.cone = Cone::smoothstep(0.2, 2.5);
  PlacedLight disc = lamp_ahead(3);
  disc.light.attenuation = {.constant = 1, .linear = 0, .quadratic = 0.1};
  disc.light.source_radius = 0.3;
  disc.light = photometric(disc.light);
  PlacedLight law = lamp_ahead(3);
  law.light.attenuation = {.constant = 0.5, .linear = 0.2, .quadratic = 0.1};
  law.light.threshold = 0.05;
  const std::array<DensityKnot, 3> knots{{{-1, 2}, {0.5, 0.5}, {2, 0}}};
  Atmosphere layers = fog_of(Phase::droplets(10));
  layers.fog.density = 0;
  layers.profile = make_density_profile(knots);
  EyeRay upwards = ray_beside(0.3);
  upwards.direction = {0.6, 0.48, -0.64};
  EyeRay short_ray = ray_beside(0.1);
  short_ray.length = 1.5;
  const std::array cases{
      Case{"isotropic", lamp_ahead(1), fog_of({}), ray_beside(0.2)},
      Case{"forward", lamp_ahead(1), fog_of(Phase::henyey_greenstein(0.85)), ray_beside(0.01)},
      Case{"backward", lamp_ahead(1), fog_of(Phase::henyey_greenstein(-0.5)), ray_beside(1.5)},
      Case{"droplets", lamp_ahead(0.1), fog_of(Phase::droplets(50)), ray_beside(0.05)},
      Case{"away from the lamp", lamp_ahead(3), fog_of({}), ray_beside(pi)},
      Case{"beam", beam, fog_of({}), ray_beside(0.3)},
      Case{"beam in droplets", beam, fog_of(Phase::droplets(5)), ray_beside(0.3)},
      Case{"wide beam", wide, fog_of({}), ray_beside(-0.3)},
      Case{"disc", disc, fog_of({}), ray_beside(0.02)},
      Case{"disc in its middle", disc, fog_of(Phase::henyey_greenstein(0.7)), ray_beside(0)},
      Case{"law with an extent", law, fog_of(Phase::henyey_greenstein(0.7)), ray_beside(0.3)},
      Case{"before a surface", lamp_ahead(1), fog_of({}), short_ray},
      Case{"layers", lamp_ahead(2), layers, ray_beside(0.3)},
      Case{"up through layers", lamp_ahead(2), layers, upwards},
  };
  for (const Case& c : cases) {
    const double truth = reference_airlight(c.light, c.air, c.ray);
    expect_near(walk_scattering(c.light, c.air, c.ray, paths_of(2048)).first, truth, 0.05, c.name);
  }
}

TEST(ScatteringWalk, SecondOrderIsItsQuadrature) {
  struct Case {
    Phase phase;
    double albedo, range, angle, most_error;
  };
  for (const Case& c :
       {Case{{}, 1, 1, 0.2, 0.02}, Case{{}, 0.6, 0.1, 0.02, 0.02}, Case{{}, 1, 3, 2, 0.04},
        Case{Phase::henyey_greenstein(0.7), 1, 1, 0.2, 0.03}, Case{Phase::henyey_greenstein(0.7), 0.6, 0.3, 1, 0.03},
        Case{Phase::henyey_greenstein(-0.4), 1, 1, 0.5, 0.03}}) {
    const Estimate second =
        walk_scattering(lamp_ahead(c.range), fog_of(c.phase, c.albedo), ray_beside(c.angle), paths_of(8192)).second;
    expect_near({second.value * kQuadratic, second.error * kQuadratic},
                c.albedo * second_order(c.phase, c.range, c.angle), c.most_error,
                std::to_string(c.phase.first.asymmetry) + " at " + std::to_string(c.range));
  }
}

/// Fluence around a point source of power 1 in endless isotropic fog of density 1, times 4 pi r (Kenneth Case, Frederic
/// de Hoffmann and George Placzek 1953, "Introduction to the Theory of Neutron Diffusion", volume 1, section 20).
double exact_fluence(double albedo, double range) {
  double residue = 3, eigenvalue = 0;
  if (albedo < 1) {
    const auto equation = [&](double k) { return albedo * std::atanh(k) - k; };
    const auto [low, high] =
        boost::math::tools::bisect(equation, 1e-3, 1 - 1e-15, boost::math::tools::eps_tolerance<double>(50));
    eigenvalue = (low + high) / 2;
    const double square = eigenvalue * eigenvalue;
    residue = 2 * square * (1 - square) / (albedo * (square - (1 - albedo)));
  }
  const double transient = integral(0, 1, 20, [&](double x) {
    const double mu = 1 - std::pow(1 - x, 3);  // its slope is infinite at 1
    const double a = 1 - albedo * mu * std::atanh(mu), b = pi * albedo * mu / 2;
    return std::exp(-range / mu) / (mu * mu * (a * a + b * b)) * 3 * (1 - x) * (1 - x);
  });
  return residue * std::exp(-eigenvalue * range) + transient;
}

/// The integral over all directions of the light scattered to a point times a power of the cosine, divided by the
/// lamp's power.
Estimate gathered(const Phase& phase, double albedo, double range, int power, std::uint64_t paths) {
  const PlacedLight light = lamp_ahead(range);
  const Atmosphere air = fog_of(phase, albedo);
  const auto weight = [&](double x) {
    const double angle = pi * x * x * x;
    return albedo / (4 * pi) * kQuadratic / (4 * pi) * 2 * pi * std::sin(angle) * std::pow(std::cos(angle), power) * 3 *
           pi * x * x;
  };
  double sum = integral(
      0, 1, 4, [&](double x) { return weight(x) * reference_airlight(light, air, ray_beside(pi * x * x * x)); });
  double square = 0;
  std::uint64_t seed = 0;
  const auto add = [&](double x, double node_weight) {
    const Estimate m = walk_scattering(light, air, ray_beside(pi * x * x * x), paths_of(paths, ++seed)).higher;
    sum += node_weight * weight(x) * m.value;
    square += std::pow(node_weight * weight(x) * m.error, 2);
  };
  using Nodes = boost::math::quadrature::gauss<double, 14>;
  for (std::size_t i = 0; i < Nodes::abscissa().size(); ++i) {
    for (const double side : {-1.0, 1.0}) add((1 + side * Nodes::abscissa()[i]) / 2, Nodes::weights()[i] / 2);
  }
  return {sum, std::sqrt(square)};
}

TEST(ScatteringWalk, IsotropicFluenceIsTheExactOne) {
  for (const auto& [albedo, range, most_error] :
       {std::array{1.0, 0.5, 0.01}, {1.0, 6.0, 0.1}, {0.9, 1.0, 0.03}, {0.9, 4.0, 0.1}}) {
    Estimate fluence = gathered({}, albedo, range, 0, 1500);
    const double scale = 4 * pi * range;
    fluence = {scale * fluence.value + std::exp(-range) / range, scale * fluence.error};
    expect_near(fluence, exact_fluence(albedo, range), most_error,
                std::to_string(albedo) + " at " + std::to_string(range));
  }
}

TEST(ScatteringWalk, FluxThroughASphereIsThePowerOfTheLamp) {
  struct Case {
    const char* name;
    Phase phase;
    double range;
    std::uint64_t paths;
  };
  for (const Case& c : {Case{"isotropic", {}, 1, 2048}, Case{"forward", Phase::henyey_greenstein(0.85), 1, 4096},
                        Case{"droplets", Phase::droplets(10), 0.5, 4096}}) {
    Estimate flux = gathered(c.phase, 1, c.range, 1, c.paths);
    const double area = 4 * pi * c.range * c.range;
    flux = {area * flux.value + std::exp(-c.range), area * flux.error};
    expect_near(flux, 1, 0.05, c.name);
  }
}

TEST(ScatteringWalk, UniformLayersAreUniformFog) {
  const std::array<DensityKnot, 2> knots{{{-1, 0.75}, {1, 0.75}}};
  for (const double asymmetry : {0.0, 0.6}) {
    const Atmosphere uniform = fog_of(Phase::henyey_greenstein(asymmetry));
    Atmosphere layers = uniform;
    layers.fog.density = 0.25;
    layers.profile = make_density_profile(knots);
    const EyeRay ray{.direction = {0.36, 0.48, -0.8}};
    const Estimate one = walk_scattering(lamp_ahead(2), uniform, ray, paths_of(4096)).higher;
    Estimate other = walk_scattering(lamp_ahead(2), layers, ray, paths_of(2048, 2)).higher;
    other.error = std::hypot(one.error, other.error);
    expect_near(other, one.value, 0.1, std::to_string(asymmetry));
  }
}

TEST(ScatteringWalk, TwoHalvesOfALampMakeTheWhole) {
  for (const auto& [phase, most_error] : {std::pair{Phase{}, 0.05}, {Phase::henyey_greenstein(0.7), 0.05}}) {
    PlacedLight light = lamp_ahead(1);
    const Estimate whole = walk_scattering(light, fog_of(phase), ray_beside(0.3), paths_of(8192)).higher;
    light.light.cone = Cone::cosine(pi / 2, 0);
    Estimate halves;
    for (const double side : {-1.0, 1.0}) {
      light.direction = glm::dvec3(0.6, 0, 0.8) * side;
      const Estimate half = walk_scattering(light, fog_of(phase), ray_beside(0.3), paths_of(8192, 2)).higher;
      halves = {halves.value + half.value, halves.error + half.error};  // alike in their seed
    }
    halves.error = std::hypot(halves.error, whole.error);
    expect_near(halves, whole.value, most_error, std::to_string(phase.first.asymmetry));
  }
}

TEST(ScatteringWalk, AWhiteGroundInThinFogLightsItOnce) {
  const double density = 1e-3;
  Atmosphere air = fog_of({});
  air.fog.density = density;
  PlacedLight light = lamp_ahead(3);
  light.position.y = 1;
  EyeRay ray = ray_beside(0.3);
  ray.length = 6;
  // By quadrature over the ray and, in polar coordinates around the lamp's foot, the ground 2 m below the lamp.
  const double truth = integral(0, 6, 2, [&](double s) {
    const glm::dvec3 eye_point = ray.direction * s;
    return density * integral(0, pi / 2, 4, [&](double angle) {
             const double radius = 2 * std::tan(angle);
             double around = 0;
             constexpr int kAround = 96;
             for (int i = 0; i < kAround; ++i) {
               const double turn = 2 * pi * (i + 0.5) / kAround;
               const glm::dvec3 foot(radius * std::cos(turn), -1, -3 + radius * std::sin(turn));
               const glm::dvec3 up = eye_point - foot;
               around += up.y / std::pow(glm::dot(up, up), 1.5) / kAround;
             }
             // The ground sends E / pi for the unit's E / (4 pi); E = cos^3(angle) / 4, and the ring is 4 tan / cos^2
             // wide.
             return 2 * pi * around * std::pow(std::cos(angle), 3) / 4 * 4 * std::tan(angle) /
                    std::pow(std::cos(angle), 2) / pi;
           });
  });
  measure::ScatteringWalk walk = paths_of(65536);
  const Ground grey(-1, 0.5), black(-1, 0);
  walk.surroundings = &grey;
  Estimate second = walk_scattering(light, air, ray, walk).second;
  expect_near({second.value * kQuadratic, second.error * kQuadratic}, 0.5 * truth, 0.05, "white");
  walk.surroundings = &black;
  walk.paths = 1024;
  EXPECT_LT(walk_scattering(light, air, ray, walk).second.value, 0.1 * second.value);
}

TEST(ScatteringWalk, ThreadsChangeNoBit) {
  const auto of = [](std::size_t threads, std::uint64_t seed) {
    return walk_scattering(lamp_ahead(1), fog_of({}), ray_beside(0.3),
                           {.paths = 1000, .seed = seed, .threads = threads});
  };
  const auto one = of(1, 1), three = of(3, 1);
  EXPECT_EQ(one.first.value, three.first.value);
  EXPECT_EQ(one.second.value, three.second.value);
  EXPECT_EQ(one.higher.value, three.higher.value);
  EXPECT_EQ(one.higher.error, three.higher.error);
  EXPECT_NE(one.higher.value, of(1, 2).higher.value);
}

TEST(ScatteringWalk, ErrorsShrinkWithTheSquareRootOfThePaths) {
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.7)}) {
    const auto error = [&](std::uint64_t paths) {
      return walk_scattering(lamp_ahead(1), fog_of(phase), ray_beside(0.1), paths_of(paths)).higher.error;
    };
    const double ratio = error(16384) / error(1024);
    EXPECT_GT(ratio, 0.15);
    EXPECT_LT(ratio, 0.4);
  }
}

TEST(ScatteringWalk, NothingIsScatteredTwiceWithoutAlbedo) {
  const auto light = walk_scattering(lamp_ahead(1), fog_of({}, 0), ray_beside(0.3), paths_of(64));
  EXPECT_GT(light.first.value, 0);
  EXPECT_EQ(light.second.value, 0);
  EXPECT_EQ(light.higher.value, 0);
}

TEST(ScatteringWalk, RejectsWhatItHasNoLawFor) {
  const auto expect_message = [](const Atmosphere& air, const measure::ScatteringWalk& walk, const char* message) {
    try {
      walk_scattering(lamp_ahead(1), air, ray_beside(0.3), walk);
      ADD_FAILURE() << message;
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), message);
    }
  };
  Atmosphere squared = fog_of({});
  squared.fog.mode = FogMode::exp2;
  expect_message(squared, {}, "fog.mode = 1: must be exp");
  Atmosphere total = fog_of({});
  total.fog.density = INFINITY;
  expect_message(total, {}, "fog.density = inf: must be finite");
  expect_message(fog_of({}), paths_of(0), "paths = 0: must be at least 1");
}

}  // namespace
}  // namespace litfog::test
