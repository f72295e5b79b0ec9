// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/program.h"
#include "litfog/phase.h"
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

/// Sets the uniform `phase` of the program in use (litfog/shaders/phase.glsl).
inline void set_phase(const gl::Program& program, const Phase& phase) {
  set_uniform(program, "phase.asymmetry", to_floats(phase).asymmetry);
}

}  // namespace litfog::render
