// SPDX-License-Identifier: Apache-2.0
// The distance from the lamp, in units of its reach. Unlike a projected depth it is the same in all maps of a lamp, and
// as precise far from the lamp as near it.

uniform float lamp_radius;  // metres, within which nothing casts a shadow
uniform float reach;        // metres

in vec3 from_lamp;

void main() {
  float range = length(from_lamp);
  if (range < lamp_radius) discard;
  gl_FragDepth = range / reach;
}
