// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/result.h"

namespace litfog::bench {

/// What an eye sees in exp fog that carries a lamp and looks along its axis, for four lamps that come with litfog, over
/// visibilities of 1 m to 20 km. Columns:
///
/// lamp            file of the light in data/lights
/// visibility_m    at 5 % contrast
/// peak            fog colour intensity
/// airlight_k0     axial airlight: without the lamp's own leg through the fog
/// airlight_k1     airlight with it, by the fast form
/// reference_k0, reference_k1  the same by the reference
/// max_error_255   largest difference of the two, in steps of an 8-bit colour channel
///
/// quick   fewer visibilities
/// throws  InputError where the lamps are not there
Result measure_lamps(bool quick);

}  // namespace litfog::bench
