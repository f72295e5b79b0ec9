// SPDX-License-Identifier: Apache-2.0
// Draws points over blocks or, where is_left_out, for each light (an instance) a quad over the texels for which the
// coarser grid leaves out part of its airlight.

#include "generated/airlight_constants.glsl"
#include "airlight/airlight_entry.glsl"
#include "airlight/block_point.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
// Scale and offset in clip space: the target's texels may be farther apart than pixels.
uniform vec4 target_from_picture;

flat out int left_out_entry;  // of the light, in airlight_entries

void draw_light() {
  vec4 entry = texelFetch(airlight_entries, left_out_entry);
  float radius = min(entry.y, left_out_range(entry.z, entry.w, 2 * pixel_step));
  if (radius <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside the picture
    return;
  }
  vec3 toward = litfog_buffered_position_extent(int(entry.x)).xyz - eye;
  float range = length(toward);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  if (range < 1.05 * radius) {  // around the eye: the whole picture
    gl_Position = vec4(corner, 0.0, 1.0);
    return;
  }
  toward /= range;
  // Across the line of sight, as large as the ball appears there, and at least half a metre away, so that the rounding
  // of the eye's position turns it little.
  float half_size = radius / sqrt(range * range - radius * radius);  // at a distance of 1
  vec3 right = normalize(cross(toward, abs(toward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(right, toward);
  vec3 place = toward + (right * corner.x + up * corner.y) * half_size;
  gl_Position = clip_from_world * vec4(eye + place * max(range, 0.5), 1.0);
  gl_Position.xy = gl_Position.xy * target_from_picture.xy + gl_Position.w * target_from_picture.zw;
  gl_Position.z = 0.0;
}

void main() {
  left_out_entry = first_entry + gl_InstanceID;
  if (is_left_out) draw_light();
  else draw_block();
}
