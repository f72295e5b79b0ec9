// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>

#include "command/command.h"
#include "command/progress.h"
#include "command/standard_output.h"
#include "demo/compare/pages.h"
#include "drawing/drawing.h"
#include "drawing/heat_map.h"
#include "drawing/picture_file.h"
#include "drawing/picture_folder.h"
#include "drawing/picture_options.h"
#include "files/hint.h"
#include "files/whole_file.h"
#include "litfog/input_error.h"
#include "measure/frame_times.h"
#include "measure/picture_error.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::demo {
namespace {

constexpr const char* kPageFile = "index.html";

void add_options(CLI::App& app, Setting& setting) {
  app.set_help_flag();
  drawing::add_picture_options(app, setting.scene, setting.drawing);
}

/// Words of a setting as the command line's arguments.
std::vector<std::string> arguments_of(const std::string& text, const CLI::App& app) {
  std::vector<std::string> arguments;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string option = "--" + word.substr(0, equals);
    const bool is_option = app.get_option_no_throw(option) != nullptr;
    if (word.starts_with("--") || (!arguments.empty() && arguments.back() == "--set")) {
      arguments.push_back(word);
    } else if (equals == word.npos) {
      arguments.push_back(is_option ? option : word);
    } else if (is_option) {
      arguments.insert(arguments.end(), {option, word.substr(equals + 1)});
    } else {
      arguments.insert(arguments.end(), {"--set", word});
    }
  }
  std::ranges::reverse(arguments);  // the order that CLI11 takes
  return arguments;
}

using Unused = std::set<std::string>;  // options of the command line that no setting has used so far

/// Removes from `unused` the command line's options that change the setting's picture: all except those that the
/// setting states itself and those without effect on it.
///
/// own  whether the setting states an option itself
template <typename IsOwn>
void take_used(Unused& unused, const drawing::DrawingOptions& drawing, const IsOwn& is_own) {
  std::erase_if(unused, [&, rules = drawing::drawing_rules(drawing)](const std::string& option) {
    const bool is_excluded = std::ranges::any_of(rules, [&](const command::OptionRule& rule) {
      return rule.applies && std::ranges::find(rule.excluded, option) != rule.excluded.end();
    });
    return !is_excluded && !is_own(option);
  });
}

Setting parse_setting(const Setting& base, const std::string& text, Unused& unused) {
  Setting setting = base;
  setting.text = text;
  CLI::App app;
  add_options(app, setting);
  try {
    auto arguments = arguments_of(text, app);
    if (arguments.empty()) throw CLI::ValidationError("must not be empty");
    app.parse(arguments);
    command::check_options(app, drawing::drawing_rules(setting.drawing));
    command::check_options(app, {{"--with", true, {"--size"}, "all pictures are of one size"}});
  } catch (const CLI::ParseError& error) {
    throw CLI::ValidationError(fmt::format("--with \"{}\": {}", text, error.what()));
  }
  take_used(unused, setting.drawing, [&app](const std::string& option) {
    return option != "--set" && app.count(option) > 0;  // members add up
  });
  return setting;
}

/// The error of an unknown member, with the option that the setting's word may have meant.
std::string with_option_hint(const std::string& text, const std::string& error) {
  CLI::App app;
  Setting any;
  add_options(app, any);
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    std::ranges::copy(option->get_lnames(), std::back_inserter(names));
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string name = word.substr(0, word.find('='));
    if (error.find(fmt::format(" \"{}\": must be one of ", name)) == error.npos) continue;
    const std::string hint = files::hint_for_word(name, {names.begin(), names.end()});
    return hint.empty() ? error : error.substr(0, error.find("; did you mean")) + hint;
  }
  return error;
}

/// Reads the scene of a setting. Errors in a view or a member quote the setting's text.
scene::Scene read_scene_of(const Setting& setting, scene::SceneParts& kept) {
  try {
    return drawing::read_scene(setting.scene, &kept);
  } catch (const CLI::ValidationError& error) {
    throw CLI::ValidationError(fmt::format("--with \"{}\": {}", setting.text, error.what()));
  } catch (const InputError& error) {
    const bool is_of_member = error.location().file.starts_with(scene::kChangePlace);
    if (!is_of_member || setting.text.find('=') == std::string::npos) throw;
    throw InputError({.file = fmt::format("--with \"{}\"", setting.text)},
                     with_option_hint(setting.text, error.what()));
  }
}

/// Throws the usage error of a --time or --lights that changes nothing in any scene.
void expect_effects(const std::vector<Setting>& settings, const std::deque<scene::Scene>& scenes) {
  const bool has_time = std::ranges::any_of(settings, [](const Setting& each) { return each.drawing.seconds > 0; });
  if (has_time && std::ranges::none_of(scenes, drawing::changes_with_time)) {
    throw CLI::ValidationError("--time cannot be given: none of the scene's lights turns or flashes");
  }
  const bool has_lights = std::ranges::any_of(settings, [](const Setting& each) { return each.scene.city_lights > 0; });
  if (has_lights && std::ranges::none_of(scenes, &scene::Scene::has_city)) {
    throw CLI::ValidationError("--lights cannot be given: the scene has no generated city");
  }
}

struct SettingRenderer {
  std::unique_ptr<render::Renderer> renderer;
  drawing::Display display;  // an automatic exposure has been chosen
};

