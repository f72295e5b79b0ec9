// SPDX-License-Identifier: Apache-2.0
// litfog: the airlight that lights add beyond their extents. One light adds little, but thousands add most of the fog's
// light. It changes slowly over the picture, so it is summed over all lights in a coarse grid of rays once per frame
// (litfog/gl/far_airlight.h), and fragments look the sum up.
//
// Scattering angles below litfog_far_peak_angle count as that angle, because the peak of a phase function is too
// narrow for the grid. litfog_far_peak() is what is missing of a light, for a host that draws it light by light.
//
// In Vulkan the grid is at LITFOG_SET (default 0) and LITFOG_FAR_AIRLIGHT_BINDING (default 6).

#ifndef LITFOG_FAR_AIRLIGHT_GLSL
#define LITFOG_FAR_AIRLIGHT_GLSL

#include "litfog/shaders/light_airlight.glsl"
#include "litfog/shaders/light_buffer.glsl"

#ifdef VULKAN
#ifndef LITFOG_FAR_AIRLIGHT_BINDING
#define LITFOG_FAR_AIRLIGHT_BINDING 6
#endif
layout(set = LITFOG_SET, binding = LITFOG_FAR_AIRLIGHT_BINDING)
#endif
// A texel is a ray; texels at the edges lie on the picture's edges. Layer i has the airlight (rgb) up to the end of
// slab i of the ray, and that end's distance from the eye in metres (alpha). Linear filters, clamped to the edges.
uniform highp sampler2DArray litfog_far_airlight_grid;

const int litfog_far_slabs = 8;  // one layer per draw buffer; every OpenGL 3.3 has 8
const float litfog_far_peak_angle = LITFOG_FAR_PEAK_ANGLE;
const float litfog_far_peak_versine = 2.0 * sin(0.5 * litfog_far_peak_angle) * sin(0.5 * litfog_far_peak_angle);
const float litfog_far_peak_cotangent = 1.0 / tan(litfog_far_peak_angle);

// Where a slab begins, in metres from the eye. Slabs grow with distance.
//
// depth  metres that all slabs cover together
float litfog_far_slab_begin(int slab, float depth) {
  float part = float(slab) / float(litfog_far_slabs);
  return depth * part * part;
}

// A light's airlight beyond its extent between two points of a ray. Multiply it by the light's colour and
// litfog_airlight_unit(). The fog is taken as uniform between the points; 1 / range^2 is its mean there, and the cone
// and the scattering angle are those of the middle.
//
// direction   unit, from the eye
// begin, end  metres along the ray, begin < end
float litfog_far_airlight_between(LitfogLight light, LitfogPhase phase, vec3 eye, vec3 direction, float begin,
                                  float end) {
  vec3 to_light = light.position_extent.xyz - eye;
  float extent = light.position_extent.w;
  float approach = dot(to_light, direction);
  float square = max(dot(to_light, to_light) - approach * approach, 0.0);
  float half_chord = sqrt(max(extent * extent - square, 0.0));
  float inner = max(begin, approach - half_chord);
  float outer = max(min(end, approach + half_chord), inner);
  float beyond = (end - begin) - (outer - inner);  // metres of the ray
  if (!(beyond > 0.0)) return 0.0;
  // The integral of 1 / range^2. Rays that nearly meet the light pass it at 1/50 of the extent, which changes the
  // integral beyond the extent by less than 1/2500.
  float offset = max(sqrt(square), 0.02 * extent);
  vec4 x = vec4(begin, end, inner, outer) - approach;
  float integral = (atan(offset * (end - begin), offset * offset + x.x * x.y) -
                    atan(offset * (outer - inner), offset * offset + x.z * x.w)) / offset;
  float range = max(sqrt(beyond / max(integral, 1.0e-30)), extent);
  float middle = 0.5 * (begin + end);
  vec3 to_middle = litfog_ray(to_light, direction * middle).xyz;
  float scale = light.attenuation.w;
  float scattered = (litfog_fog_opacity(eye.y, eye.y + end * direction.y, end, scale) -
                     litfog_fog_opacity(eye.y, eye.y + begin * direction.y, begin, scale)) * (beyond / (end - begin)) *
                    litfog_lamp_factor(light, eye.y + middle * direction.y, range) * litfog_cone(light, to_middle) *
                    litfog_attenuation(range, light.attenuation.x, light.attenuation.y, light.attenuation.z);
  if (litfog_is_isotropic(phase)) return scattered;
  return scattered * litfog_phase(phase, max(1.0 + dot(direction, to_middle), litfog_far_peak_versine));
}

