// SPDX-License-Identifier: Apache-2.0
#include "scene/model/airfield.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr int kTowerSides = 8;

/// The point of a regular tower ring, a flat side towards +Z.
glm::vec3 ring_point(int i, float radius, float height) {
  const float turn = glm::two_pi<float>() * (float(i) - 0.5f) / kTowerSides;
  return {radius * std::sin(turn), height, radius * std::cos(turn)};
}

/// Flat sides from one ring to another, outside out.
void add_ring(Mesh& mesh, float low_radius, float low, float high_radius, float high) {
  for (int i = 0; i < kTowerSides; ++i) {
    add_face(mesh, {ring_point(i, low_radius, low), ring_point(i + 1, low_radius, low),
                    ring_point(i + 1, high_radius, high), ring_point(i, high_radius, high)});
  }
}

void add_deck(Mesh& mesh, float radius, float height, bool up) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < kTowerSides; ++i) corners.push_back(ring_point(up ? i : kTowerSides - 1 - i, radius, height));
  add_face(mesh, corners);
}

}  // namespace

Model make_papi_box(const PapiBox& box) {
  Model model;
  Mesh& body = part(model, "paint_yellow");
  append(body, make_bevelled_box({0.95f, 0.34f, 0.8f}, 0.03f), place({0.0f, 0.4f, 0.0f}));
  append(body, make_box({1.0f, 0.02f, 0.2f}), place({0.0f, 0.74f, 0.45f}));
  append(part(model, "paint_black"), make_box({0.85f, 0.2f, 0.01f}), place({0.0f, 0.46f, 0.4f}));
  for (const float x : {-0.26f, 0.0f, 0.26f}) {
    append(part(model, box.white != 0 ? "lamp_white" : "lamp_red"),
           make_lathe({{0.085f, 0.0f}, {0.06f, 0.02f}, {0.0f, 0.03f}}, 16),
           glm::rotate(place({x, 0.56f, 0.405f}), glm::half_pi<float>(), glm::vec3(1, 0, 0)));
  }
  for (const float x : {-0.38f, 0.38f}) {
    for (const float z : {-0.3f, 0.3f})
      append(part(model, "galvanised"), make_cylinder({0.025f, 0.025f, 0.62f, 8}), place({x, -0.2f, z}));
  }
  append(part(model, "concrete"), make_box({1.4f, 0.26f, 1.2f}), place({0.0f, -0.2f, 0.0f}));
  return model;
}

Model make_approach_light(const ApproachLight& light) {
  Model model;
  const float h = light.height_m;
  Mesh& mast = part(model, "paint_yellow");
  const float half = 0.5f * light.spacing_m * float(light.lamps - 1);
  // A lattice of three legs for the higher ones, a single pipe for the low.
  if (h > 1.2f) {
    const float spread = 0.22f;
    for (int leg = 0; leg < 3; ++leg) {
      const float turn = glm::two_pi<float>() * float(leg) / 3.0f;
      const float next = glm::two_pi<float>() * float(leg + 1) / 3.0f;
      const auto at = [&](float angle, float y) {
        return glm::vec3(spread * std::sin(angle), y, spread * std::cos(angle));
      };
      const glm::vec3 pipe[] = {at(turn, -0.3f), at(turn, h - 0.12f)};
      append(mast, make_tube(pipe, 0.02f, 6));
      const int bays = std::clamp(int(h / 0.6f), 1, 40);
      for (int bay = 0; bay < bays; ++bay) {
        const float low = (h - 0.15f) * float(bay) / float(bays);
        const float high = (h - 0.15f) * float(bay + 1) / float(bays);
        const glm::vec3 brace[] = {at(bay % 2 == 0 ? turn : next, low), at(bay % 2 == 0 ? next : turn, high)};
        append(mast, make_tube(brace, 0.01f, 4));
      }
    }
  } else {
    const glm::vec3 pipe[] = {{0.0f, -0.3f, 0.0f}, {0.0f, h - 0.12f, 0.0f}};
    append(mast, make_tube(pipe, 0.035f, 8));
  }
  if (light.lamps > 1)
    append(mast, make_beam({-half - 0.1f, h - 0.12f, 0.0f}, {half + 0.1f, h - 0.12f, 0.0f}, 0.06f, 0.06f));
  for (int lamp = 0; lamp < light.lamps; ++lamp) {
    const glm::mat4 at = place({light.spacing_m * float(lamp) - half, h, 0.0f});
    const glm::mat4 forward = glm::rotate(at, glm::half_pi<float>(), glm::vec3(1, 0, 0));
    append(part(model, "paint_grey"),
           make_lathe({{0.0f, -0.12f}, {0.05f, -0.11f}, {0.1f, -0.02f}, {0.105f, 0.06f}, {0.095f, 0.06f}}, 14),
           forward);
    append(part(model, light.red != 0 ? "lamp_red" : "lamp_white"),
           make_lathe({{0.095f, 0.05f}, {0.06f, 0.065f}, {0.0f, 0.07f}}, 14), forward);
    append(mast, make_cylinder({0.018f, 0.018f, 0.1f, 6}), glm::translate(at, glm::vec3(0.0f, -0.14f, 0.0f)));
  }
  return model;
}

