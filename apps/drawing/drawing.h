// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "command/progress.h"
#include "drawing/drawing_options.h"
#include "litfog/fog.h"
#include "measure/frame_times.h"
#include "measure/picture_error.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace litfog::drawing {

/// A scene drawn once or several times, with times and statistics.
struct Drawn {
  render::Picture picture;
  Display display;    ///< for which it was drawn; an automatic exposure has been chosen
  double visibility;  ///< metres
  measure::FrameTimes times;
  double load_ms;                      ///< milliseconds until all is uploaded and lights are solved
  double first_ms;                     ///< from then to the first timed frame: shaders, exposure and a frame before it
  std::size_t shadow_lamps;            ///< lamps that cast shadows
  std::size_t shadow_maps;             ///< maps of these lamps and of the moon
  render::FrameStatistics statistics;  ///< one more frame's, if asked for
  std::optional<measure::Comparison> comparison;  ///< with the reference, if asked for
  int samples;                                    ///< per pixel
  std::string gl_renderer;
  std::string gl_version;
};

/// The display and the fog that a picture is drawn for.
struct DrawnFor {
  Display display;    ///< an automatic exposure has been chosen
  double visibility;  ///< metres
};

/// Sets a renderer's fog and exposure as the options state, or else as its scene suggests. The exposure is metered
/// before the eye's glare.
DrawnFor set_fog_and_exposure(render::Renderer& renderer, const DrawingOptions& options);

/// The light of a renderer's last frame. Drawn again in floats if half floats clip it, because glare shows how bright a
/// lamp is.
///
/// light   as the renderer has drawn it
/// throws  gl::Unsupported where the driver has no float framebuffer of that size
render::Picture whole_light(render::Renderer& renderer, render::Picture light);

/// Draws and times a scene. Throws gl::Unsupported if this machine cannot.
///
/// load            started when loading the scene began
/// progress        shows the current step
/// frames          number to time, >= 1
/// has_reference   compares the last frame with its reference
/// has_statistics  measures one more frame
/// in_floats       draws the picture once more in floats; happens anyway if half floats clip it
Drawn draw(const scene::Scene& scene, const DrawingOptions& options, const command::WallTimer& load,
           command::Progress& progress, int frames, bool has_reference, bool has_statistics, bool in_floats = false);

/// The file of --stats: what was drawn and how (`scene` to `lights`, `skip` to `shadow_maps`), the times of loading, of
/// a first frame, which compiles shaders, and of `frames` more frames (`ms_to_load`, `ms_to_first_frame`,
/// `ms_per_frame`), and of one more frame, drawn stage by stage as if the view had just changed:
///
/// chunks                surfaces: drawn; fog_alone (hidden by fog, but before something that is visible);
///                       outside_view; hidden_by_fog. chunks_drawn is the sum of the first two, chunks_skipped of the
///                       others
/// lights_by_fate        the scene's lights: drawn (on a surface, as a point or as airlight); off (black, or ending at
///                       the lamp); outside_view with all that they reach; out_of_reach of all surfaces and outside the
///                       view; hidden_by_fog, or by distance, in all that they reach
/// surface_lights        pairs of a drawn surface and a light: listed; out_of_reach; hidden_by_fog.
///                       surface_lights_listed is the first, surface_lights_skipped the sum of the others
/// points                lights' points: drawn; outside_view; hidden_by_fog
/// airlights             lights' airlight: drawn; invisible, because fog hides it or there is no fog to light
/// sky                   drawn, fog_alone or hidden_by_fog
/// lights_per_fragment   mean over visible surfaces; 0 where only fog is drawn
/// bytes_uploaded        fog_change: light tables at the last one; frame: light lists and uniforms of draw calls
/// ms_by_stage           plan (what to draw, on the CPU), surfaces, sky, points, panes, resolve (of a pixel's samples),
///                       airlight: each is waited for
///
/// Then exposure, tone and glare of a displayed picture, and errors if there is a reference.
///
/// display  the picture file's; none if the file holds the scene's light
std::string stats_json(const scene::Scene& scene, const DrawingOptions& options, const Drawn& drawn,
                       const std::optional<Display>& display);

}  // namespace litfog::drawing
