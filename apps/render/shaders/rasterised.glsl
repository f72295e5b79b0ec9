// SPDX-License-Identifier: Apache-2.0
// A fragment of a surface as rasterised: its position and its textures.

#include "surface_draw.glsl"
#include "generated/material.glsl"

in vec3 rasterised_position;
in vec2 uv;
#ifdef VERTEX_DETAILS
in vec4 tint;
in vec4 map_uvs;
#else
#define map_uvs uv.xyxy
#endif

uniform sampler2D albedo_map;  // rgb reflectance, a gloss, or coverage of a mask or pane
uniform sampler2D normal_map;

// Coordinates at which a texture is looked up; parallax.frag shifts them.
#ifndef texture_uv
#define texture_uv(coordinates) (coordinates)
#endif

// The position, clamped to the surface's bounds: a partly covered pixel is shaded at its centre, which near the horizon
// may be many metres beyond the surface, within reach of other lights. With one sample a pixel this never happens.
#ifdef ONE_SAMPLE
vec3 fragment_position() { return rasterised_position; }
#else
vec3 fragment_position() { return clamp(rasterised_position, bounds_low, bounds_high); }
#endif
vec3 drawn_back() { return fragment_position() - rasterised_position; }

// The base texture and the vertices' colour; a is coverage.
vec4 base_texel() {
#ifdef VERTEX_DETAILS
  return texture(albedo_map, texture_uv(uv)) * tint;
#else
  return texture(albedo_map, texture_uv(uv));
#endif
}

// Reflectance by the first texture and the vertices' colour; a is gloss.
#if defined MATERIAL_UNLIT
vec4 first_texture() { return vec4(0.0, 0.0, 0.0, 1.0); }  // unlit materials only emit
#elif defined MATERIAL_MASK || defined MATERIAL_PANE
vec4 first_texture() { return vec4(base_texel().rgb, 1.0); }
#elif defined VERTEX_DETAILS
vec4 first_texture() {
  vec4 texel = texture(albedo_map, texture_uv(uv));
  return vec4(texel.rgb * tint.rgb, texel.a);
}
#else
vec4 first_texture() { return texture(albedo_map, texture_uv(uv)); }
#endif

#ifdef MATERIAL_SECOND_TEXTURE
uniform sampler2D second_map;
uniform float second_tiles;  // tiles of the second texture on one tile of the first
vec3 second_texture() { return texture(second_map, texture_uv(uv) * second_tiles).rgb; }
#else
vec3 second_texture() { return vec3(1.0); }
#endif

vec4 base_texture() { return first_texture() * vec4(second_texture(), 1.0); }

// Ka of the Basic model, where the base texture is its Kd.
#ifdef MATERIAL_AMBIENT
uniform vec3 ambient_color;
vec3 ambient_reflectance(vec3 base) { return ambient_color; }
#else
vec3 ambient_reflectance(vec3 base) { return base; }
#endif

// The fraction of the background that the fragment hides.
#ifdef MATERIAL_PANE
float fragment_opacity() { return clamp(base_texel().a * coverage, 0.0, 1.0); }
#else
float fragment_opacity() { return 1.0; }
#endif

// The normal map's normal in tangent space. The map's alpha selects the level that means 0 (Material::normal): 128 if
// alpha is below 1 and holds a height, 127.5 if it is 1.
#ifdef MATERIAL_FLAT
vec3 mapped_normal() { return vec3(0.0, 0.0, 1.0); }
#else
vec3 mapped_normal() {
  vec4 texel = texture(normal_map, texture_uv(map_uvs.xy));
  vec3 bump = texel.xyz * 2.0 - (256.0 - floor(texel.a + 0.5 / 255.0)) * (1.0 / 255.0);
  return vec3(bump.xy * normal_scale, bump.z);
}
#endif
