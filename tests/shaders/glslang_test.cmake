# SPDX-License-Identifier: Apache-2.0
# Compiles every shader under INCLUDE_DIR/litfog/shaders by glslangValidator as a stranger's renderer would: each alone,
# all together in both orders, and with every macro defined that a host may define; for each GLSL that litfog promises.
# Writes into WORK_DIR.
cmake_minimum_required(VERSION 3.25)
find_program(glslang glslangValidator REQUIRED)  # Debian: glslang-tools

file(GLOB shaders RELATIVE ${INCLUDE_DIR} ${INCLUDE_DIR}/litfog/shaders/*.glsl)
list(LENGTH shaders count)
if(count LESS 7)
  message(FATAL_ERROR "only ${count} shaders in ${INCLUDE_DIR}/litfog/shaders")
endif()
set(reversed ${shaders})
list(REVERSE reversed)
file(MAKE_DIRECTORY ${WORK_DIR})

# compile(<version> <stage> <defines> <shader>... [USE <text>]): main() outputs what litfog_test() returns
function(compile version stage defines)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "USE" "")
  set(text "#version ${version}\n#extension GL_GOOGLE_include_directive : require\n${defines}")
  foreach(shader IN LISTS arg_UNPARSED_ARGUMENTS)
    string(APPEND text "#include \"${shader}\"\n")
  endforeach()
  if(arg_USE)
    string(APPEND text "${arg_USE}")
  else()
    string(APPEND text "vec4 litfog_test() { return vec4(1.0); }\n")
  endif()
  if(stage STREQUAL "frag")
    string(APPEND text "layout(location = 0) out vec4 color;\nvoid main() { color = litfog_test(); }\n")
  else()
    string(APPEND text "void main() { gl_Position = litfog_test(); }\n")
  endif()
  set(mode -l)  # link: without it glslang includes no files
  if(version EQUAL 450)
    set(mode -V -H --spirv-val -o ${WORK_DIR}/shader.spv)
  endif()
  file(WRITE ${WORK_DIR}/shader.${stage} "${text}")
  execute_process(COMMAND ${glslang} ${mode} -I${INCLUDE_DIR} ${WORK_DIR}/shader.${stage}
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "GLSL ${version}, ${stage}:\n${text}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(use_all "
vec4 litfog_test() {
  LitfogSurface surface = LitfogSurface(vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0), vec3(0.5),
                                        vec3(0.5), vec3(0.5), 8.0);
  LitfogAirlight air = litfog_light_airlight_ray(litfog_block_light(0), vec3(0.0), vec3(0.0, 0.0, 1.0), 9.0);
  vec3 lit = litfog_ambient(surface, vec3(0.25)) +
             litfog_light_surface(surface, litfog_block_light(LITFOG_MAX_LIGHTS - 1)) +
             litfog_light_surface(surface, litfog_buffered_light(1000)) + litfog_buffered_position_extent(0).xyz +
             litfog_multiple_scattering(air, 0.0) * vec3(0.5) + litfog_layered_scattering(air, 0.0, 0.0, 0.5) * vec3(0.5);
  LitfogLightList lights = litfog_lights_at(vec2(0.5), 9.0);
  LitfogLightList along = litfog_lights_along(vec2(0.5), 9.0);
  lit += litfog_light_surface(surface, litfog_buffered_light(litfog_listed_light(lights, along.count)));
  lit += litfog_listed_surface_light(lights, surface.position, surface.normal) +
         litfog_listed_airlight(along, vec3(0.0), vec3(0.0, 0.0, 1.0), 9.0);
  vec4 layers[litfog_far_slabs];
  litfog_sum_far_airlight(0, 9, vec3(0.0), vec3(0.0, 0.0, 1.0), 9.0, layers);
  lit += layers[7].rgb + litfog_far_airlight(vec2(0.5), vec3(0.0), vec3(0.0, 0.0, 1.0), 9.0);
  return vec4(litfog_apply_fog(lit, surface.position, vec3(1.0)), 1.0);
}
")
set(defines "#define LITFOG_COOKIES\n#define LITFOG_FOG_LIGHTS\n#define LITFOG_LIGHT_TEXTURE\n#define LITFOG_SET 6\n"
            "#define LITFOG_BLOCK_BINDING 7\n#define LITFOG_KIND_BINDING 9\n#define LITFOG_INSTANCE_BINDING 11\n"
            "#define LITFOG_SCATTERING_BINDING 13\n#define LITFOG_CLUSTER_BINDING 15\n"
            "#define LITFOG_FAR_AIRLIGHT_BINDING 17\n")
string(CONCAT defines ${defines})
set(use_doors "${use_all}
vec4 litfog_cookie_cone(float cookie) { return vec4(cookie, 0.0, 1.0, 0.0); }
float litfog_cookie(LitfogLight light, vec3 direction) { return light.cone.x * direction.x; }
vec3 litfog_lights_fog(vec3 position) { return litfog_light_fog(litfog_buffered_light(3), position); }
")

# The host's set and bindings, in the SPIR-V of the last
function(expect_places)
  foreach(place "DescriptorSet 6" "Binding 7" "Binding 9" "Binding 11" "Binding 13" "Binding 15" "Binding 17")
    if(NOT output MATCHES "${place}\n")
      message(SEND_ERROR "no ${place} in\n${output}")
    endif()
  endforeach()
endfunction()

foreach(version "330 core" "300 es" "320 es" 450)
  foreach(stage vert frag)
    foreach(shader IN LISTS shaders)
      compile("${version}" ${stage} "" ${shader})
    endforeach()
    compile("${version}" ${stage} "" ${shaders} USE "${use_all}")
    compile("${version}" ${stage} "" ${reversed} USE "${use_all}")
    compile("${version}" ${stage} "${defines}" ${shaders} USE "${use_doors}")
  endforeach()
endforeach()
expect_places()

foreach(version "430 core" "310 es" 450)
  foreach(stage vert frag)
    compile("${version}" ${stage} "#define LITFOG_LIGHT_STORAGE\n" ${shaders} USE "${use_all}")
    compile("${version}" ${stage} "#define LITFOG_LIGHT_STORAGE\n${defines}" ${reversed} USE "${use_doors}")
  endforeach()
endforeach()
expect_places()
