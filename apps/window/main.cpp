// SPDX-License-Identifier: Apache-2.0
// litfog-window: looks at a scene in a window; started by litfog-demo window.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "command/command.h"
#include "command/option_rule.h"
#include "command/uncaught.h"
#include "drawing/drawing_options.h"
#include "drawing/picture_file.h"
#include "drawing/picture_options.h"
#include "files/whole_file.h"
#include "litfog/files/output_error.h"
#include "litfog/gl/unsupported.h"
#include "litfog/input_error.h"
#include "scene/file/gltf_scene.h"
#include "window/drawing_pace.h"
#include "window/lamp_panel.h"
#include "window/picture_maker.h"
#include "window/picture_panel.h"
#include "window/scene_changes.h"
#include "window/session.h"
#include "window/settings_panel.h"
#include "window/window.h"

namespace {

using namespace litfog;
using namespace litfog::command;
using namespace litfog::window;

constexpr double kFrameSeconds = 1.0 / 30;  // while something moves
constexpr double kRestSeconds = 0.5;
constexpr double kWordsStay = 10'000;  // milliseconds

constexpr const char* kDescription =
    R"(Shows a scene lit by lamps in fog in a window, in which fog, lighting, camera and lamps can be changed.

Drag the picture to orbit or look around, right-drag to pan; the wheel goes nearer. W A S D, Q and E fly,
with Shift faster. A click picks a lamp, Ctrl and dragging move it; Ctrl+Z undoes what has been done to lamps. Ctrl+P saves the picture, Ctrl+C copies the litfog-demo command that draws it, and
prints it.)";

constexpr const char* kFooter =
    R"(Example:
  litfog-demo window street --visibility 150

Exit status: 0 done; 1 wrong usage; 2 bad scene or light file; 3 no display, or no OpenGL 3.3 on it.)";

double now_in_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a frame drew and left out, in words.
std::string counts_in_words(const render::FrameCounts& counts) {
  return fmt::format(
      "surfaces {} drawn, {} out of view, {} hidden by fog  |  "
      "lamps on them {} lit, {} out of reach, {} hidden by fog  |  airlight {}, {} unseen",
      counts.chunks_drawn + counts.chunks_as_fog, counts.chunks_outside_view, counts.chunks_hidden,
      counts.lights_listed, counts.lights_out_of_reach, counts.lights_hidden, counts.airlights_drawn,
      counts.airlights_invisible);
}

/// The window's panels, and the pictures that they order.
class App {
 public:
  App(Session session, PictureMaker& maker) : session_(std::move(session)), maker_(maker) {}

  /// Draws a frame of the window.
  ///
  /// shortcuts  Window::begin_frame
  void draw(const std::string& shortcuts);
  /// How long the window may wait for an event, seconds.
  double rest() const;

 private:
  void take_delivery();
  void order_pictures();
  void keep(const Wishes& wishes);
  void save_picture();
  void save_scene();
  void copy_command();
  void draw_status() const;
  /// Shows words for a while.
  void say(const std::string& words);
  /// Says what has been done, on standard output, too.
  void tell(const std::string& words);
  render::Exposure shown_exposure() const;
  bool is_finished() const {
    return delivery_ && delivery_->order == session_.order(picture_.width(), picture_.height(), false);
  }

  Session session_;
  PictureMaker& maker_;
  PicturePanel picture_;
  DrawingPace pace_;
  std::optional<Delivery> delivery_;
  std::optional<PictureOrder> ordered_;
  std::optional<std::size_t> hovered_;  // index in the list of lamps
  double changed_at_ = 0;               // milliseconds
  bool wants_picture_ = false;          // to be saved when it is finished
  std::string words_;                   // what has last been done, or could not be
  double said_at_ = -kWordsStay;        // milliseconds
};

void App::take_delivery() {
  auto delivery = maker_.take();
  if (!delivery) return;
  if (!delivery->error.empty()) {
    say(delivery->error);
    wants_picture_ = false;
    return;
  }
  const int divisor = std::max(picture_.width() / std::max(delivery->order.width, 1), 1);
  pace_.learn(divisor, delivery->milliseconds);
  picture_.show(*delivery);
  delivery_ = std::move(delivery);
}

