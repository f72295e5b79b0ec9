// SPDX-License-Identifier: Apache-2.0
// The last pass: shows the picture as a display does.

#include "display.glsl"

uniform sampler2D picture;
uniform float exposure_gain;
uniform bool is_neutral;

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(picture, 0);
  vec3 light = texelFetch(picture, pixel, 0).rgb;
  vec3 shown = toned(is_neutral, vec3(exposed(light.r, exposure_gain), exposed(light.g, exposure_gain),
                                      exposed(light.b, exposure_gain)));
  uint red = uint(3 * ((size.y - 1 - pixel.y) * size.x + pixel.x));
  color = vec4(shown_level(shown.r, red), shown_level(shown.g, red + 1u), shown_level(shown.b, red + 2u), 255.0) / 255.0;
}
