// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/hash_random.h"
#include "scene/paint/painter.h"

namespace litfog::scene {
namespace {

/// 1 within `reach` of the edge of a cell, falling to 0 over `soft` texels.
float joint(float to_edge, float reach, float soft) { return std::clamp((reach + soft - to_edge) / soft, 0.0f, 1.0f); }

/// Boards along v: `across` of them a tile, each cut into lengths, with grain, knots and gaps.
struct Boards {
  int across;
  int lengths;
  float gap;  ///< texels
  float contrast;
  float relief_m;
};

void paint_boards(Canvas& canvas, const Boards& boards, const glm::vec3& pale, const glm::vec3& dark,
                  std::uint32_t seed) {
  const int size = canvas.size;
  const int width = size / boards.across;
  Field grain(size);
  add_noise(grain, 64, 2, 0.6f, seed);
  add_noise(grain, 128, 4, 0.5f, seed + 1);
  add_noise(grain, 256 <= size / 2 ? 256 : size / 2, 8, 0.4f, seed + 2);
  const Field stain = make_octaves(size, 4, 4, seed + 3, 0.6f);
  Field rings(size);
  add_noise(rings, 16, 2, 1.0f, seed + 4);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const int board = x / width;
      const std::uint32_t key = hash(std::uint32_t(board), 0, seed);
      // Each board starts elsewhere, so that the cross joints are broken.
      const int length = size / boards.lengths;
      const int shifted = (y + int(key % std::uint32_t(length))) & (size - 1);
      const int piece = shifted / length;
      const std::uint32_t tint = hash(std::uint32_t(board), std::uint32_t(piece), seed + 5);
      const float tone = 0.85f + 0.3f * unit_float(tint);
      const float to_side = float(std::min(x % width, width - 1 - x % width));
      const float to_end = float(std::min(shifted % length, length - 1 - shifted % length));
      const float gap =
          boards.lengths > 1 ? joint(std::min(to_side, to_end), boards.gap, 1.0f) : joint(to_side, boards.gap, 1.0f);
      const std::size_t texel = canvas.height.texel(x, y);
      // Rings: contours of a drawn-out noise, shifted from board to board.
      const std::size_t elsewhere = canvas.height.texel(x, y + int(tint & 1023u));
      const float ring = 0.5f + 0.5f * std::sin(glm::two_pi<float>() * (4.0f * rings[elsewhere] + unit_float(tint)));
      const float shade =
          std::clamp(0.35f + boards.contrast * (0.5f * grain[elsewhere] + 0.35f * ring - 0.1f), 0.0f, 1.0f);
      canvas.color[texel] = glm::mix(pale, dark, shade) * tone * (1.0f - 0.78f * gap) * (1.0f + 0.2f * stain[texel]);
      canvas.height[texel] = boards.relief_m * (0.25f * grain[elsewhere] - 0.15f * ring - 1.6f * gap + 0.4f * tone);
      canvas.gloss[texel] = (0.65f - 0.3f * shade + 0.25f * stain[texel]) * (1.0f - 0.8f * gap);
    }
  }
}

}  // namespace

void paint_concrete(Canvas& canvas) {
  const Field cloud = make_octaves(canvas.size, 2, 5, 101, 0.6f);
  const Field fine = make_octaves(canvas.size, 32, 4, 102, 0.8f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 103);
  for (std::size_t i = 0; i < cloud.texels(); ++i) {
    canvas.color[i] = glm::vec3(1.0f, 0.985f, 0.95f) * (1.0f + 0.16f * cloud[i] + 0.1f * fine[i] + 0.06f * grain[i]);
    canvas.height[i] = 0.0015f * fine[i];
    canvas.gloss[i] = 0.4f + 0.3f * cloud[i];
  }
}

void paint_brick(Canvas& canvas) {
  // Running bond: 8 bricks of 24 x 7 cm and joints of 1 cm across, 24 courses up, on a tile of 2 m.
  const int size = canvas.size;
  const Field rough = make_octaves(size, 32, 4, 111, 0.75f);
  const Field soot = make_octaves(size, 2, 4, 112, 0.6f);
  const float brick_width = float(size) / 8.0f;
  const float course_height = float(size) / 24.0f;
  for (int y = 0; y < size; ++y) {
    const auto course = int(float(y) / course_height);
    const float up = float(y) - float(course) * course_height;
    for (int x = 0; x < size; ++x) {
      const std::size_t texel = canvas.height.texel(x, y);
      const float along = float(x) + (course % 2 == 0 ? 0.0f : 0.5f * brick_width);
      const auto column = int(along / brick_width);
      const float across = along - float(column) * brick_width;
      const float wobble = 0.8f * rough[texel];
      const float to_edge = std::min(std::min(across, brick_width - across), std::min(up, course_height - up)) + wobble;
      const float mortar = joint(to_edge, 1.2f, 1.2f);
      const std::uint32_t key = hash(std::uint32_t(column % 8), std::uint32_t(course), 113);
      const float fired = unit_float(key);
      const glm::vec3 clay = glm::mix(glm::vec3(0.36f, 0.145f, 0.085f), glm::vec3(0.22f, 0.09f, 0.07f), fired * fired) *
                             (0.85f + 0.3f * unit_float(hash(key)));
      const glm::vec3 brick = clay * (1.0f + 0.35f * rough[texel]);
      const glm::vec3 lime = glm::vec3(0.36f, 0.34f, 0.30f) * (1.0f + 0.3f * rough[texel]);
      canvas.color[texel] = glm::mix(brick, lime, mortar) * (1.0f + 0.25f * soot[texel]);
      canvas.height[texel] =
          -0.007f * mortar + 0.0025f * rough[texel] * (1.0f - mortar) + 0.003f * fired * (1.0f - mortar);
      canvas.gloss[texel] = 0.4f * (1.0f - mortar) + 0.1f;
    }
  }
}

