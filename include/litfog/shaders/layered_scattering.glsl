// SPDX-License-Identifier: Apache-2.0
// litfog: light that layers of fog scatter to the eye twice and more often, M of litfog/multiple_scattering.h. Shared
// with C++ as airlight.glsl is; GLSL includes it after multiple_scattering.glsl.
//
// Layers are taken as endless fog whose density is the mean between place and lamp. They keep part of its light; the
// rest escapes above and below.

#ifndef LITFOG_LAYERED_SCATTERING_GLSL
#define LITFOG_LAYERED_SCATTERING_GLSL

#ifndef __cplusplus
#include "litfog/shaders/multiple_scattering.glsl"

#define LITFOG_REAL float
#define LITFOG_CONSTANT const
#endif

// Optical depths of thicker layers count as this, whose square is finite in floats.
LITFOG_CONSTANT LITFOG_REAL litfog_thickest_layer = LITFOG_REAL(1.0e15);

// The distance beyond the edge of a slab where the light of diffusion ends, in transport mean free paths: fitted like
// the powers below. It is 0.71 in Milne's problem (Kenneth Case and Paul Zweifel 1967, "Linear Transport Theory").
LITFOG_CONSTANT LITFOG_REAL litfog_beyond_slab = LITFOG_REAL(1.0);

// Powers of litfog_scattered_again(), fitted to walks in slabs of 0.1 to 10 optical depths.
LITFOG_CONSTANT LITFOG_REAL litfog_slab_power_near = LITFOG_REAL(0.1);  // of the place, near the lamp
LITFOG_CONSTANT LITFOG_REAL litfog_slab_power_far = LITFOG_REAL(2.6);   // of the place, by how much more far from it
LITFOG_CONSTANT LITFOG_REAL litfog_slab_power_lamp = LITFOG_REAL(0.3);  // of the lamp, far from the place
LITFOG_CONSTANT LITFOG_REAL litfog_slab_far = LITFOG_REAL(4.0);  // where near and far meet, transport mean free paths

// Metres beyond which fog adds nothing that is seen; their square over that of the shortest stretch is finite in
// floats.
LITFOG_CONSTANT LITFOG_REAL litfog_longest_layered_ray = LITFOG_REAL(1.0e8);

// The shortest stretch of a ray at the lamp, over the distance to it and a mean free path. Light from shorter ones is
// known exactly, but for how much of it the layers keep.
LITFOG_CONSTANT LITFOG_REAL litfog_shortest_stretch = LITFOG_REAL(0.01);

// Optical depth between two heights of the layers, lowest <= highest, straight up.
LITFOG_REAL litfog_layer_column(LitfogAirlight air, LITFOG_REAL lowest, LITFOG_REAL highest) {
  return min((highest - lowest) * (air.density + air.layer_scale * litfog_mean_density(lowest, highest)),
             litfog_thickest_layer);
}

// Optical depth of the fog along the ray between two distances from the eye.
LITFOG_REAL litfog_depth_of_stretch(LitfogAirlight air, LITFOG_REAL from, LITFOG_REAL to) {
  LITFOG_REAL density =
      air.density + air.layer_scale * litfog_mean_density(litfog_airlight_height(air, from - air.approach),
                                                          litfog_airlight_height(air, to - air.approach));
  return (to - from) * density;
}

LITFOG_REAL litfog_largest_layer_density(LitfogAirlight air) {
  return max(air.density + air.layer_scale * litfog_largest_profile_density(), LITFOG_REAL(1.0e-30));
}

// The optical depth that stands for the endless fog beyond the outermost knot: none where it is thin beside the densest
// fog, endless where it is as dense.
LITFOG_REAL litfog_depth_beyond(LitfogAirlight air, int knot) {
  LITFOG_REAL part = (air.density + air.layer_scale * litfog_knot_density(knot)) / litfog_largest_layer_density(air);
  return part * part / max(LITFOG_REAL(1.0) - part, LITFOG_REAL(1.0e-6));
}

// The exponential integral E2, the part of light from all directions of a half space that an optical depth lets
// through, within 0.07.
LITFOG_REAL litfog_exponential_integral(LITFOG_REAL depth) {
  return exp(-depth) / (LITFOG_REAL(1.0) + LITFOG_REAL(1.5) * depth);
}

// The part of light, sent evenly to all sides, that a slab scatters before it leaves.
LITFOG_REAL litfog_scattered_again(LITFOG_REAL above, LITFOG_REAL below) {
  LITFOG_REAL escapes = LITFOG_REAL(0.5) * (litfog_exponential_integral(above) + litfog_exponential_integral(below));
  return max(LITFOG_REAL(1.0) - escapes, LITFOG_REAL(1.0e-30));
}

