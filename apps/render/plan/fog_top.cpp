// SPDX-License-Identifier: Apache-2.0
#include "render/plan/fog_top.h"

#include <algorithm>

#include "render/gpu/uniform.h"

namespace litfog::render {

void set_fog_top(const gl::Program& program, double above_eye) {
  // Twice the sky's distance stands for an infinite one, so that nothing finite overflows a float.
  set_uniform(program, "sky_distance", kSkyDistance);
  set_uniform(program, "fog_above_eye", float(std::clamp(above_eye, -1.0, 2.0 * kSkyDistance)));
}

}  // namespace litfog::render
