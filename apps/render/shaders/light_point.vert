// SPDX-License-Identifier: Apache-2.0
// A light as the eye sees it from afar: a point as bright as the light it sends to the eye, through the fog at the
// density of its class.

#include "cookie.glsl"
#include "litfog/shaders/fog.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float pixel_scale;  // of a picture 720 pixels high

flat out vec3 point_color;
flat out float core_fraction;

// Attenuation at which a point has full brightness: at night an eye sees a light long before a surface lit by it.
const float full_brightness = 1.0 / 2000.0;

void main() {
  LitfogLight light = litfog_buffered_light(gl_VertexID);
  vec3 to_eye = eye - light.position_extent.xyz;
  float range = length(to_eye);
  to_eye /= range;
  float attenuation = litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
  float through = 1.0 - litfog_fog_opacity(range, light.attenuation.w);
  float brightness = attenuation * litfog_cone(light, to_eye) * through / full_brightness;
  // Beyond full brightness a point grows instead; below, it fades.
  float growth = clamp(pow(max(brightness, 1.0), 0.3), 1.0, 8.0);
  float radius = 1.3 * growth * pixel_scale;
  point_color = light.color_intensity.rgb * min(brightness, 1.5);
  core_fraction = 1.0 / growth;
  gl_PointSize = max(2.0 * 2.5 * radius, 2.0);
  // Moved towards the eye, so that its own housing does not hide it.
  vec3 seen_at = light.position_extent.xyz + to_eye * min(0.4, 0.5 * range);
  gl_Position = brightness * max(max(light.color_intensity.r, light.color_intensity.g), light.color_intensity.b) < 0.002
                    ? vec4(0.0, 0.0, 2.0, 1.0)
                    : clip_from_world * vec4(seen_at, 1.0);
}
