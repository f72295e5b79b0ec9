// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/material_catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "scene/paint/painter.h"

namespace litfog::scene {
namespace {

struct Recipe {
  std::string_view name;
  void (*paint)(Canvas&);
  int size;
  float size_m;
  glm::vec3 mean_albedo;  ///< linear
  glm::vec3 specular;
  float shininess;
  glm::vec3 emissive;
  float metal_roughness = 0;
};

constexpr glm::vec3 kDark(0.0f);

/// Sorted by name. All values are chosen by eye.
const Recipe kRecipes[] = {
    {"asphalt", paint_asphalt, 512, 4.0f, {0.11f, 0.11f, 0.113f}, glm::vec3(0.16f), 22.0f, kDark},
    {"bark", paint_bark, 256, 1.0f, {0.11f, 0.095f, 0.075f}, glm::vec3(0.04f), 10.0f, kDark},
    {"blades", paint_blades, 64, 0.1f, {0.095f, 0.12f, 0.045f}, glm::vec3(0.10f), 20.0f, kDark},
    {"brick", paint_brick, 512, 2.0f, {0.24f, 0.155f, 0.115f}, glm::vec3(0.06f), 12.0f, kDark},
    {"concrete", paint_concrete, 512, 4.0f, {0.35f, 0.345f, 0.33f}, glm::vec3(0.08f), 14.0f, kDark},
    {"concrete_slabs", paint_concrete_slabs, 512, 8.0f, {0.35f, 0.345f, 0.33f}, glm::vec3(0.08f), 14.0f, kDark},
    {"corrugated", paint_corrugated, 256, 1.6f, {0.32f, 0.32f, 0.31f}, glm::vec3(0.25f), 30.0f, kDark},
    {"galvanised", paint_galvanised, 256, 0.5f, {0.45f, 0.46f, 0.47f}, glm::vec3(0.45f), 45.0f, kDark, 0.3f},
    {"glass", paint_smooth, 64, 1.0f, {0.02f, 0.022f, 0.025f}, glm::vec3(0.9f), 250.0f, kDark},
    {"grass", paint_grass, 512, 2.4f, {0.09f, 0.12f, 0.042f}, glm::vec3(0.05f), 12.0f, kDark},
    {"gravel", paint_gravel, 512, 2.4f, {0.24f, 0.225f, 0.20f}, glm::vec3(0.06f), 10.0f, kDark},
    {"lamp_red", paint_prisms, 64, 0.1f, {0.30f, 0.02f, 0.015f}, glm::vec3(0.5f), 60.0f, {2.2f, 0.10f, 0.06f}},
    {"lamp_sodium", paint_prisms, 64, 0.2f, {0.70f, 0.60f, 0.45f}, glm::vec3(0.5f), 60.0f, {6.0f, 3.0f, 0.72f}},
    {"lamp_white", paint_prisms, 64, 0.2f, {0.70f, 0.70f, 0.68f}, glm::vec3(0.5f), 60.0f, {6.0f, 5.2f, 4.0f}},
    {"leaves", paint_leaves, 256, 0.8f, {0.08f, 0.115f, 0.035f}, glm::vec3(0.12f), 25.0f, kDark},
    {"needles", paint_needles, 256, 0.5f, {0.055f, 0.085f, 0.04f}, glm::vec3(0.08f), 20.0f, kDark},
    {"paint_black", paint_painted, 128, 1.0f, {0.03f, 0.03f, 0.032f}, glm::vec3(0.20f), 40.0f, kDark},
    {"paint_blue", paint_painted, 128, 1.0f, {0.045f, 0.09f, 0.20f}, glm::vec3(0.35f), 70.0f, kDark},
    {"paint_green", paint_painted, 128, 1.0f, {0.06f, 0.14f, 0.08f}, glm::vec3(0.25f), 50.0f, kDark},
    {"paint_grey", paint_painted, 128, 1.0f, {0.14f, 0.145f, 0.15f}, glm::vec3(0.22f), 45.0f, kDark},
    {"paint_red", paint_painted, 128, 1.0f, {0.30f, 0.045f, 0.035f}, glm::vec3(0.30f), 60.0f, kDark},
    {"paint_white", paint_painted, 128, 1.0f, {0.65f, 0.65f, 0.63f}, glm::vec3(0.25f), 50.0f, kDark},
    {"paint_yellow", paint_painted, 128, 1.0f, {0.55f, 0.38f, 0.05f}, glm::vec3(0.25f), 50.0f, kDark},
    {"plaster", paint_plaster, 512, 3.0f, {0.56f, 0.535f, 0.48f}, glm::vec3(0.05f), 10.0f, kDark},
    {"reflector_amber", paint_prisms, 64, 0.05f, {0.65f, 0.32f, 0.04f}, glm::vec3(0.9f), 90.0f, kDark},
    {"reflector_red", paint_prisms, 64, 0.05f, {0.45f, 0.03f, 0.025f}, glm::vec3(0.9f), 90.0f, kDark},
    {"reflector_white", paint_prisms, 64, 0.05f, {0.75f, 0.75f, 0.73f}, glm::vec3(0.9f), 90.0f, kDark},
    {"road_paint", paint_road_paint, 256, 2.0f, {0.62f, 0.62f, 0.60f}, glm::vec3(0.12f), 20.0f, kDark},
    {"roof_tiles", paint_roof_tiles, 512, 2.4f, {0.20f, 0.10f, 0.07f}, glm::vec3(0.10f), 16.0f, kDark},
    {"rubber", paint_rubber, 128, 0.5f, {0.035f, 0.035f, 0.036f}, glm::vec3(0.10f), 12.0f, kDark},
    {"runway", paint_runway, 512, 6.0f, {0.12f, 0.12f, 0.122f}, glm::vec3(0.13f), 22.0f, kDark},
    {"sign_red", paint_smooth, 64, 1.0f, {0.48f, 0.04f, 0.035f}, glm::vec3(0.30f), 60.0f, kDark},
    {"sign_white", paint_smooth, 64, 1.0f, {0.75f, 0.75f, 0.73f}, glm::vec3(0.30f), 60.0f, kDark},
    {"skin", paint_smooth, 64, 1.0f, {0.42f, 0.26f, 0.19f}, glm::vec3(0.06f), 20.0f, kDark},
    {"stone", paint_stone, 512, 2.0f, {0.28f, 0.27f, 0.25f}, glm::vec3(0.06f), 12.0f, kDark},
    {"vault_plaster", paint_plaster, 512, 4.0f, {0.62f, 0.60f, 0.55f}, glm::vec3(0.04f), 10.0f, kDark},
    {"water", paint_water, 512, 24.0f, {0.006f, 0.011f, 0.014f}, glm::vec3(0.35f), 60.0f, kDark},
    {"wet_asphalt", paint_wet_asphalt, 512, 4.0f, {0.05f, 0.05f, 0.052f}, glm::vec3(0.6f), 110.0f, kDark},
    {"window_dim", paint_smooth, 64, 1.0f, {0.10f, 0.09f, 0.07f}, glm::vec3(0.5f), 200.0f, {0.42f, 0.25f, 0.10f}},
    {"window_lit", paint_smooth, 64, 1.0f, {0.10f, 0.09f, 0.07f}, glm::vec3(0.5f), 200.0f, {1.1f, 0.72f, 0.34f}},
    {"wood", paint_wood, 512, 1.6f, {0.22f, 0.165f, 0.115f}, glm::vec3(0.08f), 16.0f, kDark},
    {"wood_floor", paint_wood_floor, 512, 2.4f, {0.25f, 0.14f, 0.07f}, glm::vec3(0.25f), 40.0f, kDark},
};

constexpr std::size_t kRecipeCount = std::size(kRecipes);

/// srgb_level_of by table, for many texels: 4096 steps stay within half a level except in the first step.
std::uint8_t srgb(float linear) {
  static const std::array<std::uint8_t, 4097> kTable = [] {
    std::array<std::uint8_t, 4097> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_level_of(float(i) / 4096.0f);
    return table;
  }();
  return kTable[std::size_t(std::clamp(linear, 0.0f, 1.0f) * 4096.0f + 0.5f)];
}

/// A component of a normal where 128 is 0: with 127.5 no flat surface would be flat.
std::uint8_t normal_byte(float component) { return level_of((128.0f + 127.5f * component) / 255.0f); }

Texels bake_albedo(const Canvas& canvas, const glm::vec3& mean_albedo) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& color : canvas.color) sum += glm::dvec3(color);
  const glm::vec3 scale = mean_albedo / glm::vec3(sum / double(canvas.color.size()));
  Texels texels{canvas.size, canvas.size, std::vector<std::uint8_t>(4 * canvas.color.size())};
  for (std::size_t i = 0; i < canvas.color.size(); ++i) {
    const glm::vec3 color = canvas.color[i] * scale;
    texels.rgba[4 * i] = srgb(color.r);
    texels.rgba[4 * i + 1] = srgb(color.g);
    texels.rgba[4 * i + 2] = srgb(color.b);
    texels.rgba[4 * i + 3] = level_of(canvas.gloss[i]);
  }
  return texels;
}

