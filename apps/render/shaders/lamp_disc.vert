// SPDX-License-Identifier: Apache-2.0
// A lamp in pictures by airlight: a disc whose light reaches the eye through fog at the density of the lamp's class
// (Allard's law). Its pixels times their solid angles add up to pi times the illuminance at the eye, both in the unit
// of colours: a white surface at E lux shows E / pi. A disc smaller than a pixel is enlarged to one.

#include "cookie.glsl"
#include "light_list.glsl"
#include "light_point.glsl"
#include "litfog/shaders/fog.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float pixels_per_radian;  // at the picture's centre
uniform float disc_edge;          // half the width of a disc's soft edge, pixels
uniform int first_point;          // in the light list

flat out vec3 disc_color;
flat out float disc_radius;  // pixels
flat out float point_size;   // pixels

void main() {
  LitfogLight light = light_at(first_point + gl_VertexID);
  vec3 to_eye = eye - light.position_extent.xyz;
  float range = length(to_eye);
  to_eye /= range;
  float opacity = litfog_fog_opacity(light.position_extent.y, eye.y, range, light.attenuation.w);
  vec3 arriving = light.color_intensity.rgb *
                  (litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z) *
                   litfog_cone(light, to_eye) * (1.0 - opacity));
  vec4 lifted = clip_from_world * vec4(light.position_extent.xyz + to_eye * lift(range), 1.0);
  // A pixel's solid angle falls with the cube of the cosine from the picture's centre.
  float cosine = lifted.w / (range - lift(range));
  float solid_angle = cosine * cosine * cosine / (pixels_per_radian * pixels_per_radian);
  float radius = source_radius_at(gl_VertexID);
  disc_radius = max(radius * inversesqrt((range * range + radius * radius) * solid_angle), 1.0);
  // The soft edge adds 1/5 of its squared half width to the squared radius: the integral of smoothstep.
  disc_color = arriving / (solid_angle * (disc_radius * disc_radius + 0.2 * disc_edge * disc_edge));
  point_size = 2.0 * (disc_radius + disc_edge) + 1.0;
  gl_PointSize = point_size;
  bool is_seen = max(max(arriving.r, arriving.g), arriving.b) > 0.0;
  gl_Position = is_seen ? lifted : vec4(0.0, 0.0, 2.0, 1.0);  // outside the picture
}
