// SPDX-License-Identifier: Apache-2.0
// litfog: fog between the eye and a fragment, and the lights' part in it.

#include "litfog/light.glsl"

// Opacity 1 - f of the fog over a range, for what sees its density scaled (light classes; surfaces: 1).
float litfog_fog_opacity(float range, float density_scale) {
  float density = min(litfog_fog.x * density_scale, 3.4e38);  // finite: at range 0 infinity would give NaN
  return litfog_opacity(litfog_fog.y == 0.0 ? litfog_depth_exp(range, density) : litfog_depth_exp2(range, density));
}

// A light's part in the fog colour of a fragment: colour * cone * fog colour intensity (Hales 2004, "Lighting in Fog").
// The one place where lights light the fog.
vec3 litfog_light_fog(FogLight light, vec3 position) {
  vec3 direction = litfog_ray(light.position_extent.xyz, position).xyz;
  return light.color_intensity.rgb * (litfog_cone(light, direction) * light.color_intensity.w);
}

// All lights' parts together.
#ifdef LITFOG_FOG_LIGHTS  // the includer knows which lights can light the fog where it draws, and adds up their parts
vec3 litfog_lights_fog(vec3 position);
#else
vec3 litfog_lights_fog(vec3 position) {
  vec3 color = vec3(0.0);
  int count = int(litfog_fog.z);
  for (int i = 0; i < count; ++i) color += litfog_light_fog(litfog_lights[i], position);
  return color;
}
#endif

// Fragment fog colour = ambient fog colour + the lights' parts.
vec3 litfog_fog_color(vec3 position) { return litfog_ambient_fog_color.rgb + litfog_lights_fog(position); }

// The fragment as the eye sees it: mix(fog, surface, f).
vec3 litfog_apply_fog(vec3 color, vec3 position, vec3 eye) {
  float opacity = litfog_fog_opacity(distance(position, eye), 1.0);
  if (opacity <= 0.0) return color;
  return color + (litfog_fog_color(position) - color) * opacity;
}