/// From the lowest to the highest point, metres.
float relief_of(const Field& height) {
  const auto [low, high] = std::ranges::minmax(height.values());
  return high - low;
}

/// Normals of the height field at its true scale, central differences of metres over metres, and the heights.
Texels bake_normals(const Canvas& canvas) {
  const float low = std::ranges::min(canvas.height.values()), relief = relief_of(canvas.height);
  const int size = canvas.size;
  const float per_texel = 0.5f / canvas.texel_m();
  Texels texels{size, size, std::vector<std::uint8_t>(4 * canvas.height.texels())};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float du = (canvas.height.at(x + 1, y) - canvas.height.at(x - 1, y)) * per_texel;
      const float dv = (canvas.height.at(x, y + 1) - canvas.height.at(x, y - 1)) * per_texel;
      const float scale = 1.0f / std::sqrt(du * du + dv * dv + 1.0f);
      std::uint8_t* const texel = &texels.rgba[4 * canvas.height.texel(x, y)];
      texel[0] = normal_byte(-du * scale);
      texel[1] = normal_byte(-dv * scale);
      texel[2] = normal_byte(scale);
      texel[3] = relief > 0 ? level_of((canvas.height.at(x, y) - low) / relief * (254.0f / 255.0f)) : std::uint8_t{0};
    }
  }
  return texels;
}

}  // namespace

std::span<const std::string_view> material_names() {
  static const std::array<std::string_view, kRecipeCount> kNames = [] {
    std::array<std::string_view, kRecipeCount> names;
    for (std::size_t i = 0; i < kRecipeCount; ++i) names[i] = kRecipes[i].name;
    return names;
  }();
  return kNames;
}

Material make_material(std::string_view name) {
  const Recipe* recipe =
      std::find_if(std::begin(kRecipes), std::end(kRecipes), [&](const Recipe& each) { return each.name == name; });
  if (recipe == std::end(kRecipes)) throw std::invalid_argument("no material " + std::string(name));
  Canvas canvas(recipe->size, recipe->size_m);
  recipe->paint(canvas);
  return {.name = std::string(name),
          .size_m = recipe->size_m,
          .albedo = std::make_shared<const Texels>(bake_albedo(canvas, recipe->mean_albedo)),
          .normal = std::make_shared<const Texels>(bake_normals(canvas)),
          .specular = recipe->specular,
          .shininess = recipe->shininess,
          .emissive = recipe->emissive,
          .relief_m = relief_of(canvas.height),
          .metal_roughness = recipe->metal_roughness};
}

}  // namespace litfog::scene