// The layers as a slab of scattering fog.
struct LitfogSlab {
  LITFOG_REAL at_bottom;  // optical depth that stands for the fog below the lowest knot
  LITFOG_REAL lamp;       // from there to the lamp
  LITFOG_REAL thickness;
};

// Optical depth from the slab's bottom to a height.
LITFOG_REAL litfog_height_in_slab(LitfogAirlight air, LITFOG_REAL at_bottom, LITFOG_REAL height) {
  LITFOG_REAL bottom = litfog_knot_height(0);
  LITFOG_REAL top = litfog_knot_height(litfog_knot_count() - 1);
  return at_bottom + litfog_layer_column(air, bottom, clamp(height, bottom, top));
}

LitfogSlab litfog_slab(LitfogAirlight air) {
  int last = litfog_knot_count() - 1;
  LitfogSlab slab;
  slab.at_bottom = litfog_depth_beyond(air, 0);
  slab.lamp = litfog_height_in_slab(air, slab.at_bottom, air.lamp_height);
  slab.thickness =
      litfog_height_in_slab(air, slab.at_bottom, litfog_knot_height(last)) + litfog_depth_beyond(air, last);
  return slab;
}

// The endless fog that layers count as at a place: its density is the mean density between the place and the lamp.
struct LitfogEndlessFog {
  LITFOG_REAL density;
  LITFOG_REAL place;  // optical depth from the slab's bottom
};

LitfogEndlessFog litfog_endless_fog(LitfogAirlight air, LitfogSlab slab, LITFOG_REAL height) {
  LITFOG_REAL density = air.density + air.layer_scale * litfog_mean_density(air.lamp_height, height);
  LitfogEndlessFog fog;
  fog.density = min(density, LITFOG_REAL(LITFOG_DENSEST_FOG));
  fog.place = litfog_height_in_slab(air, slab.at_bottom, height);
  return fog;
}

// The part of what that fog scatters that layers keep: of diffusion in a slab from which no light comes back, with one
// image of the lamp beyond either edge, times powers of the fraction scattered again, which is small in a thin slab.
//
// beside        metres between the place and the lamp, level
// phase_cosine  mean cosine of the phase function
LITFOG_REAL litfog_kept_in_slab(LitfogSlab slab, LitfogEndlessFog fog, LITFOG_REAL beside, LITFOG_REAL phase_cosine) {
  LITFOG_REAL transport = LITFOG_REAL(1.0) - phase_cosine;
  LITFOG_REAL level = transport * fog.density * beside;
  LITFOG_REAL up = transport * (fog.place - slab.lamp);
  LITFOG_REAL range = sqrt(level * level + up * up);
  LITFOG_REAL over_place = slab.thickness - fog.place;
  LITFOG_REAL over_lamp = slab.thickness - slab.lamp;
  LITFOG_REAL below = transport * (fog.place + slab.lamp) + LITFOG_REAL(2.0) * litfog_beyond_slab;
  LITFOG_REAL above = transport * (over_place + over_lamp) + LITFOG_REAL(2.0) * litfog_beyond_slab;
  LITFOG_REAL far = range / (range + litfog_slab_far);
  return (LITFOG_REAL(1.0) - range / sqrt(level * level + below * below)) *
         (LITFOG_REAL(1.0) - range / sqrt(level * level + above * above)) *
         exp((litfog_slab_power_near + litfog_slab_power_far * far) *
                 log(litfog_scattered_again(over_place, fog.place)) +
             litfog_slab_power_lamp * far * log(litfog_scattered_again(over_lamp, slab.lamp)));
}

// A stretch of a ray in layers.
struct LitfogLayeredStretch {
  LITFOG_REAL from;  // metres from the eye
  LITFOG_REAL to;
  LITFOG_REAL place;    // the middle of its fog
  LITFOG_REAL density;  // of the endless fog that it counts as
  LITFOG_REAL depth;    // optical, of the stretch itself
  LITFOG_REAL part;     // fraction of the endless fog's light that the slab keeps and the eye sees
};

