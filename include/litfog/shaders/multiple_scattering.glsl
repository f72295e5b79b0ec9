// SPDX-License-Identifier: Apache-2.0
// litfog: light of a point lamp that exp fog scatters to the eye twice and more often, M of
// litfog/multiple_scattering.h. airlight.glsl has what is scattered once. Shared with C++ as airlight.glsl is; GLSL
// includes it after light_airlight.glsl.
//
// In Vulkan the table is at LITFOG_SET (default 0) and LITFOG_SCATTERING_BINDING (default 3), and the beams of cones
// are at LITFOG_BEAMS_BINDING (default 5).

#ifndef LITFOG_MULTIPLE_SCATTERING_GLSL
#define LITFOG_MULTIPLE_SCATTERING_GLSL

#ifndef __cplusplus
#include "litfog/shaders/light_airlight.glsl"

// The table of make_scattering_table(): a texture of one component with linear filters, clamped to its edges, an angle
// a column and a depth a row.
#ifdef VULKAN
#ifndef LITFOG_SET
#define LITFOG_SET 0
#endif
#ifndef LITFOG_SCATTERING_BINDING
#define LITFOG_SCATTERING_BINDING 3
#endif
layout(set = LITFOG_SET, binding = LITFOG_SCATTERING_BINDING)
#endif
uniform highp sampler2D litfog_scattering_table;

float litfog_scattering_log(float depth, float angle) {
  return textureLod(litfog_scattering_table, (vec2(angle, depth) + 0.5) / vec2(69.0, 61.0), 0.0).r;
}

struct LitfogScatteredBeam {
  float share;
  float radial;
  float turned;
  float forward;
};

// The ScatteredBeams, a texture of four components with linear filters: an angle a column and a depth a row, one beam
// after the other down the columns of beams from the first row on.
#ifdef VULKAN
#ifndef LITFOG_BEAMS_BINDING
#define LITFOG_BEAMS_BINDING 5
#endif
layout(set = LITFOG_SET, binding = LITFOG_BEAMS_BINDING)
#endif
uniform highp sampler2D litfog_scattered_beams;

LitfogScatteredBeam litfog_scattered_beam(float beam, float depth, float angle) {
  vec2 size = vec2(textureSize(litfog_scattered_beams, 0));
  float beams_a_column = floor(size.y / 16.0);
  float column = floor((beam + 0.5) / beams_a_column);
  vec2 first = vec2(24.0 * column, 16.0 * (beam - beams_a_column * column));
  vec4 texel = textureLod(litfog_scattered_beams, (first + vec2(angle, depth) + 0.5) / size, 0.0);
  return LitfogScatteredBeam(texel.x, texel.y, texel.z, texel.w);
}

#define LITFOG_REAL float
#define LITFOG_CONSTANT const
#endif

// The table's depths x go by equal steps of ln x + x / 5, its angles x in radians by equal steps of ln x + x / 2. These
// are the first of each, its logarithm's place and the step.
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_depth = LITFOG_REAL(0.02);
LITFOG_CONSTANT LITFOG_REAL litfog_most_scattering_depth = LITFOG_REAL(30.0);
LITFOG_CONSTANT LITFOG_REAL litfog_first_scattering_depth = LITFOG_REAL(-3.908023005428146);
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_depth_step = LITFOG_REAL(0.2218203397848384);
LITFOG_CONSTANT LITFOG_REAL litfog_least_scattering_angle = LITFOG_REAL(0.00349065850399);  // 0.2 degrees
LITFOG_CONSTANT LITFOG_REAL litfog_first_scattering_angle = LITFOG_REAL(-5.655919548222917);
LITFOG_CONSTANT LITFOG_REAL litfog_scattering_angle_step = LITFOG_REAL(0.1231094964833414);

// Depths of a scattered beam go by equal steps of their logarithm, the angles of its columns by equal steps.
LITFOG_CONSTANT LITFOG_REAL litfog_first_beam_depth = LITFOG_REAL(0.02);
LITFOG_CONSTANT LITFOG_REAL litfog_last_beam_depth = LITFOG_REAL(12.0);
LITFOG_CONSTANT LITFOG_REAL litfog_beam_depth_step = LITFOG_REAL(0.4264619770);  // ln(last / first) / 15
LITFOG_CONSTANT LITFOG_REAL litfog_beam_angle_step = LITFOG_REAL(0.1365909849);  // pi / 23

