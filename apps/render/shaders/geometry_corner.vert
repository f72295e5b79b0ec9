// SPDX-License-Identifier: Apache-2.0
// surface.vert before a geometry shader.

#define rasterised_position corner_position
#define uv corner_uv
#define tint corner_tint
#define map_uvs corner_map_uvs
#define normal corner_normal
#define tangent corner_tangent
#include "surface.vert"
