# SPDX-License-Identifier: Apache-2.0
# litfog_add_bundled_lights(<target> <file>...)
# Gives a target the header bundled_lights.h, in which litfog::browser::bundled_light("x") is the light of
# data/lights/x.json: a page has no files to read.
function(litfog_add_bundled_lights target)
  set(entries "")
  foreach(file IN LISTS ARGN)
    set(path ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../data/lights/${file}.json)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    file(READ ${path} json)
    foreach(member name threshold "color 0" "color 1" "color 2" "attenuation constant" "attenuation linear"
            "attenuation quadratic" "cone profile")
      string(REPLACE " " ";" keys ${member})
      string(REPLACE " " "_" variable ${member})
      string(JSON ${variable} GET ${json} ${keys})
    endforeach()
    set(cone ".profile = ConeProfile::${cone_profile}")
    string(JSON count LENGTH ${json} cone)
    foreach(i RANGE 1 ${count})
      math(EXPR i "${i} - 1")
      string(JSON member MEMBER ${json} cone ${i})
      string(JSON value GET ${json} cone ${member})
      if(member MATCHES "(.*)_deg$")
        string(APPEND cone ", .${CMAKE_MATCH_1} = glm::radians(${value} * 1.0)")
      elseif(NOT member STREQUAL "profile")
        string(APPEND cone ", .${member} = ${value}")
      endif()
    endforeach()
    string(APPEND entries "  if (file == \"${file}\") {\n"
                          "    return {.name = \"${name}\",\n"
                          "            .color = {${color_0}, ${color_1}, ${color_2}},\n"
                          "            .attenuation = {${attenuation_constant}, ${attenuation_linear}, "
                          "${attenuation_quadratic}},\n"
                          "            .threshold = ${threshold},\n"
                          "            .cone = {${cone}}};\n"
                          "  }\n")
  endforeach()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_lights)
  file(CONFIGURE OUTPUT ${folder}/bundled_lights.h @ONLY CONTENT [[
// Generated from light files.
#pragma once

#include <glm/trigonometric.hpp>
#include <stdexcept>
#include <string_view>

#include "litfog/light.h"

namespace litfog::browser {

inline Light bundled_light(std::string_view file) {
@entries@  throw std::logic_error("no such light");
}

}  // namespace litfog::browser
]])
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
