# SPDX-License-Identifier: Apache-2.0
# Installs the build tree BUILD_DIR under WORK_DIR, builds SOURCE_DIR against it as a project of a stranger would, and
# runs it. CONSUMER core must come without any package but GLM and link nothing but litfog; fit and gl ask for the
# component.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${WORK_DIR}/prefix)
foreach(header attenuation cone fog fog_light_block formulas light refusal solve)
  if(NOT EXISTS ${WORK_DIR}/prefix/include/litfog/${header}.h)
    message(FATAL_ERROR "litfog/${header}.h is not installed")
  endif()
endforeach()
foreach(shader expm1 fog formulas light surface)
  if(NOT EXISTS ${WORK_DIR}/prefix/include/litfog/shaders/${shader}.glsl)
    message(FATAL_ERROR "litfog/shaders/${shader}.glsl is not installed")
  endif()
endforeach()

set(options -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_BUILD_TYPE=${CONFIG}
            -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS} -DCONSUMER=${CONSUMER})
if(CONSUMER STREQUAL "core")
  foreach(package Ceres PkgConfig OpenGL OpenImageIO nlohmann_json CLI11 fmt)
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build ${options})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --verbose)

if(NOT output MATCHES "liblitfog\\.(a|so)")
  message(FATAL_ERROR "no link line to be seen:\n${output}")
endif()
set(foreign "(-l|lib)(litfog_gl|ceres|glog|GL|OpenGL|EGL|epoxy|OpenImageIO|fmt)[^A-Za-z]")
if(CONSUMER STREQUAL "core" AND output MATCHES "${foreign}")
  message(FATAL_ERROR "the core links ${CMAKE_MATCH_2}:\n${output}")
endif()

run(${WORK_DIR}/build/consumer)
if(CONSUMER STREQUAL "core" AND NOT output STREQUAL "0.0625 at 6 of 6\n")
  message(FATAL_ERROR "the consumer printed \"${output}\"")
endif()
if(CONSUMER STREQUAL "gl" AND NOT output MATCHES "litfog/surface\\.glsl")
  message(FATAL_ERROR "the consumer printed \"${output}\"")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
