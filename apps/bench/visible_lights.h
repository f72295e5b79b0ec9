// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "render/renderer.h"

namespace litfog::bench {

/// The lights that a picture needs, found without the renderer's bounds: on visible surfaces, all others together
/// change no sample by more than half a step of the display, 1/255, at 0 EV. A light's contribution to a sample is by
/// the plain formulas in double (measure::PathModel). Always includes carried lights and lights whose points the
/// renderer draws.
///
/// renderer  lights its fog by peak
/// returns   indices in the scene's lights, ascending
std::vector<std::size_t> find_visible_lights(render::Renderer& renderer);

}  // namespace litfog::bench
