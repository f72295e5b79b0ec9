// SPDX-License-Identifier: Apache-2.0
// What is the same all over a draw: uniforms, because GLSL ES has no globals made of others.

uniform vec3 eye;
uniform vec3 bounds_low;  // of the surface drawn
uniform vec3 bounds_high;
uniform vec3 specular;  // of its material
uniform float shininess;
uniform vec3 emissive;
uniform float normal_scale;
