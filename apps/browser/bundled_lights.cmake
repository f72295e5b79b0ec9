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
            "attenuation quadratic" "cone profile" "cone half_angle_deg" "cone exponent" "cone inner_deg"
            "cone outer_deg")
      string(REPLACE " " ";" keys ${member})
      string(REPLACE " " "_" variable ${member})
      string(JSON ${variable} ERROR_VARIABLE error GET ${json} ${keys})  # a cone has the members of its profile
    endforeach()
    if(cone_profile STREQUAL "cosine")
      set(cone "Cone::cosine(glm::radians(${cone_half_angle_deg} * 1.0), ${cone_exponent})")
    else()
      set(cone "Cone::smoothstep(glm::radians(${cone_inner_deg} * 1.0), glm::radians(${cone_outer_deg} * 1.0))")
    endif()
    string(APPEND entries "  if (file == \"${file}\") {\n"
                          "    return {.name = \"${name}\",\n"
                          "            .color = {${color_0}, ${color_1}, ${color_2}},\n"
                          "            .attenuation = {${attenuation_constant}, ${attenuation_linear}, "
                          "${attenuation_quadratic}},\n"
                          "            .threshold = ${threshold},\n"
                          "            .cone = ${cone}};\n"
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
