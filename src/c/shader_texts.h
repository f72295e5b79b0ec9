// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/c/litfog.h"

namespace litfog::c {

/// litfog's shader files; the definition is generated from them.
std::span<const litfog_shader_text> shader_texts();

}  // namespace litfog::c
