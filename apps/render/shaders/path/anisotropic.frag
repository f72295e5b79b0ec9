// SPDX-License-Identifier: Apache-2.0
// Brushed metals (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", chapter 5, exercise 7) by Wolfgang
// Heidrich and Hans-Peter Seidel 1998, "Efficient Rendering of Anisotropic Surfaces Using Computer Graphics Hardware":
// a groove along the tangent has every normal perpendicular to it; the one that sends most light to the eye counts.
// Other materials keep the Basic model.

#include "depth_test.glsl"
#include "cookie.glsl"
#include "litfog/shaders/surface.glsl"
#include "surface_draw.glsl"
#include "world_normal.glsl"

vec3 brushed(LitfogSurface surface, vec3 to_light, vec3 color) {
  if (metal_roughness == 0.0) return litfog_reflect(surface, to_light, color);
  if (dot(surface.normal, to_light) <= 0.0) return vec3(0.0);
  vec3 t = normalize(tangent.xyz);
  float lt = dot(to_light, t);
  float vt = dot(surface.to_eye, t);
  float nl = sqrt(max(1.0 - lt * lt, 0.0));
  float vr = nl * sqrt(max(1.0 - vt * vt, 0.0)) - lt * vt;
  // The grooves' normal is not the surface's; the surface shadows light from below.
  return color * dot(surface.normal, to_light) *
         (surface.diffuse * nl + surface.specular * pow(max(vr, 0.0), surface.shininess));
}

#define litfog_reflect brushed
#include "path/unified.frag"
