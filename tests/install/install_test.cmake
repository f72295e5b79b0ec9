# SPDX-License-Identifier: Apache-2.0
# Builds SOURCE_DIR against the install tree PREFIX as a project of a stranger would, by CMake and by pkg-config, and runs
# it. CONSUMER core must come without any package but GLM and link nothing but litfog, photometry without Ceres or what
# else the fits, the commands and GL need; each asks for the component of its name, but core and shaders, which takes the
# installed shaders alone.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
if(CONSUMER STREQUAL "shaders")
  run(${CMAKE_COMMAND} -DINCLUDE_DIR=${PREFIX}/include -DWORK_DIR=${WORK_DIR}/shaders
      -P ${CMAKE_CURRENT_LIST_DIR}/../shaders/glslang_test.cmake)
  file(REMOVE_RECURSE ${WORK_DIR})
  return()
endif()

set(options -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_BUILD_TYPE=${CONFIG}
            -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS} -DCMAKE_C_COMPILER=${C_COMPILER}
            -DCMAKE_C_FLAGS=${CXX_FLAGS} -DCONSUMER=${CONSUMER} --no-warn-unused-cli)
if(CONSUMER MATCHES "^(core|photometry|files|c)$")
  foreach(package Ceres OpenGL OpenImageIO nlohmann_json CLI11 fmt)
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
endif()
if(CONSUMER MATCHES "^(core|files|c)$")  # photometry finds pugixml and others by it
  list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build ${options})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --verbose)

if(NOT output MATCHES "liblitfog(_c)?\\.(a|so)")
  message(FATAL_ERROR "no link line to be seen:\n${output}")
endif()
set(foreign litfog_fit|litfog_gl|ceres|glog|GL|OpenGL|EGL|epoxy|OpenImageIO|fmt)
if(CONSUMER MATCHES "^(core|files|c)$")
  string(APPEND foreign |litfog_photometry|minizip|pugixml|uchardet)
endif()
if(CONSUMER MATCHES "^(core|photometry|files|c)$" AND output MATCHES "(-l|lib)(${foreign})[^A-Za-z]")
  message(FATAL_ERROR "${CONSUMER} links ${CMAKE_MATCH_2}:\n${output}")
endif()

file(GLOB_RECURSE pc_files ${PREFIX}/litfog.pc)
cmake_path(GET pc_files PARENT_PATH pc_dir)
cmake_path(GET pc_dir PARENT_PATH library_dir)
set(module litfog-${CONSUMER})
if(CONSUMER STREQUAL "core")
  set(module litfog)
endif()
find_program(PKG_CONFIG pkg-config REQUIRED)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_dir} ${PKG_CONFIG} --cflags --libs ${module})
separate_arguments(pkg_config_flags NATIVE_COMMAND "${output}")
set(compile ${CXX_COMPILER} -std=c++20 ${SOURCE_DIR}/${CONSUMER}.cpp)
if(CONSUMER STREQUAL "c")
  set(compile ${C_COMPILER} ${SOURCE_DIR}/c.c)
endif()
run(${compile} ${CXX_FLAGS} -o ${WORK_DIR}/pkg_config_consumer ${pkg_config_flags} -Wl,-rpath,${library_dir})

file(WRITE ${WORK_DIR}/lamp.json [[{"litfog": "light", "version": 1, "attenuation": {"quadratic": 1}}]])
set(expected_core "^0\\.0625 at 6 of 6\n3 lights of 1 kind: 0\\.0625\n$")
set(expected_photometry "^99\\.61 lm\n$")
set(expected_files "\"name\": \"lamp\".*\n120\n2:13\n$")
set(expected_c "^litfog [0-9.]+: lamp ends at 4\\.47214 m\n$")
set(expected_fit "^6 0\\.4")
set(expected_gl "litfog/shaders/surface\\.glsl")
foreach(consumer build/consumer pkg_config_consumer)
  run(${WORK_DIR}/${consumer} ${WORK_DIR}/lamp.json)
  if(NOT DEFINED expected_${CONSUMER} OR NOT output MATCHES "${expected_${CONSUMER}}")
    message(FATAL_ERROR "${consumer} printed \"${output}\"")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK_DIR})
