# SPDX-License-Identifier: Apache-2.0
# The commands of the install tree PREFIX, which was moved, find their libraries and their data: a spec that is in no
# other tree. Writes into WORK_DIR.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY ${WORK_DIR})
file(COPY_FILE ${PREFIX}/share/litfog/specs/aerobeacon.json ${PREFIX}/share/litfog/specs/of-this-tree-alone.json)
execute_process(COMMAND ${PREFIX}/bin/litfog-fit of-this-tree-alone -o ${WORK_DIR}/lamp.json OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PREFIX}/bin/litfog-solve --light ${WORK_DIR}/lamp.json --visibility 400 OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${WORK_DIR})
