// SPDX-License-Identifier: Apache-2.0
#include "render/surface/sky_painter.h"

#include <epoxy/gl.h>

#include <vector>

#include "render/gpu/depth.h"
#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/plan/fog_top.h"

namespace litfog::render {

void draw_sky(const gl::Program& program, const View& view, const scene::Scene& scene) {
  const scene::Environment& environment = scene.environment;
  set_uniform(program, "direction_from_clip", view.direction_from_clip);
  set_uniform(program, "far_plane", far_plane_in_clip());
  set_uniform(program, "eye", view.eye);
  set_uniform(program, "sky_zenith", environment.sky_zenith);
  set_uniform(program, "sky_horizon", environment.sky_horizon);
  set_uniform(program, "star_brightness", environment.star_brightness);
  set_uniform(program, "moon_direction", environment.moon_direction);
  set_uniform(program, "moon_color", environment.moon_color);
  set_fog_top(program, view.top_above_eye);
  set_moonlight(program, view);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

const gl::Program& SkyPainter::program(SkyDrawing drawing, bool is_lit) {
  const auto found = programs_.find({drawing, is_lit});
  if (found != programs_.end()) return found->second;
  std::vector<gl::ShaderSource> files;  // earlier files hide later ones of the same name
  if (drawing == SkyDrawing::fog) {
    files.push_back({"night_sky.glsl",
                     "uniform vec3 moon_direction;\n"
                     "uniform vec3 moon_color;\n"
                     "vec3 night_sky(vec3 direction) { return vec3(0.0); }\n"});
  }
  if (!is_lit) files.push_back({"carried_fog.glsl", "vec3 litfog_lights_fog(vec3 position) { return vec3(0.0); }\n"});
  const std::vector<gl::ShaderSource> rest = scene_shaders(!scene_.cookies.empty());
  files.insert(files.end(), rest.begin(), rest.end());
  return programs_.emplace(std::pair(drawing, is_lit), gl::Program("sky.vert", "sky.frag", files)).first->second;
}

void SkyPainter::draw(const View& view, SkyDrawing drawing, std::size_t carried_count) {
  if (drawing == SkyDrawing::background) return;
  const gl::Program& program = this->program(drawing, carried_count > 0);
  program.use();
  bind_lights(program, fog_lights_);
  set_uniform(program, "light_list", kLightListUnit);
  set_uniform(program, "carried_count", int(carried_count));
  draw_sky(program, view, scene_);
}

}  // namespace litfog::render