void App::order_pictures() {
  const PictureOrder whole = session_.order(picture_.width(), picture_.height(), false);
  const int divisor = pace_.divisor();
  const PictureOrder sketch =
      session_.order(std::max(whole.width / divisor, 1), std::max(whole.height / divisor, 1), divisor > 1);
  const double now = now_in_milliseconds();
  PictureOrder as_whole = ordered_.value_or(PictureOrder{});
  as_whole.width = whole.width;
  as_whole.height = whole.height;
  as_whole.is_sketch = false;
  if (as_whole != whole) {
    changed_at_ = now;
    ordered_ = divisor > 1 ? sketch : whole;
    maker_.order(*ordered_);
  } else if (*ordered_ != whole && now - changed_at_ > DrawingPace::kStillAfter && !maker_.is_busy()) {
    ordered_ = whole;
    maker_.order(whole);
  }
}

void App::draw(const std::string& shortcuts) {
  take_delivery();
  if (session_.runs) session_.set_time(session_.time() + std::min(double(ImGui::GetIO().DeltaTime), 0.1));
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize();
  const float side = std::min(font * 23, size.x / 2);
  const float bottom = std::min(font * 17, size.y / 2);
  const float status = ImGui::GetFrameHeight() + 4;
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
  const auto place = [](ImVec2 corner, ImVec2 extent) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize({std::max(std::floor(extent.x), 1.0f), std::max(std::floor(extent.y), 1.0f)});
  };

  place({0, 0}, {side, size.y});
  ImGui::Begin("settings", nullptr, kFixed & ~ImGuiWindowFlags_NoScrollbar);
  Wishes wishes = draw_settings(session_, shown_exposure());
  if (!wishes.complaint.empty()) say(wishes.complaint);
  ImGui::End();

  place({side, size.y - bottom}, {size.x - side, bottom});
  hovered_.reset();
  ImGui::Begin("lamps", nullptr, kFixed);
  draw_lamps(session_, hovered_);
  ImGui::End();

  place({side, size.y - bottom - status}, {size.x - side, status});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 5});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.12f, 0.125f, 0.14f, 1});
  ImGui::Begin("status", nullptr, kFixed);
  draw_status();
  ImGui::End();
  ImGui::PopStyleColor();

  place({side, 0}, {size.x - side, size.y - bottom - status});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("picture", nullptr, kFixed);
  picture_.draw(session_, maker_.surfaces(), hovered_);
  ImGui::End();
  ImGui::PopStyleVar(2);

  if (!ImGui::IsAnyItemActive()) session_.end_step();
  if (!ImGui::GetIO().WantTextInput) {  // letters that do not fly
    for (const char letter : shortcuts) {
      if (letter == 'Z') session_.undo();
      if (letter == 'Y') session_.redo();
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete)) && session_.picked &&
        session_.is_removable(*session_.picked)) {
      session_.remove(*session_.picked);
    }
    wishes.picture = wishes.picture || shortcuts.find('P') != shortcuts.npos;
    wishes.command = wishes.command || shortcuts.find('C') != shortcuts.npos;
  }
  order_pictures();
  keep(wishes);
}

void App::draw_status() const {
  const float right = ImGui::GetContentRegionMax().x;
  const bool has_words = now_in_milliseconds() - said_at_ < kWordsStay;
  if (!delivery_) {
    ImGui::TextDisabled("%s", has_words ? words_.c_str() : "drawing the first picture");
    return;
  }
  const std::size_t which = std::min(session_.edited, delivery_->pictures.size() - 1);
  const DrawnPicture& drawn = delivery_->pictures[which];
  const bool is_whole = delivery_->order.width == picture_.width();
  ImGui::Text("%s ms", fmt::format("{:.0f}", drawn.milliseconds).c_str());
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("A frame of %d x %d pixels on\n%s", delivery_->order.width, delivery_->order.height,
                      maker_.gl_renderer().c_str());
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", has_words ? words_.c_str() : counts_in_words(drawn.counts).c_str());
  const std::string sharpness = is_finished() ? ""
                                : is_whole    ? "drawing"
                                              : fmt::format("1/{} size", picture_.width() / delivery_->order.width);
  ImGui::SameLine(right - ImGui::CalcTextSize(sharpness.c_str()).x);
  ImGui::TextUnformatted(sharpness.c_str());
}

