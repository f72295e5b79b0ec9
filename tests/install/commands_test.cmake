# SPDX-License-Identifier: Apache-2.0
# The commands of the install tree PREFIX, which was moved, find their libraries, their data (a spec that is in no other
# tree) and their plugin. Writes into WORK_DIR.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY ${WORK_DIR})
file(COPY_FILE ${PREFIX}/share/litfog/specs/aerobeacon.json ${PREFIX}/share/litfog/specs/of-this-tree-alone.json)
execute_process(COMMAND ${PREFIX}/bin/litfog-fit of-this-tree-alone -o ${WORK_DIR}/lamp.json OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PREFIX}/bin/litfog-solve --light ${WORK_DIR}/lamp.json --visibility 400 OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
if(EXISTS ${PREFIX}/bin/litfog-demo)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_DEBUG=files ${PREFIX}/bin/litfog-demo room --size 8x8
                          -o ${WORK_DIR}/room.exr OUTPUT_QUIET ERROR_VARIABLE loads RESULT_VARIABLE status)
  if(NOT status EQUAL 0 AND (NOT status EQUAL 3 OR DEFINED ENV{LITFOG_REQUIRE_GL}))
    message(FATAL_ERROR "litfog-demo: ${status}")
  endif()
  if(status EQUAL 0 AND NOT loads MATCHES "${PREFIX}/[^ ]*/litfog-openimageio.so")
    message(FATAL_ERROR "litfog-demo loaded another tree's plugin")
  endif()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
