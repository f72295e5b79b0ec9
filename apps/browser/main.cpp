// SPDX-License-Identifier: Apache-2.0
// What the page's script (page/page.js) calls: the scene, its lamps, and the view of it. All numbers; angles in
// degrees.

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <exception>
#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "browser/street.h"
#include "browser/view.h"
#include "litfog/gl/unsupported.h"
#include "scene/paint/material_catalogue.h"
#include "scene/srgb.h"
#include "window/camera_motion.h"
#include "window/drawing_pace.h"
#include "window/range_curve.h"
#include "window/visibility_preset.h"

namespace litfog::browser {
namespace {

constexpr int kCurveSamples = 240;

/// Lights of a name: what the page changes together.
struct Lamp {
  std::vector<std::size_t> lights;
};

/// Everything that the page shows.
struct Session {
  scene::Scene scene = make_street();
  std::vector<std::string> unpainted;  // materials
  std::vector<Lamp> lamps;
  std::optional<View> view;
  Fog fog;
  render::Display display;
  FrameReport report;
  window::DrawingPace pace;

  Session() {
    std::set<std::string> names;
    for (const scene::Model& model : scene.models) {
      for (const scene::Part& part : model) names.insert(part.material);
    }
    unpainted.assign(names.rbegin(), names.rend());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      if (i == 0 || scene.lights[i].light.name != scene.lights[i - 1].light.name) lamps.emplace_back();
      lamps.back().lights.push_back(i);
    }
  }

  const PlacedLight& first_of(int lamp) const { return scene.lights[lamps[std::size_t(lamp)].lights.front()]; }
};

Session& session() {
  static Session session;
  return session;
}

/// values  of the profile's parameters, in their order; angles in degrees
Cone cone_of(ConeProfile profile, const std::array<double, kMaxConeParameters>& values) {
  Cone cone{.profile = profile};
  std::size_t i = 0;
  for (const ConeParameter& parameter : facts_of(profile).parameters) {
    const double value = values[i++];
    cone.*parameter.member = parameter.is_angle ? glm::radians(value) : value;
  }
  return cone;
}

}  // namespace

// Pointers are to what the next call of the same function overwrites.
extern "C" {

/// The sentence of an exception that has left one of these functions.
EMSCRIPTEN_KEEPALIVE const char* page_what(const std::exception* error) { return error->what(); }

/// Paints one of the materials that are left; returns how many are left then.
EMSCRIPTEN_KEEPALIVE int page_paint() {
  auto& unpainted = session().unpainted;
  if (!unpainted.empty()) {
    session().scene.materials.push_back(scene::make_material(unpainted.back()));
    unpainted.pop_back();
  }
  return int(unpainted.size());
}

/// Makes the view in the page's canvas. All materials are painted.
EMSCRIPTEN_KEEPALIVE void page_open() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.alpha = attributes.depth = attributes.antialias = false;
  const auto context = emscripten_webgl_create_context("#picture", &attributes);
  if (context <= 0) throw gl::Unsupported("this browser has no WebGL 2");
  emscripten_webgl_make_context_current(context);
  if (!emscripten_webgl_enable_extension(context, "EXT_color_buffer_float")) {
    throw gl::Unsupported("this browser's WebGL 2 has no EXT_color_buffer_float");
  }
  session().view.emplace(session().scene);
}

/// By what a moving view's picture is made smaller, and the milliseconds after which it is still.
EMSCRIPTEN_KEEPALIVE int page_divisor() { return session().pace.divisor(); }
EMSCRIPTEN_KEEPALIVE double page_still_after() { return window::DrawingPace::kStillAfter; }

/// Draws a frame of a size in pixels, which is the canvas's over a divisor, and waits for it; returns milliseconds.
EMSCRIPTEN_KEEPALIVE double page_draw(int width, int height, int divisor) {
  const double begin = emscripten_get_now();
  session().view->set_size(width, height);
  session().report = session().view->draw(session().fog, session().display);
  std::array<unsigned char, 4> pixel;
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());  // glFinish does not wait in browsers
  const double milliseconds = emscripten_get_now() - begin;
  session().pace.learn(divisor, milliseconds);
  return milliseconds;
}

