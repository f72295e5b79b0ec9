// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace litfog::demo {

// clang-format off
/// A camera's smooth path through its keyframes: cubic, with the slope at a keyframe of the chord between its
/// neighbours. Files, version 1 (data/schemas has their JSON Schema):
///
///     {
///       "litfog": "camera-path",
///       "version": 1,
///       "keyframes": [                                   two or more
///         {"time_s": 0,                                  ascending, in [-1e9, 1e9]; even steps if none states it
///          "position": [0, 40, 500], "target": [0, 0, 0],
///          "field_of_view_deg": 50},                     optional: the scene's
///         ...
///       ]
///     }
// clang-format on
class CameraPath {
 public:
  struct Key {
    double seconds;
    glm::dvec3 position;
    glm::dvec3 target;
    double field_of_view;  ///< radians
  };

  /// keys  two or more, their times ascending
  explicit CameraPath(std::vector<Key> keys) : keys_(std::move(keys)) {}

  /// fraction  [0, 1] of the time from the first to the last keyframe
  scene::Camera at(double fraction) const;

 private:
  std::vector<Key> keys_;
};

/// Reads a path's file. Throws InputError.
///
/// field_of_view  radians, for keyframes that state none
CameraPath read_camera_path(const std::string& file, double field_of_view);

}  // namespace litfog::demo
