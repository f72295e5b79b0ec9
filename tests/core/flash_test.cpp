// SPDX-License-Identifier: Apache-2.0
#include "litfog/flash.h"

#include <gtest/gtest.h>

#include <string>

#include "reference/digits50.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

/// Two flashes that touch, and one that ends with the period.
const Flash kTriple{2, 3, {{{0, 0.25, 5}, {0.25, 0.25}, {1.5, 0.5, 0.5}}}};

std::string rule_broken_by(const Flash& flash) {
  const auto error = find_error(flash);
  return error ? to_string(*error) : "accepted";
}

/// The error of kTriple with one member of its second flash replaced.
std::string error_with(double SingleFlash::*member, double value) {
  Flash flash = kTriple;
  flash.flashes[1].*member = value;
  return rule_broken_by(flash);
}

TEST(Flash, LampIsOnFromItsStartUntilItsEndInEachPeriod) {
  for (const double periods : {0.0, 1.0, 1000.0, 499'999'999.0}) {
    const auto at = [&](double seconds) { return flash_at(kTriple, 2 * periods + seconds); };
    constexpr double kStep = 0x1p-20;
    EXPECT_EQ(at(0), 5) << periods;
    EXPECT_EQ(at(0.25 - kStep), 5);
    EXPECT_EQ(at(0.25), 1);
    EXPECT_EQ(at(0.5 - kStep), 1);
    EXPECT_EQ(at(0.5), 0);
    EXPECT_EQ(at(1.5 - kStep), 0);
    EXPECT_EQ(at(1.5), 0.5);
    EXPECT_EQ(at(2 - kStep), 0.5);
  }
}

TEST(Flash, TimeWithinThePeriodIsExactUpToTheLargestTime) {
  Random random(12);
  for (int i = 0; i < 10'000; ++i) {
    const double period = random.log_uniform(1e-3, kMaxFlashPeriod);
    const Flash flash{period, 1, {{{random.uniform(0, 0.5) * period, random.uniform(0.1, 0.5) * period}}}};
    const double seconds = random.log_uniform(1e-3, kMaxFlashSeconds);
    const Digits50 within = Digits50(seconds) - floor(Digits50(seconds) / period) * period;
    const auto& [start, duration, intensity] = flash.flashes[0];
    const bool is_on = within >= start && within < Digits50(start + duration);
    ASSERT_EQ(flash_at(flash, seconds), is_on ? 1 : 0) << seconds << " of " << period;
  }
}

TEST(Flash, SteadyLampKeepsItsColour) {
  EXPECT_EQ(flash_at({}, 7), 1);
  EXPECT_EQ(largest_flash({}), 1);
  EXPECT_EQ(rule_broken_by({.period = -1}), "accepted");
  EXPECT_EQ(largest_flash(kTriple), 5);
}

TEST(Flash, EndThatRoundsBeyondTheNextStartOrThePeriodIsAccepted) {
  EXPECT_EQ(rule_broken_by({0.3, 1, {{{0.1, 0.2}}}}), "accepted");
  EXPECT_EQ(rule_broken_by({1, 2, {{{0.1, 0.2}, {0.3, 0.7}}}}), "accepted");
}

TEST(Flash, PatternThatNoLampHasIsAnError) {
  EXPECT_EQ(rule_broken_by(kTriple), "accepted");
  for (const double period : {0.0, -1.0, 3600.1, kNan, kInfinity}) {
    Flash flash = kTriple;
    flash.period = period;
    EXPECT_TRUE(rule_broken_by(flash).ends_with(": must be in (0, 3600]")) << period;
  }
  EXPECT_EQ(rule_broken_by({.period = 1, .count = 9}), "flash.count = 9: must be at most 8");
  const std::string order = ": must be >= 0 and not before the end of the flash before it";
  EXPECT_EQ(error_with(&SingleFlash::start, 0.2), "flash.flashes[1].start = 0.2" + order);
  EXPECT_EQ(error_with(&SingleFlash::start, kNan), "flash.flashes[1].start = nan" + order);
  EXPECT_EQ(rule_broken_by({1, 1, {{{-0.1, 0.2}}}}), "flash.flashes[0].start = -0.1" + order);
  EXPECT_EQ(error_with(&SingleFlash::duration, 0), "flash.flashes[1].duration = 0: must be > 0");
  EXPECT_EQ(error_with(&SingleFlash::duration, kNan), "flash.flashes[1].duration = nan: must be > 0");
  EXPECT_EQ(rule_broken_by({3600, 1, {{{3000, 1e-13}}}}),
            "flash.flashes[0].duration = 1e-13: must be longer than a rounding of the start");
  EXPECT_EQ(error_with(&SingleFlash::duration, 1.8), "flash.flashes[1].duration = 1.8: must end within the period");
  EXPECT_EQ(error_with(&SingleFlash::start, kInfinity), "flash.flashes[1].duration = 0.25: must end within the period");
  for (const double intensity : {0.0, -1.0, 1.1e6, kNan, kInfinity}) {
    EXPECT_TRUE(error_with(&SingleFlash::intensity, intensity).ends_with(": must be in (0, 1e6]")) << intensity;
  }
}

}  // namespace
}  // namespace litfog::test
