// SPDX-License-Identifier: Apache-2.0
#include "scene/model/street_life.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/model/numeral.h"
#include "scene/model/primitive.h"

namespace litfog::scene {
namespace {

constexpr float kAxle_m = 1.28f;  // before and behind the middle
constexpr float kWheel_m = 0.31f;
constexpr float kArch_m = 0.365f;
constexpr float kSill_m = 0.24f;

/// The body's outline at a station along z.
struct Station {
  float z;
  float half_width;
  float belt;   ///< height of the shoulder
  float crown;  ///< height in the middle
};
constexpr std::array<Station, 13> kBody{{{-2.15f, 0.62f, 0.53f, 0.56f},
                                         {-2.12f, 0.73f, 0.61f, 0.66f},
                                         {-2.02f, 0.80f, 0.70f, 0.755f},
                                         {-1.75f, 0.845f, 0.77f, 0.83f},
                                         {-1.30f, 0.865f, 0.83f, 0.895f},
                                         {-0.85f, 0.875f, 0.885f, 0.945f},
                                         {-0.30f, 0.88f, 0.905f, 0.95f},
                                         {1.00f, 0.88f, 0.93f, 0.96f},
                                         {1.60f, 0.875f, 0.945f, 0.97f},
                                         {1.95f, 0.855f, 0.945f, 0.97f},
                                         {2.07f, 0.825f, 0.93f, 0.955f},
                                         {2.13f, 0.79f, 0.90f, 0.925f},
                                         {2.15f, 0.74f, 0.86f, 0.885f}}};

Station station_at(float z) {
  std::size_t i = 1;
  while (i + 1 < kBody.size() && kBody[i].z < z) ++i;
  const Station& a = kBody[i - 1];
  const Station& b = kBody[i];
  const float t = glm::clamp((z - a.z) / (b.z - a.z), 0.0f, 1.0f);
  return {z, glm::mix(a.half_width, b.half_width, t), glm::mix(a.belt, b.belt, t), glm::mix(a.crown, b.crown, t)};
}

/// Lower edge of the side: the sill, cut out over the wheels.
float lower_edge(float z) {
  const float to_axle = std::min(std::abs(z - kAxle_m), std::abs(z + kAxle_m));
  if (to_axle >= kArch_m) return kSill_m;
  return std::max(kSill_m, kWheel_m + std::sqrt(kArch_m * kArch_m - to_axle * to_axle));
}

/// Half of a cross-section: from the lower edge over the shoulder to the middle of the top.
std::array<glm::vec2, 8> half_section(const Station& s) {
  const float low = std::min(lower_edge(s.z), s.belt - 0.08f);
  const float w = s.half_width;
  const float waist = std::max(low + 0.01f, 0.55f * s.belt + 0.02f);
  return {glm::vec2(0.965f * w, low),
          glm::vec2(w, glm::mix(low, waist, 0.5f)),
          glm::vec2(w, waist),
          glm::vec2(0.985f * w, glm::mix(waist, s.belt, 0.6f)),
          glm::vec2(0.965f * w, s.belt - 0.025f),
          glm::vec2(0.90f * w, s.belt),
          glm::vec2(0.5f * w, glm::mix(s.belt, s.crown, 0.8f)),
          glm::vec2(0.0f, s.crown)};
}

Mesh make_shell() {
  std::vector<float> zs;
  for (const Station& s : kBody) zs.push_back(s.z);
  for (const float axle : {-kAxle_m, kAxle_m}) {
    for (int i = 0; i <= 12; ++i) {
      const float turn = glm::pi<float>() * float(i) / 12.0f;
      zs.push_back(axle - (kArch_m + (i == 0 || i == 12 ? 0.002f : 0.0f)) * std::cos(turn));
    }
  }
  std::sort(zs.begin(), zs.end());
  zs.erase(std::unique(zs.begin(), zs.end(), [](float a, float b) { return b - a < 0.004f; }), zs.end());
  std::vector<glm::vec3> points;
  for (const float z : zs) {
    const auto half = half_section(station_at(z));
    for (const glm::vec2& p : half) points.emplace_back(p.x, p.y, z);
    for (std::size_t i = half.size() - 1; i-- > 0;) points.emplace_back(-half[i].x, half[i].y, z);
  }
  const int columns = 2 * int(half_section(kBody[0]).size()) - 1;
  Mesh shell = make_surface(points, columns);
  std::vector<glm::vec3> front(points.begin(), points.begin() + columns);
  std::vector<glm::vec3> back(points.end() - columns, points.end());
  Mesh ends;
  for (auto* outline : {&front, &back}) {
    // Whichever way round: the ends look away from the middle.
    const glm::vec3 normal = glm::cross((*outline)[3] - (*outline)[0], (*outline)[7] - (*outline)[0]);
    if (normal.z * (*outline)[0].z < 0.0f) std::reverse(outline->begin(), outline->end());
    add_face(ends, *outline);
  }
  // Seen from inside through the wheel arches.
  add_back_faces(shell);
  append(shell, ends);
  return shell;
}

/// The cabin: glass between pillars under a curved roof.
void add_cabin(Model& model, std::string_view paint) {
  // Corners of the right half: at the belt and at the roof, front to back. B pillar in between.
  const std::array<glm::vec3, 3> low{glm::vec3(0.77f, 0.90f, -0.86f), glm::vec3(0.80f, 0.92f, 0.42f),
                                     glm::vec3(0.76f, 0.94f, 1.98f)};
  const std::array<glm::vec3, 3> high{glm::vec3(0.56f, 1.40f, -0.08f), glm::vec3(0.59f, 1.425f, 0.50f),
                                      glm::vec3(0.54f, 1.37f, 1.52f)};
  const glm::vec3 mirror(-1.0f, 1.0f, 1.0f);
  Mesh& glass = part(model, "glass");
  Mesh& body = part(model, paint);
  add_face(glass, {low[0] * mirror, high[0] * mirror, high[0], low[0]});  // windscreen
  add_face(glass, {low[2], high[2], high[2] * mirror, low[2] * mirror});  // rear window
  for (const float side : {1.0f, -1.0f}) {
    Mesh half;
    for (std::size_t i = 0; i < 2; ++i) {
      add_face(half, {low[i], high[i], high[i + 1], low[i + 1]});
    }
    const glm::mat4 at = glm::scale(glm::mat4(1.0f), glm::vec3(side, 1.0f, 1.0f));
    append(glass, half, at);
    Mesh frame;
    const float widths[] = {0.075f, 0.085f, 0.16f};
    const float inwards[] = {0.015f, 0.0f, 0.02f};
    for (std::size_t i = 0; i < 3; ++i) {
      append(frame, make_beam(low[i] - glm::vec3(inwards[i], 0.03f, 0), high[i] - glm::vec3(inwards[i], 0.02f, 0),
                              widths[i], 0.05f, glm::vec3(1, 0, 0)));
    }
    for (std::size_t i = 0; i < 2; ++i) append(frame, make_beam(high[i], high[i + 1], 0.07f, 0.06f));
    append(body, frame, at);
    // Mirror.
    Mesh mirror_shell;
    append(mirror_shell, make_bevelled_box({0.2f, 0.13f, 0.1f}, 0.03f), place({0.96f, 0.93f, -0.62f}));
    append(body, mirror_shell, at);
    Mesh reflecting;
    append(reflecting, make_box({0.16f, 0.09f, 0.004f}), place({0.96f, 0.95f, -0.567f}));
    append(glass, reflecting, at);
  }
  std::vector<glm::vec3> roof;
  constexpr int kColumns = 9;
  constexpr int kRows = 8;
  for (int j = 0; j < kRows; ++j) {
    const float t = float(j) / (kRows - 1);
    const glm::vec3 edge =
        t < 0.36f ? glm::mix(high[0], high[1], t / 0.36f) : glm::mix(high[1], high[2], (t - 0.36f) / 0.64f);
    for (int i = 0; i < kColumns; ++i) {
      const float s = 1.0f - 2.0f * float(i) / (kColumns - 1);
      // Flat at both ends, where the straight edges of the windows end under it.
      const float crown = (0.06f * (1.0f - s * s) + 0.015f) * std::sqrt(std::max(0.0f, std::sin(glm::pi<float>() * t)));
      roof.emplace_back(1.07f * edge.x * s, edge.y + 0.005f + crown,
                        edge.z + (t < 0.01f   ? -0.05f
                                  : t > 0.99f ? 0.06f
                                              : 0.0f));
    }
  }
  append(body, make_surface(roof, kColumns));
}

void add_wheel(Model& model, const glm::mat4& at) {
  // Turned about Y, then laid on its side: the outside at +Y becomes +X.
  const glm::mat4 turned = glm::rotate(at, -glm::half_pi<float>(), glm::vec3(0, 0, 1));
  append(part(model, "rubber"),
         make_lathe({{0.19f, -0.2f},
                     {kWheel_m - 0.02f, -0.2f},
                     {kWheel_m, -0.18f},
                     {kWheel_m, -0.02f},
                     {kWheel_m - 0.03f, 0.005f},
                     {0.215f, 0.0f},
                     {0.205f, -0.02f}},
                    28),
         turned);
  append(part(model, "paint_black"), make_lathe({{0.21f, -0.05f}, {0.0f, -0.05f}}, 20), turned);
  Mesh& rim = part(model, "galvanised");
  append(rim, make_lathe({{0.21f, -0.01f}, {0.185f, 0.0f}, {0.18f, -0.05f}}, 28), turned);
  append(rim, make_lathe({{0.06f, -0.04f}, {0.05f, 0.0f}, {0.0f, 0.005f}}, 12), turned);
  for (int i = 0; i < 5; ++i) {
    const float turn = glm::two_pi<float>() * float(i) / 5.0f;
    const glm::vec3 out(std::sin(turn), 0.0f, std::cos(turn));
    append(rim, make_beam(0.04f * out - glm::vec3(0, 0.02f, 0), 0.19f * out - glm::vec3(0, 0.025f, 0), 0.055f, 0.03f),
           turned);
  }
}

/// A dark seam around half the body at z: the edge of a door.
void add_seam(Mesh& mesh, float z, float side) {
  const auto half = half_section(station_at(z));
  for (std::size_t i = 0; i + 3 < half.size(); ++i) {
    const glm::vec2 along = glm::normalize(half[i + 1] - half[i]);
    const glm::vec2 lift = 0.003f * glm::vec2(along.y, -along.x);
    const glm::vec3 a(half[i] + lift, z);
    const glm::vec3 b(half[i + 1] + lift, z);
    const glm::vec3 wide(0.0f, 0.0f, 0.009f);
    Mesh strip;
    add_face(strip, {a, b, b + wide, a + wide});
    add_back_faces(strip);
    append(mesh, strip, glm::scale(glm::mat4(1.0f), glm::vec3(side, 1.0f, 1.0f)));
  }
}

void add_ends(Model& model, const Car& car) {
  const bool on = car.lights != 0;
  Mesh& black = part(model, "paint_black");
  for (const float end : {1.0f, -1.0f}) {
    append(black, make_bevelled_box({1.56f, 0.2f, 0.26f}, 0.06f), place({0.0f, 0.27f, end * 2.07f}));
    append(part(model, "sign_white"), make_box({0.5f, 0.11f, 0.008f}),
           place({0.0f, end > 0.0f ? 0.60f : 0.36f, end * (end > 0.0f ? 2.155f : 2.205f)}));
  }
  const glm::mat4 plate = glm::scale(place({0.08f, 0.655f, 2.162f}), glm::vec3(0.07f));
  add_numeral(black, car.number, 2, plate);
  add_numeral(black, (car.number * 7) % 100, 2, glm::translate(plate, glm::vec3(-2.6f, 0.0f, 0.0f)));
  append(black, make_box({0.66f, 0.16f, 0.004f}), place({0.0f, 0.575f, 2.151f}));
  append(part(model, "galvanised"), make_bevelled_box({0.5f, 0.025f, 0.03f}, 0.008f), place({0.0f, 0.745f, 2.15f}));
  const glm::vec3 exhaust[] = {{0.5f, 0.24f, 1.9f}, {0.5f, 0.24f, 2.22f}};
  append(part(model, "galvanised"), make_tube(exhaust, 0.03f, 10));
  for (const float side : {-1.0f, 1.0f}) {
    const float turned = side * 0.42f;
    append(part(model, on ? "lamp_red" : "reflector_red"), make_bevelled_box({0.2f, 0.2f, 0.1f}, 0.025f),
           place({side * 0.705f, 0.70f, 2.112f}, turned));
    append(part(model, "reflector_amber"), make_bevelled_box({0.2f, 0.07f, 0.1f}, 0.02f),
           place({side * 0.705f, 0.625f, 2.112f}, turned));
    append(part(model, "reflector_white"), make_bevelled_box({0.11f, 0.07f, 0.08f}, 0.02f),
           place({side * 0.545f, 0.625f, 2.125f}, turned));
    append(part(model, on ? "lamp_white" : "glass"), make_bevelled_box({0.3f, 0.13f, 0.14f}, 0.04f),
           place({side * 0.58f, 0.545f, -2.08f}, -turned));
  }
  append(black, make_bevelled_box({0.7f, 0.09f, 0.06f}, 0.02f), place({0.0f, 0.49f, -2.13f}));
}

}  // namespace

Model make_car(const Car& car) {
  Model model;
  const std::string_view paint = kCarPaints[car.paint];
  part(model, paint) = make_shell();
  add_cabin(model, paint);
  Mesh& black = part(model, "paint_black");
  append(black, make_box({1.24f, 0.5f, 3.9f}), place({0.0f, 0.2f, 0.0f}));
  for (const float side : {-1.0f, 1.0f}) {
    for (const float z : {-0.72f, 0.46f, 1.42f}) {
      if (lower_edge(z) <= kSill_m + 0.2f) add_seam(black, z, side);
    }
    for (const float z : {0.34f, 1.28f}) {
      append(part(model, "galvanised"), make_bevelled_box({0.02f, 0.025f, 0.15f}, 0.006f),
             place({side * 0.872f, 0.76f, z}));
    }
    for (const float z : {-kAxle_m, kAxle_m}) {
      add_wheel(model, place({side * 0.83f, kWheel_m, z}, side > 0.0f ? 0.0f : glm::pi<float>()));
    }
  }
  add_ends(model, car);
  return model;
}

}  // namespace litfog::scene