// The layers of the grid at a ray for some lights of light_buffer.glsl; layers of other lights are added to them.
//
// first, count  the range of lights
// depth         metres along the ray that the grid covers
void litfog_sum_far_airlight(int first, int count, vec3 eye, vec3 direction, float depth,
                             out vec4 layers[litfog_far_slabs]) {
  LitfogPhase phase = litfog_fog_phase();
  for (int slab = 0; slab < litfog_far_slabs; ++slab) layers[slab] = vec4(0.0);
  for (int i = first; i < first + count; ++i) {
    LitfogLight light = litfog_buffered_light(i);
    vec3 color = litfog_airlight_unit() * light.color_intensity.rgb;
    for (int slab = 0; slab < litfog_far_slabs; ++slab) {
      float begin = litfog_far_slab_begin(slab, depth);
      float end = litfog_far_slab_begin(slab + 1, depth);
      layers[slab].rgb += color * litfog_far_airlight_between(light, phase, eye, direction, begin, end);
    }
  }
  for (int slab = 0; slab < litfog_far_slabs; ++slab) {
    if (slab > 0) layers[slab].rgb += layers[slab - 1].rgb;
    layers[slab].a = litfog_far_slab_begin(slab + 1, depth);
  }
}

// The airlight that all lights add beyond their extents along a ray from the eye.
//
// place      the fragment's position in the picture, from 0 to 1, y up: gl_FragCoord.xy over the picture's size
// direction  unit, from the eye
// range      metres along it: to the surface or the end of the fog
vec3 litfog_far_airlight(vec2 place, vec3 eye, vec3 direction, float range) {
  vec2 size = vec2(textureSize(litfog_far_airlight_grid, 0).xy);
  vec2 at = (place * (size - 1.0) + 0.5) / size;
  float depth = texelFetch(litfog_far_airlight_grid, ivec3(0, 0, litfog_far_slabs - 1), 0).a;
  if (!(depth > 0.0)) return vec3(0.0);  // nothing has been drawn
  float reached = min(range, depth);
  int slab = min(int(sqrt(reached / depth) * float(litfog_far_slabs)), litfog_far_slabs - 1);
  vec3 before = slab > 0 ? textureLod(litfog_far_airlight_grid, vec3(at, float(slab - 1)), 0.0).rgb : vec3(0.0);
  vec3 behind = textureLod(litfog_far_airlight_grid, vec3(at, float(slab)), 0.0).rgb;
  // Within the slab the airlight grows with the fog's opacity.
  float begin = litfog_far_slab_begin(slab, depth);
  float end = litfog_far_slab_begin(slab + 1, depth);
  float hidden = litfog_fog_opacity(eye.y, eye.y + begin * direction.y, begin, 1.0);
  float more = litfog_fog_opacity(eye.y, eye.y + reached * direction.y, reached, 1.0) - hidden;
  float most = litfog_fog_opacity(eye.y, eye.y + end * direction.y, end, 1.0) - hidden;
  return mix(before, behind, clamp(more / max(most, 1.0e-30), 0.0, 1.0));
}

// What the peak of the phase function adds to a light's airlight beyond its extent. Along rays that pass the light
// within litfog_far_peak_angle, the fog between the eye and the extent scatters more, by the difference of the phase
// function to its value at that angle. Multiply it by the light's colour and litfog_airlight_unit().
//
// air  from litfog_light_airlight_ray()
float litfog_far_peak(LitfogAirlight air) {
  if (litfog_is_isotropic(air.phase)) return 0.0;
  // The stretch ends at these distances before the closest approach to the light.
  float nearest = max(max(litfog_airlight_chord(air, air.extent), air.offset * litfog_far_peak_cotangent),
                      air.approach - air.ray_length);
  if (!(air.approach > nearest) || air.offset * litfog_far_peak_cotangent >= air.approach || nearest <= 0.0) return 0.0;
  float at_peak_angle = litfog_phase(air.phase, litfog_far_peak_versine);
  LitfogPhase phase = air.phase;
  air.phase = litfog_isotropic;
  float size = log(air.approach / nearest);
  float sum = 0.0;
  const int nodes = 6;
  const int first = nodes * (nodes - 1) / 2;
  for (int i = first; i < first + nodes; ++i) {
    float before = nearest * exp(size * litfog_gauss_nodes[i]);
    float at_range = litfog_airlight_range(air, -before);
    float above = litfog_phase(phase, litfog_airlight_versine(air, -before, at_range)) - at_peak_angle;
    sum += litfog_gauss_weights[i] * before * above * litfog_airlight_integrand(air, -before);
  }
  return size * sum;
}

#endif
