// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "render/renderer.h"

namespace litfog::bench {

/// The lights that a picture needs, found without the bounds by which the renderer skips: on the surfaces seen, all the
/// others together change no sample by more than half a step of the display, 1/255, at 0 EV. What each light gives to a
/// sample is that of the plain formulas in double (measure::PathModel). Lights whose points the renderer draws and
/// carried lights are always among them.
///
/// renderer  which lights its fog by peak
/// returns   indices in the scene's lights, ascending
std::vector<std::size_t> find_visible_lights(render::Renderer& renderer);

}  // namespace litfog::bench
