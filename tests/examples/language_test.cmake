# SPDX-License-Identifier: Apache-2.0
# Builds the smallest host of EXAMPLES in LANGUAGE (ada by GNATMAKE, csharp by MCS, run by MONO) and a program that calls
# the rest of its declarations. Runs both with LIBRARY in the place of the installed liblitfog_c and the file LAMP; the
# output is the host's.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
foreach(name liblitfog_c.so liblitfog_c.so.0.1)
  file(CREATE_LINK ${LIBRARY} ${WORK_DIR}/${name} SYMBOLIC)
endforeach()
cmake_path(GET LIBRARY PARENT_PATH library_dir)
set(ENV{LD_LIBRARY_PATH} ${WORK_DIR}:${library_dir})
set(ENV{LC_ALL} C)
if(LANGUAGE STREQUAL "ada")
  foreach(source ${EXAMPLES}/ada/smallest_host.adb ${CMAKE_CURRENT_LIST_DIR}/declarations.adb)
    run(${GNATMAKE} -q -gnatwae -D ${WORK_DIR} -aI${EXAMPLES}/ada ${source} -o ${WORK_DIR}/program
        -largs -L${WORK_DIR} -llitfog_c)
    execute_process(COMMAND ${WORK_DIR}/program ${LAMP} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
else()
  foreach(source ${EXAMPLES}/csharp/SmallestHost.cs ${CMAKE_CURRENT_LIST_DIR}/Declarations.cs)
    run(${MCS} -warnaserror -out:${WORK_DIR}/program.exe ${source} ${EXAMPLES}/csharp/Litfog.cs)
    execute_process(COMMAND ${MONO} ${WORK_DIR}/program.exe ${LAMP} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
