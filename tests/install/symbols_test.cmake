# SPDX-License-Identifier: Apache-2.0
# The shared libraries of the install tree PREFIX show litfog's names alone, and each has the version of its ABI in its
# name: liblitfog*.so.ABI.
cmake_minimum_required(VERSION 3.25)
find_program(nm nm REQUIRED)
file(GLOB_RECURSE libraries ${PREFIX}/liblitfog*.so.${ABI})
list(LENGTH libraries count)
if(count LESS 1)
  message(FATAL_ERROR "no liblitfog*.so.${ABI} below ${PREFIX}")
endif()
foreach(library IN LISTS libraries)
  execute_process(COMMAND ${nm} --dynamic --demangle --defined-only --format=posix ${library} OUTPUT_VARIABLE symbols
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" "" symbols "${symbols}")
  string(REGEX REPLACE "\n$" "" symbols "${symbols}")
  string(REPLACE "\n" ";" symbols "${symbols}")
  list(LENGTH symbols count)
  list(FILTER symbols EXCLUDE REGEX "^((typeinfo|typeinfo name|vtable) for )?litfog(::|_[a-z])|^LITFOG_[0-9.]+ A")
  if(symbols OR count LESS 10)
    message(FATAL_ERROR "${library} shows ${count} symbols, and of other libraries' ${symbols}")
  endif()
endforeach()
