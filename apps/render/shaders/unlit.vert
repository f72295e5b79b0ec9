// SPDX-License-Identifier: Apache-2.0
// Places a vertex, and no more.

#include "vertex.glsl"

void main() { place_vertex(); }
