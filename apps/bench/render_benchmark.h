// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Frame time beside error of every lighting path, over scenes, numbers of lights (with_light_count) and sizes, in exp
/// fog at the visibility that each scene suggests. Columns:
///
/// scene, path          path also: unlit, the base texture alone; plain, the rival (PlainRenderer), which skips nothing
/// fog_light            peak: carried lights light the fog by their fog colour intensity; airlight (unified
///                      only): every light by its airlight
/// phase                the fog's phase function: isotropic, g-0.85 or droplets; empty: the scene's
/// lights, size         of the scene; WIDTHxHEIGHT in pixels
/// samples              a pixel
/// skip                 on or off: whether what cannot be visible is left out
/// ms_per_frame         wall time: the median over frames, each drawn and waited for
/// ms_spread            from their 10th to their 90th percentile
/// ratio_to_legacy      of the medians; legacy's of the same scene, lights, size and skip, frames interleaved
/// ratio_to_two_light_legacy  of the medians; legacy's of two lights, else the same, interleaved, too
/// ratio_to_plain       of the medians, interleaved, too; empty with more than kMaxPlainLights lights
/// max_error_255, mean_error_255  against the path's plain formulas in double (shade_reference), in steps of an 8-bit
///                      colour channel; empty for unlit and plain
/// excepted_pixels      too close to a jump of the model to be compared
///
/// The picture shows frame time over the number of lights and, beside this machine's, table 1 of Steven Hales 2004,
/// "Realtime Pixel Lighting Using Fragment Programs".
///
/// quick   one scene, small, few lights: to see that it works
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_render(bool quick);

}  // namespace litfog::bench
