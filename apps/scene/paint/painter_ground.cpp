// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "scene/hash_random.h"
#include "scene/paint/painter.h"

namespace litfog::scene {
namespace {

float saturate(float x) { return std::clamp(x, 0.0f, 1.0f); }

/// Rounded stones of a few texels pressed into the surface: the higher one wins.
struct Stones {
  int count;
  float least_radius, most_radius;  ///< texels
  float relief_m;
};

void add_stones(Canvas& canvas, const Stones& stones, float contrast, std::uint32_t seed) {
  HashRandom random(seed);
  const auto size = float(canvas.size);
  for (int i = 0; i < stones.count; ++i) {
    const float middle_y = random.unit() * size;
    const glm::vec2 middle(random.unit() * size, middle_y);
    const float radius = random.between(stones.least_radius, stones.most_radius);
    const float turn = random.between(0.0f, glm::pi<float>());
    const glm::vec2 axis(std::cos(turn), std::sin(turn));
    const float flat = random.between(0.6f, 1.0f);
    const float tone = 1.0f + contrast * random.between(-1.0f, 1.0f);
    const float blue = 1.0f + 0.05f * random.between(-1, 1);
    const float red = 1.0f + 0.06f * random.between(-1, 1);
    const glm::vec3 tint = tone * glm::vec3(red, 1.0f, blue);
    const float sunk = random.between(0.0f, 0.6f);
    stamp(canvas.height, middle, glm::vec2(radius), [&](std::size_t texel, float dx, float dy) {
      const float along = (dx * axis.x + dy * axis.y) / radius;
      const float across = (dy * axis.x - dx * axis.y) / (radius * flat);
      const float dome = 1.0f - along * along - across * across;
      if (dome <= 0.0f) return;
      const float top = stones.relief_m * (std::sqrt(dome) - sunk);
      if (top <= canvas.height[texel]) return;
      canvas.height[texel] = top;
      canvas.color[texel] = tint * (0.75f + 0.25f * std::sqrt(dome));
    });
  }
}

/// A crack wanders as a chain of short cuts.
void add_crack(Canvas& canvas, glm::vec2 at, float turn, int steps, float width, float depth_m, HashRandom& random) {
  for (int i = 0; i < steps; ++i) {
    turn += random.between(-0.35f, 0.35f);
    at += 1.2f * glm::vec2(std::cos(turn), std::sin(turn));
    const float radius = width * random.between(0.6f, 1.2f);
    stamp(canvas.height, at, glm::vec2(radius + 1.0f), [&](std::size_t texel, float dx, float dy) {
      const float inside = saturate(radius + 0.5f - std::sqrt(dx * dx + dy * dy));
      if (inside <= 0.0f) return;
      canvas.height[texel] = std::min(canvas.height[texel], -depth_m * inside);
      canvas.color[texel] *= 1.0f - 0.3f * inside;
      canvas.gloss[texel] *= 1.0f - 0.6f * inside;
    });
  }
}

void bitumen(Canvas& canvas, std::uint32_t seed) {
  std::fill(canvas.color.begin(), canvas.color.end(), glm::vec3(0.62f, 0.63f, 0.66f));
  // One stone per ten texels; the bitumen between them is darker.
  const int count = canvas.size * canvas.size / 10;
  add_stones(canvas, {count, 1.0f, 2.6f, 0.002f}, 0.28f, seed);
  const Field damp = make_octaves(canvas.size, 2, 4, seed + 10, 0.6f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, seed + 20);
  for (std::size_t i = 0; i < damp.texels(); ++i) {
    const float wet = saturate(0.5f + 0.9f * damp[i]);
    canvas.color[i] *= (1.12f - 0.24f * wet) * (1.0f + 0.10f * grain[i]);
    canvas.gloss[i] = 0.18f + 0.5f * wet + 0.12f * grain[i];
  }
}

}  // namespace

void paint_asphalt(Canvas& canvas) {
  bitumen(canvas, 11);
  HashRandom random(12);
  const auto size = float(canvas.size);
  add_crack(canvas, {0.2f * size, 0.1f * size}, 1.2f, 190, 0.7f, 0.004f, random);
  add_crack(canvas, {0.7f * size, 0.5f * size}, 0.3f, 110, 0.6f, 0.004f, random);
}

void paint_wet_asphalt(Canvas& canvas) {
  bitumen(canvas, 11);
  // Water fills the pores and stands in the hollows, where it is smooth; between them stones come through the film.
  const Field hollows = make_octaves(canvas.size, 2, 4, 14, 0.5f);
  for (std::size_t i = 0; i < hollows.texels(); ++i) {
    const float film = saturate(0.62f + 1.1f * hollows[i]);
    canvas.height[i] *= 0.5f * (1.0f - film);
    canvas.color[i] *= 1.0f - 0.45f * film;
    canvas.gloss[i] = glm::mix(0.35f, 1.0f, film);
  }
}

void paint_runway(Canvas& canvas) {
  bitumen(canvas, 21);
  // Tyres leave their rubber along the runway (v): long soft streaks.
  Field rubber(canvas.size);
  add_noise(rubber, 32, 1, 0.8f, 22);
  add_noise(rubber, 128, 2, 0.6f, 23);
  add_noise(rubber, 8, 2, 0.5f, 24);
  for (std::size_t i = 0; i < rubber.texels(); ++i) {
    const float streak = saturate(0.35f + rubber[i]);
    canvas.color[i] *= 1.05f - 0.4f * streak * streak;
    canvas.gloss[i] *= 1.0f - 0.3f * streak;
  }
  // Grooves across, as airports cut them against standing water: 6 mm wide, one every 8 texels.
  for (int y = 0; y < canvas.size; y += 8) {
    for (int x = 0; x < canvas.size; ++x) {
      const std::size_t texel = canvas.height.texel(x, y);
      canvas.height[texel] -= 0.002f;
      canvas.color[texel] *= 0.86f;
    }
  }
}

void paint_road_paint(Canvas& canvas) {
  // Thick paint over stones: the stones show through, and where tyres have worn it off, the road does.
  add_stones(canvas, {canvas.size * canvas.size / 14, 1.0f, 2.4f, 0.0015f}, 0.03f, 31);
  const Field wear = make_octaves(canvas.size, 4, 5, 32, 0.65f);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 33);
  for (std::size_t i = 0; i < wear.texels(); ++i) {
    const float worn = saturate(3.0f * (wear[i] + 0.25f * grain[i] - 0.55f));
    const float grey = 0.95f + 0.05f * grain[i];
    canvas.color[i] = glm::mix(grey * glm::vec3(1.0f, 1.0f, 0.97f), glm::vec3(0.2f), worn);
    canvas.gloss[i] = 0.6f * (1.0f - 0.7f * worn);
    canvas.height[i] -= 0.001f * worn;
  }
}

