// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/hash_random.h"
#include "scene/paint/painter.h"

namespace litfog::scene {
namespace {

/// Strokes that overlap, each one leaf or needle; `lean` is the half-angle about the v axis.
struct Strokes {
  int count;
  float least_length, most_length;  ///< texels
  float half_width;                 ///< texels, at the widest point
  float lean;                       ///< radians
  float relief_m;
};

void add_strokes(Canvas& canvas, const Strokes& strokes, const glm::vec3& dull, const glm::vec3& fresh,
                 std::uint32_t seed) {
  HashRandom random(seed);
  const auto size = float(canvas.size);
  for (int i = 0; i < strokes.count; ++i) {
    const float level = float(i) / float(strokes.count);
    const float middle_y = random.unit() * size;
    const glm::vec2 middle(random.unit() * size, middle_y);
    const float half_length = 0.5f * random.between(strokes.least_length, strokes.most_length);
    const float turn = random.between(-strokes.lean, strokes.lean);
    const glm::vec2 along(std::sin(turn), std::cos(turn));
    const float tone = random.between(0.6f, 1.3f) * (0.4f + 0.8f * level);
    const glm::vec3 color = tone * glm::mix(dull, fresh, random.unit());
    const float gloss = random.between(0.3f, 0.7f);
    const glm::vec2 reach = glm::abs(along) * half_length + strokes.half_width + 1.0f;
    stamp(canvas.height, middle, reach, [&](std::size_t texel, float dx, float dy) {
      const float t = (dx * along.x + dy * along.y) / half_length;
      const float across = dx * along.y - dy * along.x;
      const float half = strokes.half_width * (1.0f - t * t);
      if (std::abs(t) >= 1.0f || std::abs(across) > std::max(half, 0.5f)) return;
      const float ridge = half > 0.5f ? 1.0f - std::abs(across) / half : 1.0f;
      canvas.height[texel] = strokes.relief_m * (level + 0.35f * ridge);
      canvas.color[texel] = color * (0.8f + 0.35f * ridge);
      canvas.gloss[texel] = gloss;
    });
  }
}

void clear(Canvas& canvas, const glm::vec3& color) {
  std::fill(canvas.color.begin(), canvas.color.end(), color);
  for (std::size_t i = 0; i < canvas.gloss.texels(); ++i) canvas.gloss[i] = 0.1f;
}

}  // namespace

void paint_bark(Canvas& canvas) {
  // Plates drawn out along the trunk (v), with deep furrows between them.
  const int size = canvas.size;
  Field plates(size);
  add_noise(plates, 16, 4, 1.0f, 201);
  add_noise(plates, 32, 8, 0.6f, 202);
  const Field fine = make_octaves(size, 32, 3, 203, 0.7f);
  const Field lichen = make_octaves(size, 4, 4, 204, 0.6f);
  for (std::size_t i = 0; i < plates.texels(); ++i) {
    const float furrow = std::min(1.0f, 3.0f * std::abs(plates[i]));
    canvas.height[i] = 0.012f * furrow + 0.003f * fine[i];
    const float moss = std::clamp(2.0f * lichen[i] - 0.3f, 0.0f, 1.0f) * furrow;
    canvas.color[i] = glm::mix(glm::vec3(0.115f, 0.085f, 0.065f), glm::vec3(0.14f, 0.16f, 0.10f), moss) *
                      (0.35f + 0.75f * furrow) * (1.0f + 0.4f * fine[i]);
    canvas.gloss[i] = 0.15f + 0.1f * fine[i];
  }
}

void paint_needles(Canvas& canvas) {
  clear(canvas, glm::vec3(0.02f, 0.022f, 0.014f));
  const int area = canvas.size * canvas.size;
  add_strokes(canvas, {area / 14, 10.0f, 20.0f, 0.9f, 1.1f, 0.01f}, {0.035f, 0.06f, 0.03f}, {0.075f, 0.125f, 0.045f},
              211);
}

void paint_leaves(Canvas& canvas) {
  clear(canvas, glm::vec3(0.03f, 0.035f, 0.015f));
  const int area = canvas.size * canvas.size;
  add_strokes(canvas, {area / 60, 18.0f, 34.0f, 6.0f, glm::pi<float>(), 0.012f}, {0.06f, 0.10f, 0.03f},
              {0.13f, 0.20f, 0.05f}, 221);
}

void paint_blades(Canvas& canvas) {
  // Fibres along the blade (v).
  Field fibres(canvas.size);
  add_noise(fibres, 32, 1, 1.0f, 231);
  add_noise(fibres, 4, 2, 0.8f, 232);
  for (std::size_t i = 0; i < fibres.texels(); ++i) {
    canvas.color[i] = glm::mix(glm::vec3(0.09f, 0.15f, 0.04f), glm::vec3(0.22f, 0.20f, 0.09f),
                               std::clamp(0.35f + 0.8f * fibres[i], 0.0f, 1.0f));
    canvas.height[i] = 0.0004f * fibres[i];
    canvas.gloss[i] = 0.5f;
  }
}

}  // namespace litfog::scene
