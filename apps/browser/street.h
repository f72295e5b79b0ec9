// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace litfog::browser {

/// The page's scene: a wet street at night, seen from a car whose headlights are on. Sodium lamps, an oncoming car,
/// houses, trees. Small enough to be built, painted and drawn by a telephone. Lamps of one kind stand next to each
/// other, and those that the eye's car carries come first. Its materials are not painted, and its lights have only
/// names: those of files in data/lights.
scene::Scene make_street();

}  // namespace litfog::browser
