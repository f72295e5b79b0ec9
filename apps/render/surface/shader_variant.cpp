// SPDX-License-Identifier: Apache-2.0
#include "render/surface/shader_variant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

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
  // Few numbers, because a driver may take a second to compile a shader, and a frame has many numbers of lights.
  constexpr std::array<std::size_t, 11> kCounts{0, 1, 2, 3, 4, 5, 6, 8, 10, 12, kMaxUniformLights};
  return *std::ranges::lower_bound(kCounts, lights);
}

UniformLights compiled_for(std::span<const PackedLight> lights) {
  constexpr std::size_t kMaxOfKnownProfile = 2;  // of more lights, a shader for each profile would be too many
  UniformLights compiled{.count = compiled_light_count(lights.size())};
  if (lights.empty() || compiled.count > kMaxOfKnownProfile) return compiled;
  const float profile = lights.front().instance.axis_profile.w;
  const auto has_profile = [profile](const PackedLight& light) { return light.instance.axis_profile.w == profile; };
  if (std::ranges::all_of(lights, has_profile)) compiled.profile = int(profile);
  return compiled;
}

std::string pass_constants(const ShaderVariant& variant) {
  const UniformLights& fog_lights = variant.fog_lights;
  std::vector<int> profiles(fog_lights.count, fog_lights.profile);
  profiles.insert(profiles.end(), variant.lights.count, variant.lights.profile);
  const std::size_t first_light = variant.shares_lights ? 0 : fog_lights.count;
  const std::size_t lights_in_pass = profiles.size() - first_light;
  if (profiles.empty()) profiles.push_back(UniformLights::kAnyProfile);  // arrays may not be empty
  return fmt::format(
      "{}"
      "const int uniform_light_count = {};\n"
      "const int profiles[uniform_light_count] = int[]({});\n"
      "const int vertex_light_count = {};\n"
      "const int any_profile = {};\n"
      "const int first_light_in_pass = {};\n"
      "const int lights_in_pass = {};\n"
      "const int batch_size = max(lights_in_pass, 1);\n"
      "const bool has_listed_lights = {};  // too many for uniforms\n"
      "const bool has_listed_fog_lights = {};\n"
      "const bool is_first_pass = {};\n"
      "#define EACH_LIGHT(DO){}\n"
      "#define EACH_FOG_LIGHT(DO){}\n",
      variant.takes_constants_from_vertices ? "#define VERTICES_PASS_CONSTANTS\n" : "", profiles.size(),
      fmt::join(profiles, ", "), variant.vertex_lights, UniformLights::kAnyProfile, first_light, lights_in_pass,
      variant.has_listed_lights, variant.has_listed_fog_lights, variant.is_first, unrolled(lights_in_pass),
      unrolled(fog_lights.count));
}

std::string material_constants(const MaterialFeatures& material) {
  std::string text;
  if (material.is_flat) text += "#define MATERIAL_FLAT\n";
  if (material.is_masked) text += "#define MATERIAL_MASK\n";
  if (material.is_pane) text += "#define MATERIAL_PANE\n";
  if (material.is_unlit) text += "#define MATERIAL_UNLIT\n";
  if (material.has_emission_map) text += "#define MATERIAL_EMISSION_MAP\n";
  if (material.has_second_texture) text += "#define MATERIAL_SECOND_TEXTURE\n";
  if (material.has_details) text += "#define VERTEX_DETAILS\n";
  return text;
}

}  // namespace litfog::render
