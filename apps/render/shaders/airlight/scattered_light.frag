// SPDX-License-Identifier: Apache-2.0
// The light that fog scatters to a texel of the grid of render::ScatteredLight, of all lamps.

#include "generated/airlight_constants.glsl"
#include "litfog/shaders/light_buffer.glsl"
#include "litfog/shaders/layered_scattering.glsl"
#include "litfog/shaders/multiple_scattering.glsl"
#include "pixel_direction.glsl"

uniform vec3 eye;
uniform isamplerBuffer far_lights;
uniform int light_count;
uniform samplerBuffer scattering_sources;  // HigherOrders::sources
uniform float grid_depth;                  // metres along a ray that the grid covers
uniform int slice_count;                   // along a ray: slices grow with the distance from the eye
uniform int slice;

layout(location = 0) out vec4 all;   // of each colour
layout(location = 1) out vec4 flow;  // of luminance, and luminance from all directions

void main() {
  float part = (float(slice) + 0.5) / float(slice_count);
  float seen = grid_depth * part * part * part;
  // Nearer lamps than a third of a texel count as so far away, because what they light is smaller than a texel.
  float least_range = 0.33 * max(seen * length(pixel_size), 3.0 * grid_depth * part * part / float(slice_count));
  vec3 direction = pixel_direction(ivec2(gl_FragCoord.xy));
  vec3 position = eye + seen * direction;
  all = vec4(0.0);
  flow = vec4(0.0);
  for (int i = 0; i < light_count; ++i) {
    int index = texelFetch(far_lights, i).x;
    if (index < 0) index = -1 - index;
    LitfogLight light = litfog_buffered_light(index);
    vec4 source = texelFetch(scattering_sources, index);
    vec3 away = position - light.position_extent.xyz;
    float range = max(length(away), least_range);
    away /= range;
    vec3 axis = light.axis_profile.xyz;
    float cosine = clamp(dot(away, axis), -1.0, 1.0);
    vec3 turned = away * cosine - axis;
    turned *= inversesqrt(max(dot(turned, turned), 1.0e-12));
    LitfogAirlight air = litfog_light_airlight_ray(light, eye, direction, seen);
    LitfogScatteredLight scattered =
        litfog_airlight_is_layered(air)
            ? litfog_scattered_light_in_layers(air, position.y, range, source.w, source.y, cosine, source.z)
            : litfog_scattered_light(air.density, range, source.w, source.y, cosine, source.z);
    vec3 color = source.x * light.color_intensity.rgb;
    float luminance = dot(color, vec3(0.2126, 0.7152, 0.0722));  // Rec. 709
    all.rgb += color * scattered.all;
    flow += luminance * vec4(scattered.radial * away + scattered.turned * turned, scattered.all);
  }
}