// Of litfog_beam_share(), fitted to random walks: the strength of light that has hardly been turned, and the power of
// the cone's edge in it.
LITFOG_CONSTANT LITFOG_REAL litfog_unturned_of_cosine = LITFOG_REAL(0.6);
LITFOG_CONSTANT LITFOG_REAL litfog_edge_power = LITFOG_REAL(1.2);
LITFOG_CONSTANT LITFOG_REAL litfog_edge_power_of_unturned = LITFOG_REAL(1.6);

// Of litfog_softness(), fitted to the glow of lamps of 17 laws in fog of 11 phase functions: the angle, radians, over
// which one lobe blurs less than all, and the distance within which it does not matter, in soft ranges a radian.
LITFOG_CONSTANT LITFOG_REAL litfog_softening_width = LITFOG_REAL(1.1);
LITFOG_CONSTANT LITFOG_REAL litfog_softening_near = LITFOG_REAL(0.15);

// The soft range of the flow of light, over that of isotropic fog.
LITFOG_CONSTANT LITFOG_REAL litfog_softening_flow = LITFOG_REAL(1.1);

// M d^-2 of a lamp of 1 / r^2 in endless fog of density d, at an optical depth from the lamp and an angle between the
// ray and the direction to the lamp. Depths and angles below the table's count as its first. Beyond its last depth the
// light falls as that of diffusion does, by 1 / depth.
LITFOG_REAL litfog_scattered_at(LITFOG_REAL depth, LITFOG_REAL angle) {
  LITFOG_REAL x = clamp(depth, litfog_least_scattering_depth, litfog_most_scattering_depth);
  LITFOG_REAL y = max(angle, litfog_least_scattering_angle);
  LITFOG_REAL row = (log(x) + LITFOG_REAL(0.2) * x - litfog_first_scattering_depth) / litfog_scattering_depth_step;
  LITFOG_REAL column = (log(y) + LITFOG_REAL(0.5) * y - litfog_first_scattering_angle) / litfog_scattering_angle_step;
  return exp(litfog_scattering_log(row, column)) * (x / max(depth, x));
}

// The fraction of a lamp's soft range by which rays count as passing it farther off. What the peak of the phase
// function hardly turns still comes almost straight from the lamp, so that small angles are blurred less, but close to
// the lamp.
//
// range  from the lamp, over the soft range
// angle  between the ray and the direction to the lamp
LITFOG_REAL litfog_softness(LitfogPhase phase, LITFOG_REAL range, LITFOG_REAL angle) {
  LITFOG_REAL turned = LITFOG_REAL(1.0) - litfog_second_weight(phase);
  LITFOG_REAL width = litfog_softening_width * turned * turned * sqrt(turned);
  LITFOG_REAL rest = sqrt(min(phase.first.base, phase.second.base));  // 1 - g of the narrowest lobe
  LITFOG_REAL wide = rest * (LITFOG_REAL(2.0) - rest);
  LITFOG_REAL least = wide * sqrt(wide);
  LITFOG_REAL narrow = width * (LITFOG_REAL(1.0) - least);
  LITFOG_REAL near = litfog_softening_near * turned * narrow / max(range, LITFOG_REAL(1.0e-3));
  LITFOG_REAL seen = width * least + angle + near * near;
  return turned * seen / (seen + narrow);
}

// M, over the lamp's effective intensity, that a point on the ray receives from there on in endless fog. The point is
// at a distance along the ray from the closest approach. Angles below the least one, radians, count as that. In the
// lamp itself the angle is a right one, as atan(0, 0) is not defined.
//
// soft_range  of the lamp, metres: soft_range() of litfog/multiple_scattering.h
LITFOG_REAL litfog_scattered_from(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL least_angle,
                                  LITFOG_REAL soft_range) {
  LITFOG_REAL range = litfog_airlight_range(air, along);
  LITFOG_REAL offset = max(air.offset, LITFOG_REAL(1.0e-30));
  if (soft_range > LITFOG_REAL(0.0)) {
    LITFOG_REAL soft =
        soft_range * litfog_softness(air.phase, range / soft_range, max(atan(offset, -along), least_angle));
    range = sqrt(range * range + soft * soft);
    offset = sqrt(offset * offset + soft * soft);
  }
  return air.density * air.density * litfog_scattered_at(air.density * range, max(atan(offset, -along), least_angle));
}

// The same as the eye sees it through the fog before the point, a distance from the eye.
LITFOG_REAL litfog_scattered_beyond(LitfogAirlight air, LITFOG_REAL range, LITFOG_REAL least_angle,
                                    LITFOG_REAL soft_range) {
  return exp(-air.density * range) * litfog_scattered_from(air, range - air.approach, least_angle, soft_range);
}

