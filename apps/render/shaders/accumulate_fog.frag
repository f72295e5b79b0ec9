// SPDX-License-Identifier: Apache-2.0
// What shines by itself, and the fog over it all, whose transmittance is the alpha.

#include "fragment.glsl"

void main() {
  vec3 position = fragment_position();
  float opacity = litfog_fog_opacity(distance(position, eye), 1.0);
  color = vec4(litfog_apply_fog(emissive, position, eye), 1.0 - opacity);
}
