// SPDX-License-Identifier: Apache-2.0
// White where lit.

out vec4 color;

void main() { color = vec4(1.0); }
