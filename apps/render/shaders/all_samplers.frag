// SPDX-License-Identifier: Apache-2.0
// Uses every sampler (gpu/sampler_states.h).
uniform sampler2D maps[16];
out vec4 color;

void main() {
  ivec2 sum = textureSize(maps[0], 0) + textureSize(maps[1], 0) + textureSize(maps[2], 0) + textureSize(maps[3], 0) +
        textureSize(maps[4], 0) + textureSize(maps[5], 0) + textureSize(maps[6], 0) + textureSize(maps[7], 0) +
        textureSize(maps[8], 0) + textureSize(maps[9], 0) + textureSize(maps[10], 0) + textureSize(maps[11], 0) +
        textureSize(maps[12], 0) + textureSize(maps[13], 0) + textureSize(maps[14], 0) + textureSize(maps[15], 0);
  color = vec4(sum, sum);
}
