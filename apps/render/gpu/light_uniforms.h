// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/program.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {

/// Lets the program in use read the fog, the lights' tables and their cookies.
inline void bind_lights(const gl::Program& program, const gl::FogLightBuffer& fog_lights) {
  fog_lights.bind(program, kFogLightBinding);
  set_uniform(program, "litfog_kind_buffer", kKindBufferUnit);
  set_uniform(program, "litfog_instance_buffer", kInstanceBufferUnit);
  set_uniform(program, "cookies", kCookieUnit);
  set_uniform(program, "cookie_cones", kCookieConeUnit);
}

}  // namespace litfog::render
