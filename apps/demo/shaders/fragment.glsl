// SPDX-License-Identifier: Apache-2.0
// A fragment of a surface: its material, and how it is seen through the fog.

#include "cookie.glsl"
#include "litfog/fog.glsl"
#include "pass.glsl"
#include "rasterised.glsl"
#include "scene.glsl"

uniform vec3 specular;
uniform float shininess;
uniform vec3 emissive;

out vec4 color;

// Light from the vertices: at the middle of a pixel that a triangle covers in part it is extrapolated, but not below none.
vec3 vertex_light(vec3 interpolated) { return max(interpolated, vec3(0.0)); }

// A pass's light from the surface as the eye sees it; the fog's own light is the first pass's to add.
vec4 seen_by_eye(vec3 lit, vec3 position) {
  if (is_first_pass) return vec4(litfog_apply_fog(lit, position, eye), 1.0);
  return vec4(lit * (1.0 - litfog_fog_opacity(distance(position, eye), 1.0)), 1.0);
}
