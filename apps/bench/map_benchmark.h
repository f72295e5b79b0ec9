// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// Hales's light maps over their size: memory of the 3-D range map and of the pair of 2-D maps, and the error of the
/// picture that is drawn by them. The scene is `headlights` by its two headlights, in exp2 fog. Columns:
///
/// path            lookup-3d or lookup-2d
/// map_size        texels a side of the 3-D map and of the cube map's faces
/// pair_size       of the 2-D maps; 0: none
/// range_kib       memory of a light shape's range map, and of the pair's distance map
/// cone_kib        of its cube map
/// max_error_255, mean_error_255   against the formulas in double
/// p99_error_255   all but one in a hundred pixels err by less
///
/// quick   fewer sizes
/// throws  gl::Unsupported, InputError where the scene is not there
Result measure_maps(bool quick);

}  // namespace litfog::bench
