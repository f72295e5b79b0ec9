// SPDX-License-Identifier: Apache-2.0
#include "scene/model/airfield.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/numeral.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kCell_m = 9.0f;  // the surface is cut into squares of about this size, for lighting per vertex
constexpr float kHalf_m = 0.5f * kRunwayWidth_m;
constexpr float kPiece_m = 15.0f;

/// A level surface from `left` to `right`, from -`from` to -`to` along Z.
Mesh make_level(float left, float right, float from, float to, float height, float cell) {
  const int columns = std::max(1, int(std::ceil((right - left) / cell)));
  const int rows = std::max(1, int(std::ceil((to - from) / cell)));
  std::vector<glm::vec3> points;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      points.emplace_back(glm::mix(left, right, float(i) / float(columns)), height,
                          -glm::mix(from, to, float(j) / float(rows)));
    }
  }
  Mesh mesh = make_surface(points, columns + 1);
  for (Vertex& vertex : mesh.vertices) vertex.uv = {vertex.position.x, -vertex.position.z};
  return mesh;
}

struct Stripe {
  float left, right, from, to;
};

void add_stripe(Mesh& paint, const Stripe& stripe, float lift) {
  append(paint, make_level(stripe.left, stripe.right, stripe.from, stripe.to, lift, kPiece_m));
}

/// A stripe on both sides of the centre line.
void add_pair(Mesh& paint, const Stripe& stripe, float lift) {
  add_stripe(paint, stripe, lift);
  add_stripe(paint, {-stripe.right, -stripe.left, stripe.from, stripe.to}, lift);
}

/// The markings of one end, from its threshold to the middle of the runway (annex 14, 5.2.2 to 5.2.6).
void add_half(Mesh& paint, const Runway& runway, int number) {
  const float lift = runway.lift_m;
  const float middle = 0.5f * runway.length_m;
  // Threshold: 12 stripes of 30 m for 45 m of width, 1.8 m wide and apart, twice that in the middle.
  for (int i = 0; i < 6; ++i) {
    const float left = 1.8f + 3.6f * float(i);
    add_pair(paint, {left, left + 1.8f, 6.0f, 36.0f}, lift);
  }
  // Designator: 9 m high, 12 m beyond the stripes, its top away from the landing pilot.
  glm::mat4 numeral = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, lift, -52.5f));
  numeral = glm::rotate(numeral, -glm::half_pi<float>(), glm::vec3(1, 0, 0));
  add_numeral(paint, number, 2, glm::scale(numeral, glm::vec3(5.4f, 9.0f, 1.0f)));
  // Centre line: 30 m stripes, 20 m gaps, from 12 m beyond the designator.
  for (float from = 69.0f; from < middle - 1.0f; from += 50.0f) {
    add_stripe(paint, {-0.45f, 0.45f, from, std::min(from + 30.0f, middle)}, lift);
  }
  // Aiming point: two blocks, 18 m apart, 300 m in; 400 m on runways from 2400 m.
  const float aiming = runway.length_m >= 2400.0f ? 400.0f : 300.0f;
  add_pair(paint, {9.0f, 17.0f, aiming, aiming + 50.0f}, lift);
  // Touchdown zone: pairs every 150 m, fewer bars the further in, none within 50 m of the aiming point.
  const float zone = std::min(900.0f, middle - 50.0f);
  for (int pair = 1; 150.0f * float(pair) <= zone; ++pair) {
    const float from = 150.0f * float(pair);
    if (std::abs(from - aiming) < 50.0f) continue;
    const int bars = pair <= 2 ? 3 : pair <= 4 ? 2 : 1;
    for (int bar = 0; bar < bars; ++bar) {
      const float left = 9.0f + 3.3f * float(bar);
      add_pair(paint, {left, left + 1.8f, from, from + 22.5f}, lift);
    }
  }
  // Side stripes.
  add_pair(paint, {kHalf_m - 1.2f, kHalf_m - 0.3f, 0.0f, middle}, lift);
  add_stripe(paint, {-kHalf_m + 0.3f, kHalf_m - 0.3f, 0.6f, 2.4f}, lift);
}

}  // namespace

Model make_runway(const Runway& runway) {
  Model model;
  part(model, "runway") = make_level(-kHalf_m, kHalf_m, 0.0f, runway.length_m, 0.0f, kCell_m);
  Mesh& shoulder = part(model, "asphalt");
  // Pavement goes on 60 m before each threshold; its edge falls off into the ground.
  constexpr float kOverrun_m = 60.0f;
  const float outer = kHalf_m + runway.shoulder_m;
  const float low = -0.02f;  // the joint between shoulder and runway is a small step, as on real ones
  for (const float side : {-1.0f, 1.0f}) {
    const float inner = side * kHalf_m;
    const float far = side * outer;
    append(shoulder, make_level(std::min(inner, far), std::max(inner, far), 0.0f, runway.length_m, low, kCell_m));
  }
  for (const float from : {-kOverrun_m, runway.length_m}) {
    append(shoulder, make_level(-outer, outer, from, from + kOverrun_m, low, kCell_m));
  }
  const glm::vec3 sides[] = {{0.0f, 0.0f, kOverrun_m}, {0.0f, 0.0f, -runway.length_m - kOverrun_m}};
  for (const float side : {-1.0f, 1.0f}) {
    std::vector<glm::vec2> edge{{side * (outer + 1.5f), -0.4f}, {side * outer, low}};
    if (side < 0.0f) std::reverse(edge.begin(), edge.end());
    append(part(model, "gravel"), make_sweep(edge, sides));
  }
  Mesh half;
  add_half(half, runway, runway.number);
  Mesh& paint = part(model, "road_paint");
  append(paint, half);
  Mesh other;
  const int opposite = (runway.number + 17) % 36 + 1;
  add_half(other, runway, opposite);
  append(paint, other, place({0.0f, 0.0f, -runway.length_m}, glm::pi<float>()));
  return model;
}

}  // namespace litfog::scene
