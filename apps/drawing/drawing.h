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

/// A scene drawn once or several times, and what there is to know about it.
struct Drawn {
  render::Picture picture;
  Display display;    ///< for which it was drawn, an automatic exposure chosen
  double visibility;  ///< metres
  measure::FrameTimes times;
  double load_ms;            ///< milliseconds until all is uploaded and lights are solved
  double first_ms;           ///< from then on until the first frame timed: shaders, exposure and a frame before it
  std::size_t shadow_lamps;  ///< that cast shadows
  std::size_t shadow_maps;   ///< theirs and the moon's
  render::FrameStatistics statistics;             ///< one more frame's, if asked for
  std::optional<measure::Comparison> comparison;  ///< with the reference, if asked for
  int samples;                                    ///< a pixel
  std::string gl_renderer;
  std::string gl_version;
};

/// What a picture is drawn for.
struct DrawnFor {
  Display display;    ///< an automatic exposure chosen
  double visibility;  ///< metres
};

/// Gives a renderer the fog and the exposure that the options state, or else its scene suggests. The exposure is that
/// of the light before the eye's glare.
DrawnFor set_fog_and_exposure(render::Renderer& renderer, const DrawingOptions& options);

/// The light of a renderer's last frame, drawn again in floats where half floats cut it off: glare shows how bright a
/// lamp is.
///
/// light   as the renderer has drawn it
/// throws  gl::Unsupported where the driver has no float framebuffer of that size
render::Picture whole_light(render::Renderer& renderer, render::Picture light);

/// Draws and times a scene. Throws gl::Unsupported if this machine cannot.
///
/// load            since the scene has been loading
/// progress        shows what is done
/// frames          to time, >= 1
/// has_reference   whether the last frame is compared with its reference
/// has_statistics  whether statistics are wanted
/// in_floats       whether the picture is drawn once more into floats; it is anyway where light is beyond half floats
Drawn draw(const scene::Scene& scene, const DrawingOptions& options, const command::WallTimer& load,
           command::Progress& progress, int frames, bool has_reference, bool has_statistics, bool in_floats = false);

/// The file of --stats: what was drawn and how (`scene` to `lights`, `skip` to `shadow_maps`), the times of loading it,
/// of a first frame, for which shaders are compiled, and of `frames` frames after it (`ms_to_load`,
/// `ms_to_first_frame`, `ms_per_frame`), and of one frame more, drawn stage by stage as if the view had just changed:
///
/// chunks                surfaces: drawn; fog_alone (hidden by fog, but before something that is visible);
///                       outside_view; hidden_by_fog. chunks_drawn is the sum of the first two, chunks_skipped of the
///                       others
/// lights_by_fate        the scene's lights: drawn (on a surface, as a point or as airlight); off (black, or ending at
///                       the lamp); outside_view with all that they reach; out_of_reach of all surfaces and outside the
///                       view; hidden_by_fog, or by distance, in all that they reach
/// surface_lights        pairs of a drawn surface and a light: listed; out_of_reach; hidden_by_fog.
///                       surface_lights_listed is the first, surface_lights_skipped the sum of the others
/// points                of lights: drawn; outside_view; hidden_by_fog
/// airlights             of lights: drawn; invisible, because fog hides them or there is none that they light
/// sky                   drawn, fog_alone or hidden_by_fog
/// lights_per_fragment   of visible surfaces, in the mean; 0 on those that are fog alone
/// bytes_uploaded        by the last fog_change: of the light tables; by the frame: lists of lights and what draws take
/// ms_by_stage           plan (what to draw, on the CPU), surfaces, sky, points, panes, resolve (of a pixel's samples),
///                       airlight: each is waited for
///
/// Then exposure, tone and glare of a picture that a display shows, and errors where there is a reference.
///
/// display  of the picture's file; none for one that holds the scene's light
std::string stats_json(const scene::Scene& scene, const DrawingOptions& options, const Drawn& drawn,
                       const std::optional<Display>& display);

}  // namespace litfog::drawing
