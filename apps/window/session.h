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
#include "litfog/airlight.h"
#include "scene/scene.h"
#include "window/command_line.h"
#include "window/picture_maker.h"

namespace litfog::window {

/// How dragging over the picture moves the camera.
enum class CameraMotion { fly, orbit };

/// The state that a user views and edits in a window, apart from how the window shows it.
class Session {
 public:
  /// given     the scene's source
  /// scene     meshes and materials are ignored
  /// settings  without a visibility, the runway visual range's or the scene's is taken
  Session(drawing::SceneOptions given, scene::Scene scene, const drawing::DrawingOptions& settings);

  // Two settings, A and B, which split views compare. B is a copy of A until the view is split for the first time.
  std::array<drawing::DrawingOptions, 2> settings;
  bool is_split = false;
  std::size_t edited = 0;  ///< index of the settings that the controls change; 0 except in split views
  double wipe = 0.5;       ///< boundary between A and B, a fraction of the width

  scene::Camera camera;
  bool is_false_colored = false;  ///< shows levels of light in false colours
  CameraMotion motion = CameraMotion::orbit;
  std::optional<std::size_t> picked;  ///< index of a light
  EyeRay ray;                         ///< the ray last under the mouse, with its end

  bool runs = false;  ///< whether time passes

  drawing::DrawingOptions& edited_settings() { return settings[edited]; }
  double time() const { return settings[0].seconds; }
  void set_time(double seconds);  ///< for both settings
  void split(bool on);
  /// Takes the settings of another session with the same scene, and its camera if that has been moved.
  void look_as(const Session& other);
  /// The scene's source, with all changes.
  drawing::SceneOptions given_now() const;

  const scene::Scene& scene() const { return scene_; }  ///< as given
  /// The scene's lights, removed ones black, then added lights.
  const std::vector<PlacedLight>& lights() const { return lamps_->lights; }
  /// A light as turned at the current time.
  PlacedLight light_now(std::size_t light) const;
  /// The number of lights that change together: the same member of the file states them.
  std::size_t copies(std::size_t light) const;
  /// The first light of each member that has not been removed.
  const std::vector<std::size_t>& firsts() const { return lamps_->firsts; }
  /// Whether two lights are one, or copies of each other. Neither may have been removed.
  bool are_copies(std::size_t a, std::size_t b) const { return lamps_->entries[a] == lamps_->entries[b]; }
  /// Replaces a light and its copies. The copies keep their names, and move with it. A city's light moves alone: it
  /// becomes an added light, which is picked if it was.
  ///
  /// changed  valid (find_error())
  void change(std::size_t light, const PlacedLight& changed);
  void reset(std::size_t light);  ///< a light of the scene, with its copies
  void reset_all();
  bool is_added(std::size_t light) const { return light >= scene_.lights.size(); }
  bool is_changed(std::size_t light) const;  ///< or added
  bool has_changes() const { return lamps_ != given_lamps_; }
  bool is_movable(std::size_t light) const;  ///< in the world: not on a vehicle
  bool is_of_city(std::size_t light) const;
  /// Adds a light and picks it.
  void add(const PlacedLight& light);
  void remove(std::size_t light);  ///< with its copies, but a city's alone

  // Undo and redo of all changes of lights. Changes until end_step() are one step.
  bool can_undo() const { return !undone_to_.empty(); }
  bool can_redo() const { return !redone_to_.empty(); }
  void undo() { step_back(undone_to_, redone_to_); }
  void redo() { step_back(redone_to_, undone_to_); }
  void end_step() { is_step_open_ = false; }
  /// All changes of the scene's file: the given ones, with the number of a city's lights, then the lights'.
  std::vector<scene::SceneChange> changes() const;

  /// The order for the settings' pictures. Sizes in pixels.
  PictureOrder order(int width, int height, bool is_sketch) const;
  /// The command that draws the same.
  DrawingCommand command(std::size_t which, int width, int height) const;
  /// The fog of one of the settings.
  Fog fog(std::size_t which) const;
  bool is_camera_moved() const;
  /// The camera if it differs from the scene file's.
  std::optional<scene::Camera> own_camera() const;

 private:
  struct Lamps {
    std::vector<PlacedLight> lights;
    std::vector<std::size_t> entries;  // one per light: Scene::light_entries, a number of each added light, or kRemoved
    std::vector<std::size_t> firsts;   // found_firsts()

    void add(const PlacedLight& light, std::size_t entry);
    void remove(std::size_t light);
    std::vector<std::size_t> found_firsts() const;
  };
  static constexpr auto kRemoved = std::size_t(-1);
  using Steps = std::vector<std::shared_ptr<const Lamps>>;

  /// The entry of a light that is added next.
  std::size_t next_entry() const { return scene_.light_members.size() + lights().size() - scene_.lights.size(); }
  void take(Lamps lamps);
  void step_back(Steps& from, Steps& to);
  void forget_removed_pick();

  drawing::SceneOptions given_;
  scene::Scene scene_;
  std::shared_ptr<const Lamps> given_lamps_;
  std::shared_ptr<const Lamps> lamps_;
  Steps undone_to_;
  Steps redone_to_;
  bool is_step_open_ = false;
  bool was_split_ = false;
};

/// Combines two pictures of one size: the left one up to a fraction of the width, then the right one.
render::Picture wiped(const render::Picture& left, const render::Picture& right, double fraction);

/// The first of STEM-1.ENDING, STEM-2.ENDING, ... that does not exist.
std::string free_file_name(const std::string& stem, const std::string& ending);

}  // namespace litfog::window
