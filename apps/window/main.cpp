// SPDX-License-Identifier: Apache-2.0
// litfog-window: looks at a scene in a window; started by litfog-demo window.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <future>
#include <memory>
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
#include "text/shown_number.h"
#include "window/drawing_pace.h"
#include "window/key_sheet.h"
#include "window/lamp_panel.h"
#include "window/light_levels.h"
#include "window/own_files.h"
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
    "Shows a scene lit by lamps in fog in a window where fog, lighting, camera and lamps can be changed.";

constexpr const char* kFooter =
    R"(
Example:
  litfog-demo window street --visibility 150

Exit status: 0 done; 1 wrong usage; 2 bad scene or light file; 3 no display, or no OpenGL 3.3 on it.)";

double now_in_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string keys_in_words() {
  std::string words = "Mouse and keys:\n";
  for (const KeyMeaning& key : kKeyMeanings) words += fmt::format("  {:<16}{}\n", key.keys, key.meaning);
  return words;
}

/// The facts of a scene that the window keeps. The pictures' thread has the rest.
scene::Scene facts_of(const scene::Scene& scene) {
  scene::Scene facts = scene;
  facts.models.clear();
  facts.instances.clear();
  facts.materials.clear();
  return facts;
}

std::vector<std::filesystem::file_time_type> times_of(const std::vector<std::string>& files) {
  std::vector<std::filesystem::file_time_type> times;
  std::error_code error;  // a missing file gets a time, too
  for (const std::string& file : files) times.push_back(std::filesystem::last_write_time(file, error));
  return times;
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

/// The window's panels, and the pictures that they request.
class App {
 public:
  App(const drawing::SceneOptions& given, scene::Scene scene, const drawing::DrawingOptions& settings)
      : session_(given, facts_of(scene), settings), maker_(start(std::move(scene))) {}

  /// Draws a frame of the window.
  ///
  /// shortcuts  Window::begin_frame
  void draw(const std::string& shortcuts);
  /// Reads a scene and shows it.
  ///
  /// is_again  whether it is the scene shown, whose file has changed
  void open(const drawing::SceneOptions& given, bool is_again = false);
  /// The time that the window may wait for an event, seconds.
  double rest() const;

 private:
  struct Reading {
    drawing::SceneOptions given;
    bool is_again;
    std::future<scene::Scene> scene;
  };

  std::unique_ptr<PictureMaker> start(scene::Scene scene);
  void take_scene();
  void look_at_files();
  void take_delivery();
  void show_pictures();
  void order_pictures();
  void keep(const Wishes& wishes);
  void save_picture();
  void save_scene();
  void copy_command();
  void draw_status() const;
  void draw_key_sheet();
  std::string pixel_in_words(const DrawnPicture& drawn) const;
  /// Shows words for a while.
  void say(const std::string& words);
  /// Shows words for a while and prints them on standard output.
  void tell(const std::string& words);
  render::Exposure shown_exposure() const;
  bool is_finished() const {
    return delivery_ && delivery_->order == session_.order(picture_.width(), picture_.height(), false);
  }

  Session session_;
  std::vector<std::filesystem::file_time_type> file_times_;  // the scene's files'
  std::unique_ptr<PictureMaker> maker_;
  std::optional<Reading> reading_;
  PicturePanel picture_;
  DrawingPace pace_;
  std::optional<Delivery> delivery_;
  std::optional<PictureOrder> ordered_;
  std::optional<std::size_t> hovered_;  // index in the list of lamps
  double looked_at_ = 0;                // milliseconds
  double changed_at_ = 0;               // milliseconds
  bool wants_picture_ = false;          // saves the picture when it is finished
  bool shows_keys_ = false;
  bool was_false_colored_ = false;
  std::array<float, 64> histogram_{};  // the edited settings' picture's
  std::string words_;                  // the last result or error
  double said_at_ = -kWordsStay;       // milliseconds
};

std::unique_ptr<PictureMaker> App::start(scene::Scene scene) {
  file_times_ = times_of(scene.files);
  if (std::filesystem::path(scene.files.front()) != scene::bundled_scene_path(scene.name)) {
    remember_file(scene.files.front());
  }
  return std::make_unique<PictureMaker>(std::move(scene), &Window::wake);
}

void App::open(const drawing::SceneOptions& given, bool is_again) {
  say("reading " + given.scene);
  reading_ = {given, is_again, std::async(std::launch::async, [given] { return drawing::read_scene(given); })};
}

void App::take_scene() {
  if (!reading_ || reading_->scene.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  Reading reading = std::move(*reading_);
  reading_.reset();
  try {
    scene::Scene scene = reading.scene.get();
    drawing::DrawingOptions settings = session_.settings[0];
    settings.visibility.reset();  // the new scene suggests its own
    Session next(reading.given, facts_of(scene), settings);
    if (reading.is_again) next.look_as(session_);
    session_ = std::move(next);
    delivery_.reset();
    picture_.clear();
    ordered_.reset();
    hovered_.reset();
    maker_.reset();  // frees its memory before another takes as much
    maker_ = start(std::move(scene));
    say(reading.given.scene + (reading.is_again ? " has changed and was read again" : ""));
  } catch (const InputError& error) {
    say(error.what());
  } catch (const CLI::Error& error) {
    say(error.what());
  }
}

void App::look_at_files() {
  auto times = times_of(session_.scene().files);
  if (reading_ || times == file_times_) return;
  file_times_ = std::move(times);
  open(session_.given_now(), true);
}

void App::take_delivery() {
  auto delivery = maker_->take();
  if (!delivery) return;
  if (!delivery->error.empty()) {
    say(delivery->error);
    wants_picture_ = false;
    return;
  }
  const int divisor = std::max(picture_.width() / std::max(delivery->order.width, 1), 1);
  if (!delivery->is_rough) pace_.learn(divisor, delivery->milliseconds);
  delivery_ = std::move(delivery);
  show_pictures();
}

void App::show_pictures() {
  was_false_colored_ = session_.is_false_colored;
  picture_.show(*delivery_, was_false_colored_);
  const DrawnPicture& drawn = delivery_->pictures[std::min(session_.edited, delivery_->pictures.size() - 1)];
  histogram_ = light_histogram(drawn.light, drawn.display.exposure.ev);
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
    maker_->order(*ordered_);
  } else if (*ordered_ != whole && now - changed_at_ > DrawingPace::kStillAfter && !maker_->is_busy()) {
    ordered_ = whole;
    maker_->order(whole);
  }
}

void App::draw(const std::string& shortcuts) {
  if (now_in_milliseconds() - looked_at_ > 1000 * kRestSeconds) {
    looked_at_ = now_in_milliseconds();
    look_at_files();
  }
  take_scene();
  take_delivery();
  if (session_.runs) session_.set_time(session_.time() + std::min(double(ImGui::GetIO().DeltaTime), 0.1));
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize();
  const float status = ImGui::GetFrameHeight() + 4;
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
  const auto place = [](ImVec2 corner, ImVec2 extent) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize({std::max(std::floor(extent.x), 1.0f), std::max(std::floor(extent.y), 1.0f)});
  };

  // Two panels are resized by their edges, which ImGui keeps between runs.
  constexpr ImGuiWindowFlags kResized = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({font * 23, size.y}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({std::min(font * 12, size.x / 2), size.y}, {size.x / 2, size.y});
  ImGui::Begin("settings", nullptr, kResized);
  const float side = ImGui::GetWindowWidth();
  Wishes wishes = draw_settings(session_, shown_exposure(), histogram_);
  if (!wishes.complaint.empty()) say(wishes.complaint);
  if (!wishes.opened.empty()) open({.scene = wishes.opened});
  ImGui::End();

  ImGui::SetNextWindowPos({side, size.y}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({size.x - side, font * 17}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({size.x - side, std::min(font * 8, size.y / 2)}, {size.x - side, size.y / 2});
  hovered_.reset();
  ImGui::Begin("lamps", nullptr, kResized | ImGuiWindowFlags_NoScrollbar);
  const float bottom = ImGui::GetWindowHeight();
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
  picture_.draw(session_, maker_->surfaces(), hovered_);
  ImGui::End();
  ImGui::PopStyleVar(2);

  if (delivery_ && was_false_colored_ != session_.is_false_colored) show_pictures();
  if (shows_keys_) draw_key_sheet();
  if (!ImGui::IsAnyItemActive()) session_.end_step();
  const ImGuiIO& io = ImGui::GetIO();
  const std::string typed(std::size_t(std::ranges::count(io.InputQueueCharacters, ImWchar('?'))), Window::kHelp);
  if (!io.WantTextInput) {  // keys that do not fly
    for (const char letter : shortcuts + typed) {
      if (letter == 'f') session_.is_false_colored = !session_.is_false_colored;
      if (letter == Window::kHelp) shows_keys_ = !shows_keys_;
      if (letter == Window::kDelete && session_.picked) session_.remove(*session_.picked);
      if (letter == 'Z') session_.undo();
      if (letter == 'Y') session_.redo();
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
                      maker_->gl_renderer().c_str());
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", has_words          ? words_.c_str()
                            : picture_.mouse() ? pixel_in_words(drawn).c_str()
                                               : counts_in_words(drawn.counts).c_str());
  const std::string sharpness = is_finished()         ? ""
                                : delivery_->is_rough ? "without glow at first"
                                : is_whole            ? "drawing"
                                           : fmt::format("1/{} size", picture_.width() / delivery_->order.width);
  ImGui::SameLine(right - ImGui::CalcTextSize(sharpness.c_str()).x);
  ImGui::TextUnformatted(sharpness.c_str());
}

std::string App::pixel_in_words(const DrawnPicture& drawn) const {
  const render::Picture& light = drawn.light;
  const glm::dvec2 at = *picture_.mouse();
  const int x = std::clamp(int(at.x * light.width), 0, light.width - 1);
  const int y = std::clamp(int(at.y * light.height), 0, light.height - 1);
  const std::size_t i = 3 * (std::size_t(y) * std::size_t(light.width) + std::size_t(x));
  const float* const rgb = &light.rgb[i];
  const std::uint8_t* const shown = &drawn.pixels[i];
  const double range = session_.ray.length;
  return fmt::format("{}, {}: light {:.4g} {:.4g} {:.4g}, {:+.1f} EV of white  |  shown {} {} {}  |  {}", x, y, rgb[0],
                     rgb[1], rgb[2], light_level(rgb, drawn.display.exposure.ev), shown[0], shown[1], shown[2],
                     std::isfinite(range) ? shown_rounded(range, 4) + " m" : "sky");
}

void App::draw_key_sheet() {
  ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x / 2, 2 * ImGui::GetFontSize()}, ImGuiCond_Always, {0.5f, 0});
  if (ImGui::Begin(
          "Mouse and keys", &shows_keys_,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
    ImGui::BeginTable("keys", 2);
    for (const KeyMeaning& key : kKeyMeanings) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(key.keys);
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", key.meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

double App::rest() const {
  if (picture_.is_moving() || session_.runs || reading_) return kFrameSeconds;
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
  tell(command);  // the clipboard may be lost with the window
}

struct Options {
  drawing::SceneOptions scene;
  drawing::DrawingOptions drawing;
};

ExitStatus show(const CLI::App& app, Options& options) {
  if (app.count("SCENE") == 0) throw CLI::ValidationError("a scene must be given: see litfog-demo list scenes");
  check_options(app, drawing::drawing_rules(options.drawing));
  Window::prepare();
  auto reading = std::async(std::launch::async, [&options] { return drawing::read_scene(options.scene); });
  std::optional<Window> window;  // opened while the scene is read, because each takes tenths of a second
  std::exception_ptr no_window;
  try {
    window.emplace("litfog", options.drawing.width, options.drawing.height, app.count("--size") == 0);
  } catch (const MissingCapability&) {
    no_window = std::current_exception();
  }
  scene::Scene scene = reading.get();  // a wrong scene is reported rather than a missing display
  drawing::check_scene_options(app, scene);
  if (no_window) std::rethrow_exception(no_window);
  window->show();
  App shown(options.scene, std::move(scene), options.drawing);
  while (!window->is_closed()) {
    window->wait(shown.rest());
    for (const std::string& file : window->take_dropped()) shown.open({.scene = file});
    shown.draw(window->begin_frame());
    window->end_frame();
  }
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  CLI::App app{kDescription, "litfog-window"};
  Options options;
  app.footer(keys_in_words() + kFooter);
  drawing::add_picture_options(app, options.scene, options.drawing);
  return run_command(app, argc, argv, [&] {
    try {
      return show(app, options);
    } catch (const gl::Unsupported& missing) {
      throw MissingCapability(missing.what());
    }
  });
}
