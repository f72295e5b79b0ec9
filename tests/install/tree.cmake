# SPDX-License-Identifier: Apache-2.0
# Installs the build tree BUILD_DIR and moves what it has installed to PREFIX: the tests take an install tree that lies
# elsewhere than where it was installed.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${PREFIX}_first
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}_first ${PREFIX})
foreach(header attenuation cone fit/attenuation_fit fog fog_light_block gl/fog_light_tables formulas light c/litfog solve
               updater value_error)
  if(NOT EXISTS ${PREFIX}/include/litfog/${header}.h)
    message(FATAL_ERROR "litfog/${header}.h is not installed")
  endif()
endforeach()