void paint_grass(Canvas& canvas) {
  const int size = canvas.size;
  const Field clumps = make_octaves(size, 4, 4, 41, 0.6f);
  for (std::size_t i = 0; i < clumps.texels(); ++i) {
    canvas.color[i] = glm::vec3(0.085f, 0.065f, 0.045f) * (1.0f + 0.5f * clumps[i]);
    canvas.height[i] = 0.006f * clumps[i] - 0.02f;
    canvas.gloss[i] = 0.05f;
  }
  // Blades as bent strokes; later ones lie higher. Most are green, some straw; dry and lush patches.
  HashRandom random(42);
  const int blades = size * size / 22;
  for (int blade = 0; blade < blades; ++blade) {
    const float at_y = random.unit() * float(size);
    glm::vec2 at(random.unit() * float(size), at_y);
    const float lush = clumps.at(int(at.x), int(at.y));
    float turn = random.between(0.0f, glm::two_pi<float>());
    const float bend = random.between(-0.09f, 0.09f);
    const float level = float(blade) / float(blades);
    const int steps = int(random.between(9.0f, 26.0f));
    const bool straw = random.unit() < 0.16f - 0.2f * lush;
    const float tone = random.between(0.55f, 1.25f) * (0.45f + 0.75f * level);
    const glm::vec3 root = tone * (straw ? glm::vec3(0.20f, 0.16f, 0.075f) : glm::vec3(0.045f, 0.085f, 0.022f));
    const glm::vec3 tip = tone * (straw ? glm::vec3(0.36f, 0.30f, 0.16f) : glm::vec3(0.13f, 0.19f, 0.05f));
    for (int step = 0; step < steps; ++step) {
      const float t = float(step) / float(steps);
      turn += bend;
      const glm::vec2 along(std::cos(turn), std::sin(turn));
      at += along;
      const float height = 0.02f * (level - 0.5f) + 0.009f * std::sin(glm::pi<float>() * std::min(1.0f, t + 0.2f));
      const glm::vec3 color = glm::mix(root, tip, t);
      // Two texels wide at the root, one at the tip.
      const int width = t < 0.6f ? 2 : 1;
      for (int k = 0; k < width; ++k) {
        const glm::vec2 p = at + float(k) * glm::vec2(-along.y, along.x);
        const std::size_t texel = canvas.height.texel(int(std::floor(p.x)), int(std::floor(p.y)));
        if (height < canvas.height[texel] - 0.004f) continue;
        canvas.height[texel] = height;
        canvas.color[texel] = color;
        canvas.gloss[texel] = 0.25f + 0.35f * t;
      }
    }
  }
}

void paint_gravel(Canvas& canvas) {
  std::fill(canvas.color.begin(), canvas.color.end(), glm::vec3(0.35f, 0.31f, 0.26f));
  for (std::size_t i = 0; i < canvas.height.texels(); ++i) canvas.height[i] = -0.013f;
  const int area = canvas.size * canvas.size;
  add_stones(canvas, {area / 25, 1.5f, 4.0f, 0.008f}, 0.4f, 51);
  add_stones(canvas, {area / 160, 4.0f, 8.0f, 0.013f}, 0.4f, 52);
  Field grain(canvas.size);
  add_grain(grain, 1.0f, 53);
  for (std::size_t i = 0; i < grain.texels(); ++i) {
    canvas.color[i] *= (1.0f + 0.12f * grain[i]) * saturate(1.0f + 25.0f * canvas.height[i]);
    canvas.gloss[i] = 0.3f + 0.15f * grain[i];
  }
}

void paint_concrete_slabs(Canvas& canvas) {
  paint_concrete(canvas);
  // Four slabs a tile with tarred joints.
  const int half = canvas.size / 2;
  for (int y = 0; y < canvas.size; ++y) {
    for (int x = 0; x < canvas.size; ++x) {
      const int to_joint = std::min(std::min(x % half, half - 1 - x % half), std::min(y % half, half - 1 - y % half));
      const std::size_t texel = canvas.height.texel(x, y);
      const std::uint32_t slab = hash(std::uint32_t(x / half), std::uint32_t(y / half), 71);
      canvas.color[texel] *= 0.9f + 0.2f * unit_float(slab);
      if (to_joint > 2) continue;
      const float inside = to_joint < 2 ? 1.0f : 0.5f;
      canvas.color[texel] *= 1.0f - 0.72f * inside;
      canvas.height[texel] -= 0.006f * inside;
    }
  }
}

void paint_water(Canvas& canvas) {
  // Waves of 6 m and shorter ones on them.
  add_octaves(canvas.height, 4, 6, 0.35f, 71, 0.5f);
}

}  // namespace litfog::scene
