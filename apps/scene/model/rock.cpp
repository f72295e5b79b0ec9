// SPDX-License-Identifier: Apache-2.0
#include "scene/model/band.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/model/primitive.h"
#include "scene/noise.h"

namespace litfog::scene {

Model make_rock(const Rock& rock) {
  const auto seed = std::uint32_t(rock.seed);
  HashRandom random(seed);
  glm::vec3 stretch;
  stretch.z = random.between(0.8f, 1.2f);
  stretch.y = random.between(0.55f, 0.8f);
  stretch.x = random.between(0.8f, 1.2f);
  const auto surface = [&](const glm::vec3& direction) {
    const glm::vec3 p = 1.3f * direction;
    float bump = 0.28f * (octave_noise(p.x + p.z, p.y, 4, seed) + octave_noise(p.y + p.x, p.z, 4, seed + 7));
    // Planes of cleavage: the noise is flattened in steps.
    bump = 0.5f * bump + 0.5f * std::round(bump * 9.0f) / 9.0f;
    return 0.5f * rock.size_m * (1.0f + bump) * stretch * direction +
           glm::vec3(0.0f, 0.3f * rock.size_m * stretch.y, 0.0f);
  };
  // An octahedron whose faces are divided and blown up to the sphere.
  constexpr int kCuts = 10;
  Model model;
  Mesh& mesh = part(model, "stone");
  for (int octant = 0; octant < 8; ++octant) {
    const glm::vec3 x(octant & 1 ? -1.0f : 1.0f, 0, 0);
    const glm::vec3 y(0, octant & 2 ? -1.0f : 1.0f, 0);
    const glm::vec3 z(0, 0, octant & 4 ? -1.0f : 1.0f);
    const bool flipped = x.x * y.y * z.z < 0.0f;
    const auto point = [&](int i, int j) {
      const float a = float(i) / kCuts;
      const float b = float(j) / kCuts;
      return surface(glm::normalize(x * a + y * b + z * (1.0f - a - b)));
    };
    const auto face = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
      if (flipped) {
        add_face(mesh, {a, c, b});
      } else {
        add_face(mesh, {a, b, c});
      }
    };
    for (int i = 0; i < kCuts; ++i) {
      for (int j = 0; i + j < kCuts; ++j) {
        face(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j + 1 < kCuts) face(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
    }
  }
  return model;
}

Model make_rocks(const Rocks& rocks) {
  HashRandom random(std::uint32_t(rocks.band.seed));
  Model model;
  for (int i = 0; i < rocks.rocks; ++i) {
    Rock rock;
    // Small ones are more frequent.
    const float fraction = random.unit();
    rock.size_m =
        glm::mix(rocks.least_size_m, std::max(rocks.least_size_m, rocks.most_size_m), fraction * fraction * fraction);
    rock.seed = int(random.bits() >> 12);
    const glm::vec3 spot = random_point(rocks.band, random);
    append(model, make_rock(rock), place(spot, random.between(0.0f, glm::two_pi<float>())));
  }
  return model;
}

}  // namespace litfog::scene
