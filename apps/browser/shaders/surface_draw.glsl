// SPDX-License-Identifier: Apache-2.0
// What is the same all over a draw, in place of the renderer's file: GLSL ES has no globals made of uniforms.

uniform vec3 eye;
uniform vec3 bounds_low;  // of the surface drawn
uniform vec3 bounds_high;
uniform vec3 specular;  // of its material
uniform float shininess;
uniform vec3 emissive;
uniform float normal_scale;
