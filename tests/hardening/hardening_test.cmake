# SPDX-License-Identifier: Apache-2.0
# Each of FILES, libraries and commands of this build, calls what ends the program at a smashed stack and at an index beyond
# a container's end; those together, what ends it at an overflow that the C library sees. A host's own code has none of it.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

set(checked "")
string(REPLACE "," ";" files "${FILES}")
foreach(file IN LISTS files)
  run(${NM} --undefined-only ${file})
  foreach(function __stack_chk_fail __glibcxx_assert_fail)
    if(NOT output MATCHES "${function}")
      message(FATAL_ERROR "${file} has no call of ${function}")
    endif()
  endforeach()
  string(APPEND checked "${output}")
endforeach()
if(NOT checked MATCHES "U __[a-z]+_chk")
  message(FATAL_ERROR "no call of a checked function of the C library")
endif()
