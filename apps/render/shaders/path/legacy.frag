// SPDX-License-Identifier: Apache-2.0
// One texture, and fog of one colour.

#include "depth_test.glsl"
#include "fragment.glsl"

in vec3 light;

void main() {
  float opacity = litfog_fog_opacity(distance(fragment_position(), eye), 1.0);
  color = vec4(mix(emissive + vertex_light(light) * base_texture().rgb, litfog_ambient_fog_color.rgb, opacity), 1.0);
}
