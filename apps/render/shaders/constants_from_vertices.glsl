// SPDX-License-Identifier: Apache-2.0
// A fragment shader that includes this first takes what is the same all over a draw from the vertices where those pass
// it on (draw_constants.glsl).

#include "pass.glsl"

#ifdef VERTICES_PASS_CONSTANTS
#define CONSTANTS_FROM_VERTICES
#endif
