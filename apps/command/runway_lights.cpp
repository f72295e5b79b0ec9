// SPDX-License-Identifier: Apache-2.0
#include "command/runway_lights.h"

#include <fmt/format.h>

#include "command/command.h"
#include "litfog/runway_visual_range.h"

namespace litfog::command {

void add_runway_lights(CLI::App& app, RunwayLights& lights) {
  add_number(app, "--lamp-cd", lights.candela, kFiniteNotNegative,
             "Intensity in candela of the lamps of --rvr; 0: only markings are seen (default 10000, a new edge light)");
  constexpr NumberRule kPositive{[](double x) { return x > 0 && kFiniteNotNegative.accepts(x); },
                                 "must be a finite number > 0"};
  static constexpr NumberRule kBackground{[](double x) { return x >= 0 && x <= kMaxBackground; },
                                          "must be a number in [0, 1e12]"};
  CLI::Option* const threshold =
      add_number(app, "--threshold-lx", lights.illuminance_threshold, kPositive,
                 "Lux at the eye at which a lamp becomes visible: 8e-7 at night, 1e-5 in twilight, 1e-4 by day, 1e-3 "
                 "on a bright day (default 8e-7)");
  const auto parse = [&lights, threshold](const std::string& text) {
    if (threshold->count() > 0) {
      throw CLI::ValidationError("--background-cd-m2 cannot be given with --threshold-lx: it gives the threshold");
    }
    const auto background = parse_number(text, kBackground);
    if (!background) fail_option("--background-cd-m2", text, kBackground.text);
    lights.illuminance_threshold = illuminance_threshold(*background);
  };
  app.add_option_function<std::string>("--background-cd-m2", parse,
                                       "Background luminance in cd/m2, from which ICAO's relation gives --threshold-lx")
      ->type_name("NUMBER");
}

void expect_lamps_reach(double metres, const RunwayLights& lights) {
  if (const auto error = find_runway_visual_range_error(metres, lights)) {
    fail_option("--rvr", fmt::format("{}", error->value), error->rule);
  }
}

}  // namespace litfog::command
