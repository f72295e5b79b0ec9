// SPDX-License-Identifier: Apache-2.0
// A distant light in pictures by peak: a point with glare, as bright as the light that reaches the eye through fog at
// the density of the light's class (by airlight: lamp_disc.vert). Constants without a source are chosen by eye;
// point_list.h has those that the CPU needs to leave out points.

#include "cookie.glsl"
#include "light_list.glsl"
#include "light_point.glsl"
#include "litfog/shaders/fog.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float point_radii;  // the point's size in radii of its glare, which is black beyond half of it
uniform float pixel_scale;  // the picture's height over kPointPictureHeight
uniform int first_point;  // in the light list
// point_list.h:
uniform float full_brightness;
uniform float brightest;
uniform float core_radius;
uniform float largest_growth;

flat out vec3 point_color;
flat out float core_fraction;

const float glare_power = 0.3;   // how glare grows with brightness; Stevens 1957, "On the psychophysical law": 0.33

void main() {
  LitfogLight light = light_at(first_point + gl_VertexID);
  vec3 to_eye = eye - light.position_extent.xyz;
  float range = length(to_eye);
  to_eye /= range;
  float attenuation = litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
  float through = 1.0 - litfog_fog_opacity(light.position_extent.y, eye.y, range, light.attenuation.w);
  float sent = attenuation * litfog_cone(light, to_eye);
  float brightness = sent * through / full_brightness;
  // Above full brightness a point grows; below, it fades. Fog dims a point's glare but does not shrink it.
  float growth = clamp(pow(max(sent / full_brightness, 1.0), glare_power), 1.0, largest_growth);
  float radius = core_radius * growth * pixel_scale;
  point_color = light.color_intensity.rgb * min(brightness, brightest);
  core_fraction = 1.0 / growth;
  gl_PointSize = max(point_radii * radius, 2.0);
  vec4 lifted = clip_from_world * vec4(light.position_extent.xyz + to_eye * lift(range), 1.0);
  gl_Position = brightness > 0.0 ? lifted : vec4(0.0, 0.0, 2.0, 1.0);  // outside the picture
}
