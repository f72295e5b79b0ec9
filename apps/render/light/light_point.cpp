// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_point.h"

#include <epoxy/gl.h>

#include "render/gpu/depth.h"
#include "render/gpu/uniform.h"
#include "render/light/point_list.h"

namespace litfog::render {

PointShaders point_shaders(FogLighting fog_lighting) {
  if (fog_lighting == FogLighting::airlight) return {"lamp_disc.vert", "lamp_disc.frag"};
  return {"light_point.vert", "light_point.frag"};
}

void draw_light_points(const gl::Program& program, const View& view, FogLighting fog_lighting, int first, int count) {
  set_uniform(program, "clip_from_world", view.clip_from_world);
  set_uniform(program, "eye", view.eye);
  set_uniform(program, "near_plane", kNearPlane);
  set_uniform(program, "has_clip_control", has_clip_control());
  set_uniform(program, "first_point", first);
  if (fog_lighting == FogLighting::airlight) {
    set_uniform(program, "pixels_per_radian", float(view.pixels_per_radian));
    set_uniform(program, "disc_edge", kDiscEdge);
  } else {
    set_uniform(program, "full_brightness", kFullBrightness);
    set_uniform(program, "brightest", kBrightestPoint);
    set_uniform(program, "core_radius", kPointRadius);
    set_uniform(program, "point_radii", kPointRadii);
    set_uniform(program, "largest_growth", kMaxGlare);
    set_uniform(program, "halo_brightness", kHaloBrightness);
    set_uniform(program, "pixel_scale", float(view.size.y) / kPointPictureHeight);
  }
#ifdef GL_PROGRAM_POINT_SIZE  // which OpenGL ES always has
  glEnable(GL_PROGRAM_POINT_SIZE);
#endif
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_POINTS, 0, count);
  glDisable(GL_BLEND);
}

}  // namespace litfog::render
