// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog::bench {

/// One lamp, 100 m away in endless fog of droplets of 10 micrometres, at six visibilities (columns), with its light
/// scattered once, in all orders by litfog, and in all orders by measure::RadialScattering (rows). A column has the
/// exposure that is chosen for its last picture. The lamp's direct light lies on a disc of a few pixels.
///
/// quick   small pictures and a coarser reference
/// returns the bytes of a PNG file
/// throws  image::ImageError where no font is found for its letters
std::string draw_glow_strip(bool quick);

}  // namespace litfog::bench