void paint_plaster(Canvas& canvas) {
  const Field trowel = make_octaves(canvas.size, 8, 5, 121, 0.55f);
  Field runs(canvas.size);
  add_noise(runs, 32, 2, 0.5f, 122);
  add_octaves(runs, 2, 4, 0.8f, 123, 0.6f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 124);
  for (std::size_t i = 0; i < trowel.texels(); ++i) {
    const float stain = std::clamp(0.2f + 0.8f * runs[i], 0.0f, 1.0f);
    canvas.color[i] = glm::mix(glm::vec3(1.0f, 0.97f, 0.90f), glm::vec3(0.80f, 0.74f, 0.63f), stain) *
                      (1.0f + 0.07f * trowel[i] + 0.03f * grain[i]);
    canvas.height[i] = 0.004f * trowel[i] + 0.0002f * grain[i];
    canvas.gloss[i] = 0.3f + 0.2f * trowel[i];
  }
}

void paint_wood_floor(Canvas& canvas) {
  paint_boards(canvas, {16, 2, 0.6f, 1.0f, 0.0016f}, {0.42f, 0.25f, 0.12f}, {0.22f, 0.11f, 0.045f}, 131);
}

void paint_wood(Canvas& canvas) {
  paint_boards(canvas, {8, 1, 0.8f, 1.2f, 0.003f}, {0.33f, 0.27f, 0.20f}, {0.16f, 0.12f, 0.085f}, 136);
}

void paint_stone(Canvas& canvas) {
  const Field veins = make_octaves(canvas.size, 4, 6, 141, 0.6f);
  const Field rough = make_octaves(canvas.size, 16, 5, 142, 0.75f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 143);
  for (std::size_t i = 0; i < veins.texels(); ++i) {
    canvas.color[i] = glm::mix(glm::vec3(1.0f, 0.97f, 0.9f), glm::vec3(0.8f, 0.82f, 0.84f), 0.5f + 0.7f * veins[i]) *
                      (1.0f + 0.25f * rough[i] + 0.08f * grain[i]);
    canvas.height[i] = 0.006f * rough[i] + 0.004f * veins[i];
    canvas.gloss[i] = 0.35f + 0.3f * rough[i];
  }
}

void paint_roof_tiles(Canvas& canvas) {
  // Pantiles: 8 a row, 8 rows; each tile's foot lies on the next row down the roof (towards smaller v).
  const int size = canvas.size;
  const Field weather = make_octaves(size, 4, 5, 151, 0.65f);
  Field grain(size);
  add_grain(grain, 1.0f, 152);
  const int cell = size / 8;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const std::size_t texel = canvas.height.texel(x, y);
      const float u = float(x % cell) / float(cell);
      const float v = float(y % cell) / float(cell);
      const float wave = std::sin(glm::two_pi<float>() * u);
      const float foot = joint(float(y % cell), 1.0f, 2.0f);
      const float seam = joint(float(std::min(x % cell, cell - 1 - x % cell)), 0.5f, 1.5f);
      const std::uint32_t key = hash(std::uint32_t(x / cell), std::uint32_t(y / cell), 153);
      const float moss = std::clamp(2.2f * weather[texel] - 0.5f + 0.4f * v, 0.0f, 1.0f);
      const glm::vec3 clay = glm::vec3(0.30f, 0.115f, 0.07f) * (0.75f + 0.5f * unit_float(key));
      canvas.color[texel] = glm::mix(clay, glm::vec3(0.10f, 0.11f, 0.07f), 0.6f * moss) *
                            (1.0f + 0.12f * grain[texel]) * (1.0f - 0.6f * foot) * (1.0f - 0.35f * seam);
      canvas.height[texel] = 0.028f * wave - 0.03f * v - 0.02f * foot + 0.004f * weather[texel];
      canvas.gloss[texel] = 0.45f * (1.0f - moss) * (1.0f - foot);
    }
  }
}

void paint_corrugated(Canvas& canvas) {
  // Sheets with waves along v, 16 a tile, and rust that runs from the laps.
  const int size = canvas.size;
  const Field weather = make_octaves(size, 4, 5, 161, 0.65f);
  Field runs(size);
  add_noise(runs, 64, 2, 0.9f, 162);
  for (int y = 0; y < size; ++y) {
    const float lap = joint(float(std::min(y, size - y)), 1.0f, 2.0f);
    for (int x = 0; x < size; ++x) {
      const std::size_t texel = canvas.height.texel(x, y);
      const float wave = std::sin(glm::two_pi<float>() * 16.0f * float(x) / float(size));
      const float down = 1.0f - float(y) / float(size);
      const float rust = std::clamp(1.2f * weather[texel] + 0.9f * runs[texel] * down - 0.35f, 0.0f, 1.0f);
      canvas.color[texel] = glm::mix(glm::vec3(0.40f, 0.42f, 0.43f), glm::vec3(0.22f, 0.11f, 0.06f), rust) *
                            (1.0f + 0.08f * wave) * (1.0f - 0.4f * lap);
      canvas.height[texel] = 0.016f * wave - 0.004f * lap;
      canvas.gloss[texel] = 0.7f * (1.0f - rust);
    }
  }
}

}  // namespace litfog::scene
