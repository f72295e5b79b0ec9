// SPDX-License-Identifier: Apache-2.0
// One texture, and fog of one colour.

#include "depth_test.glsl"
#include "fragment.glsl"

in vec3 light;

void main() {
  float opacity = opacity_before(fragment_position());
  color = vec4(mix(emissive + vertex_light(light) * base_texture().rgb, litfog_ambient_fog_color.rgb, opacity), 1.0);
}
