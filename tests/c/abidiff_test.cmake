# SPDX-License-Identifier: Apache-2.0
# Compares LIBRARY, liblitfog_c with debug information, with DUMP, the ABI that this minor version keeps: nothing may
# differ but functions that were added. After a change of the minor version, and on x86-64, the dump is
#
#     abidw --headers-dir include --drop-private-types --exported-interfaces-only --no-corpus-path --no-show-locs
#           --no-comp-dir-path --no-elf-needed --no-parameter-names build/tests/c/liblitfog_c_shared.so
#
# ABIDIFF is libabigail's abidiff (Debian's abigail-tools).
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${ABIDIFF} --no-added-syms ${DUMP} ${LIBRARY} RESULT_VARIABLE status OUTPUT_VARIABLE output
                ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "abidiff ended with ${status}:\n${output}")
endif()
