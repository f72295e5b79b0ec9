// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace litfog {
struct RunwayLights;
}

namespace litfog::command {

/// Adds --lamp-cd, --background-cd-m2 and --threshold-lx, which relate --rvr and density
/// (fog_from_runway_visual_range). CLI11 reads options in the order in which they are added, so these must precede
/// --rvr.
void add_runway_lights(CLI::App& app, RunwayLights& lights);

/// Throws the usage error of an --rvr that no lamp reaches.
void expect_lamps_reach(double metres, const RunwayLights& lights);

}  // namespace litfog::command
