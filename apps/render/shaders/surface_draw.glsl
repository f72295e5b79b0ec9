// SPDX-License-Identifier: Apache-2.0
// What stays the same within a draw call of a surface.

uniform vec3 eye;

// The surface's.
uniform vec3 bounds_low;
uniform vec3 bounds_high;

// Its material's.
uniform float coverage;  // a mask's least coverage; a pane's opacity where texels and vertices have 1
uniform float normal_scale;
uniform float relief;  // range of heights, in tiles
uniform vec3 specular;
uniform float shininess;
uniform vec3 uniform_emissive;
uniform float metal_roughness;  // 0: no metal

vec3 emissive = uniform_emissive;  // material.frag multiplies it by a texture
