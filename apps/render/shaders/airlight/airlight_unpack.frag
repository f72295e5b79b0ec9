// SPDX-License-Identifier: Apache-2.0
// Moves packed texels back to their positions in the grid.

#include "airlight/airlight_blocks.glsl"
#include "airlight/seen.glsl"
#include "pixel_direction.glsl"

uniform sampler2DRect packed_airlight;
uniform sampler2DRect packed_gain;
uniform int pixel_step;  // pixels between texels
uniform vec3 eye;

layout(location = 0) out vec4 airlight;
layout(location = 1) out vec4 gain;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 block = here / block_size;
  int here_in_block = morton_index(here - block * block_size);
  uint marks[mark_words] = marks_of(block);
  int index = 0;
  for (int word = 0; word < mark_words; ++word) {
    int below = clamp(here_in_block - 32 * word, 0, 32);  // bits of the word
    uint mask = below == 32 ? 0xffffffffu : (1u << uint(below)) - 1u;
    index += count_bits(marks[word] & mask);
  }
  ivec2 place = block * block_stride * block_size + morton_position(index);
  ivec2 pixel = here * pixel_step;
  float opacity = mean_of(seen_opacities(eye, pixel_direction(pixel), seen_at(pixel), 1.0));
  airlight = vec4(texel_at(packed_airlight, place).rgb, opacity);
  gain = texel_at(packed_gain, place);
}
