// SPDX-License-Identifier: Apache-2.0
#include "scene/model/roadside.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/numeral.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

// Layers of a plate stand this far before each other: enough for a depth buffer at 50 m.
constexpr float kLayer_m = 0.006f;
constexpr float kThickness_m = 0.02f;

std::vector<glm::vec2> regular(int corners, float radius, float first_turn) {
  std::vector<glm::vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const float turn = first_turn + glm::two_pi<float>() * float(i) / float(corners);
    outline.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
  }
  return outline;
}

void add_flat(Mesh& mesh, std::span<const glm::vec2> outline, const glm::mat4& at, int layer) {
  std::vector<glm::vec3> corners;
  for (const glm::vec2& corner : outline) corners.emplace_back(corner, kLayer_m * float(layer));
  Mesh flat;
  add_face(flat, corners);
  append(mesh, flat, at);
}

struct Face {
  std::vector<glm::vec2> outline;
  std::vector<glm::vec2> inner;
  std::string_view border;
  std::string_view field;
};

/// Plate, post and the two colours of the face; returns where the face's middle is.
glm::mat4 add_sign(Model& model, const Sign& sign, const Face& face) {
  Mesh& metal = part(model, "galvanised");
  const float top = sign.height_m + 0.4f * sign.size_m;
  append(metal, make_cylinder({0.03f, 0.03f, top + 0.3f, 10}), place({0.0f, -0.3f, 0.0f}));
  const glm::mat4 at = place({0.0f, sign.height_m, 0.05f});
  append(metal, make_plate(face.outline, kThickness_m), at);
  for (const float clamp : {-0.2f, 0.2f}) {
    append(metal, make_box({0.09f, 0.03f, 0.06f}), place({0.0f, sign.height_m + clamp * sign.size_m, 0.0f}));
  }
  add_flat(part(model, face.border), face.outline, at, 1);
  add_flat(part(model, face.field), face.inner, at, 2);
  return at;
}

}  // namespace

Model make_speed_sign(const SpeedSign& speed) {
  Model model;
  const Sign& sign = speed.sign;
  const float radius = 0.5f * sign.size_m;
  const glm::mat4 at =
      add_sign(model, sign, {regular(40, radius, 0.0f), regular(40, 0.78f * radius, 0.0f), "sign_red", "sign_white"});
  const float digits = speed.number >= 10 ? 0.40f : 0.5f;
  add_numeral(part(model, "paint_black"), speed.number, 1,
              glm::scale(glm::translate(at, glm::vec3(0.0f, 0.0f, 3.0f * kLayer_m)), glm::vec3(digits * sign.size_m)));
  return model;
}

Model make_warning_sign(const Sign& sign) {
  Model model;
  const float radius = 0.62f * sign.size_m;
  const float up = glm::half_pi<float>();
  const glm::mat4 at =
      add_sign(model, sign, {regular(3, radius, up), regular(3, 0.72f * radius, up), "sign_red", "sign_white"});
  Mesh& mark = part(model, "paint_black");
  const float s = sign.size_m;
  const glm::vec2 bar[] = {
      {-0.025f * s, -0.06f * s}, {0.025f * s, -0.06f * s}, {0.045f * s, 0.2f * s}, {-0.045f * s, 0.2f * s}};
  add_flat(mark, bar, at, 3);
  add_flat(mark, regular(12, 0.035f * s, 0.0f), glm::translate(at, glm::vec3(0.0f, -0.12f * s, 0.0f)), 3);
  return model;
}

}  // namespace litfog::scene
