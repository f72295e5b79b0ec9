// SPDX-License-Identifier: Apache-2.0
// The scene's lights, through the light list: the indices of the lights that the eye's vehicle carries, then of the
// local lights, then of the local lights that reach each surface.

#include "cookie.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform isamplerBuffer light_list;
uniform int carried_count;

int light_entry(int i) { return texelFetch(light_list, i).x; }
LitfogLight carried_light(int i) { return litfog_buffered_light(light_entry(i)); }
LitfogLight local_light(int i) { return litfog_buffered_light(light_entry(carried_count + i)); }
