// SPDX-License-Identifier: Apache-2.0
// A fragment shader that includes this first, behind surface.vert, takes a draw's bounds from the vertices, and what
// else is the same all over a draw where those pass it on (draw_constants.glsl).

#include "pass.glsl"

#define BOUNDS_FROM_VERTICES
#ifdef VERTICES_PASS_CONSTANTS
#define CONSTANTS_FROM_VERTICES
#endif
