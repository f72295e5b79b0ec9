// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/c/litfog.h"

namespace litfog::c {

/// litfog's shader files. Generated from them.
std::span<const litfog_shader_text> shader_texts();

}  // namespace litfog::c
