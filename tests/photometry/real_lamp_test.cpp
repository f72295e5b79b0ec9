// SPDX-License-Identifier: Apache-2.0
// Files of real lamps, which tests/data/photometry/make_real_lamps.py writes from published figures. It prints the
// answers.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "litfog/photometry/axial_beam.h"
#include "litfog/photometry/eulumdat.h"
#include "litfog/photometry/ies.h"
#include "photometry/photometric_file.h"
#include "reference/degree.h"

namespace litfog::test {
namespace {

constexpr const char* kFiles[] = {"landing_lamp.ies", "approach_light.ies", "position_light.ies",
                                  "runway_edge_light.ldt"};

/// The direction of type C's angles in degrees.
glm::dvec3 direction_of(double turn_deg, double gamma_deg) {
  const double turn = turn_deg * kDegree, gamma = gamma_deg * kDegree;
  return {std::sin(gamma) * std::cos(turn), std::sin(gamma) * std::sin(turn), -std::cos(gamma)};
}

/// What make_real_lamps.py prints: flux, peak, and on one half plane the angles at 50 % and 10 % of the peak.
struct KnownLamp {
  const char* file;
  double flux, peak, turn_deg, half_deg, tenth_deg;
};

TEST(RealLamps, OurFilesHaveTheFluxPeakAndHalfAnglesOfTheirGenerator) {
  for (const auto& [file, flux, peak, turn_deg, half_deg, tenth_deg] :
       {KnownLamp{"landing_lamp.ies", 1516.69431, 100000.039, 0, 3.295328, 6.000008},
        {"approach_light.ies", 2017.22934, 30000, 0, 10.962717, 14},
        {"position_light.ies", 25.6553973, 40, 0, 90 + 15, 90 + 30},
        {"runway_edge_light.ldt", 636.823851, 9999.99, 3.5, 90 + 6.000018, 90 + 10.799996}}) {
    SCOPED_TRACE(file);
    const auto distribution = our_luminaire(file).distribution;
    EXPECT_NEAR(luminous_flux(distribution), flux, 1e-8 * flux);
    EXPECT_NEAR(find_peak(distribution).intensity, peak, 1e-8 * peak);
    EXPECT_NEAR(intensity_at(distribution, direction_of(turn_deg, half_deg)), 0.5 * peak, 1e-6 * peak);
    EXPECT_NEAR(intensity_at(distribution, direction_of(turn_deg, tenth_deg)), 0.1 * peak, 1e-6 * peak);
  }
}

TEST(RealLamps, OurFilesHaveTheOdditiesOfMakersFiles) {
  const Luminaire landing = our_luminaire("landing_lamp.ies");
  EXPECT_EQ(landing.name, "GE 4509, 100 W, 4\xC2\xBD in");   // a Latin-1 byte
  EXPECT_DOUBLE_EQ(landing.opening.width, -0.375 * 0.3048);  // feet; round
  EXPECT_EQ(landing.lamp_flux, 1900);
  const Luminaire approach = our_luminaire("approach_light.ies");
  EXPECT_EQ(approach.distribution.type, PhotometryType::b);
  EXPECT_TRUE(approach.is_absolute);
  const glm::dvec3 corner = direction_of(30, 5);
  for (const double x : {-corner.x, corner.x}) {
    for (const double y : {-corner.y, corner.y}) {
      EXPECT_EQ(intensity_at(approach.distribution, {x, y, corner.z}), 30000);  // four quadrants
    }
  }
  const auto position = our_luminaire("position_light.ies").distribution;
  EXPECT_EQ(position.horizontal.size(), 9u);
  EXPECT_NEAR(intensity_at(position, direction_of(20, 90)), 30, 1e-9);
  EXPECT_NEAR(intensity_at(position, direction_of(110, 85)), 4, 1e-9);  // 0.80 of 5 cd, below and above
  EXPECT_NEAR(intensity_at(position, direction_of(110, 95)), 4, 1e-9);
  EXPECT_EQ(intensity_at(position, direction_of(200, 90)), 0);
  const Luminaire runway = our_luminaire("runway_edge_light.ldt");
  EXPECT_EQ(runway.name, "Landebahnfeuer wei\xC3\x9F/gelb");
  EXPECT_NEAR(intensity_at(runway.distribution, direction_of(176.5, 90)), 4000, 0.02);  // yellow is 0.40 of white
}

TEST(RealLamps, LampSendsOutItsStatedFluxOrLessThanItsLampsGive) {
  for (const char* file : kFiles) {
    SCOPED_TRACE(file);
    const Luminaire luminaire = our_luminaire(file);
    const double flux = luminous_flux(luminaire.distribution);
    std::printf("%-50s %9.1f lm, asymmetry %.3f", file, flux,
                AxialBeam(luminaire.distribution, kPhotometricAxis).asymmetry());
    if (const auto stated = stated_flux(luminaire)) {
      std::printf(", stated %.1f lm", *stated);
      EXPECT_NEAR(flux, *stated, 0.005 * flux);
    } else if (luminaire.lamp_flux) {
      std::printf(", %.1f %% of the lamps'", 100 * flux / *luminaire.lamp_flux);
      EXPECT_LT(flux, *luminaire.lamp_flux);
      EXPECT_GT(flux, 0.3 * *luminaire.lamp_flux);
    }
    std::printf("\n");
  }
}

}  // namespace
}  // namespace litfog::test
