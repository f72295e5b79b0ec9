// SPDX-License-Identifier: Apache-2.0
#include "scene/model/street_life.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/primitive.h"

namespace litfog::scene {

Model make_person(const Person& person) {
  Model body;
  const float stride = person.walks != 0 ? 0.32f : 0.02f;
  Mesh& coat = part(body, kCarPaints[person.coat]);
  Mesh& skin = part(body, "skin");
  Mesh& dark = part(body, "rubber");
  for (const float side : {-1.0f, 1.0f}) {
    const float ahead = -side * stride;  // the left foot leads, and the right hand
    const glm::vec3 leg[] = {
        {side * 0.09f, 0.9f, 0.0f}, {side * 0.1f, 0.48f, 0.4f * ahead - 0.02f}, {side * 0.1f, 0.07f, ahead}};
    const float leg_radii[] = {0.1f, 0.07f, 0.05f};
    append(dark, make_tube(leg, leg_radii, 10));
    append(dark, make_bevelled_box({0.1f, 0.09f, 0.27f}, 0.03f), place({side * 0.1f, 0.0f, ahead - 0.06f}));
    const glm::vec3 hand(side * 0.29f, 0.82f, -0.9f * ahead - 0.06f);
    const glm::vec3 arm[] = {{side * 0.2f, 1.4f, 0.0f}, {side * 0.27f, 1.12f, -0.3f * ahead}, hand};
    const float arm_radii[] = {0.075f, 0.06f, 0.045f};
    append(coat, make_tube(arm, arm_radii, 8));
    append(skin, make_sphere(0.048f, 8), place(hand - glm::vec3(0.0f, 0.05f, 0.0f)));
  }
  // Wider than deep.
  const glm::mat4 flat = glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1.0f, 0.68f));
  append(
      coat,
      make_lathe({{0.0f, 0.68f}, {0.24f, 0.68f}, {0.19f, 1.05f}, {0.225f, 1.36f}, {0.15f, 1.45f}, {0.0f, 1.48f}}, 14),
      flat);
  append(skin, make_cylinder({0.055f, 0.055f, 0.12f, 8}), place({0.0f, 1.43f, 0.0f}));
  append(skin, make_sphere(0.105f, 12), place({0.0f, 1.61f, -0.01f}));
  append(dark, make_lathe({{0.14f, 1.645f}, {0.14f, 1.655f}, {0.112f, 1.66f}, {0.1f, 1.73f}, {0.0f, 1.75f}}, 14));
  Model model;
  append(model, body, glm::scale(glm::mat4(1.0f), glm::vec3(person.height_m / 1.75f)));
  return model;
}

}  // namespace litfog::scene
