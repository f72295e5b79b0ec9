// SPDX-License-Identifier: Apache-2.0
#include "scene/model/wall.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/model/primitive.h"

namespace litfog::scene {

Mesh make_wall(float width, float height, std::span<const Opening> openings, float depth) {
  // The edges of all openings cut the wall into a grid; a cell is wall unless its middle is in an opening.
  std::vector<float> xs{0.0f, width};
  std::vector<float> ys{0.0f, height};
  Mesh mesh;
  for (const Opening& hole : openings) {
    xs.insert(xs.end(), {hole.left, hole.right});
    ys.insert(ys.end(), {hole.bottom, hole.top});
    const float l = hole.left;
    const float r = hole.right;
    const float b = hole.bottom;
    const float t = hole.top;
    const float d = -depth;
    add_face(mesh, {{l, b, 0}, {l, b, d}, {l, t, d}, {l, t, 0}});
    add_face(mesh, {{r, b, d}, {r, b, 0}, {r, t, 0}, {r, t, d}});
    add_face(mesh, {{l, t, d}, {r, t, d}, {r, t, 0}, {l, t, 0}});
    if (b > 0.0f) add_face(mesh, {{l, b, 0}, {r, b, 0}, {r, b, d}, {l, b, d}});
  }
  for (std::vector<float>* cuts : {&xs, &ys}) {
    std::sort(cuts->begin(), cuts->end());
    const auto same = [](float a, float b) { return b - a < 1e-4f; };
    cuts->erase(std::unique(cuts->begin(), cuts->end(), same), cuts->end());
  }
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      const glm::vec2 middle(0.5f * (xs[i] + xs[i + 1]), 0.5f * (ys[j] + ys[j + 1]));
      const bool open = std::any_of(openings.begin(), openings.end(), [&](const Opening& hole) {
        return middle.x > hole.left && middle.x < hole.right && middle.y > hole.bottom && middle.y < hole.top;
      });
      if (open) continue;
      add_face(mesh, {{xs[i], ys[j], 0}, {xs[i + 1], ys[j], 0}, {xs[i + 1], ys[j + 1], 0}, {xs[i], ys[j + 1], 0}});
    }
  }
  return mesh;
}

void add_window(Model& model, const Opening& opening, const glm::mat4& model_from_wall, bool lit) {
  const float back = -kReveal_m;
  const float w = 0.06f;
  Mesh& frame = part(model, "paint_white");
  const float l = opening.left;
  const float r = opening.right;
  const float b = opening.bottom;
  const float t = opening.top;
  add_box(frame, {l, b, back}, {r, b + w, back + 0.06f}, model_from_wall);
  add_box(frame, {l, t - w, back}, {r, t, back + 0.06f}, model_from_wall);
  add_box(frame, {l, b + w, back}, {l + w, t - w, back + 0.06f}, model_from_wall);
  add_box(frame, {r - w, b + w, back}, {r, t - w, back + 0.06f}, model_from_wall);
  const float middle = 0.5f * (l + r);
  add_box(frame, {middle - 0.04f, b + w, back}, {middle + 0.04f, t - w, back + 0.055f}, model_from_wall);
  const float bar = b + 0.66f * (t - b);
  add_box(frame, {l + w, bar - 0.016f, back}, {middle - 0.04f, bar + 0.016f, back + 0.045f}, model_from_wall);
  add_box(frame, {middle + 0.04f, bar - 0.016f, back}, {r - w, bar + 0.016f, back + 0.045f}, model_from_wall);
  Mesh pane;
  add_face(pane, {{l, b, back + 0.02f}, {r, b, back + 0.02f}, {r, t, back + 0.02f}, {l, t, back + 0.02f}});
  append(part(model, lit ? "window_lit" : "glass"), pane, model_from_wall);
  add_box(part(model, "stone"), {l - 0.06f, b - 0.07f, back}, {r + 0.06f, b, 0.07f}, model_from_wall);
}

void add_door(Model& model, const Opening& opening, const glm::mat4& model_from_wall, std::string_view paint) {
  const float back = -kReveal_m;
  const float l = opening.left;
  const float r = opening.right;
  const float b = opening.bottom;
  const float t = opening.top;
  const float w = 0.08f;
  Mesh& frame = part(model, "paint_white");
  add_box(frame, {l, b, back}, {l + w, t, back + 0.09f}, model_from_wall);
  add_box(frame, {r - w, b, back}, {r, t, back + 0.09f}, model_from_wall);
  add_box(frame, {l + w, t - w, back}, {r - w, t, back + 0.09f}, model_from_wall);
  Mesh& leaf = part(model, paint);
  add_box(leaf, {l + w, b, back}, {r - w, t - w, back + 0.03f}, model_from_wall);
  // Rails and stiles stand before the panels.
  const float z = back + 0.03f;
  const float inner_l = l + w;
  const float inner_r = r - w;
  const float height = t - w - b;
  const float middle = 0.5f * (l + r);
  const float stile = 0.11f;
  for (const float level : {0.0f, 0.42f, 0.92f}) {
    add_box(leaf, {inner_l, b + level * height, z}, {inner_r, b + level * height + 0.08f * height, z + 0.025f},
            model_from_wall);
  }
  for (const float x : {inner_l, middle - 0.5f * stile, inner_r - stile}) {
    add_box(leaf, {x, b + 0.08f * height, z}, {x + stile, b + 0.42f * height, z + 0.025f}, model_from_wall);
    add_box(leaf, {x, b + 0.50f * height, z}, {x + stile, b + 0.92f * height, z + 0.025f}, model_from_wall);
  }
  append(part(model, "galvanised"), make_sphere(0.03f, 10),
         glm::translate(model_from_wall, glm::vec3(inner_r - 0.06f, b + 0.47f * height, z + 0.06f)));
}

}  // namespace litfog::scene
