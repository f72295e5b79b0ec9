// SPDX-License-Identifier: Apache-2.0
#include "render/plan/fog_top.h"

#include <algorithm>

#include "render/gpu/uniform.h"

namespace litfog::render {

void set_fog_top(const gl::Program& program, double above_eye) {
  // Twice the sky's distance stands for infinity, so that no float overflows.
  set_uniform(program, "sky_distance", kSkyDistance);
  set_uniform(program, "fog_above_eye", float(std::clamp(above_eye, -1.0, 2.0 * kSkyDistance)));
}

bool is_fog_moonlit(const scene::Environment& environment, const Atmosphere& atmosphere, FogLighting fog_lighting) {
  return fog_lighting == FogLighting::airlight && environment.has_moon() && atmosphere.fog.mode == FogMode::exp &&
         atmosphere.thickest_fog().density > 0;
}

void set_moonlight(const gl::Program& program, const View& view) {
  constexpr double kHighest = 1e9;  // higher tops count as infinite
  set_uniform(program, "is_fog_moonlit", view.is_fog_moonlit);
  set_uniform(program, "light_top", float(std::clamp(view.light_top, -kHighest, kHighest)));
}

}  // namespace litfog::render
