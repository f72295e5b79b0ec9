# SPDX-License-Identifier: Apache-2.0
# Builds the page of SOURCE_DIR into BUILD_DIR by EMCMAKE and GENERATOR.
include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

run(${EMCMAKE} ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BUILD_DIR} -G ${GENERATOR})
run(${CMAKE_COMMAND} --build ${BUILD_DIR})
