// SPDX-License-Identifier: Apache-2.0
// A fragment of a pane with the airlight before it.

#include "compose/compose.glsl"
#include "cookie.glsl"
#include "litfog/shaders/far_airlight.glsl"
#include "scene.glsl"

uniform samplerBuffer airlight_entries;  // render::AirlightEntry
uniform int airlight_count;              // 0 where the scene is not lit by airlight

#include "airlight/far_airlight_at.glsl"
#include "airlight/shaft.glsl"

// The airlight before the fragment. The airlight behind it is added later, times the transmittance of the panes.
vec3 airlight_before(vec3 position) {
  float range = distance(position, eye);
  vec3 direction = (position - eye) / max(range, 1.0e-6);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < airlight_count; ++i) {
    vec4 entry = texelFetch(airlight_entries, i);
    int index = int(entry.x);
    LitfogLight light = litfog_buffered_light(index);
    vec3 to_light = light.position_extent.xyz - eye;
    vec3 offset = to_light - clamp(dot(to_light, direction), 0.0, range) * direction;
    if (dot(offset, offset) > entry.y * entry.y) continue;
    float lit = has_shafts ? lit_fraction(index, light, direction, range) : 1.0;
    sum += lit * litfog_light_airlight(light, eye, direction, range);
    if (!(has_shafts && cuts_shafts(index)) && far_depth > 0.0) {
      LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, range);
      sum += light.color_intensity.rgb * (litfog_airlight_unit() * litfog_far_peak(air));
    }
  }
  return sum + far_airlight_at(gl_FragCoord.xy, range, eye.y, direction.y);
}

// The pane's colour, premultiplied by its opacity.
vec4 over_what_is_behind(vec3 seen) {
  return compose_pane(seen, airlight_before(fragment_position()), fragment_opacity());
}
