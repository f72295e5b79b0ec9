// SPDX-License-Identifier: Apache-2.0
#include "render/surface/shader_variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace litfog::render {
namespace {

/// "DO(0) DO(1)": a loop over lights unrolled.
std::string unrolled(std::size_t count) {
  std::string calls;
  for (std::size_t i = 0; i < count; ++i) calls += fmt::format(" DO({})", i);
  return calls;
}

}  // namespace

std::size_t compiled_light_count(std::size_t lights) {
  assert(lights <= kMaxUniformLights);
  // Few counts, because a driver may take a second to compile a shader, and surfaces differ in their number of lights.
  constexpr std::array<std::size_t, 6> kCounts{0, 1, 2, 4, 8, kMaxUniformLights};
  return *std::ranges::lower_bound(kCounts, lights);
}

std::string pass_constants(const ShaderVariant& variant) {
  const std::size_t lights = variant.fog_light_count + variant.light_count;
  const std::size_t first_light = variant.shares_lights ? 0 : variant.fog_light_count;
  const std::size_t lights_in_pass = lights - first_light;
  return fmt::format(
      "const int uniform_light_count = {};  // arrays may not be empty\n"
      "const int first_light_in_pass = {};\n"
      "const int lights_in_pass = {};\n"
      "const int batch_size = max(lights_in_pass, 1);\n"
      "const bool has_listed_lights = {};  // too many for uniforms\n"
      "const bool has_listed_fog_lights = {};\n"
      "const bool is_first_pass = {};\n"
      "#define EACH_LIGHT(DO){}\n"
      "#define EACH_FOG_LIGHT(DO){}\n"
      "#define LITFOG_KNOT_COUNT {}\n",
      std::max<std::size_t>(lights, 1), first_light, lights_in_pass, variant.has_listed_lights,
      variant.has_listed_fog_lights, variant.is_first, unrolled(lights_in_pass), unrolled(variant.fog_light_count),
      variant.knot_count);
}

std::string material_constants(const MaterialFeatures& material) {
  std::string text;
  if (material.is_flat) text += "#define MATERIAL_FLAT\n";
  if (material.is_masked) text += "#define MATERIAL_MASK\n";
  if (material.is_pane) text += "#define MATERIAL_PANE\n";
  if (material.is_unlit) text += "#define MATERIAL_UNLIT\n";
  if (material.has_emission_map) text += "#define MATERIAL_EMISSION_MAP\n";
  if (material.has_second_texture) text += "#define MATERIAL_SECOND_TEXTURE\n";
  if (material.has_ambient) text += "#define MATERIAL_AMBIENT\n";
  if (material.has_details) text += "#define VERTEX_DETAILS\n";
  return text;
}

}  // namespace litfog::render
