// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// A flight of 300 frames through the streets of a city at night, with 100 to 100,000 of its lights, at four
/// visibilities in exp fog. A light's range is its reach in the fog, beyond which all lights together add less than half
/// a step of the display, and the view ends where fog hides what is as bright as a display's white. Columns:
///
/// method         clusters (LightClusters at each frame of the flight), clusters-one-light (the view stands and one
///                light changes), clusters-fog (a change of the visibility: reaches, ranges and clusters); frame (a
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
/// Pictures that differ by more than both may leave out are a failure.
///
/// quick   fewer lights, visibilities and frames
/// throws  gl::Unsupported, InputError where the city is not there
Result measure_city(bool quick);

}  // namespace litfog::bench
