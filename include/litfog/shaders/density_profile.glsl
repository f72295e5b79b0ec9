// SPDX-License-Identifier: Apache-2.0
// litfog: the density profile, which states the density of exp fog over height: linear between knots, constant below
// the first and above the last, 0 without knots. All that depends on its shape is asked here. GLSL includes this file
// like any other; C++ takes the same text through src/model/density_profile_text.h.
//
// The knots are those of the block. Heights rise from knot to knot, but two may be equal where they are rounded: that
// is a step. A program for profiles of so many knots, 0 in fog without layers, may define LITFOG_KNOT_COUNT before the
// first include of litfog; compilers then unroll the loops over knots.

#ifndef LITFOG_DENSITY_PROFILE_GLSL
#define LITFOG_DENSITY_PROFILE_GLSL

#ifndef __cplusplus
#include "litfog/shaders/light_block.glsl"

#ifdef LITFOG_KNOT_COUNT
int litfog_knot_count() { return LITFOG_KNOT_COUNT; }
#else
int litfog_knot_count() { return int(litfog_ambient_fog_color.w); }
#endif
float litfog_knot_height(int knot) { return litfog_density_knots[knot].x; }
float litfog_knot_density(int knot) { return litfog_density_knots[knot].y; }

#define LITFOG_REAL float
#define LITFOG_FUNCTION
#endif

// Mean density between two heights, lowest <= highest, that lie between a knot and the next, which is higher. Every
// term is >= 0, so that no digits cancel.
LITFOG_FUNCTION LITFOG_REAL litfog_density_above_knot(int knot, LITFOG_REAL lowest, LITFOG_REAL highest) {
  LITFOG_REAL from = litfog_knot_height(knot);
  LITFOG_REAL to = litfog_knot_height(knot + 1);
  LITFOG_REAL twice = LITFOG_REAL(2.0) * (to - from);
  return ((to - lowest) + (to - highest)) / twice * litfog_knot_density(knot) +
         ((lowest - from) + (highest - from)) / twice * litfog_knot_density(knot + 1);
}

// Density at a height.
LITFOG_FUNCTION LITFOG_REAL litfog_profile_density(LITFOG_REAL height) {
  int last = litfog_knot_count() - 1;
  if (last < 0) return LITFOG_REAL(0.0);
  if (height < litfog_knot_height(0)) return litfog_knot_density(0);
  for (int i = 0; i < last; ++i) {
    if (height < litfog_knot_height(i + 1)) return litfog_density_above_knot(i, height, height);
  }
  return litfog_knot_density(last);
}

// Largest density at any height.
LITFOG_FUNCTION LITFOG_REAL litfog_largest_profile_density() {
  LITFOG_REAL largest = LITFOG_REAL(0.0);
  for (int i = 0; i < litfog_knot_count(); ++i) largest = max(largest, litfog_knot_density(i));
  return largest;
}

// The density's integral over height, lowest <= highest, of at least one knot: a sum of the parts between knots, each
// from its own clipped heights, rather than a difference of large integrals.
LITFOG_FUNCTION LITFOG_REAL litfog_profile_column(LITFOG_REAL lowest, LITFOG_REAL highest) {
  int last = litfog_knot_count() - 1;
  LITFOG_REAL column =
      max(min(highest, litfog_knot_height(0)) - lowest, LITFOG_REAL(0.0)) * litfog_knot_density(0) +
      max(highest - max(lowest, litfog_knot_height(last)), LITFOG_REAL(0.0)) * litfog_knot_density(last);
  for (int i = 0; i < last; ++i) {
    LITFOG_REAL from = max(lowest, litfog_knot_height(i));
    LITFOG_REAL to = min(highest, litfog_knot_height(i + 1));
    if (to > from) column += (to - from) * litfog_density_above_knot(i, from, to);
  }
  return column;
}

// Mean density between two heights, in either order: that along any straight line from one to the other.
LITFOG_FUNCTION LITFOG_REAL litfog_mean_density(LITFOG_REAL height_a, LITFOG_REAL height_b) {
  if (litfog_knot_count() == 0) return LITFOG_REAL(0.0);
  LITFOG_REAL lowest = min(height_a, height_b);
  LITFOG_REAL highest = max(height_a, height_b);
  LITFOG_REAL rise = highest - lowest;
  // The smallest rises of all have too few digits.
  return rise > LITFOG_REAL(1.0e-30) ? litfog_profile_column(lowest, highest) / rise : litfog_profile_density(lowest);
}

// Optical depth of an endless ray, at most `endless`, which it is where the ray ends or stays in fog. The slope is the
// sine of the ray's elevation.
LITFOG_FUNCTION LITFOG_REAL litfog_profile_depth_to_sky(LITFOG_REAL height, LITFOG_REAL slope, LITFOG_REAL endless) {
  int last = litfog_knot_count() - 1;
  if (last < 0) return LITFOG_REAL(0.0);
  bool rises = slope > LITFOG_REAL(0.0);
  LITFOG_REAL beyond = rises                      ? litfog_knot_density(last)
                       : slope < LITFOG_REAL(0.0) ? litfog_knot_density(0)
                                                  : litfog_profile_density(height);
  if (beyond > LITFOG_REAL(0.0)) return endless;
  if (slope == LITFOG_REAL(0.0)) return LITFOG_REAL(0.0);
  LITFOG_REAL outermost = litfog_knot_height(rises ? last : 0);
  if (rises ? height >= outermost : height <= outermost) return LITFOG_REAL(0.0);
  return min(litfog_profile_column(min(height, outermost), max(height, outermost)) / abs(slope), endless);
}

#undef LITFOG_FUNCTION
#undef LITFOG_REAL

#endif
