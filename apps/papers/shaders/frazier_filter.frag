// SPDX-License-Identifier: Apache-2.0
// The second of two passes of a spot light: what is drawn so far, times the light's cube map. "We would begin to see
// some artifacts in some situations where 2 or more lights shine on the same pixel": the map of one light filters the
// others, too (Ronald Frazier 2000, section "Converting a Point Light Into a Spot Light"). Here all lights are added
// before the first is filtered; light by light, only the last one would be right.

#include "depth_test.glsl"
#include "path/light_coordinates.glsl"

uniform samplerCube cone_map;

void main() { color = vec4(vec3(texture(cone_map, cone_coordinate(0)).r), 1.0); }
