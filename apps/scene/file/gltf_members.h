// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

/// Refuses what a glTF reader would pass over in silence as if it were not given, or misread: members of a wrong kind
/// or length, of all that the demo reads of such a file (glTF 2.0, chapter 5; KHR_lights_punctual).
///
/// root    the file's JSON
/// throws  InputError
void expect_gltf_members(const JsonValue& root);

}  // namespace litfog::scene
