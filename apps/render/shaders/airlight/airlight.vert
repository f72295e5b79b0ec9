// SPDX-License-Identifier: Apache-2.0
// An instance is a light of the list: a quad over the pixels whose rays can show more of its airlight than a budget, or
// that a grid has left out.

#include "airlight_constants.glsl"
#include "airlight_entry.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
// Scale and offset in clip space: the target's texels may be farther apart than pixels.
uniform vec4 target_from_picture;
uniform int first_entry;
uniform float block_angle;  // across a block of texels at the picture's middle, where it is largest: radians

flat out int light_index;
flat out vec2 bend_range_width;

void main() {
  vec4 entry = texelFetch(airlight_entries, first_entry + gl_InstanceID);
  light_index = int(entry.x);
  bend_range_width = entry.zw;
  LitfogLight light = litfog_buffered_light(light_index);
  float radius = is_filled ? min(entry.y, left_out_range(entry.z, entry.w, 2 * pixel_step)) : entry.y;
  if (radius <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside the picture
    return;
  }
  // The cone's part of that sphere is within a ball at its end, or between that and the light.
  vec3 apex = light.position_extent.xyz;
  vec3 centre = apex;
  if (!is_filled && (profile == LITFOG_PROFILE_COSINE || profile == LITFOG_PROFILE_SMOOTHSTEP)) {
    float cos_cut = max(light.cone.x, 0.0);
    centre += light.axis_profile.xyz * (radius * cos_cut);
    radius *= sqrt(1.0 - cos_cut * cos_cut);
  }
  vec3 toward = centre - eye;
  float range = length(toward);
  toward /= range;
  vec3 toward_apex = apex - eye;
  float apex_depth = dot(toward_apex, toward);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  if (range < 1.05 * radius || apex_depth < 0.2 * length(toward_apex)) {  // around the eye: the whole picture
    gl_Position = vec4(corner, 0.0, 1.0);
    return;
  }
  // Across the line of sight, as large as the ball appears there and as far as the light, and at least half a metre
  // away, so that the rounding of the eye's position turns it little.
  float half_size = radius / sqrt(range * range - radius * radius);  // at a distance of 1
  vec3 to_apex = toward_apex / apex_depth - toward;
  float apex_size = length(to_apex);
  vec3 right = apex_size > 0.01 * half_size ? to_apex / apex_size
               : normalize(cross(toward, abs(toward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(right, toward);
  float far_size = max(half_size, apex_size);
  if (is_packed) {  // a texel may stand for one that far away
    half_size += block_angle * (1.0 + half_size * half_size);
    far_size += block_angle * (1.0 + far_size * far_size);
  }
  vec3 place = toward + right * (corner.x < 0.0 ? -half_size : far_size) + up * (corner.y * half_size);
  gl_Position = clip_from_world * vec4(eye + place * max(range, 0.5), 1.0);
  gl_Position.xy = gl_Position.xy * target_from_picture.xy + gl_Position.w * target_from_picture.zw;
  gl_Position.z = 0.0;
}
