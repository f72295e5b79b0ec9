// SPDX-License-Identifier: Apache-2.0
#include "scene/paint/field.h"

#include "scene/noise.h"

namespace litfog::scene {

void add_noise(Field& field, int across, int along, float amplitude, std::uint32_t seed) {
  const int size = field.size();
  const int cell_width = size / across;
  const int cell_height = size / along;
  std::vector<float> inside(std::size_t(cell_width), 0.0f);
  std::vector<float> faded(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] = float(i) / float(cell_width);
    faded[i] = fade(inside[i]);
  }
  std::vector<Gradient> lattice(std::size_t(across * along));
  const auto corner = [&](int column, int row) -> Gradient& {
    return lattice[std::size_t((row % along) * across + column % across)];
  };
  for (int row = 0; row < along; ++row) {
    for (int column = 0; column < across; ++column) {
      corner(column, row) = lattice_gradient(std::uint32_t(column), std::uint32_t(row), seed);
    }
  }
  for (int y = 0; y < size; ++y) {
    const int row = y / cell_height;
    const float v = float(y % cell_height) / float(cell_height);
    NoiseEdge left = noise_edge(corner(0, row), corner(0, row + 1), v);
    for (int column = 0; column < across; ++column) {
      const NoiseEdge right = noise_edge(corner(column + 1, row), corner(column + 1, row + 1), v);
      float* out = &field[std::size_t(y * size + column * cell_width)];
      for (std::size_t i = 0; i < inside.size(); ++i)
        out[i] += amplitude * noise_between(left, right, inside[i], faded[i]);
      left = right;
    }
  }
}

void add_octaves(Field& field, int features, int octaves, float amplitude, std::uint32_t seed, float decay) {
  for (int octave = 0; octave < octaves && features <= field.size() / 2; ++octave) {
    add_noise(field, features, features, amplitude, seed + std::uint32_t(octave));
    features *= 2;
    amplitude *= decay;
  }
}

void add_grain(Field& field, float amplitude, std::uint32_t seed) {
  const std::uint32_t key = hash(seed);
  for (std::size_t i = 0; i < field.texels(); ++i) {
    field[i] += amplitude * (2.0f * unit_float(hash(std::uint32_t(i) + key)) - 1.0f);
  }
}

Field make_octaves(int size, int features, int octaves, std::uint32_t seed, float decay) {
  Field field(size);
  add_octaves(field, features, octaves, 1.0f, seed, decay);
  return field;
}

}  // namespace litfog::scene
