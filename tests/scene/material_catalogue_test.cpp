// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/material_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reference/srgb.h"

namespace litfog::test {
using namespace scene;

namespace {

double linear(std::uint8_t srgb) { return linear_from_srgb(srgb / 255.0); }

double mean_luminance(const Material& material) {
  double sum = 0.0;
  for (std::size_t i = 0; i < material.albedo->rgba.size(); i += 4) {
    sum += 0.2126 * linear(material.albedo->rgba[i]) + 0.7152 * linear(material.albedo->rgba[i + 1]) +
           0.0722 * linear(material.albedo->rgba[i + 2]);
  }
  return sum / (double(material.albedo->width) * material.albedo->height);
}

/// Mean difference of bytes between two neighbouring rows (or columns) of a picture of four channels.
double mean_jump(const std::vector<std::uint8_t>& picture, int size, int line, bool rows) {
  const int next = (line + 1) % size;
  double sum = 0.0;
  for (int i = 0; i < size; ++i) {
    for (int channel = 0; channel < 4; ++channel) {
      const auto at = [&](int k) {
        const int texel = rows ? k * size + i : i * size + k;
        return int(picture[std::size_t(4 * texel + channel)]);
      };
      sum += std::abs(at(line) - at(next));
    }
  }
  return sum / (4.0 * size);
}

/// The jump across the border, and the largest and the mean jump inside.
struct Jumps {
  double border, inside_mean, inside_most;
};
Jumps jumps(const std::vector<std::uint8_t>& picture, int size, bool rows) {
  Jumps found{mean_jump(picture, size, size - 1, rows), 0.0, 0.0};
  for (int line = 0; line + 1 < size; ++line) {
    const double jump = mean_jump(picture, size, line, rows);
    found.inside_mean += jump / (size - 1);
    found.inside_most = std::max(found.inside_most, jump);
  }
  return found;
}

class EveryMaterial : public testing::TestWithParam<std::string> {};

TEST_P(EveryMaterial, PicturesAreSquareAndValuesAreInRange) {
  const Material material = make_material(GetParam());
  EXPECT_EQ(material.name, GetParam());
  EXPECT_GE(material.albedo->width, 16);
  EXPECT_EQ(material.albedo->width & (material.albedo->width - 1), 0);
  EXPECT_EQ(material.albedo->height, material.albedo->width);
  EXPECT_EQ(material.normal->width, material.albedo->width);
  EXPECT_EQ(material.normal->height, material.albedo->width);
  EXPECT_GT(material.size_m, 0.0f);
  const auto texels = std::size_t(material.albedo->width) * std::size_t(material.albedo->height);
  EXPECT_EQ(material.albedo->rgba.size(), 4 * texels);
  EXPECT_EQ(material.normal->rgba.size(), 4 * texels);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(material.specular[i], 0.0f);
    EXPECT_LE(material.specular[i], 1.0f);
    EXPECT_GE(material.emissive[i], 0.0f);
  }
  EXPECT_GE(material.shininess, 1.0f);
}

TEST_P(EveryMaterial, NormalsAreUnitVectorsThatPointOut) {
  const Material material = make_material(GetParam());
  double worst = 0.0;
  for (std::size_t i = 0; i < material.normal->rgba.size(); i += 4) {
    const double x = material.normal->rgba[i] / 127.5 - 256.0 / 255.0;
    const double y = material.normal->rgba[i + 1] / 127.5 - 256.0 / 255.0;
    const double z = material.normal->rgba[i + 2] / 127.5 - 256.0 / 255.0;
    worst = std::max(worst, std::abs(std::sqrt(x * x + y * y + z * z) - 1.0));
    ASSERT_GT(z, 0.0);
  }
  // Half a level in each of three channels is sqrt(3) / 255 = 0.0068.
  EXPECT_LE(worst, 0.0069);
}

TEST(MaterialCatalogue, SmoothPaintIsFlat) {
  const Material material = make_material("sign_white");
  for (std::size_t i = 0; i < material.normal->rgba.size(); i += 4) {
    ASSERT_EQ(material.normal->rgba[i], 128);
    ASSERT_EQ(material.normal->rgba[i + 1], 128);
    ASSERT_EQ(material.normal->rgba[i + 3], 0);
  }
}

TEST(MaterialCatalogue, BricksStandOutOfTheirJointsByTheirRelief) {
  const Material material = make_material("brick");
  EXPECT_GT(material.relief_m, 0.002f);
  EXPECT_LT(material.relief_m, 0.03f);
  std::array<int, 2> extremes{255, 0};
  for (std::size_t i = 3; i < material.normal->rgba.size(); i += 4) {
    extremes = {std::min<int>(extremes[0], material.normal->rgba[i]),
                std::max<int>(extremes[1], material.normal->rgba[i])};
  }
  EXPECT_EQ(extremes, (std::array{0, 254})) << "255 is glTF's";
  EXPECT_EQ(make_material("sign_white").relief_m, 0);
}

TEST_P(EveryMaterial, PicturesTile) {
  const Material material = make_material(GetParam());
  for (const bool rows : {false, true}) {
    for (const auto& picture : {material.albedo, material.normal}) {
      const Jumps found = jumps(picture->rgba, picture->width, rows);
      // A border may fall on a joint (of slabs, planks, sheets), which is also found inside: then that is the measure.
      EXPECT_LE(found.border, std::max(1.5 * found.inside_mean, 1.05 * found.inside_most) + 0.05)
          << (rows ? "rows " : "columns ") << (picture == material.albedo ? "of the albedo" : "of the normals");
    }
  }
}

TEST_P(EveryMaterial, PicturesAreTheSameTwice) {
  const Material first = make_material(GetParam());
  const Material second = make_material(GetParam());
  EXPECT_EQ(first.albedo->rgba, second.albedo->rgba);
  EXPECT_EQ(first.normal->rgba, second.normal->rgba);
}

std::vector<std::string> names() { return {material_names().begin(), material_names().end()}; }

INSTANTIATE_TEST_SUITE_P(MaterialCatalogue, EveryMaterial, testing::ValuesIn(names()),
                         [](const auto& tested) { return tested.param; });

TEST(MaterialCatalogue, NamesAreSorted) {
  EXPECT_TRUE(std::is_sorted(material_names().begin(), material_names().end()));
}

TEST(MaterialCatalogue, SceneGetsEachMaterialThatItNamesAndLacksOnce) {
  Material wood{};
  wood.name = "wood";
  wood.size_m = 7;
  Scene scene;
  scene.materials.push_back(wood);
  scene.models.push_back({Part{"wood", {}}, Part{"sign_red", {}}});
  scene.models.push_back({Part{"sign_red", {}}, Part{"glass", {}}});
  add_materials(scene);
  std::vector<std::string> added;
  for (const Material& material : scene.materials) added.push_back(material.name);
  EXPECT_EQ(added, (std::vector<std::string>{"wood", "glass", "sign_red"}));
  EXPECT_EQ(scene.materials[0].size_m, 7);
  EXPECT_EQ(scene.materials[1].albedo->rgba, make_material("glass").albedo->rgba);
}

TEST(MaterialCatalogue, UnknownNameIsAnError) {
  EXPECT_THROW(make_material("no_such_material"), std::invalid_argument);
}

/// Luminance (linear) that looks right for each surface, by eye.
TEST(MaterialCatalogue, MeanAlbedosAreInTheirRanges) {
  const std::map<std::string, std::pair<double, double>> ranges{
      {"asphalt", {0.09, 0.14}},        {"runway", {0.09, 0.14}},      {"road_paint", {0.58, 0.68}},
      {"grass", {0.09, 0.20}},          {"gravel", {0.18, 0.30}},      {"concrete", {0.30, 0.40}},
      {"concrete_slabs", {0.30, 0.40}}, {"brick", {0.15, 0.25}},       {"plaster", {0.50, 0.60}},
      {"vault_plaster", {0.50, 0.65}},  {"wood_floor", {0.12, 0.25}},  {"wood", {0.12, 0.25}},
      {"roof_tiles", {0.08, 0.20}},     {"stone", {0.20, 0.35}},       {"galvanised", {0.40, 0.50}},
      {"bark", {0.06, 0.12}},           {"needles", {0.06, 0.10}},     {"leaves", {0.08, 0.15}},
      {"glass", {0.01, 0.04}},          {"rubber", {0.02, 0.05}},      {"paint_white", {0.60, 0.70}},
      {"paint_grey", {0.10, 0.20}},     {"paint_black", {0.02, 0.04}}, {"sign_white", {0.70, 0.80}},
      {"corrugated", {0.25, 0.40}}};
  for (const auto& [name, range] : ranges) {
    const double mean = mean_luminance(make_material(name));
    EXPECT_GE(mean, range.first) << name;
    EXPECT_LE(mean, range.second) << name;
  }
}

TEST(MaterialCatalogue, OnlyLampsAndLitWindowsShine) {
  for (const std::string_view name : material_names()) {
    const bool should = name.starts_with("lamp_") || name == "window_lit" || name == "window_dim";
    const glm::vec3 emissive = make_material(name).emissive;
    EXPECT_EQ(emissive.r + emissive.g + emissive.b > 0.0f, should) << name;
  }
}

}  // namespace
}  // namespace litfog::test
