// SPDX-License-Identifier: Apache-2.0
// Metals by Robert Cook and Kenneth Torrance 1982, "A Reflectance Model for Computer Graphics" (further reading of The
// Cg Tutorial, chapter 5): facets of a Beckmann distribution of slopes, which shadow and mask each other, under
// Fresnel's reflection, here by Christophe Schlick's approximation of 1994. A metal has no diffuse light; its
// reflectance at normal incidence is its base colour. Other materials keep the Basic model. The Basic model's diffuse
// term lacks the factor 1 / pi; this leaves it out as well, so that the two compare.

#include "depth_test.glsl"
#include "cookie.glsl"
#include "litfog/shaders/surface.glsl"
#include "surface_draw.glsl"

vec3 cook_torrance(LitfogSurface surface, vec3 to_light, vec3 color) {
  if (metal_roughness == 0.0) return litfog_reflect(surface, to_light, color);
  float nl = dot(surface.normal, to_light);
  float nv = dot(surface.normal, surface.to_eye);
  if (nl <= 0.0 || nv <= 0.0) return vec3(0.0);
  vec3 h = normalize(to_light + surface.to_eye);
  float nh = dot(surface.normal, h);
  float vh = dot(surface.to_eye, h);
  float m2 = metal_roughness * metal_roughness;
  float nh2 = nh * nh;
  float d = exp((nh2 - 1.0) / (nh2 * m2)) / (m2 * nh2 * nh2);
  float g = min(1.0, min(2.0 * nh * nv / vh, 2.0 * nh * nl / vh));
  vec3 f = surface.diffuse + (1.0 - surface.diffuse) * pow(1.0 - vh, 5.0);
  return color * f * (d * g / (4.0 * nv));
}

#define litfog_reflect cook_torrance
#include "path/unified.frag"
