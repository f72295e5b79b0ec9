// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <tuple>

#include "litfog/atmosphere.h"
#include "litfog/formulas.h"
#include "litfog/gl/program.h"
#include "render/airlight/airlight_list.h"

namespace litfog::render {

inline constexpr int kCookieProfile = int(LITFOG_PROFILE_COOKIE);  ///< profile of a light with a cookie, in shaders

/// Compiles two shaders once for each kind of lights, fog mode, number of knots of its layers and even or uneven
/// scattering, when first asked for, so that the compiler drops what a kind does not need. The shaders include
/// airlight_constants.glsl. Needs a current GL context.
class AirlightPrograms {
 public:
  AirlightPrograms(const char* vertex_file, const char* fragment_file)
      : vertex_file_(vertex_file), fragment_file_(fragment_file) {}

  /// Good as long as this.
  const gl::Program& program(const Atmosphere& atmosphere, const AirlightKind& lights);

 private:
  const char* vertex_file_;
  const char* fragment_file_;
  std::map<std::tuple<FogMode, std::size_t, AirlightKind, bool>, gl::Program> programs_;  // bool: isotropic fog
};

}  // namespace litfog::render