/// What the last frame did: surfaces drawn, bytes of the lights' tables uploaded; and its exposure in EV.
EMSCRIPTEN_KEEPALIVE const double* page_report() {
  static std::array<double, 3> values;
  const FrameReport& report = session().report;
  values = {double(report.surfaces), double(report.bytes_uploaded), report.exposure};
  return values.data();
}

/// mode     -1 none, or FogMode
/// metres   visibility, [0, infinity]
/// returns  density, 1/m
EMSCRIPTEN_KEEPALIVE double page_set_fog(int mode, double metres, double contrast) {
  session().fog = mode < 0 ? Fog{} : Fog::from_visibility(FogMode(mode), metres, contrast);
  return session().fog.density;
}

EMSCRIPTEN_KEEPALIVE void page_set_airlight(bool has_airlight) {
  session().view->set_fog_lighting(has_airlight ? render::FogLighting::airlight : render::FogLighting::peak);
}

/// ev       exposure, within page_largest_exposure() either way
/// is_auto  each frame chooses its own in place of it
EMSCRIPTEN_KEEPALIVE void page_set_display(double ev, bool is_auto, bool is_neutral) {
  session().display = {.exposure = {.ev = ev, .is_auto = is_auto},
                       .tone = is_neutral ? render::ToneCurve::neutral : render::ToneCurve::clip};
}

EMSCRIPTEN_KEEPALIVE double page_largest_exposure() { return kMaxExposure; }
EMSCRIPTEN_KEEPALIVE double page_srgb(double linear) { return double{scene::srgb_from_linear(float(linear))}; }
EMSCRIPTEN_KEEPALIVE double page_linear(double srgb) { return double{scene::linear_from_srgb(float(srgb))}; }

/// The camera: position and target, three metres each.
EMSCRIPTEN_KEEPALIVE const double* page_camera() {
  static std::array<double, 6> values;
  const scene::Camera& camera = session().scene.camera;
  for (int i = 0; i < 3; ++i) {
    values[std::size_t(i)] = double{camera.position[i]};
    values[std::size_t(i) + 3] = double{camera.target[i]};
  }
  return values.data();
}
EMSCRIPTEN_KEEPALIVE void page_set_camera(double x, double y, double z, double to_x, double to_y, double to_z) {
  scene::Camera camera = session().scene.camera;
  camera.position = glm::dvec3(x, y, z);
  camera.target = glm::dvec3(to_x, to_y, to_z);
  if (scene::has_heading(camera)) session().scene.camera = camera;
}
EMSCRIPTEN_KEEPALIVE void page_look(double right_deg, double up_deg) {
  window::look(session().scene.camera, glm::radians(right_deg), glm::radians(up_deg));
}
EMSCRIPTEN_KEEPALIVE void page_orbit(double right_deg, double up_deg) {
  scene::Camera& camera = session().scene.camera;
  window::orbit(camera, camera.target, glm::radians(right_deg), glm::radians(up_deg));
}
EMSCRIPTEN_KEEPALIVE void page_fly(double right, double up, double ahead) {
  window::fly(session().scene.camera, right, up, ahead);
}
EMSCRIPTEN_KEEPALIVE void page_approach(double factor) {
  scene::Camera& camera = session().scene.camera;
  window::approach(camera, camera.target, factor);
}

EMSCRIPTEN_KEEPALIVE int page_lamp_count() { return int(session().lamps.size()); }
/// The name of its file in data/lights.
EMSCRIPTEN_KEEPALIVE const char* page_lamp_file(int lamp) { return session().first_of(lamp).light.name.c_str(); }
EMSCRIPTEN_KEEPALIVE int page_lamp_copies(int lamp) { return int(session().lamps[std::size_t(lamp)].lights.size()); }

