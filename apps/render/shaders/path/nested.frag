// SPDX-License-Identifier: Apache-2.0
// Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation of Games", section "Break
// out of the shader as soon as possible": the lights in nested ifs, so that the shader ends at the first light whose
// flag is off. "As long as there is light data, there is a boolean set to true. Once no more data is available, the
// next boolean is set to false." His listings 3.1 (the arrays of lights and flags) and 3.2 (the shader) are pictures
// without text; this follows the section's words.
//
// One program draws every number of lights up to 16, his boolean registers; more are read from the light list, which
// needs no flags. His example has 6 lights, and his compiler nests up to 24. The lighting is that of unified.frag, which
// is compiled for the number of lights that a surface has.

#include "depth_test.glsl"
#include "lit_surface.glsl"
#include "light_batch.glsl"

uniform bool light_flags[batch_size];

void add_flagged_lights(LitfogSurface surface, inout vec3 lit) {
#define BEGIN_IF(i) if (light_flags[i]) { lit += lamp_shadow(i) * lit_by(surface, batch_light(i));
#define END_IF(i) }
  EACH_LIGHT(BEGIN_IF)
  EACH_LIGHT(END_IF)
#undef BEGIN_IF
#undef END_IF
}

#undef EACH_LIGHT
#define EACH_LIGHT(DO) add_flagged_lights(surface, lit);
#include "path/unified.frag"
