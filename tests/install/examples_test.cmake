# SPDX-License-Identifier: Apache-2.0
# Builds each example of the install tree PREFIX against that tree, as whoever copies it would, and runs it.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
set(examples ${PREFIX}/share/doc/litfog-dev/examples)
set(openscenegraph "")
if(OPENSCENEGRAPH)
  set(openscenegraph "openscenegraph;openscenegraph_host;${examples}/openscenegraph/street.osgt")
endif()
foreach(example "smallest;smallest_host" "smallest_c;smallest_c_host" "gl;gl_host" "cigi;cigi_ig;--demo"
        "many_lights;many_lights_host;${WORK_DIR}/many_lights.ppm;36;500" "${openscenegraph}")
  if(NOT example)
    continue()
  endif()
  list(POP_FRONT example folder program)
  run(${CMAKE_COMMAND} -S ${examples}/${folder} -B ${WORK_DIR}/${folder} -G ${GENERATOR}
      -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
      -DCMAKE_C_COMPILER=${C_COMPILER} --no-warn-unused-cli)
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/${folder})
  run(${WORK_DIR}/${folder}/${program} ${example})
endforeach()
file(REMOVE_RECURSE ${WORK_DIR})
