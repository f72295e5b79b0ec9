// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command/plot.h"
#include "command/table.h"

// The benchmarks of litfog-bench, and the columns of their rows.

namespace litfog::bench {

/// The result of a benchmark.
struct Result {
  command::Table table;
  command::Figure figure;                   ///< no charts for a benchmark that draws none
  std::string gl_renderer = "none";         ///< GL_RENDERER
  std::function<std::string()> strip = {};  ///< draws the bytes of a PNG file; empty for a benchmark without
  std::vector<std::string> failures;        ///< sentences: where litfog exceeded its own stated error
};

/// Time against error of every method to find a light's fog colour intensity, over the mix of light_mix.h. Columns:
///
/// method         hales-N, hales-N-simd, boost-brent, exact, batch, memory-copy;
///                batch-uncached (exp fog only) and memory-copy-uncached over more lights than the caches hold
/// precision      of arguments, computation and result: float or double
/// fog            exp or exp2; empty for the copies
/// ns_per_light   processor time of one thread: the median over repetitions
/// ns_spread      from the 10th to the 90th percentile
/// max_ulp, mean_ulp              error in units of the precision's last place at the 50-digit reference
/// max_error_255, mean_error_255  error in steps of an 8-bit colour channel; both errors are empty for the copies
///
/// quick  fewer lights, shorter runs: to see that it works
Result measure_solve(bool quick);

/// Time against error of every method to find a lamp's airlight along a ray, over the mixes of airlight_mix.h. Columns:
///
/// method         march, march-clipped, litfog, reference; over the inverse-square mix: arctangent, pegoraro-2009 and
///                sun-2005 (both with the lamp's leg), litfog, reference
/// nodes          steps of a march; empty for the other methods
/// fog            exp or exp2
/// lights         point, g-0.85, droplets, layers, any or inverse-square: the mix
/// lamp_leg       k: 1 if the fog also dims the light on its way from the lamp, else 0
/// ns_per_ray     processor time of one thread: the median over repetitions
/// ns_spread      from its 10th to its 90th percentile
/// max_error_255  largest error in steps of an 8-bit colour channel, relative where the airlight is above 1; empty for
///                the reference
/// p99_relative   99th percentile of the relative error; empty for the reference
///
/// quick  fewer rays, shorter runs: to see that it works
Result measure_airlight(bool quick);

/// The fog's light in exp fog for an eye that carries a lamp and looks along its axis, for four bundled lamps, over
/// visibilities of 1 m to 20 km. Columns:
///
/// lamp            file of the light in data/lights
/// visibility_m    at 5 % contrast
/// peak            fog colour intensity
/// airlight_k0     axial airlight, without extinction on the lamp's leg
/// airlight_k1     airlight with it, by the fast form
/// reference_k0, reference_k1  the same by the reference
/// max_error_255   largest difference from the reference, in steps of an 8-bit colour channel
///
/// quick   fewer visibilities
/// throws  InputError if the lamps are missing
Result measure_lamps(bool quick);

/// Light that endless uniform fog of albedo 1 scatters from a point lamp to the eye twice or more often, by
/// measure::RadialScattering: M / (I d^2) in the unit of airlight(), for the law a(r) = I / r^2 in fog of density d. It
/// depends on the phase function, the optical depth tau from eye to lamp and the angle between the ray and the
/// direction to the lamp. A row has all angles for a phase function and a depth. Columns:
///
/// phase                hg or droplets
/// parameter            g, or micrometres
/// tau                  optical depth
/// 0.2 deg ... 180 deg  M / (I d^2) at an angle, five digits
/// max_error            largest relative error in the row: the change of a number when a third of the nodes is left out
///
/// quick  fewer phase functions and nodes
Result tabulate_scattering(bool quick);

/// The glow around a point lamp in endless uniform fog, isotropic and of droplets of 10 micrometres, over the angle
/// between ray and lamp: by litfog, its rivals (glow_rival.h), the random walk and, as the reference,
/// measure::RadialScattering. Columns:
///
/// phase            hg or droplets
/// parameter        g, or micrometres
/// tau              optical depth between lamp and eye
/// angle_deg        angle between the ray and the direction to the lamp
/// method           reference; single: airlight(); all: the same plus multiple_scattering(); apsf-2003 (tau above 1);
///                  gaussian-2004; octaves-2013, in 16 steps; walk: walk_scattering()
/// glow             light over I d^2, for the law a(r) = I / r^2 in fog of density d
/// glow_error       standard error of walk; else empty
/// relative_error   against the reference; the walk's includes its own noise
/// ns_per_ray       processor time of one thread, median over repetitions, mean over the angles; empty for walk
///
/// quick  fewer angles, a coarser reference and shorter walks
Result draw_glow(bool quick);

/// One lamp, 100 m away in endless fog of droplets of 10 micrometres, at six visibilities (columns), with its light
/// scattered once, in all orders by litfog, and in all orders by measure::RadialScattering (rows). A column has the
/// automatic exposure of its last picture. The lamp's direct light is a disc of a few pixels.
///
/// quick   small pictures and a coarser reference
/// returns the bytes of a PNG file
/// throws  image::ImageError if no font is found
std::string draw_glow_strip(bool quick);

/// Four views of scenes with fog lit by single scattering and by all orders, beside the true pictures: single
/// scattering, and traced paths for the rest (measure::trace_higher_orders). Single scattering has shafts of shadow of
/// 32 lamps, which are all in `street` and `room`; the traced paths know the shadows of all. The strip has a row of the
/// three for each view, by the automatic exposure of the last. Columns:
///
/// scene, visibility_m
/// fog_light             single or all
/// ratio_p10, ratio_p50, ratio_p90  luminance over the true one: quantiles over squares of 4 x 4 pixels
/// noise_p50             of the traced paths, relative: the median of half the difference of two halves over their mean
///
/// quick   one view, tiny, of few paths
/// throws  gl::Unsupported like Renderer
Result trace_scenes(bool quick);

/// A visibility that falls from 10,000 to 50 m and rises again, step by step, over many lights of few kinds, all of
/// them carried and switched on. Columns:
///
/// method         updater (FogUpdater with its default budget), updater-no-skip (with budget 0), batch-of-all (no
///                updater: the float batch over every light, each result stored among the light's other
///                parameters)
/// fog            exp or exp2
/// lights, kinds, steps
/// ms_per_step    processor time of one thread: the median over the steps
/// ms_spread      from its 10th to its 90th percentile
/// bytes_per_step bytes to upload to the GPU after a step, with the fog: the maximum over the steps
/// skipped_share  fraction of the lights whose kind was not solved, mean over the steps
/// max_deviation_255  largest difference of colour times intensity from solving everything exactly, in 1/255
///
/// quick  fewer lights and steps: to see that it works
Result measure_update(bool quick);

/// An hour of a simulator at 60 steps a second, as fast as possible: in each step the visibility changes, and lights
/// flash, move, are switched, removed and added as others. Columns:
///
/// lights, kinds, steps
/// ms_per_step, ms_99, ms_worst  processor time of a step, the shorter one of two equal runs: median, 99th percentile,
///                               maximum
/// resident_mib, grown_mib       memory of the process at the end, and its growth after a twentieth of the steps
/// max_deviation_255             largest difference of an intensity at the end from its exact value, in 1/255
///
/// quick  fewer lights and steps: to see that it works
Result measure_load(bool quick);

/// C, L and Q from falloff tables of 20 samples, by litfog and by a plain use of Ceres. Columns:
///
/// problem       exact: samples of a light of 1 to 1,000 m; noise-2 and noise-20: off by 2 and 20 per cent (standard
///               deviation); outliers: 2 %, and one in eight off by a factor of 2 to 20; clamped: C < 1, 2 %; far: a
///               light of 10 to 1,000 km, 2 %; near: of 1 to 100 mm, 2 %
/// method        litfog (fit_attenuation, proof of the global optimum included); ceres (bounds at 0, default options,
///               start C = L = Q = 1)
/// tables        number of tables in the problem
/// ms            processor time of one thread per table: the median over repetitions
/// ms_spread     from the 10th to the 90th percentile
/// objective     mean over the tables
/// solved_share  fraction of the tables whose objective is within 0.1 % of the optimum's (and 1e-20)
/// digits        in which ln attenuation agrees with the optimum's at all samples, up to 17: the fewest of all tables
///
/// The optimum is the best found by any method, brought to 50 digits and certified there.
///
/// quick  fewer tables and shorter runs, to test that it works
Result measure_fit(bool quick);

/// Frame time beside error of every lighting path, over scenes, numbers of lights (with_light_count) and sizes, in exp
/// fog at the visibility that each scene suggests. Columns:
///
/// scene, path          path also: unlit, the base texture alone; plain, the rival (PlainRenderer), which skips nothing
/// fog_light            peak: carried lights light the fog by their fog colour intensity; airlight (unified
///                      only): every light by its airlight
/// lights, size         in the scene; WIDTHxHEIGHT in pixels
/// samples              per pixel
/// skip                 on or off: whether invisible surfaces and lights are left out
/// ms_per_frame         wall time: the median over frames, each drawn and waited for
/// ms_spread            from the 10th to the 90th percentile
/// ratio_to_legacy      of medians, to legacy with the same scene, lights, size and skip, frames interleaved
/// ratio_to_two_light_legacy  of medians, to legacy with two lights, else the same, frames interleaved
/// ratio_to_plain       of medians, to plain, frames interleaved; empty with more than kMaxPlainLights lights
/// max_error_255, mean_error_255  against the path's plain formulas in double (shade_reference), in steps of an 8-bit
///                      colour channel; empty for unlit and plain
/// excepted_pixels      too close to a jump of the model to be compared
///
/// The picture shows frame time over the number of lights, and table 1 of Steven Hales 2004, "Realtime Pixel Lighting
/// Using Fragment Programs", beside this machine's.
///
/// quick   one scene, small, few lights: to see that it works
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_render(bool quick);

/// Frame time beside error of every bundled scene with all its lamps, as litfog-demo draws it: in exp fog at the
/// visibility that it suggests. Columns:
///
/// scene, phase     phase: isotropic or g-0.85; empty: the scene's
/// lights           in the scene
/// fog_light        peak: the fog colour intensity of carried lights; single: the airlight of every light, scattered
///                  once; all: in all orders
/// ms_per_frame     wall time: the median over frames, each drawn and waited for, the three fog lights' interleaved
/// ms_spread        from the 10th to the 90th percentile
/// ratio_to_peak, ratio_to_single  of medians
/// bytes_uploaded   per frame
/// max_error_255, mean_error_255   of a picture of 16x9, as in measure_render()
///
/// quick   one scene, small: to see that it works
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_frames(bool quick);

/// Frame time and fragments shaded by each way to reject hidden fragments early (render::EarlyRejection; Jason Lacroix
/// 2005, "Let There Be Light!", "Early rejection is key"): every bundled scene by `unified` and peak, with 2 and 16
/// lights (with_light_count), 1 and 4 samples a pixel, in exp fog at the visibility that the scene suggests. Columns:
///
/// scene, lights, size, samples  of the frame; size is WIDTHxHEIGHT in pixels
/// rejection             none, front-to-back or depth-pass
/// ms_per_frame          wall time: the median over frames, each drawn and waited for
/// ms_spread             from the 10th to the 90th percentile
/// ratio_to_none         of medians, frames interleaved
/// layers_passed         samples of surfaces and sky that pass the depth test, also in a depth pass, over the picture's
///                       samples: the least that must be shaded
/// fragments_per_pixel   shader runs that the driver reports (GL_ARB_pipeline_statistics_query; empty without it).
///                       llvmpipe also counts rejected fragments.
///
/// quick   one scene, small, two lights: to see that it works
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_rejection(bool quick);

/// Hales's light maps over their size: memory of the 3-D range map and of the pair of 2-D maps, and the error of
/// pictures drawn with them. The scene is `headlights` with its two headlights, in exp2 fog. Columns:
///
/// path            lookup-3d or lookup-2d
/// map_size        texels along a side of the 3-D map and of the cube map's faces
/// pair_size       texels along a side of the 2-D maps; 0: none
/// range_kib       memory of a light shape's range map, and of the pair's distance map
/// cone_kib        memory of its cube map
/// max_error_255, mean_error_255   against the formulas in double
/// p99_error_255   99th percentile over the pixels
///
/// quick   fewer sizes
/// throws  gl::Unsupported, InputError if the scene is missing
Result measure_maps(bool quick);

/// A flight of 300 frames through the streets of a city at night, with 100 to 100,000 of its lights, at four
/// visibilities in exp fog. A light's range is its reach in the fog, beyond which all lights together add less than
/// half a step of the display. The view ends where fog hides a display's white. Columns:
///
/// method         clusters (LightClusters at each frame of the flight), clusters-one-light (in a still view one light
///                changes), clusters-fog (a change of the visibility: reaches, ranges and clusters); frame (a
///                picture of 320x180 by the default path, fog lit by peak, from the scene's camera), frame-airlight
///                (the same, fog lit by airlight, up to 1000 lights), frame-of-those (the same scene by peak with only
///                the lights that matter there), frame-flight (the same picture at each frame of the flight, with
///                10,000 lights)
/// visibility_m   inf is clear air
/// lights         in the scene
/// lights_that_matter  clusters: in at least one cluster, median over the frames; frame: those that the picture
///                needs (visible_lights.h); frame-airlight: those whose airlight fog does not hide
/// entries        in the light list, median over the frames
/// ms             processor time, median over the frames: clusters: of one thread; frames: of the process, a
///                software rasteriser's threads included
/// ms_spread      from the 10th to the 90th percentile
/// worst_ratio    the longest frame over the median
/// wall_ms        frames: wall time, drawn and waited for
/// ratio_to_those frame: ms over that of frame-of-those
/// max_error_255  frame: largest difference between the two pictures, in steps of the display (measure::PictureError)
///
/// It is a failure if the two pictures differ by more than both may leave out.
///
/// quick   fewer lights, visibilities and frames
/// throws  gl::Unsupported, InputError if the city is missing
Result measure_city(bool quick);

}  // namespace litfog::bench
