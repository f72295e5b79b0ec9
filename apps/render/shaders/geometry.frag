// SPDX-License-Identifier: Apache-2.0
// The inputs of a fragment's shading. The CPU shades from them in double.

#define WITHOUT_COLOR
#include "rasterised.glsl"

in vec3 normal;
in vec4 tangent;

uniform float material;  // the material's number

layout(location = 0) out vec4 position_material;
layout(location = 1) out vec4 normal_texel;
layout(location = 2) out vec4 vertex_tangent;
layout(location = 3) out vec4 vertex_normal_gloss;
layout(location = 4) out vec4 emission;
layout(location = 5) out vec4 albedo_depth;

void main() {
  vec4 base = base_texture();
  position_material = vec4(fragment_position(), material);
  normal_texel = texture(normal_map, map_uvs.xy);
  vertex_tangent = tangent;
  vertex_normal_gloss = vec4(normal, base.a);
  emission = vec4(emissive, fragment_opacity());
  albedo_depth = vec4(base.rgb, 0.0);  // each sample has its own depth: geometry_sample.frag
}
