// SPDX-License-Identifier: Apache-2.0
#include "render/plan/fog_top.h"

#include <algorithm>

#include "render/gpu/uniform.h"

namespace litfog::render {

void set_fog_top(const gl::Program& program, const scene::Scene& scene) {
  // Twice the sky's distance stands for an infinite one, so that nothing finite overflows a float.
  const double above_eye = std::clamp(scene.fog_top - scene.camera.position.y, -1.0, 2.0 * kSkyDistance);
  set_uniform(program, "sky_distance", kSkyDistance);
  set_uniform(program, "fog_above_eye", float(above_eye));
}

}  // namespace litfog::render
