// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demo/sequence/camera_path.h"
#include "demo/sequence/course.h"
#include "drawing/drawing_options.h"
#include "drawing/scene_options.h"

namespace litfog::demo {

/// A member of the scene file in each frame.
struct MemberCourse {
  scene::SceneChange change;
  std::optional<Course<double>> numbers;  ///< replaces the change's value
};

/// What changes from frame to frame.
struct SequenceOptions {
  std::string scene;  ///< as drawing::SceneOptions::scene
  std::vector<MemberCourse> members = {};
  std::optional<Course<double>> visibility = {};  ///< metres; default: the scene's
  std::optional<Course<double>> seconds = {};     ///< the scene's time; default: 0
  std::optional<Course<glm::dvec3>> camera = {};  ///< default: the scene's, like the three that follow
  std::optional<Course<glm::dvec3>> target = {};
  std::optional<Course<double>> field_of_view_deg = {};
  std::string camera_path = {};  ///< a file that replaces these three
  int frames = 0;                ///< 0: as a course asks for, else kDefaultFrames
  int frames_per_second = 12;
  std::string film = {};  ///< a file, beside the folder; empty: none
};

inline constexpr int kDefaultFrames = 24;

/// Adds --set, --visibility, --time, the camera's options, --frames, --fps and --film.
void add_sequence(CLI::App& app, SequenceOptions& options);

/// A scene in each frame of a sequence.
class Sequence {
 public:
  /// Reads the scene of every frame, and keeps the first. The options must outlive this object. Throws InputError, and
  /// usage errors of options that do not belong together or make an impossible frame.
  explicit Sequence(const SequenceOptions& options);

  const SequenceOptions& options() const { return options_; }
  int frames() const { return frames_; }
  const scene::Scene& scene() const { return scene_; }  ///< as in the frame last shown; keeps its address
  double visibility(int frame) const;                   ///< metres
  std::string text(int frame) const;                    ///< all that changes: "visibility 400 m, time 0.5 s"
  bool moves_camera() const { return moves_camera_; }
  bool moves_lights() const { return moves_lights_; }
  bool changes_members() const { return changes_members_; }  ///< members of the scene's file
  bool changes_objects() const { return changes_objects_; }  ///< the scene's, or its generated city

  /// Changes the scene to that of a frame. Carried lights move with the camera, from their positions in the first
  /// frame. Throws InputError if a file has changed since the sequence was made.
  void show(int frame);

 private:
  scene::Scene read(int frame);
  scene::Camera camera(int frame) const;
  void expect_heading(int frame) const;
  void move_lights(int frame);

  const SequenceOptions& options_;
  int frames_;
  scene::SceneParts parts_;
  scene::Scene scene_;
  scene::Camera own_camera_;      // the file's, in the frame last shown
  scene::Camera vehicle_camera_;  // the file's in frame 0; the carried lights are relative to it
  std::optional<CameraPath> path_;
  bool changes_members_ = false;
  bool changes_objects_ = false;
  bool moves_camera_ = false;
  bool moves_lights_ = false;
  std::vector<PlacedLight> lights_;  // at rest, like what follows
  std::map<std::size_t, scene::CookieUse> cookie_uses_;
};

/// Draws every frame into a folder (made if missing): SCENE-0001.png and so on, SCENE.apng, which plays them, and the
/// film, if asked for. One renderer draws all frames. Reports every frame on standard output. Needs a current GL
/// context. Throws OutputError, and MissingCapability if a film cannot be made.
///
/// sequence  shows its first frame
/// drawing   the first frame sets an automatic exposure for all
void draw_sequence(Sequence& sequence, const std::string& folder, const drawing::DrawingOptions& drawing);

}  // namespace litfog::demo
