# SPDX-License-Identifier: Apache-2.0
# A stranger's project has litfog's tree LITFOG in it, BY FetchContent (a shared core, built and run) or add_subdirectory
# (a static core, against which one file is compiled, of no build type). It installs nothing of litfog's. SOURCE_DIR is
# that project.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
if(BY STREQUAL "FetchContent")
  set(shared ON)
  set(target host)
  set(type -DCMAKE_BUILD_TYPE=Debug)
else()
  set(shared OFF)
  set(target host_parts)
  set(type "")
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} ${type}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DBUILD_SHARED_LIBS=${shared} -DBY=${BY} -DLITFOG=${LITFOG}
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_CXX_FLAGS=-DHWY_COMPILE_ONLY_STATIC)  # one SIMD target: built sooner
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --target ${target})
file(STRINGS ${WORK_DIR}/build/compile_commands.json optimised REGEX "-O2 .*/solve/solve\\.cpp")
if(optimised AND type OR NOT optimised AND NOT type)
  message(FATAL_ERROR "the build type ${type}: -O2 in \"${optimised}\"")
endif()
if(BY STREQUAL "FetchContent")
  run(${WORK_DIR}/build/host)
  if(NOT output MATCHES "^0\\.0625 at 6 of 6\n")
    message(FATAL_ERROR "the host printed \"${output}\"")
  endif()
  run(${CMAKE_COMMAND} --install ${WORK_DIR}/build --prefix ${WORK_DIR}/prefix)
  file(GLOB_RECURSE installed RELATIVE ${WORK_DIR}/prefix ${WORK_DIR}/prefix/*)
  if(NOT installed STREQUAL "bin/host")
    message(FATAL_ERROR "installed with the host: ${installed}")
  endif()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