Model make_edge_light(const EdgeLight& light) {
  Model model;
  append(part(model, "concrete"), make_cylinder({0.3f, 0.28f, 0.13f, 16}), place({0.0f, -0.1f, 0.0f}));
  append(part(model, "paint_yellow"), make_lathe({{0.11f, 0.02f},
                                                  {0.11f, 0.05f},
                                                  {0.03f, 0.07f},
                                                  {0.025f, 0.2f},
                                                  {0.07f, 0.22f},
                                                  {0.085f, 0.27f},
                                                  {0.0f, 0.275f}},
                                                 14));
  append(part(model, light.red != 0 ? "lamp_red" : "lamp_white"),
         make_lathe({{0.075f, 0.27f}, {0.078f, 0.33f}, {0.06f, 0.375f}, {0.03f, 0.395f}, {0.0f, 0.4f}}, 16));
  return model;
}

Model make_hangar(const Hangar& hangar) {
  Model model;
  const float half = 0.5f * hangar.width_m;
  const float side = 0.35f * hangar.height_m;  // the walls are upright up to here
  const float rise = hangar.height_m - side;
  const auto arch = [&](float x) { return side + rise * std::sqrt(std::max(0.0f, 1.0f - (x / half) * (x / half))); };
  constexpr int kPieces = 28;
  std::vector<glm::vec2> outline{{-half, -0.3f}};
  for (int i = 0; i <= kPieces; ++i) {
    const float turn = glm::pi<float>() * float(i) / kPieces;
    outline.emplace_back(-half * std::cos(turn), side + rise * std::sin(turn));
  }
  outline.emplace_back(half, -0.3f);
  // Walked over the top from the right, the outside is on the right.
  std::vector<glm::vec2> shell(outline.rbegin(), outline.rend());
  std::vector<glm::vec3> axis;
  for (int i = 0; i <= 8; ++i) axis.emplace_back(0.0f, 0.0f, -hangar.depth_m * float(i) / 8.0f);
  append(part(model, "corrugated"), make_sweep(shell, axis));
  std::vector<glm::vec3> back;
  for (std::size_t i = outline.size(); i-- > 0;) back.emplace_back(-outline[i].x, outline[i].y, -hangar.depth_m);
  std::reverse(back.begin(), back.end());
  Mesh rear;
  add_face(rear, back);
  append(part(model, "corrugated"), rear);
  // The front: columns under the arch, above the door if there is one.
  const float door_half = 0.78f * half;
  const float door = std::min(0.62f * hangar.height_m, 0.9f * arch(door_half));
  Mesh front;
  for (int i = 0; i < kPieces; ++i) {
    const auto x_at = [&](int k) { return -half * std::cos(glm::pi<float>() * float(k) / kPieces); };
    const float left = x_at(i);
    const float right = x_at(i + 1);
    // A column that the door's edge crosses is cut there.
    std::vector<float> cuts{left};
    for (const float edge : {-door_half, door_half}) {
      if (edge > left && edge < right) cuts.push_back(edge);
    }
    cuts.push_back(right);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const float a = cuts[k];
      const float b = cuts[k + 1];
      const float foot = std::abs(0.5f * (a + b)) < door_half ? door : -0.3f;
      // The chord, not the arch, so that front and shell meet.
      const auto top = [&](float x) { return glm::mix(arch(left), arch(right), (x - left) / (right - left)); };
      add_face(front, {{a, foot, 0.0f}, {b, foot, 0.0f}, {b, top(b), 0.0f}, {a, top(a), 0.0f}});
    }
  }
  append(part(model, "corrugated"), front);
  // Sliding doors on two rails, every other leaf before its neighbour, each with a strip of windows.
  constexpr int kLeaves = 6;
  const float leaf = 2.0f * door_half / kLeaves;
  for (int i = 0; i < kLeaves; ++i) {
    const float x = -door_half + leaf * (float(i) + 0.5f);
    const float z = i % 2 == 0 ? -0.12f : -0.3f;
    append(part(model, "paint_green"), make_box({leaf + 0.15f, door + 0.1f, 0.08f}), place({x, 0.0f, z}));
    for (const float stile : {-0.5f, 0.0f, 0.5f}) {
      append(part(model, "paint_green"), make_box({0.12f, door, 0.05f}),
             place({x + stile * (leaf - 0.1f), 0.0f, z + 0.06f}));
    }
    for (const float rail : {0.02f, 0.45f, 0.72f}) {
      append(part(model, "paint_green"), make_box({leaf - 0.2f, 0.12f, 0.045f}), place({x, rail * door, z + 0.06f}));
    }
    for (const float pane : {-0.24f, 0.24f}) {
      append(part(model, hangar.lit != 0 ? "window_lit" : "glass"), make_box({0.36f * leaf, 0.16f * door, 0.02f}),
             place({x + pane * leaf, 0.51f * door, z + 0.045f}));
    }
  }
  append(part(model, "galvanised"), make_box({2.0f * door_half + 0.8f, 0.25f, 0.35f}), place({0.0f, door, 0.1f}));
  append(part(model, "concrete"), make_box({2.0f * door_half + 4.0f, 0.34f, 6.0f}), place({0.0f, -0.32f, 2.5f}));
  // An edge trim along the arch, and lamps over the doors.
  std::vector<glm::vec3> trim;
  for (std::size_t i = 0; i < outline.size(); ++i) trim.emplace_back(outline[i], 0.02f);
  append(part(model, "paint_grey"), make_tube(trim, 0.12f, 8));
  for (const float x : {-0.55f, 0.0f, 0.55f}) {
    const glm::mat4 at = place({x * half, door + 0.55f, 0.35f});
    append(part(model, "paint_grey"), make_lathe({{0.24f, 0.0f}, {0.2f, 0.12f}, {0.06f, 0.2f}, {0.0f, 0.21f}}, 14), at);
    append(part(model, hangar.lit != 0 ? "lamp_white" : "glass"),
           make_lathe({{0.0f, -0.03f}, {0.12f, -0.02f}, {0.22f, 0.01f}}, 14), at);
    append(part(model, "paint_grey"),
           make_beam({x * half, door + 0.7f, 0.0f}, {x * half, door + 0.72f, 0.3f}, 0.05f, 0.05f));
  }
  return model;
}

