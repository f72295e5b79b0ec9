// SPDX-License-Identifier: Apache-2.0
// Sums the airlight of the lights of one kind in the pixel's tile or, where is_left_out, adds the part of one light's
// that the coarser grid leaves out. One program for both, because drivers take long to compile it.

#include "generated/airlight_constants.glsl"
#include "airlight/airlight_light.glsl"
#include "pixel_direction.glsl"

uniform bool is_packed;  // the target's texels stand for other texels of their block (airlight_blocks.glsl)
uniform sampler2DRect packed_positions;
uniform isamplerBuffer tile_lists;  // render::AirlightTiles
uniform ivec2 tile_count;
uniform vec2 tile_size;  // pixels
uniform int first_tile;  // index in tile_lists of the kind's first tile
uniform int entry_count;  // of each tile's list that are drawn

flat in int left_out_entry;

// Where a tile's entries begin and end in tile_lists.
ivec2 tile_list(ivec2 pixel) {
  ivec2 tile = min(ivec2((vec2(pixel) + 0.5) / tile_size), tile_count - 1);
  int place = first_tile + 2 * (tile.y * tile_count.x + tile.x);
  return ivec2(texelFetch(tile_lists, place).x, texelFetch(tile_lists, place + 1).x);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  if (is_packed) place = ivec2(texel_at(packed_positions, place).xy);
  ivec2 pixel = place * pixel_step;
  vec3 direction = pixel_direction(pixel);
  vec4 seen = seen_at(pixel);
  float shown_exposure = shown_exposure_at(direction, seen);
  ivec2 list = ivec2(left_out_entry, left_out_entry + 1);
  if (!is_left_out) {
    list = tile_list(pixel);
    list.x += first_entry;
    list.y = min(list.y, list.x + entry_count);
  }
  airlight = vec4(0.0);
  gain = vec4(0.0);
  int i = list.x;
  do {  // tested at its end, as the loops of airlight.glsl
    vec4 entry = texelFetch(airlight_entries, is_left_out ? i : texelFetch(tile_lists, i).x);
    vec3 position = litfog_buffered_position_extent(int(entry.x)).xyz;
    float square = squared_passing_distance(position, direction);
    bool is_reached = i < list.y && square < entry.y * entry.y;
    float fraction = is_reached ? kept_fraction(entry, square, pixel_step) : 0.0;
    if (is_left_out) fraction -= kept_fraction(entry, square, 2 * pixel_step);
    if (fraction > 0.0) add_light(int(entry.x), fraction, direction, seen, shown_exposure);
    ++i;
  } while (i < list.y);
}
