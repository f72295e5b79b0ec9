// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"
#include "scene/scene.h"
#include "window/command_line.h"
#include "window/picture_maker.h"

namespace litfog::window {

/// How dragging over the picture moves the camera.
enum class CameraMotion { fly, orbit };

/// What a person looks at and changes in a window, apart from how the window shows it.
class Session {
 public:
  /// given     where the scene is from
  /// scene     of which meshes and materials do not matter
  /// settings  without a visibility that of the runway visual range is taken, or the scene's own
  Session(drawing::SceneOptions given, scene::Scene scene, const drawing::DrawingOptions& settings);

  // Two settings, A and B, which split views compare. B is a copy of A until the view is split for the first time.
  std::array<drawing::DrawingOptions, 2> settings;
  bool is_split = false;
  std::size_t edited = 0;  ///< which of them the controls change: 0 but in split views
  double wipe = 0.5;       ///< where A ends and B begins, a fraction of the width

  scene::Camera camera;
  CameraMotion motion = CameraMotion::orbit;
  std::optional<std::size_t> picked;  ///< index of a light

  drawing::DrawingOptions& edited_settings() { return settings[edited]; }
  void split(bool on);

  const scene::Scene& scene() const { return scene_; }  ///< as it was given
  const std::vector<PlacedLight>& lights() const { return *lights_; }
  /// How many lights change with one: those that the same member of the file states.
  std::size_t copies(std::size_t light) const;
  /// The first light of each such member.
  const std::vector<std::size_t>& firsts() const { return firsts_; }
  /// Whether two lights are one, or copies of each other.
  bool are_copies(std::size_t a, std::size_t b) const { return scene_.light_entries[a] == scene_.light_entries[b]; }
  /// Takes another light in the place of one, and of its copies. Those keep their names.
  ///
  /// changed  it is valid (find_error())
  void change(std::size_t light, const Light& changed);
  void reset(std::size_t light) { change(light, scene_.lights[light].light); }
  bool is_changed(std::size_t light) const;
  /// What has been changed of the scene's file: what was given, with the number of a city's lights, and then the
  /// lights.
  std::vector<scene::SceneChange> changes() const;

  /// What the settings draw, in pixels.
  PictureOrder order(int width, int height, bool is_sketch) const;
  /// The command that draws the same.
  DrawingCommand command(std::size_t which, int width, int height) const;
  /// The fog of one of the settings.
  Fog fog(std::size_t which) const;
  bool is_camera_moved() const;
  /// The camera if it is not that of the scene's file.
  std::optional<scene::Camera> own_camera() const;

 private:
  drawing::SceneOptions given_;
  scene::Scene scene_;
  std::vector<std::size_t> firsts_;
  std::shared_ptr<const std::vector<PlacedLight>> lights_;
  bool was_split_ = false;
};

/// A picture whose left part, up to a fraction of the width, is one picture's and whose right part another's of the
/// same size.
render::Picture wiped(const render::Picture& left, const render::Picture& right, double fraction);

/// The first of STEM-1.ENDING, STEM-2.ENDING... that is no file yet.
std::string free_file_name(const std::string& stem, const std::string& ending);

}  // namespace litfog::window
