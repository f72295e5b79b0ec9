// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command/table.h"
#include "scene/scene.h"

namespace litfog::demo {

/// A scene's lights: a row for each entry of its file's "lights", with the position of its first copy, for each kind of
/// a generated city's, and for each light of a glTF file. Its columns:
///
/// member                        as --set takes it: lights[3]; city; empty of a glTF file
/// lights                        how many the row stands for
/// name                          of the light
/// x_m, y_m, z_m                 where the first of them is
/// constant, linear, quadratic   of the attenuation, 1, 1/m, 1/m^2
/// threshold, extent_m           the attenuation at which the light ends, and where that is
/// cone                          in words
/// density_scale
/// carried                       yes or no: by the eye's vehicle
command::Table list_lights(const scene::Scene& scene);

}  // namespace litfog::demo