/// The first setting with an automatic exposure sets it for all.
std::vector<SettingRenderer> make_renderers(const std::vector<Setting>& settings,
                                            const std::deque<scene::Scene>& scenes) {
  std::vector<SettingRenderer> renderers;
  std::optional<double> automatic;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const drawing::DrawingOptions& drawing = settings[i].drawing;
    auto renderer = std::make_unique<render::Renderer>(scenes[i], drawing.width, drawing.height, drawing.settings());
    renderer->set_atmosphere(drawing.atmosphere_of(scenes[i], drawing.visibility_in(scenes[i])));
    drawing::Display display = drawing.display.display_for(scenes[i], renderer->settings().fog_lighting);
    if (display.exposure.is_auto && automatic) display.exposure = {.ev = *automatic};
    display.exposure = renderer->set_exposure(display.exposure);
    if (display.exposure.is_auto) automatic = display.exposure.ev;
    renderers.push_back({std::move(renderer), display});
  }
  return renderers;
}

/// Compares each picture with each later one, the pairs of the first picture first.
std::vector<PairResult> compare_pairs(const std::vector<render::Picture>& pictures, const measure::Progress& progress) {
  std::vector<PairResult> pairs;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (std::size_t k = i + 1; k < pictures.size(); ++k) {
      progress(fmt::format("comparing {} and {}", i + 1, k + 1));
      const measure::PictureError error = measure::picture_error(pictures[k], pictures[i]);
      pairs.push_back({.first = i,
                       .second = k,
                       .largest = error.largest,
                       .mean = error.mean,
                       .png = drawing::png_text(drawing::heat_picture(error))});
    }
  }
  return pairs;
}

/// pairs  the first setting's first
void report_results(const std::vector<SettingResult>& results, const std::vector<PairResult>& pairs) {
  const std::size_t widest =
      std::ranges::max(results, {}, [](const auto& each) { return each.text.size(); }).text.size();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string apart =
        i == 0 ? ""
               : fmt::format("; from 1: largest {:.3g}, mean {:.3g} of 1/255", pairs[i - 1].largest, pairs[i - 1].mean);
    command::report(fmt::format("{}: {:<{}} {:>8} ms{}\n", i + 1, results[i].text, widest,
                                measure::milliseconds_text(results[i].milliseconds), apart));
  }
}

}  // namespace

std::vector<Setting> parse_settings(const CLI::App& app, const Setting& base, const std::vector<std::string>& texts) {
  if (texts.size() > kMaxSettings) {
    throw CLI::ValidationError(fmt::format("--with: must be given at most {} times", kMaxSettings));
  }
  Unused unused;
  CLI::App picture;
  Setting any;
  add_options(picture, any);
  for (const CLI::Option* option : picture.get_options()) {
    const CLI::Option* const given = app.get_option_no_throw(option->get_name());
    if (!option->get_positional() && given && given->count() > 0) unused.insert(option->get_name());
  }
  std::vector<Setting> settings;
  if (texts.size() == 1) {
    settings.push_back(base);
    take_used(unused, base.drawing, [](const std::string&) { return false; });
  }
  for (const std::string& text : texts) settings.push_back(parse_setting(base, text, unused));
  if (unused.empty()) return settings;
  throw CLI::ValidationError(*unused.begin() + " has no effect on any of these settings");
}

void compare_settings(const std::vector<Setting>& settings, const std::string& folder, const std::string& machine,
                      int frames) {
  const drawing::DrawingOptions& first = settings.front().drawing;
  std::deque<scene::Scene> scenes;  // renderers keep their addresses
  scene::SceneParts kept;
  std::vector<std::string> inputs;
  for (const Setting& setting : settings) {
    scene::Scene& scene = scenes.emplace_back(read_scene_of(setting, kept));
    scene::move_to_time(scene, setting.drawing.seconds);
    inputs.insert(inputs.end(), scene.files.begin(), scene.files.end());
  }
  expect_effects(settings, scenes);
  const drawing::PictureFolder page(folder, {kPageFile}, inputs);

  command::Progress shown;
  const measure::Progress progress = [&shown](std::string_view step) { shown.show(step); };
  progress(measure::kCompiling);
  const std::vector<SettingRenderer> renderers = make_renderers(settings, scenes);
  std::vector<measure::DrawFrame> draws;
  for (const SettingRenderer& each : renderers) draws.push_back(measure::frames_of(*each.renderer));
  const std::vector<measure::FrameTimes> times =
      measure::time_frames(draws, measure::FrameBudget::exactly(frames), progress);

  std::vector<render::Picture> pictures;
  std::vector<SettingResult> results;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    render::Renderer& renderer = *renderers[i].renderer;
    pictures.push_back(
        drawing::displayed(drawing::whole_light(renderer, renderer.read()), scenes[i].camera, renderers[i].display));
    results.push_back({.text = settings[i].text,
                       .milliseconds = times[i].median(),
                       .spread = times[i].spread(),
                       .png = drawing::png_text(pictures[i])});
  }
  const std::vector<PairResult> pairs = compare_pairs(pictures, progress);
  report_results(results, pairs);
  const std::string file = page.path_of(kPageFile);
  files::write_whole_file(file, settings_page({.title = scenes.front().name,
                                               .machine = machine,
                                               .width = first.width,
                                               .height = first.height,
                                               .frames = frames},
                                              results, pairs));
  command::report(fmt::format("{} shows them\n", file));
}

}  // namespace litfog::demo
