# SPDX-License-Identifier: Apache-2.0
# litfog_embed_text(<target> FUNCTION <qualified name> TYPE <type> HEADER <header> BASES <folder>... FILES <file>...)
# Compiles text files into a target: FUNCTION() returns them as a span of TYPE{name, text}, which HEADER defines. A name
# is the file's path below whichever of the BASES holds it.
function(litfog_embed_text target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FUNCTION;TYPE;HEADER" "BASES;FILES")
  string(REGEX REPLACE "::[^:]*$" "" namespace ${arg_FUNCTION})
  string(REGEX REPLACE "^.*::" "" function ${arg_FUNCTION})
  set(entries "")
  foreach(file IN LISTS arg_FILES)
    cmake_path(ABSOLUTE_PATH file NORMALIZE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set(name ${file})
    foreach(base IN LISTS arg_BASES)
      string(REPLACE ${base}/ "" name ${name})
    endforeach()
    string(APPEND entries "    {\"${name}\", R\"text(${text})text\"},\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[
// Generated from text files.
#include "@arg_HEADER@"

#include <span>

namespace @namespace@ {

std::span<const @arg_TYPE@> @function@();

std::span<const @arg_TYPE@> @function@() {
  static constexpr @arg_TYPE@ kTexts[] = {
@entries@  };
  return kTexts;
}

}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE ${output})
endfunction()
