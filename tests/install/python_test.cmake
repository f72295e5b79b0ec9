# SPDX-License-Identifier: Apache-2.0
# The Python package of the install tree PREFIX, which was moved, finds its libraries, and its types lie beside it. With
# PICTURES it also finds its scenes: one that is in no other tree. Where the libraries are not SHARED, so does the package
# that `pip install .` builds in BUILD_DIR and installs into a virtual environment.
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
if(NOT SHARED)
  set(environment ${WORK_DIR}/environment)
  file(REMOVE_RECURSE ${WORK_DIR})
  file(MAKE_DIRECTORY ${WORK_DIR})
  execute_process(COMMAND ${PYTHON} -m venv --system-site-packages ${environment} COMMAND_ERROR_IS_FATAL ANY)
  set(PYTHON ${environment}/bin/python)
  execute_process(COMMAND ${PYTHON} -m pip install --quiet --no-index --no-deps --no-build-isolation
                          --config-settings build=${BUILD_DIR} ${SOURCE_DIR} COMMAND_ERROR_IS_FATAL ANY)
  set(folder "")
  run_python("import litfog\nprint(litfog.data_dir, litfog.read_light('headlight').name)")
  if(NOT output MATCHES "^${environment}/share/litfog headlight")
    message(FATAL_ERROR "${output}")
  endif()
endif()
