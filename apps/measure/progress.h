// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace litfog::measure {

/// What of an OpenGL driver takes longest: it compiles a shader when that is first drawn with.
inline constexpr std::string_view kCompiling = "compiling shaders";

/// Called now and then, on the caller's thread, with what is being done: "timing frame 3, 2 of 10", "shading the
/// reference: 40 %". An empty one is not called.
using Progress = std::function<void(std::string_view step)>;

}  // namespace litfog::measure
