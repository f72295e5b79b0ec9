// SPDX-License-Identifier: Apache-2.0
// litfog: the glow of a light in the fog of the block, as the eye sees it along a ray: colour * airlight.

#ifndef LITFOG_GLOW_GLSL
#define LITFOG_GLOW_GLSL

#include "litfog/shaders/light_block.glsl"

#ifdef LITFOG_COOKIES
LitfogLight litfog_glow_light;    // for a cookie: the light
vec3 litfog_glow_offset;          // from it to the ray's closest approach
vec3 litfog_glow_direction;       // of the ray
#endif
#include "litfog/shaders/airlight.glsl"

#ifdef LITFOG_COOKIES
float litfog_airlight_cookie(LitfogAirlight air, float along) {
  return litfog_cookie(litfog_glow_light, litfog_ray(vec3(0.0), litfog_glow_offset + along * litfog_glow_direction).xyz);
}
#endif

// direction  unit, from the eye
// range      metres along it: to the surface or to the end of the fog
// lamp_leg   1 where the light loses f(r) on its way from the lamp, 0 where it does not
// asymmetry  g of Henyey and Greenstein's phase function, in (-1, 1)
vec3 litfog_glow(LitfogLight light, vec3 eye, vec3 direction, float range, float lamp_leg, float asymmetry) {
  vec3 to_light = light.position_extent.xyz - eye;
  float approach = dot(to_light, direction);
  vec3 offset = approach * direction - to_light;
#ifdef LITFOG_COOKIES
  litfog_glow_light = light;
  litfog_glow_offset = offset;
  litfog_glow_direction = direction;
#endif
  float density = min(litfog_fog.x * light.attenuation.w, 1.0e6);  // a visibility of micrometres
  return light.color_intensity.rgb *
         litfog_airlight(LitfogAirlight(density, litfog_fog.y, lamp_leg, asymmetry, light.attenuation.x,
                                        light.attenuation.y, light.attenuation.z, light.position_extent.w,
                                        light.axis_profile.w, light.cone.x, light.cone.y, range, approach,
                                        length(offset), dot(offset, light.axis_profile.xyz),
                                        dot(direction, light.axis_profile.xyz)));
}

#endif
