// SPDX-License-Identifier: Apache-2.0
// Only transforms a vertex.

#include "vertex.glsl"

void main() { place_vertex(); }