/// Changes all lights of a lamp; returns what is wrong with the members, and then changes nothing, or nothing.
///
/// radius         of the source, metres
/// profile        ConeProfile
/// first, second  its parameters
EMSCRIPTEN_KEEPALIVE const char* page_set_lamp(int lamp, double red, double green, double blue, double constant,
                                               double linear, double quadratic, double threshold, double radius,
                                               int profile, double first, double second) {
  static std::string error;
  Light light = session().first_of(lamp).light;
  light.color = {red, green, blue};
  light.attenuation = {constant, linear, quadratic};
  light.threshold = threshold;
  light.source_radius = radius;
  light.cone = cone_of(ConeProfile(profile), {first, second});
  if (const auto wrong = find_error(light)) {
    error = to_string(*wrong);
    return error.c_str();
  }
  for (const std::size_t i : session().lamps[std::size_t(lamp)].lights) {
    session().scene.lights[i].light = light;
    session().view->set_light(i);
  }
  return nullptr;
}

/// The profiles of cones as JSON:
/// [{"name": "x", "parameters": [{"file": "x_deg", "label": "X", "isAngle": true, "ends": [0, 90], "first": 30}]}].
EMSCRIPTEN_KEEPALIVE const char* page_profiles() {
  static std::string text;
  text = "[";
  for (const ConeProfileFacts& facts : kConeProfiles) {
    text.append(text == "[" ? "" : ", ").append(R"({"name": ")").append(facts.name).append(R"(", "parameters": [)");
    for (const ConeParameter& each : facts.parameters) {
      const double first = facts.first.*each.member;
      text.append(&each == facts.parameters.data() ? "" : ", ");
      text.append(R"({"file": ")").append(each.file_name).append(R"(", "label": ")").append(each.label);
      text.append(R"(", "isAngle": )").append(each.is_angle ? "true" : "false").append(R"(, "ends": [)");
      text.append(std::to_string(each.control[0])).append(", ").append(std::to_string(each.control[1]));
      text.append(R"(], "first": )").append(std::to_string(each.is_angle ? glm::degrees(first) : first)).append("}");
    }
    text.append("]}");
  }
  text.append("]");
  return text.c_str();
}

/// A lamp's solve and its curve: intensity, peak range, extent, knee, end of the plot, number of samples; then of each
/// sample opacity, attenuation and their product.
EMSCRIPTEN_KEEPALIVE const double* page_curve(int lamp) {
  static std::vector<double> values;
  const window::RangeCurve curve =
      window::make_range_curve(session().first_of(lamp).light, session().fog, kCurveSamples);
  values = {curve.solved.intensity,      curve.solved.peak_range, curve.solved.extent, curve.knee, curve.end,
            double(curve.samples.size())};
  for (const window::RangeCurve::Sample& sample : curve.samples) {
    values.insert(values.end(), {sample.opacity, sample.attenuation, sample.product});
  }
  return values.data();
}

/// The visibility slider's ends and its presets.
EMSCRIPTEN_KEEPALIVE double page_least_visibility() { return window::kMinVisibility; }
EMSCRIPTEN_KEEPALIVE double page_most_visibility() { return window::kMaxVisibility; }
EMSCRIPTEN_KEEPALIVE int page_preset_count() { return int(window::kVisibilityPresets.size()); }
EMSCRIPTEN_KEEPALIVE const char* page_preset_name(int i) { return window::kVisibilityPresets[std::size_t(i)].name; }
/// mode  as of page_set_fog; returns metres of visibility
EMSCRIPTEN_KEEPALIVE double page_preset_metres(int i, int mode, double contrast) {
  return window::kVisibilityPresets[std::size_t(i)].visibility(FogMode(std::max(mode, 0)), contrast).value();
}
EMSCRIPTEN_KEEPALIVE const char* page_preset_meaning(int i) {
  return window::kVisibilityPresets[std::size_t(i)].meaning;
}

}  // extern "C"

}  // namespace litfog::browser
