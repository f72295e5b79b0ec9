// SPDX-License-Identifier: Apache-2.0
// The sum of the lights' airlight, to be added to the picture.
uniform sampler2D airlight;

out vec4 color;

void main() { color = vec4(texelFetch(airlight, ivec2(gl_FragCoord.xy), 0).rgb, 0.0); }
