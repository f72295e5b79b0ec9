// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_point.h"

#include "render/gpu/depth.h"
#include "render/gpu/uniform.h"
#include "render/light/point_list.h"

namespace litfog::render {

void set_point_uniforms(const gl::Program& program, FogLighting fog_lighting, int height, bool has_clip_control) {
  const bool has_glare = fog_lighting == FogLighting::peak;
  set_uniform(program, "has_glare", has_glare);
  set_uniform(program, "full_brightness", kFullBrightness);
  set_uniform(program, "brightest", kBrightestPoint);
  set_uniform(program, "core_radius", kPointRadius);
  set_uniform(program, "point_radii", kPointRadii);
  set_uniform(program, "largest_growth", has_glare ? kLargestGlare : kLargestWithoutGlare);
  set_uniform(program, "halo_brightness", kHaloBrightness);
  set_uniform(program, "pixel_scale", float(height) / kPointPictureHeight);
  set_uniform(program, "near_plane", kNearPlane);
  set_uniform(program, "has_clip_control", has_clip_control);
}

}  // namespace litfog::render