Model make_tower(const Tower& tower) {
  Model model;
  const float h = tower.height_m;
  const float shaft = 2.6f;
  const float cab_floor = h - 4.2f;
  Mesh& concrete = part(model, "concrete");
  add_ring(concrete, shaft, -0.3f, shaft, cab_floor - 1.2f);
  // The shaft widens under the gallery.
  add_ring(concrete, shaft, cab_floor - 1.2f, 4.0f, cab_floor - 0.3f);
  add_ring(concrete, 4.0f, cab_floor - 0.3f, 4.0f, cab_floor);
  add_deck(concrete, 4.0f, cab_floor, true);
  // Windows up the stairs, and the door.
  const std::string_view pane = tower.lit != 0 ? "window_lit" : "glass";
  const float flat = shaft * std::cos(glm::pi<float>() / kTowerSides);
  const int floors = int((cab_floor - 4.0f) / 2.8f);
  for (int floor = 1; floor <= floors; ++floor) {
    const float y = 2.8f * float(floor) + 0.6f;
    append(part(model, pane), make_box({0.55f, 1.0f, 0.04f}), place({0.0f, y, flat}));
    append(part(model, "paint_grey"), make_box({0.75f, 0.1f, 0.12f}), place({0.0f, y - 0.1f, flat}));
    append(part(model, "paint_grey"), make_box({0.75f, 0.1f, 0.12f}), place({0.0f, y + 1.0f, flat}));
  }
  append(part(model, "paint_green"), make_bevelled_box({1.0f, 2.1f, 0.1f}, 0.02f), place({0.0f, 0.0f, flat}));
  append(concrete, make_box({1.5f, 0.15f, 1.1f}), place({0.0f, 2.25f, flat + 0.5f}));
  append(part(model, "lamp_white"), make_box({0.3f, 0.06f, 0.2f}), place({0.0f, 2.19f, flat + 0.4f}));
  // Gallery rail.
  Mesh& steel = part(model, "galvanised");
  for (int i = 0; i < kTowerSides; ++i) {
    const glm::vec3 a = ring_point(i, 3.9f, cab_floor);
    const glm::vec3 b = ring_point(i + 1, 3.9f, cab_floor);
    for (const float level : {0.55f, 1.05f}) {
      const glm::vec3 rail[] = {a + glm::vec3(0, level, 0), b + glm::vec3(0, level, 0)};
      append(steel, make_tube(rail, 0.025f, 6));
    }
    for (const float t : {0.0f, 0.5f})
      append(steel, make_cylinder({0.025f, 0.025f, 1.05f, 6}), place(glm::mix(a, b, t)));
  }
  // The cab: a parapet, panes that lean out between mullions, a roof that shades them.
  add_ring(part(model, "paint_white"), 2.9f, cab_floor, 2.9f, cab_floor + 0.9f);
  const float top = cab_floor + 3.1f;
  add_ring(part(model, pane), 2.85f, cab_floor + 0.9f, 3.35f, top);
  for (int i = 0; i < kTowerSides; ++i) {
    const glm::vec3 low = ring_point(i, 2.9f, cab_floor + 0.85f);
    const glm::vec3 high = ring_point(i, 3.4f, top);
    append(part(model, "paint_grey"),
           make_beam(low, high, 0.12f, 0.12f, glm::normalize(glm::vec3(low.x, 0.0f, low.z))));
    const glm::vec3 next_low = ring_point(i + 1, 2.9f, cab_floor + 0.85f);
    const glm::vec3 next_high = ring_point(i + 1, 3.4f, top);
    append(part(model, "paint_grey"), make_beam(0.5f * (low + next_low), 0.5f * (high + next_high), 0.07f, 0.07f));
  }
  Mesh& roof = part(model, "paint_white");
  add_deck(roof, 4.0f, top, false);
  add_ring(roof, 4.0f, top, 4.0f, top + 0.45f);
  add_deck(roof, 4.0f, top + 0.45f, true);
  // Antennas and the obstruction lamp.
  const glm::vec3 mast[] = {{0.0f, top + 0.4f, 0.0f}, {0.0f, top + 3.4f, 0.0f}};
  append(steel, make_tube(mast, 0.05f, 8));
  append(part(model, "lamp_red"), make_sphere(0.16f, 14), place({0.0f, top + 3.5f, 0.0f}));
  for (const float x : {-1.6f, 1.6f}) {
    const glm::vec3 whip[] = {{x, top + 0.4f, 0.8f}, {x, top + 2.6f, 0.8f}};
    append(steel, make_tube(whip, 0.02f, 5));
  }
  return model;
}

}  // namespace litfog::scene
