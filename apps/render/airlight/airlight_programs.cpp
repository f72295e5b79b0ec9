// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_programs.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "render/airlight/airlight_bound.h"
#include "render/gpu/render_shaders.h"

namespace litfog::render {

const gl::Program& AirlightPrograms::program(const Atmosphere& atmosphere, const AirlightKind& lights) {
  const bool is_isotropic = litfog::is_isotropic(atmosphere.phase);
  const std::tuple key(atmosphere.fog.mode, atmosphere.profile.count, lights, is_isotropic);
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  const std::string constants = fmt::format(
      "#define LITFOG_FOG_MODE {}.0\n"
      "#define LITFOG_KNOT_COUNT {}\n"
      "{}"
      "#define LITFOG_ISOTROPIC {}\n"
      "const float profile = {}.0;  // of the lights to draw\n"
      "const bool has_far_peak = {};\n"
      "const float most_flattened = {:.1f};\n"
      "{}",
      int(atmosphere.fog.mode), atmosphere.profile.count, lights.has_knee ? "" : "#define LITFOG_NO_KNEE\n",
      is_isotropic ? 1 : 0, lights.profile, lights.has_far_peak, AirlightBound::kMostFlattened,
      lights.has_higher_orders ? "#define HAS_HIGHER_ORDERS\n" : "");
  std::vector<gl::ShaderSource> files = scene_shaders(lights.profile == kCookieProfile, lights.has_shafts);
  files.push_back({"generated/airlight_constants.glsl", constants});
  return programs_.emplace(key, gl::Program(vertex_file_, fragment_file_, files)).first->second;
}

}  // namespace litfog::render
