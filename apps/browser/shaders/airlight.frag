// SPDX-License-Identifier: Apache-2.0
// Composes the picture with the lamps' airlight.

#include "compose/compose.glsl"
#include "fog_top.glsl"
#include "light_list.glsl"
#include "litfog/shaders/light_airlight.glsl"
#include "pixel_direction.glsl"

uniform sampler2D picture;  // lit.frag
uniform vec3 eye;

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(picture, pixel, 0);
  vec3 direction = pixel_direction(pixel);
  float end = fog_before_sky(direction);
  float range = seen.a * end > 1.0 ? 1.0 / seen.a : end;
  vec3 sum = vec3(0.0);
  int count = int(litfog_fog.z);
  for (int i = 0; i < count; ++i) sum += litfog_light_airlight(light_at(i), eye, direction, range);
  color = vec4(compose(seen.rgb, sum), 1.0);
}
