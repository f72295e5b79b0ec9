// SPDX-License-Identifier: Apache-2.0
// Range attenuation from a 3-D map (Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section
// "Embedding Range Attenuation in a Texture Map").

#include "depth_test.glsl"
#include "path/lookup.glsl"

uniform sampler3D range_map;

float range_attenuation(vec3 str) { return texture(range_map, map_coordinate(str, textureSize(range_map, 0).x)).r; }
