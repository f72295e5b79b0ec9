# SPDX-License-Identifier: Apache-2.0
# The Python module of the install tree PREFIX, which was moved, finds its libraries, and its types lie beside it.
cmake_minimum_required(VERSION 3.25)
set(folder ${PREFIX}/lib/python3/dist-packages)
set(program "import litfog; print(litfog.__file__, litfog.read_light('${PREFIX}/share/litfog/lights/headlight.json').name)")
execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${folder} ${PYTHON} -c "${program}" OUTPUT_VARIABLE output
                COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "^${folder}/litfog.*headlight" OR NOT EXISTS ${folder}/litfog-stubs/__init__.pyi)
  message(FATAL_ERROR "${output}")
endif()