// hidden  optical depth from the eye to where it begins
LitfogLayeredStretch litfog_layered_stretch(LitfogAirlight air, LitfogSlab slab, LITFOG_REAL from, LITFOG_REAL to,
                                            LITFOG_REAL hidden, LITFOG_REAL phase_cosine) {
  LITFOG_REAL middle = LITFOG_REAL(0.5) * (from + to);
  LITFOG_REAL first = litfog_depth_of_stretch(air, from, middle);
  LITFOG_REAL second = litfog_depth_of_stretch(air, middle, to);
  LitfogLayeredStretch stretch;
  stretch.from = from;
  stretch.to = to;
  stretch.depth = first + second;
  stretch.place =
      middle + LITFOG_REAL(0.25) * (to - from) * (second - first) / max(stretch.depth, LITFOG_REAL(1.0e-30));
  LITFOG_REAL along = stretch.place - air.approach;
  LITFOG_REAL height = litfog_airlight_height(air, along);
  LitfogEndlessFog fog = litfog_endless_fog(air, slab, height);
  stretch.density = fog.density;
  stretch.part = LITFOG_REAL(0.0);
  LITFOG_REAL endless = fog.density * (to - from);
  if (min(endless, stretch.depth) > LITFOG_REAL(1.0e-30)) {
    LITFOG_REAL range = litfog_airlight_range(air, along);
    LITFOG_REAL rise = height - air.lamp_height;
    LITFOG_REAL beside = sqrt(max(range * range - rise * rise, LITFOG_REAL(0.0)));
    stretch.part = litfog_kept_in_slab(slab, fog, beside, phase_cosine) * exp(-hidden) * litfog_expm1(-stretch.depth) /
                   litfog_expm1(-endless);
  }
  return stretch;
}

// M from a stretch, over the lamp's effective intensity.
//
// soft_range  of the lamp, metres
// beam        index of the cone's ScatteredBeam; below 0 for a point lamp
LITFOG_REAL litfog_scattered_in_stretch(LitfogAirlight air, LitfogLayeredStretch stretch, LITFOG_REAL soft_range,
                                        LITFOG_REAL beam, LITFOG_REAL phase_cosine) {
  if (!(stretch.part > LITFOG_REAL(0.0))) return LITFOG_REAL(0.0);
  air.density = stretch.density;  // the ray in the endless fog
  air.layer_scale = LITFOG_REAL(0.0);
  LITFOG_REAL all = litfog_scattered_from(air, stretch.from - air.approach, LITFOG_REAL(0.0), soft_range);
  LITFOG_REAL beyond = exp(-air.density * (stretch.to - stretch.from)) *
                       litfog_scattered_from(air, stretch.to - air.approach, LITFOG_REAL(0.0), soft_range);
  if (!(all > beyond)) return LITFOG_REAL(0.0);
  LITFOG_REAL scattered = stretch.part * (all - beyond);
  if (beam >= LITFOG_REAL(0.0)) {
    scattered *= litfog_beam_share(air, stretch.place - air.approach, beam, phase_cosine);
  }
  return scattered;
}

// The light of litfog_scattered_light(), in layers, at a height.
//
// range       metres from the lamp
// soft_range  of the lamp, metres
// cosine      between the beam's axis and the direction away from the lamp
LitfogScatteredLight litfog_scattered_light_in_layers(LitfogAirlight air, LITFOG_REAL height, LITFOG_REAL range,
                                                      LITFOG_REAL soft_range, LITFOG_REAL beam, LITFOG_REAL cosine,
                                                      LITFOG_REAL phase_cosine) {
  LitfogSlab slab = litfog_slab(air);
  LitfogEndlessFog fog = litfog_endless_fog(air, slab, height);
  LITFOG_REAL rise = height - air.lamp_height;
  LITFOG_REAL beside = sqrt(max(range * range - rise * rise, LITFOG_REAL(0.0)));
  LITFOG_REAL kept = litfog_kept_in_slab(slab, fog, beside, phase_cosine);
  LitfogScatteredLight light = litfog_scattered_light(fog.density, range, soft_range, beam, cosine, phase_cosine);
  light.all *= kept;
  light.radial *= kept;
  light.turned *= kept;
  return light;
}

// The eye sees nothing behind the first of these optical depths. A ray is cut off between the two.
LITFOG_CONSTANT LITFOG_REAL litfog_hidden_depth = LITFOG_REAL(12.0);
LITFOG_CONSTANT LITFOG_REAL litfog_deepest_end = LITFOG_REAL(16.0);

