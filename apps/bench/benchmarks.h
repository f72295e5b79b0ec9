// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "command/plot.h"
#include "command/table.h"

// The benchmarks of litfog-bench. Its --help explains their methods and inputs, data/benchmarks/README.md the columns
// of their rows. Each takes `quick`: fewer and smaller inputs, to see that it works.

namespace litfog::bench {

/// The result of a benchmark.
struct Result {
  command::Table table;
  command::Figure figure;                   ///< no charts for a benchmark that draws none
  std::string gl_renderer = "none";         ///< GL_RENDERER
  std::function<std::string()> strip = {};  ///< draws the bytes of a PNG file; empty for a benchmark without
  std::vector<std::string> failures;        ///< sentences: where litfog exceeded its own stated error
};

/// Time against error of every method to find a light's fog colour intensity, over the mix of light_mix.h.
Result measure_solve(bool quick);

/// Time against error of every method to find a lamp's airlight along a ray, over the mixes of airlight_mix.h.
Result measure_airlight(bool quick);

/// The fog's light in exp fog for an eye that carries a lamp and looks along its axis, for four bundled lamps, over
/// visibilities of 1 m to 20 km.
///
/// throws  InputError if the lamps are missing
Result measure_lamps(bool quick);

/// Light that endless uniform fog of albedo 1 scatters from a point lamp to the eye twice or more often, by
/// measure::RadialScattering.
Result tabulate_scattering(bool quick);

/// The glow around a point lamp in endless uniform fog, isotropic and of droplets of 10 micrometres, over the angle
/// between ray and lamp: by litfog, its rivals (glow_rival.h), the random walk and, as the reference,
/// measure::RadialScattering.
Result draw_glow(bool quick);

/// One lamp, 100 m away in endless fog of droplets of 10 micrometres, at six visibilities (columns), with its light
/// scattered once, in all orders by litfog, and in all orders by measure::RadialScattering (rows). A column has the
/// automatic exposure of its last picture. The lamp's direct light is a disc of a few pixels.
///
/// returns the bytes of a PNG file
/// throws  image::ImageError if no font is found
std::string draw_glow_strip(bool quick);

/// Four views of scenes with fog lit by single scattering and by all orders, beside the true pictures: single
/// scattering, and traced paths for the rest (measure::trace_higher_orders). Single scattering has shafts of shadow of
/// 32 lamps, which are all in `street` and `room`; the traced paths know the shadows of all. The strip has a row of the
/// three for each view, by the automatic exposure of the last.
///
/// throws  gl::Unsupported like Renderer
Result trace_scenes(bool quick);

/// A visibility that falls and rises again, step by step, over many lights of few kinds: by FogUpdater, by one that
/// skips nothing, and by the float batch over every light.
Result measure_update(bool quick);

/// An hour of a simulator at 60 steps a second, as fast as possible.
Result measure_load(bool quick);

/// C, L and Q from falloff tables of 20 samples, by litfog and by a plain use of Ceres (bounds at 0, default options).
/// The optimum is the best found by any method, brought to 50 digits and certified there.
Result measure_fit(bool quick);

/// Frame time beside error of every lighting path, over scenes, numbers of lights (with_light_count) and sizes, in exp
/// fog at the visibility that each scene suggests. The picture shows frame time over the number of lights, and table 1
/// of Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", beside this machine's.
///
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_render(bool quick);

/// Frame time beside error of every bundled scene with all its lamps, as litfog-demo draws it.
///
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_frames(bool quick);

/// Frame time and fragments shaded by each way to reject hidden fragments early (render::EarlyRejection; Jason Lacroix
/// 2005, "Let There Be Light!", "Early rejection is key").
///
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_rejection(bool quick);

/// Hales's light maps over their size: memory of the 3-D range map and of the pair of 2-D maps, and the error of
/// pictures drawn with them.
///
/// throws  gl::Unsupported, InputError if the scene is missing
Result measure_maps(bool quick);

/// A flight through the streets of a city at night: the clusters of its lights, and frames of it. It is a failure if a
/// frame with all lights and one with only the lights that matter differ by more than both may leave out.
///
/// throws  gl::Unsupported, InputError if the city is missing
Result measure_city(bool quick);

}  // namespace litfog::bench
