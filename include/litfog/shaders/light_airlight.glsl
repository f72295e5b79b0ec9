// SPDX-License-Identifier: Apache-2.0
// litfog: the airlight of a light in the block's fog along a ray from the eye, single scattering:
// litfog_airlight_unit() * colour * airlight, in the unit of surfaces that the light lights. Light on surfaces is then
// dimmed by litfog_lamp_factor() (litfog/shaders/fog.glsl).

#ifndef LITFOG_LIGHT_AIRLIGHT_GLSL
#define LITFOG_LIGHT_AIRLIGHT_GLSL

#include "litfog/shaders/fog.glsl"

#ifdef LITFOG_COOKIES
// Set by litfog_light_airlight_ray() for litfog_airlight_cookie().
LitfogLight litfog_cookie_light;
vec3 litfog_cookie_offset;     // from the light to the ray's closest approach
vec3 litfog_cookie_direction;  // the ray's
#endif
#include "litfog/shaders/airlight.glsl"

#ifdef LITFOG_COOKIES
float litfog_airlight_cookie(LitfogAirlight air, float along) {
  return litfog_cookie(litfog_cookie_light,
                       litfog_ray(vec3(0.0), litfog_cookie_offset + along * litfog_cookie_direction).xyz);
}
#endif

// Density of the fog for the light's class, 1/m.
float litfog_light_fog_density(LitfogLight light) {
  return min(litfog_fog.x * light.attenuation.w, LITFOG_DENSEST_FOG);
}

// Factor of the density profile for the light's class; 0 where there are no layers.
float litfog_layer_scale(LitfogLight light) { return litfog_knot_count() > 0 ? light.attenuation.w : 0.0; }

// The light relative to a ray from the eye, for litfog_airlight() with as many nodes as its stated errors need.
//
// direction  unit, from the eye
// range      metres along it: to the surface or the end of the fog
LitfogAirlight litfog_light_airlight_ray(LitfogLight light, vec3 eye, vec3 direction, float range) {
  vec3 to_light = light.position_extent.xyz - eye;
  float approach = dot(to_light, direction);
  vec3 offset = approach * direction - to_light;
#ifdef LITFOG_COOKIES
  litfog_cookie_light = light;
  litfog_cookie_offset = offset;
  litfog_cookie_direction = direction;
#endif
  float density = litfog_light_fog_density(light);
  return LitfogAirlight(density, litfog_fog_mode(), 1.0, litfog_fog_phase(), light.attenuation.x, light.attenuation.y,
                        light.attenuation.z, light.position_extent.w, light.axis_profile.w, light.cone.x, light.cone.y,
                        range, approach, length(offset), dot(offset, light.axis_profile.xyz),
                        dot(direction, light.axis_profile.xyz), 0.0, litfog_layer_scale(light),
                        eye.y + approach * direction.y, direction.y, light.position_extent.y);
}

// The light's airlight along a ray, with the arguments of litfog_light_airlight_ray().
vec3 litfog_light_airlight(LitfogLight light, vec3 eye, vec3 direction, float range) {
  vec3 color = litfog_airlight_unit() * light.color_intensity.rgb;
  LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
  air.nodes = litfog_airlight_nodes(air);
  // A light that adds little along this ray needs few nodes. In isotropic fog, relative errors are some 3 % with 4
  // nodes and 0.5 % with 6 for a point light, and some 10 % with 4, 2 % with 8 and 0.3 % with 12 for others. In other
  // fog they are some 10 % with 8 and 2 % with 12 for a point light, and 3 % with 12 and 0.3 % with 20 for others. A
  // cookie's errors fall with the square of the number of nodes, and show less in a bright picture.
  LitfogAirlightStretch stretch = litfog_airlight_stretch(air);
  float most = max(max(color.r, color.g), color.b) * litfog_airlight_bound(air, stretch);
  if (air.profile == LITFOG_PROFILE_COOKIE) {
    air.nodes = clamp(156.0 * pow(most, 0.3), 8.0, 512.0);
  } else if (litfog_airlight_is_layered(air)) {
    air.nodes *= most < 0.0015 ? 0.5 : most < 0.03 ? 0.75 : 1.0;
  } else if (litfog_airlight_is_shaped(air)) {
    if (air.profile == LITFOG_PROFILE_NONE) {
      air.nodes = most < 0.0004 ? 8.0 : most < 0.004 ? 12.0 : air.nodes;
    } else {
      air.nodes = most < 0.002 ? 12.0 : most < 0.03 ? 20.0 : air.nodes;
    }
  } else if (litfog_is_isotropic(air.phase)) {
    if (air.profile == LITFOG_PROFILE_NONE) {
      air.nodes = most < 0.0015 ? 4.0 : most < 0.03 ? 6.0 : air.nodes;
    } else {
      air.nodes = most < 0.0004 ? 4.0 : most < 0.008 ? 8.0 : most < 0.03 ? 12.0 : air.nodes;
    }
  }
  return color * litfog_airlight_along(air, stretch);
}

#endif