// Where the fog cuts off the ray between two distances from the eye, metres: at `last`, or nearer.
LITFOG_REAL litfog_end_of_sight(LitfogAirlight air, LITFOG_REAL first, LITFOG_REAL last) {
  LITFOG_REAL before = LITFOG_REAL(0.0);
  LITFOG_REAL behind = litfog_depth_of_stretch(air, first, last);
  LITFOG_REAL seen = first;
  LITFOG_REAL end = last;
  for (int i = 0; i < 16 && behind > litfog_deepest_end; ++i) {
    // False position alternates with bisection, which also converges where the depth rises late.
    LITFOG_REAL part = LITFOG_REAL(0.5);
    if (i % 2 == 0) {
      LITFOG_REAL aim = LITFOG_REAL(0.5) * (litfog_hidden_depth + litfog_deepest_end);
      part = clamp((aim - before) / (behind - before), LITFOG_REAL(0.01), LITFOG_REAL(0.99));
    }
    LITFOG_REAL middle = seen + part * (end - seen);
    LITFOG_REAL depth = litfog_depth_of_stretch(air, first, middle);
    if (depth < litfog_hidden_depth) {
      seen = middle;
      before = depth;
    } else {
      end = middle;
      behind = depth;
    }
  }
  return end;
}

// M of the ray between two distances from the eye, on which it is divided into stretches: the shorter the nearer they
// are to the lamp. Where `beside` passes the lamp farther off than the ray, its light is subtracted.
LITFOG_REAL litfog_scattered_between(LitfogAirlight air, LitfogAirlight beside, LitfogSlab slab, LITFOG_REAL first,
                                     LITFOG_REAL last, int stretches, LITFOG_REAL soft_range, LITFOG_REAL beam,
                                     LITFOG_REAL phase_cosine) {
  LITFOG_REAL near = max(air.approach, -air.approach) +
                     LITFOG_REAL(1.0) / min(litfog_largest_layer_density(air), LITFOG_REAL(LITFOG_DENSEST_FOG));
  LITFOG_REAL width = max(air.offset, litfog_shortest_stretch * near);
  LITFOG_REAL start = asinh((first - air.approach) / width);
  LITFOG_REAL end = asinh((last - air.approach) / width);
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  LITFOG_REAL from = first;
  LITFOG_REAL hidden = litfog_depth_of_stretch(air, LITFOG_REAL(0.0), first);
  for (int i = 1; i <= stretches; ++i) {
    LITFOG_REAL to = last;
    if (i < stretches) to = clamp(air.approach + litfog_piece_end(start, end, width, i, stretches), from, last);
    LitfogLayeredStretch stretch = litfog_layered_stretch(air, slab, from, to, hidden, phase_cosine);
    sum += litfog_scattered_in_stretch(air, stretch, soft_range, beam, phase_cosine);
    if (beside.offset > air.offset) sum -= litfog_scattered_in_stretch(beside, stretch, soft_range, beam, phase_cosine);
    hidden += stretch.depth;
    from = to;
  }
  return sum;
}

// M along a ray in layers, over the lamp's effective intensity. Where `beside` passes the lamp farther off than the
// ray, its light is subtracted.
//
// stretches   into which the ray is divided between two knots
// soft_range  of the lamp, metres
// beam        index of the cone's ScatteredBeam; below 0 for a point lamp
LITFOG_REAL litfog_layered_scattering(LitfogAirlight air, LitfogAirlight beside, int stretches, LITFOG_REAL soft_range,
                                      LITFOG_REAL beam, LITFOG_REAL phase_cosine) {
  LITFOG_REAL from = litfog_airlight_start_of_layers(air);
  LITFOG_REAL last =
      min(min(air.ray_length, litfog_airlight_end_of_layers(air, litfog_hidden_depth)), litfog_longest_layered_ray);
  if (!(last > from)) return LITFOG_REAL(0.0);
  last = litfog_end_of_sight(air, from, last);
  LitfogSlab slab = litfog_slab(air);
  LITFOG_REAL eye_height = litfog_airlight_height(air, -air.approach);
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  int knots = litfog_knot_count();
  for (int i = 0; i <= knots; ++i) {
    LITFOG_REAL to = last;
    if (i < knots) {
      if (air.rise == LITFOG_REAL(0.0)) continue;
      LITFOG_REAL height = litfog_knot_height(air.rise > LITFOG_REAL(0.0) ? i : knots - 1 - i);
      to = min((height - eye_height) / air.rise, last);
    }
    if (!(to > from)) continue;
    sum += litfog_scattered_between(air, beside, slab, from, to, stretches, soft_range, beam, phase_cosine);
    from = to;
  }
  return sum;
}

// M along the ray with nothing subtracted.
LITFOG_REAL litfog_layered_scattering(LitfogAirlight air, LITFOG_REAL soft_range, LITFOG_REAL beam,
                                      LITFOG_REAL phase_cosine) {
  return litfog_layered_scattering(air, air, 24, soft_range, beam, phase_cosine);
}

#undef LITFOG_REAL
#undef LITFOG_CONSTANT

#endif
