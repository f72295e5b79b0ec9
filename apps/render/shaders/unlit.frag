// SPDX-License-Identifier: Apache-2.0
// The base texture unchanged: neither light nor fog.

#include "rasterised.glsl"

out vec4 color;

void main() { color = vec4(base_texel().rgb, 1.0); }
