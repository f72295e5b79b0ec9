# SPDX-License-Identifier: Apache-2.0
# litfog_add_component(<target> [NEEDS <component>...] [PACKAGES <package>...] [MODULES <module>...] [LINKS <text>...]
#                      [MAP <file>])
# What makes a library of this tree a component of litfog: its alias, how it is shared, installed and found. litfog is
# the core; litfog_<name> is litfog::<name>, the component <name>.
#
# NEEDS     other components than the core that come with it
# PACKAGES  targets of CMake packages that it takes privately, by which the packages are named: Ceres::ceres
# MODULES   the same by pkg-config
# LINKS     PACKAGES in its .pc file: modules, or -l flags where a package has none
# MAP       which names it shows if shared; litfog.map, the names of C++, where it is not given
function(litfog_add_component target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MAP" "NEEDS;PACKAGES;MODULES;LINKS")
  string(REGEX REPLACE "^litfog_" "" component ${target})
  add_library(litfog::${component} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component} VERSION ${PROJECT_VERSION}
                                             SOVERSION ${litfog_abi} INSTALL_RPATH $ORIGIN DEFINE_SYMBOL "")
  # Position-independent though static, for litfog::c and bindings, which are shared libraries. Nobody replaces a
  # function of a library alone: calls within it may be inlined.
  if(NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    set(map ${PROJECT_SOURCE_DIR}/src/packaging/litfog.map)
    if(arg_MAP)
      set(map ${PROJECT_SOURCE_DIR}/src/${arg_MAP})
    endif()
    target_link_options(${target} PRIVATE LINKER:--version-script=${map} LINKER:--as-needed)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${map})
    # A shared library brings what it takes privately.
    set(arg_PACKAGES "")
    set(arg_MODULES "")
    set(arg_LINKS "")
  endif()
  if(NOT LITFOG_INSTALL)
    return()
  endif()

  install(TARGETS ${target} EXPORT ${target}_targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev)
  install(EXPORT ${target}_targets NAMESPACE litfog:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/litfog COMPONENT dev)
  set_property(GLOBAL APPEND_STRING PROPERTY litfog_components
               "litfog_component(${component} NEEDS ${arg_NEEDS} PACKAGES ${arg_PACKAGES} MODULES ${arg_MODULES})\n")

  # litfog.pc, litfog-<component>.pc: their paths are seen from the file, so that an install tree may be moved.
  string(REPLACE "_" "-" module ${target})
  set(requires ${arg_MODULES})
  if(NOT component STREQUAL "litfog")
    list(APPEND requires "litfog = ${PROJECT_VERSION}")
  endif()
  foreach(needed IN LISTS arg_NEEDS)
    list(APPEND requires "litfog-${needed} = ${PROJECT_VERSION}")
  endforeach()
  set(libraries -l${target})
  foreach(link IN LISTS arg_LINKS)
    if(link MATCHES "^-l")
      list(APPEND libraries ${link})
    else()
      list(APPEND requires ${link})
    endif()
  endforeach()
  list(JOIN requires ", " requires)
  list(JOIN libraries " " libraries)
  file(RELATIVE_PATH include_dir ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  configure_file(${PROJECT_SOURCE_DIR}/src/packaging/litfog.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${module}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${module}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()
