// SPDX-License-Identifier: Apache-2.0
#include "scene/model/roadside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/hash_random.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kSunk_m = 0.4f;  // how deep posts go, so that uneven ground shows no gap

/// The insulators' positions along a cross-arm of 2 m, and their height over its top.
constexpr std::array<float, 3> kInsulators_m{-0.9f, 0.35f, 0.9f};
constexpr float kInsulatorHeight_m = 0.2f;
constexpr float kArmBelowTop_m = 0.35f;

std::vector<float> stations(const RoadsideRow& row) {
  std::vector<float> along;
  for (float at = 0.0f; at <= row.path.length_m; at += row.spacing_m) along.push_back(at);
  return along;
}

}  // namespace

Model make_fence(const Fence& fence) {
  HashRandom random(std::uint32_t(fence.seed));
  Model model;
  Mesh& wood = part(model, "wood");
  const std::vector<float> posts = stations(fence.row);
  for (std::size_t i = 0; i < posts.size(); ++i) {
    // Nothing old stands quite upright.
    const glm::vec3 foot = fence.row.path.point(posts[i], fence.row.offset_m) - glm::vec3(0.0f, kSunk_m, 0.0f);
    const float lean_z = random.between(-0.03f, 0.03f);
    const float lean_x = random.between(-0.03f, 0.03f);
    const glm::vec3 lean(lean_x, 1.0f, lean_z);
    const float height = fence.height_m + kSunk_m + random.between(0.05f, 0.15f);
    append(wood, make_beam(foot, foot + lean * height, 0.11f, 0.11f, -fence.row.path.direction(posts[i])));
    if (i + 1 == posts.size()) break;
    for (int rail = 0; rail < fence.rails; ++rail) {
      const float level = fence.height_m * (float(rail) + 0.75f) / float(fence.rails);
      const auto end = [&](float along, float beyond) {
        return fence.row.path.point(along + beyond,
                                    fence.row.offset_m + (fence.row.offset_m > 0.0f ? -0.075f : 0.075f)) +
               glm::vec3(0.0f, level + random.between(-0.025f, 0.025f), 0.0f);
      };
      const glm::vec3 from = end(posts[i], -0.06f);
      append(wood, make_beam(from, end(posts[i + 1], 0.06f), 0.04f, 0.12f));
    }
  }
  return model;
}

Model make_delineator(const Delineator& delineator) {
  Model model;
  const float h = delineator.height_m;
  // Seen from above a blunt wedge; the top slopes back.
  const float x = 0.06f;
  const float z = 0.04f;
  Mesh& white = part(model, "paint_white");
  Mesh& black = part(model, "paint_black");
  const auto band = [&](Mesh& mesh, float low, float high, float slant, float out) {
    const auto p = [&](float sx, float sz, float y) {
      return glm::vec3(sx * (x + out), y + sx * slant, sz * (z + out));
    };
    const std::array<glm::vec2, 4> around{glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1), glm::vec2(-1, -1)};
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::vec2 a = around[i];
      const glm::vec2 b = around[(i + 1) % 4];
      add_face(mesh, {p(a.x, a.y, low), p(b.x, b.y, low), p(b.x, b.y, high), p(a.x, a.y, high)});
    }
    add_face(mesh, {p(-1, 1, high), p(1, 1, high), p(1, -1, high), p(-1, -1, high)});
  };
  band(white, -kSunk_m, h, 0.02f, 0.0f);
  band(black, 0.66f * h, 0.88f * h, 0.02f, 0.003f);
  for (const float face : {1.0f, -1.0f}) {
    const glm::mat4 at = place({0.0f, 0.69f * h, face * (z + 0.005f)}, face > 0 ? 0.0f : glm::pi<float>());
    const glm::vec2 plate[] = {{-0.025f, 0.0f}, {0.025f, 0.0f}, {0.025f, 0.16f * h}, {-0.025f, 0.16f * h}};
    append(part(model, "reflector_white"), make_plate(plate, 0.004f), at);
  }
  return model;
}

Model make_delineators(const Delineators& delineators) {
  Model model;
  const Model post = make_delineator(delineators.post);
  for (const float along : stations(delineators.row)) {
    for (const float side : {-1.0f, 1.0f}) {
      append(
          model, post,
          place(delineators.row.path.point(along, side * delineators.row.offset_m), delineators.row.path.yaw(along)));
    }
  }
  return model;
}

