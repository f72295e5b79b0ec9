// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Frame time and fragments shaded by each way to reject hidden fragments early (render::EarlyRejection; Jason Lacroix
/// 2005, "Let There Be Light!", "Early rejection is key"): every bundled scene by `unified` and peak, with 2 and 16
/// lights (with_light_count), 1 and 4 samples a pixel, in exp fog at the visibility that the scene suggests. Columns:
///
/// scene, lights, size, samples  of the frame; size is WIDTHxHEIGHT in pixels
/// rejection             none, front-to-back or depth-pass
/// ms_per_frame          wall time: the median over frames, each drawn and waited for
/// ms_spread             from their 10th to their 90th percentile
/// ratio_to_none         of the medians, frames interleaved
/// layers_passed         samples of surfaces and sky that pass the depth test, also in a pass of depths alone, over the
///                       picture's samples: what has to be shaded at least
/// fragments_per_pixel   for which the driver says that it ran a shader (GL_ARB_pipeline_statistics_query; empty where
///                       it lacks that). llvmpipe counts fragments that it rejects, too.
///
/// quick   one scene, small, two lights: to see that it works
/// throws  gl::Unsupported where there is no OpenGL 3.3 through EGL
Result measure_rejection(bool quick);

}  // namespace litfog::bench
