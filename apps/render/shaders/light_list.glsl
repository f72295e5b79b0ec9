// SPDX-License-Identifier: Apache-2.0
// The scene's lights, through the frame's light list (render::FramePlan), which begins with the carried lights.

#include "cookie.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform isamplerBuffer light_list;
uniform int carried_count;
uniform int first_radius;  // index in the light list; the radii of the lamps that are drawn as points

int light_entry(int i) { return texelFetch(light_list, i).x; }
LitfogLight light_at(int i) { return litfog_buffered_light(light_entry(i)); }
LitfogLight carried_light(int i) { return light_at(i); }
float source_radius_at(int point) { return intBitsToFloat(light_entry(first_radius + point)); }