// M of a point lamp along a ray of exp fog, over the lamp's effective intensity: what the eye would receive from
// endless fog without what comes from beyond the ray's end.
LITFOG_REAL litfog_multiple_scattering(LitfogAirlight air, LITFOG_REAL soft_range) {
  LITFOG_REAL all = litfog_scattered_from(air, -air.approach, LITFOG_REAL(0.0), soft_range);
  if (!(air.ray_length < litfog_far)) return all;
  return max(all - litfog_scattered_beyond(air, air.ray_length, LITFOG_REAL(0.0), soft_range), LITFOG_REAL(0.0));
}

// Henyey and Greenstein's phase function of a mean cosine.
LITFOG_REAL litfog_scattered_lobe(LITFOG_REAL mean_cosine, LITFOG_REAL cosine) {
  LITFOG_REAL base = LITFOG_REAL(1.0) + mean_cosine * (mean_cosine - LITFOG_REAL(2.0) * cosine);
  return (LITFOG_REAL(1.0) - mean_cosine * mean_cosine) / (base * sqrt(base));
}

// M of a cone over that of a point lamp: of what is scattered into the eye at a point of the ray, a distance along it
// from the closest approach. The light that arrives there is taken as spread about the direction in which it flows.
//
// beam          index of the cone's ScatteredBeam
// phase_cosine  mean cosine of the phase function
LITFOG_REAL litfog_beam_share(LitfogAirlight air, LITFOG_REAL along, LITFOG_REAL beam, LITFOG_REAL phase_cosine) {
  LITFOG_REAL range = max(litfog_airlight_range(air, along), LITFOG_REAL(1.0e-30));
  LITFOG_REAL away = along / range;
  LITFOG_REAL cosine = clamp((air.axis_offset + along * air.axis_slope) / range, LITFOG_REAL(-1.0), LITFOG_REAL(1.0));
  LITFOG_REAL depth = clamp(air.density * range, litfog_first_beam_depth, litfog_last_beam_depth);
  LITFOG_REAL column = acos(cosine) / litfog_beam_angle_step;
  LitfogScatteredBeam scattered =
      litfog_scattered_beam(beam, log(depth / litfog_first_beam_depth) / litfog_beam_depth_step, column);
  LITFOG_REAL even = phase_cosine * scattered.forward;
  if (even == LITFOG_REAL(0.0)) return scattered.share;
  LITFOG_REAL sine = sqrt(max(LITFOG_REAL(1.0) - cosine * cosine, LITFOG_REAL(1.0e-6)));
  LITFOG_REAL across = (away * cosine - air.axis_slope) / sine;
  LITFOG_REAL flow =
      max(sqrt(scattered.radial * scattered.radial + scattered.turned * scattered.turned), LITFOG_REAL(1.0e-9));
  LITFOG_REAL ahead = -(scattered.radial * away + scattered.turned * across) / flow;
  LITFOG_REAL mean_cosine = min(even * flow / scattered.share, LITFOG_REAL(0.95));
  LITFOG_REAL cone =
      scattered.share * litfog_scattered_lobe(mean_cosine, clamp(ahead, LITFOG_REAL(-1.0), LITFOG_REAL(1.0)));
  LITFOG_REAL point = litfog_scattered_lobe(even, -away);
  // Some of the light has hardly been turned yet. It lights the peak of the phase function. Only inside the cone is
  // there such light; the less a scattering turns it, the sharper that edge.
  LITFOG_REAL unturned = litfog_second_weight(air.phase);
  LITFOG_REAL straight = (litfog_unturned_of_cosine * phase_cosine * phase_cosine + unturned) * scattered.forward *
                         scattered.forward * litfog_phase(air.phase, LITFOG_REAL(1.0) + away);
  LITFOG_REAL inside = litfog_scattered_beam(beam, LITFOG_REAL(0.0), column).share;
  cone += straight * pow(inside, litfog_edge_power + litfog_edge_power_of_unturned * unturned);
  point += straight;
  return min(cone / point, LITFOG_REAL(1.0));
}

// Light that the fog has scattered once or more often, at a place. Over the lamp's effective intensity, 1/m^2.
struct LitfogScatteredLight {
  LITFOG_REAL all;     // from all directions; no less than the flow
  LITFOG_REAL radial;  // flow away from the lamp
  LITFOG_REAL turned;  // flow away from the beam's axis, at right angles to that
};

