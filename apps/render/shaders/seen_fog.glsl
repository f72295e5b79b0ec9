// SPDX-License-Identifier: Apache-2.0
// litfog's fog, its parameters from the vertices where those pass them on.

#include "draw_constants.glsl"
#include "litfog/shaders/light_block.glsl"

#ifdef CONSTANTS_FROM_VERTICES
flat in vec4 vertex_fog;
flat in vec4 vertex_ambient_fog_color;
#define litfog_fog vertex_fog
#define litfog_ambient_fog_color vertex_ambient_fog_color
#endif
#include "litfog/shaders/fog.glsl"
