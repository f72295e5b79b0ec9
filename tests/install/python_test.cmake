# SPDX-License-Identifier: Apache-2.0
# The Python package of the install tree PREFIX, which was moved, finds its libraries, and its types lie beside it. With
# PICTURES it also finds its scenes: one that is in no other tree.
cmake_minimum_required(VERSION 3.25)
set(folder ${PREFIX}/lib/python3/dist-packages)

function(run_python program)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${folder} ${PYTHON} -c "${program}"
                  OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(light ${PREFIX}/share/litfog/lights/headlight.json)
run_python("import litfog\nprint(litfog.__file__, litfog.read_light('${light}').name)")
if(NOT output MATCHES "^${folder}/litfog.*headlight" OR NOT EXISTS ${folder}/litfog/__init__.pyi
   OR NOT EXISTS ${folder}/litfog/py.typed)
  message(FATAL_ERROR "${output}")
endif()
if(PICTURES)
  file(COPY_FILE ${PREFIX}/share/litfog/scenes/room.json ${PREFIX}/share/litfog/scenes/of-this-tree-alone.json)
  run_python("import litfog.pictures\nprint(litfog.pictures.scenes())")
  if(NOT output MATCHES "'of-this-tree-alone'" OR NOT EXISTS ${folder}/litfog/pictures.pyi)
    message(FATAL_ERROR "${output}")
  endif()
endif()
