// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_program.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "render/render_shaders.h"

namespace litfog::render {

gl::Program make_airlight_program(const char* vertex_file, const char* fragment_file, const scene::Scene& scene,
                                  FogMode fog_mode, int profile, bool has_shafts, bool has_knee) {
  const std::string constants = fmt::format(
      "#define LITFOG_FOG_MODE {}.0\n"
      "{}"
      "const float profile = {}.0;  // of the lights to draw\n"
      "{}",
      int(fog_mode), has_knee ? "" : "#define LITFOG_NO_KNEE\n", profile,
      scene.phase_g == 0 ? "const float asymmetry = 0.0;\n" : "uniform float asymmetry;\n");
  std::vector<gl::ShaderSource> files = scene_shaders(profile == kCookieProfile, has_shafts);
  files.push_back({"airlight_constants.glsl", constants});
  return gl::Program(vertex_file, fragment_file, files);
}

}  // namespace litfog::render
