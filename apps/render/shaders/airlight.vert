// SPDX-License-Identifier: Apache-2.0
// Instance i is light i of the light list: a quad over the pixels whose rays can show more of its airlight than a
// budget.
//
// The bound is litfog_glow_bound(). It also holds for what a ray receives from beyond a range h, whatever its closest
// approach. So the part of the light's cone within that range need be covered.

#include "cookie.glsl"
#include "light_list.glsl"
#include "litfog/shaders/glow.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float budget;         // of the airlight times the largest component of the colour
uniform float largest_phase;  // of the phase function over its isotropic value
uniform vec4 target_from_picture;  // scale and offset in clip space: the target's texels may be farther apart than pixels
uniform bool takes_cookies;        // only lights with a cookie, which may be finer than the grid; else only the others
uniform bool is_core;              // only the pixels around the light in which its airlight bends sharply
uniform float pixels_per_radian;   // at the middle of the picture

flat out int light_index;

// Range at which a light's denominator has a value.
float level_range(LitfogLight light, float value) {
  return litfog_level_range(value, light.attenuation.x, light.attenuation.y, light.attenuation.z);
}

// Range from the light beyond which its airlight is below the budget; 0 where it is so everywhere.
float airlight_reach(LitfogLight light, float eye_range, float brightness) {
  float share = budget / brightness;
  float integral = share / max(litfog_glow_weight(light, eye_range), 1.0e-30);  // that of the attenuation may not exceed
  float denominator = min(1.0 / share, 2.0 * light.position_extent.w / integral);
  float quadratic = light.attenuation.z;
  if (quadratic > 0.0) denominator = min(denominator, 16.0 / (quadratic * integral * integral));
  if (denominator <= max(light.attenuation.x, 1.0)) return 0.0;
  return min(level_range(light, denominator), light.position_extent.w);
}

// Range from the light within which a grid of every fourth pixel misses its airlight by more than about 1/1000. At h
// pixels from the light that is k / h with k from the bound, the grid's error 2 (k / h)'' = 4 k / h^3, and less within
// the falloff's width.
float core_reach(LitfogLight light, float eye_range, float brightness) {
  float pixels = pixels_per_radian / eye_range;  // a metre
  float width = level_range(light, 2.0 * max(light.attenuation.x, 1.0));
  float slope = max(light.attenuation.z, light.attenuation.y / max(width, 1.0e-3));
  float k = brightness * litfog_glow_weight(light, eye_range) * 4.0 / max(slope, 1.0e-30) * pixels;
  float core = pow(4000.0 * k, 1.0 / 3.0);
  return core > width * pixels ? min(core + 4.0, 400.0) / pixels : 0.0;
}

void main() {
  light_index = light_entry(gl_InstanceID);
  LitfogLight light = litfog_buffered_light(light_index);
  vec3 center = light.position_extent.xyz;
  float eye_range = distance(eye, center);
  vec3 color = light.color_intensity.rgb * largest_phase;
  float brightness = max(max(max(color.r, color.g), color.b), 1.0e-30);
  float radius = airlight_reach(light, eye_range, brightness);
  if (is_core) radius = min(radius, core_reach(light, eye_range, brightness));
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  if (radius <= 0.0 || (light.axis_profile.w == 3.0) != takes_cookies) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside the picture
    return;
  }
  // The sphere around the cone's part of that range.
  float cos_cut = light.axis_profile.w == 1.0 || light.axis_profile.w == 2.0 ? light.cone.x : -1.0;
  if (cos_cut > 0.70710678) {
    radius *= 0.5 / cos_cut;
    center += light.axis_profile.xyz * radius;
  } else if (cos_cut > 0.0) {
    center += light.axis_profile.xyz * (radius * cos_cut);
    radius *= sqrt(1.0 - cos_cut * cos_cut);
  }
  vec3 toward = center - eye;
  float range = length(toward);
  if (range < 1.05 * radius) {  // around the eye: the whole picture
    gl_Position = vec4(corner, 0.0, 1.0);
    return;
  }
  // Across the line of sight, as large as the sphere appears there, and at least half a metre away, so that the near
  // plane does not cut it.
  toward /= range;
  float half_size = radius / sqrt(range * range - radius * radius);  // at a distance of 1
  vec3 right = normalize(abs(toward.y) < 0.9 ? cross(toward, vec3(0.0, 1.0, 0.0)) : cross(toward, vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(right, toward);
  vec3 place = toward + (right * corner.x + up * corner.y) * half_size;
  gl_Position = clip_from_world * vec4(eye + place * max(range, 0.5), 1.0);
  gl_Position.xy = gl_Position.xy * target_from_picture.xy + gl_Position.w * target_from_picture.zw;
  gl_Position.z = 0.0;
}