Model make_street_lamp(const StreetLamp& lamp) {
  Model model;
  const float h = lamp.height_m;
  Mesh& steel = part(model, "galvanised");
  append(steel, make_cylinder({0.11f, 0.11f, 1.2f + kSunk_m, 14}), place({0.0f, -kSunk_m, 0.0f}));
  append(steel, make_cylinder({0.16f, 0.16f, 0.04f, 14}));
  append(part(model, "paint_grey"), make_box({0.09f, 0.45f, 0.02f}), place({0.0f, 0.5f, 0.105f}));
  // Mast and arm are one pipe that bends over.
  std::vector<glm::vec3> line;
  std::vector<float> radii;
  const float bend = std::min(0.9f * (lamp.arm_m - 0.2f), 0.25f * h);
  const float straight = h - bend;
  for (const float t : {0.0f, 0.5f, 1.0f}) line.emplace_back(0.0f, 1.15f + t * (straight - 1.15f), 0.0f);
  constexpr int kBends = 8;
  for (int i = 1; i <= kBends; ++i) {
    const float turn = glm::half_pi<float>() * 0.94f * float(i) / kBends;
    line.emplace_back(bend * (1.0f - std::cos(turn)), straight + bend * std::sin(turn), 0.0f);
  }
  line.emplace_back(lamp.arm_m - 0.2f, h, 0.0f);
  for (std::size_t i = 0; i < line.size(); ++i) {
    radii.push_back(glm::mix(0.085f, 0.035f, float(i) / float(line.size() - 1)));
  }
  append(steel, make_tube(line, radii, 10));
  // The head: a flat shell with its lens below.
  const glm::mat4 head =
      glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(lamp.arm_m, h, 0.0f)), 0.07f, glm::vec3(0, 0, 1));
  append(
      part(model, "paint_grey"),
      make_lathe({{0.0f, -0.05f}, {0.5f, -0.05f}, {0.5f, -0.015f}, {0.42f, 0.045f}, {0.25f, 0.08f}, {0.0f, 0.09f}}, 20),
      glm::scale(head, glm::vec3(0.72f, 1.0f, 0.34f)));
  append(part(model, lamp.sodium != 0 ? "lamp_sodium" : "lamp_white"),
         make_lathe({{0.0f, -0.045f}, {0.25f, -0.035f}, {0.36f, 0.0f}}, 18),
         glm::scale(glm::translate(head, glm::vec3(0.06f, -0.05f, 0.0f)), glm::vec3(0.7f, 1.0f, 0.32f)));
  return model;
}

Model make_utility_pole(const UtilityPole& pole) {
  Model model;
  const float h = pole.height_m;
  Mesh& wood = part(model, "wood");
  append(wood, make_cylinder({0.15f, 0.10f, h + kSunk_m, 12}), place({0.0f, -kSunk_m, 0.0f}));
  const float arm = h - kArmBelowTop_m;
  append(wood, make_beam({-1.05f, arm - 0.05f, 0.13f}, {1.05f, arm - 0.05f, 0.13f}, 0.09f, 0.1f));
  Mesh& steel = part(model, "galvanised");
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec3 brace[] = {{side * 0.6f, arm - 0.06f, 0.12f}, {0.0f, arm - 0.65f, 0.12f}};
    append(steel, make_tube(brace, 0.014f, 5));
  }
  for (const float x : kInsulators_m) {
    append(part(model, "paint_white"),
           make_lathe({{0.0f, 0.0f},
                       {0.035f, 0.0f},
                       {0.05f, 0.05f},
                       {0.028f, 0.07f},
                       {0.045f, 0.11f},
                       {0.025f, 0.14f},
                       {0.035f, 0.18f},
                       {0.0f, kInsulatorHeight_m}},
                      10),
           place({x, arm, 0.13f}));
  }
  return model;
}

Model make_power_line(const PowerLine& power) {
  Model model;
  const Model pole = make_utility_pole(power.pole);
  const std::vector<float> poles = stations(power.row);
  for (const float along : poles) {
    append(model, pole, place(power.row.path.point(along, power.row.offset_m), power.row.path.yaw(along)));
  }
  const float height = power.pole.height_m - kArmBelowTop_m + kInsulatorHeight_m;
  for (std::size_t i = 0; i + 1 < poles.size(); ++i) {
    for (const float x : kInsulators_m) {
      const glm::vec3 up(0.0f, height, 0.0f);
      const glm::vec3 from = power.row.path.point(poles[i], power.row.offset_m + x) + up;
      const glm::vec3 to = power.row.path.point(poles[i + 1], power.row.offset_m + x) + up;
      std::vector<glm::vec3> wire;
      constexpr int kPieces = 10;
      for (int k = 0; k <= kPieces; ++k) {
        const float t = float(k) / kPieces;
        const float sag = 0.02f * power.row.spacing_m * 4.0f * t * (1.0f - t);  // a parabola is a catenary this flat
        wire.push_back(glm::mix(from, to, t) - glm::vec3(0.0f, sag, 0.0f));
      }
      append(part(model, "paint_black"), make_tube(wire, 0.012f, 4));
    }
  }
  return model;
}

}  // namespace litfog::scene
