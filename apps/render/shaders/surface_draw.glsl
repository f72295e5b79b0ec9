// SPDX-License-Identifier: Apache-2.0
// What is the same all over a draw of a surface.

uniform vec3 eye;

// Of the surface.
uniform vec3 bounds_low;
uniform vec3 bounds_high;

// Of its material.
uniform float coverage;  // the least of a mask; of a pane, where its texels and vertices have 1
uniform float normal_scale;
uniform float relief;  // the range of its heights, in tiles
uniform vec3 specular;
uniform float shininess;
uniform vec3 uniform_emissive;
uniform float metal_roughness;  // 0: no metal

vec3 emissive = uniform_emissive;  // material.frag multiplies it by a texture
