// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "scene/hash_random.h"
#include "scene/paint/painter.h"

namespace litfog::scene {

void paint_painted(Canvas& canvas) {
  // Orange peel under gloss, dust that runs down (v), a few chips.
  const Field peel = make_octaves(canvas.size, 16, 3, 301, 0.7f);
  Field dust(canvas.size);
  add_noise(dust, 16, 1, 0.8f, 302);
  add_octaves(dust, 2, 4, 0.8f, 303);
  for (std::size_t i = 0; i < peel.texels(); ++i) {
    const float dirt = std::clamp(0.25f + 0.5f * dust[i], 0.0f, 1.0f);
    canvas.color[i] = glm::mix(glm::vec3(1.0f), glm::vec3(0.72f, 0.70f, 0.66f), dirt);
    canvas.gloss[i] = 0.95f - 0.55f * dirt;
    canvas.height[i] = 0.00025f * peel[i];
  }
}

void paint_galvanised(Canvas& canvas) {
  // Spangle: each crystal of zinc has its own grey. The crystal of the nearest seed, on a jittered lattice.
  const int cells = 16;
  const int cell = canvas.size / cells;
  const Field weather = make_octaves(canvas.size, 2, 5, 312, 0.6f);
  const auto seed_of = [&](int column, int row, int which) {
    return unit_float(
        hash(std::uint32_t(column & (cells - 1)), std::uint32_t(row & (cells - 1)), 311u + std::uint32_t(which)));
  };
  for (int y = 0; y < canvas.size; ++y) {
    for (int x = 0; x < canvas.size; ++x) {
      float nearest = 1e9f;
      float tone = 0.0f;
      for (int row = y / cell - 1; row <= y / cell + 1; ++row) {
        for (int column = x / cell - 1; column <= x / cell + 1; ++column) {
          const float dx = (float(column) + seed_of(column, row, 0)) * float(cell) - float(x);
          const float dy = (float(row) + seed_of(column, row, 1)) * float(cell) - float(y);
          const float distance = dx * dx + dy * dy;
          if (distance >= nearest) continue;
          nearest = distance;
          tone = seed_of(column, row, 2);
        }
      }
      const std::size_t texel = canvas.height.texel(x, y);
      const float dull = std::clamp(0.4f + 0.8f * weather[texel], 0.0f, 1.0f);
      canvas.color[texel] = glm::vec3(0.96f, 0.98f, 1.0f) * (0.85f + 0.3f * tone * (1.0f - 0.5f * dull) - 0.15f * dull);
      canvas.gloss[texel] = 0.35f + 0.45f * tone * (1.0f - dull) + 0.15f * (1.0f - dull);
      canvas.height[texel] = 0.0006f * weather[texel];
    }
  }
}

void paint_smooth(Canvas& canvas) {
  const Field smear = make_octaves(canvas.size, 2, 4, 321, 0.5f);
  for (std::size_t i = 0; i < smear.texels(); ++i) {
    canvas.color[i] = glm::vec3(1.0f + 0.04f * smear[i]);
    canvas.gloss[i] = std::clamp(0.92f + 0.2f * smear[i], 0.0f, 1.0f);
  }
}

void paint_rubber(Canvas& canvas) {
  const Field worn = make_octaves(canvas.size, 4, 4, 331, 0.6f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 332);
  for (std::size_t i = 0; i < worn.texels(); ++i) {
    canvas.color[i] = glm::vec3(1.0f, 0.99f, 0.97f) * (1.0f + 0.5f * worn[i] + 0.1f * grain[i]);
    canvas.gloss[i] = 0.35f + 0.2f * worn[i];
    canvas.height[i] = 0.0004f * (worn[i] + 0.3f * grain[i]);
  }
}

void paint_prisms(Canvas& canvas) {
  // The little pyramids of a reflector or a lamp's lens, eight a tile.
  const int cell = canvas.size / 8;
  for (int y = 0; y < canvas.size; ++y) {
    for (int x = 0; x < canvas.size; ++x) {
      const float u = std::abs(2.0f * float(x % cell) / float(cell) - 1.0f);
      const float v = std::abs(2.0f * float(y % cell) / float(cell) - 1.0f);
      const float rise = 1.0f - std::max(u, v);
      const std::size_t texel = canvas.height.texel(x, y);
      canvas.height[texel] = 0.4f * canvas.texel_m() * float(cell) * 0.5f * rise;
      canvas.color[texel] = glm::vec3(0.75f + 0.5f * rise);
    }
  }
}

}  // namespace litfog::scene
