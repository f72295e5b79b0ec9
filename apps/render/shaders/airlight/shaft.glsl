// SPDX-License-Identifier: Apache-2.0
// The fraction of a light's airlight that surfaces do not block. In a picture with shafts, mapped_shaft.glsl replaces
// this file.

bool cuts_shafts(int light_index) { return false; }
float lit_fraction(int light_index, LitfogLight light, vec3 direction, float range) { return 1.0; }
float lit_fraction_at(int light_index, vec3 position) { return 1.0; }
