# SPDX-License-Identifier: Apache-2.0
# CMake in PAGES (separated by |): each block is the end of a reader's project that has the target `engine`, litfog's
# install tree PREFIX, and litfog's sources ROOT in third_party. It is configured, not built, in WORK_DIR.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
file(WRITE ${WORK_DIR}/main.cpp "int main() {}\n")
file(MAKE_DIRECTORY ${WORK_DIR}/third_party)
file(CREATE_LINK ${ROOT} ${WORK_DIR}/third_party/litfog SYMBOLIC)
set(fence "\n```cmake\n")
string(LENGTH "${fence}" fence_length)
set(count 0)
string(REPLACE "|" ";" pages "${PAGES}")
foreach(page IN LISTS pages)
  file(READ ${page} text)
  string(FIND "${text}" "${fence}" begin)
  while(begin GREATER_EQUAL 0)
    math(EXPR begin "${begin} + ${fence_length}")
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(FIND "${text}" "```\n" end)
    string(SUBSTRING "${text}" 0 ${end} block)
    math(EXPR count "${count} + 1")
    # In one folder after another, so that the compiler is asked only once what it is.
    file(WRITE ${WORK_DIR}/CMakeLists.txt
         "cmake_minimum_required(VERSION 3.25)\nproject(reader)\nadd_executable(engine main.cpp)\n${block}"
         "foreach(folder \${litfog_SHADER_DIR} \${litfog_DATA_DIR})\n  if(NOT EXISTS \${folder})\n"
         "    message(FATAL_ERROR \"there is no \${folder}\")\n  endif()\nendforeach()\n")
    message(STATUS "${page}\n${block}")
    run(${CMAKE_COMMAND} -S ${WORK_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${PREFIX}
        -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_C_COMPILER=${C_COMPILER} --no-warn-unused-cli)
    string(FIND "${text}" "${fence}" begin)
  endwhile()
endforeach()
if(count LESS 3)
  message(FATAL_ERROR "only ${count} blocks in ${PAGES}")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
