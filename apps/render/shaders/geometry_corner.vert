// SPDX-License-Identifier: Apache-2.0
// surface.vert before a geometry shader.

#define rasterised_position corner_position
#define uv corner_uv
#define normal corner_normal
#define tangent corner_tangent
#include "surface.vert"
