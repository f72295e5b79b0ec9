// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace litfog::measure {

/// The longest step of an OpenGL driver: it compiles a shader at its first draw call.
inline constexpr std::string_view kCompiling = "compiling shaders";

/// Called now and then, on the caller's thread, with the current step: "timing frame 3, 2 of 10", "shading the
/// reference: 40 %". May be empty.
using Progress = std::function<void(std::string_view step)>;

}  // namespace litfog::measure