double App::rest() const {
  if (picture_.is_moving() || session_.runs) return kFrameSeconds;
  const double still_in = changed_at_ + DrawingPace::kStillAfter - now_in_milliseconds();
  return still_in > 0 ? still_in / 1000 + 0.005 : kRestSeconds;
}

render::Exposure App::shown_exposure() const {
  const drawing::DrawingOptions& options = session_.settings[session_.edited];
  render::Exposure exposure = options.display.display_for(session_.scene(), options.settings().fog_lighting).exposure;
  if (exposure.is_auto && delivery_ && session_.edited < delivery_->pictures.size()) {
    exposure.ev = delivery_->pictures[session_.edited].display.exposure.ev;
  }
  return exposure;
}

void App::say(const std::string& words) {
  words_ = words;
  said_at_ = now_in_milliseconds();
}

void App::tell(const std::string& words) {
  say(words);
  report(words + "\n");
}

void App::keep(const Wishes& wishes) {
  wants_picture_ = wants_picture_ || wishes.picture;
  try {
    if (wishes.command) copy_command();
    if (wishes.scene) save_scene();
    if (wants_picture_ && is_finished()) save_picture();
  } catch (const OutputError& error) {
    say(error.what());
  } catch (const InputError& error) {
    say(error.what());
  }
}

void App::save_picture() {
  wants_picture_ = false;
  const std::string path = free_file_name(session_.scene().name, ".png");
  const std::vector<DrawnPicture>& pictures = delivery_->pictures;
  drawing::write_picture(
      path, pictures.size() > 1 ? wiped(pictures[0].shown, pictures[1].shown, session_.wipe) : pictures[0].shown);
  tell(fmt::format("{}: {}x{}", path, picture_.width(), picture_.height()));
}

void App::save_scene() {
  const std::string& file = session_.scene().files.front();
  if (scene::is_gltf_path(file)) {
    say("a glTF file cannot be saved: copy the command line, which has the camera and the lamps");
    return;
  }
  const std::string path = free_file_name(session_.scene().name, ".json");
  files::write_whole_file(path, changed_scene(file, session_.own_camera(), session_.changes(), path));
  tell(path + ": the scene with its changes");
}

void App::copy_command() {
  const std::string command = to_string(session_.command(session_.edited, picture_.width(), picture_.height()));
  ImGui::SetClipboardText(command.c_str());
  tell(command);  // a clipboard may end with the window
}

struct Options {
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
};

ExitStatus show(const CLI::App& app, Options& options) {
  if (app.count("SCENE") == 0) throw CLI::ValidationError("a scene must be given: see litfog-demo list scenes");
  check_options(app, drawing::drawing_rules(options.drawing));
  scene::Scene scene = drawing::read_scene(options.scene);
  drawing::check_scene_options(app, scene);
  scene::Scene facts = scene;
  facts.models.clear();
  facts.instances.clear();
  facts.materials.clear();
  Window window("litfog: " + scene.name, options.drawing.width, options.drawing.height);
  PictureMaker maker(std::move(scene), &Window::wake);
  App shown(Session(options.scene, std::move(facts), options.drawing), maker);
  while (!window.is_closed()) {
    window.wait(shown.rest());
    shown.draw(window.begin_frame());
    window.end_frame();
  }
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  CLI::App app{kDescription, "litfog-window"};
  Options options;
  app.footer(kFooter);
  drawing::add_picture_options(app, options.scene, options.drawing);
  return run_command(app, argc, argv, [&] {
    try {
      return show(app, options);
    } catch (const gl::Unsupported& missing) {
      throw MissingCapability(missing.what());
    }
  });
}
