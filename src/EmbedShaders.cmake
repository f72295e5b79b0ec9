# SPDX-License-Identifier: Apache-2.0
# litfog_embed_shaders(<target> FUNCTION <qualified name> [PREFIX <prefix>] FILES <file>...)
# Compiles shader files into a target: FUNCTION() returns them as a span of litfog::gl::ShaderSource, each under PREFIX and
# its file name.
function(litfog_embed_shaders target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FUNCTION;PREFIX" "FILES")
  string(REGEX REPLACE "::[^:]*$" "" namespace ${arg_FUNCTION})
  string(REGEX REPLACE "^.*::" "" function ${arg_FUNCTION})
  set(entries "")
  foreach(file IN LISTS arg_FILES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    file(READ ${file} text)
    cmake_path(GET file FILENAME name)
    string(APPEND entries "    {\"${arg_PREFIX}${name}\", R\"glsl(${text})glsl\"},\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[
// Generated from shader files.
#include "litfog/gl/shader_library.h"

namespace @namespace@ {

std::span<const litfog::gl::ShaderSource> @function@();

std::span<const litfog::gl::ShaderSource> @function@() {
  static constexpr litfog::gl::ShaderSource kSources[] = {
@entries@  };
  return kSources;
}

}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE ${output})
endfunction()