// What flows away from a point lamp is (1 - e^-depth) / range^2, as the fog absorbs none; the rest is known by the
// beam. A soft lamp counts as farther off. litfog_diffuse_irradiance() of diffuse_light.glsl is what a surface receives
// of it.
//
// density       of the fog, 1/m
// range         from the lamp, metres
// soft_range    of the lamp, metres
// cosine        between the beam's axis and the direction away from the lamp
// phase_cosine  mean cosine of the phase function
LitfogScatteredLight litfog_scattered_light(LITFOG_REAL density, LITFOG_REAL range, LITFOG_REAL soft_range,
                                            LITFOG_REAL beam, LITFOG_REAL cosine, LITFOG_REAL phase_cosine) {
  LITFOG_REAL soft = sqrt(range * range + soft_range * soft_range);
  LITFOG_REAL depth = density * soft;
  LITFOG_REAL row = log(clamp(depth, litfog_first_beam_depth, litfog_last_beam_depth) / litfog_first_beam_depth) /
                    litfog_beam_depth_step;
  LitfogScatteredBeam scattered = litfog_scattered_beam(beam, row, acos(cosine) / litfog_beam_angle_step);
  LITFOG_REAL of_flow = litfog_softening_flow * soft_range / (LITFOG_REAL(1.0) + phase_cosine);
  LITFOG_REAL flowing = sqrt(range * range + of_flow * of_flow);
  LITFOG_REAL flow = litfog_expm1(-density * flowing) * LITFOG_REAL(-1.0) / (flowing * flowing) * (range / flowing);
  LitfogScatteredLight light;
  light.all = max(litfog_expm1(-depth) * LITFOG_REAL(-1.0) / (soft * soft) * scattered.share / scattered.forward,
                  flow * sqrt(scattered.radial * scattered.radial + scattered.turned * scattered.turned));
  light.radial = flow * scattered.radial;
  light.turned = flow * scattered.turned;
  return light;
}

// Where piece i of a ray ends, metres from its closest approach. Pieces are the shorter the nearer they are to the lamp.
// None is on both sides of it, because a beam lights one far more than the other.
//
// first, last  asinh of the ray's ends over the width
// width        of the pieces at the lamp, metres
LITFOG_REAL litfog_piece_end(LITFOG_REAL first, LITFOG_REAL last, LITFOG_REAL width, int i, int pieces) {
  LITFOG_REAL step = (last - first) / LITFOG_REAL(pieces);
  LITFOG_REAL t = first + step * LITFOG_REAL(i);
  if (max(t, -t) <= LITFOG_REAL(0.5) * step) t = LITFOG_REAL(0.0);
  return width * LITFOG_REAL(0.5) * (exp(t) - exp(-t));
}

// M of a cone along a ray of exp fog, over the lamp's effective intensity: that of a point lamp, piece by piece of the
// ray.
LITFOG_REAL litfog_multiple_scattering(LitfogAirlight air, LITFOG_REAL soft_range, LITFOG_REAL beam,
                                       LITFOG_REAL phase_cosine) {
  const int pieces = 32;
  LITFOG_REAL width =
      max(air.offset, LITFOG_REAL(1.0e-4) * (max(air.approach, -air.approach) + LITFOG_REAL(1.0) / air.density));
  LITFOG_REAL farthest = min(air.ray_length, max(air.approach, LITFOG_REAL(0.0)) + LITFOG_REAL(12.0) / air.density);
  LITFOG_REAL first = asinh(-air.approach / width);
  LITFOG_REAL last = asinh((farthest - air.approach) / width);
  LITFOG_REAL sum = LITFOG_REAL(0.0);
  LITFOG_REAL begin = LITFOG_REAL(0.0);
  LITFOG_REAL beyond = litfog_scattered_from(air, -air.approach, LITFOG_REAL(0.0), soft_range);
  for (int i = 0; i < pieces; ++i) {
    LITFOG_REAL end = i + 1 < pieces ? air.approach + litfog_piece_end(first, last, width, i + 1, pieces) : farthest;
    end = clamp(end, begin, max(begin, farthest));
    LITFOG_REAL next = litfog_scattered_beyond(air, end, LITFOG_REAL(0.0), soft_range);
    sum += max(beyond - next, LITFOG_REAL(0.0)) *
           litfog_beam_share(air, LITFOG_REAL(0.5) * (begin + end) - air.approach, beam, phase_cosine);
    begin = end;
    beyond = next;
  }
  return sum;
}

#undef LITFOG_REAL
#undef LITFOG_CONSTANT

#endif
