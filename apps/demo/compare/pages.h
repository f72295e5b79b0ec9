// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/plan/lighting_path.h"

namespace litfog::demo {

/// What a lighting path made of a scene. Errors are in 1/255 against the path's own reference.
struct PathResult {
  const render::LightingPath* path;
  double milliseconds;  ///< a frame, the median
  double spread;        ///< frame times from the 10th to the 90th percentile
  double over_legacy;   ///< milliseconds over the legacy path's
  double largest_error;
  double mean_error;
  std::size_t excluded;  ///< pixels
};

/// What all paths made of a scene, and the names of their pictures' files.
struct SceneResult {
  std::string name;
  std::string description;
  std::string conditions;  ///< text: the fog, and the display where it is not the default
  std::size_t lights;
  std::vector<PathResult> paths = {};  ///< the default path first

  std::string drawn_file(const render::LightingPath& path) const;
  std::string error_file(const render::LightingPath& path) const;
  /// SCENE-reference.png for the default path.
  std::string reference_file(const render::LightingPath& path) const;
  std::string sheet_file() const;
};

/// Names of all pictures of a scene.
std::vector<std::string> picture_files(const std::string& scene);

/// What the results of a page have in common.
struct PageFacts {
  std::string machine;  ///< text: what drew the pictures
  int width;            ///< pixels
  int height;
  int frames;            ///< timed of each path
  std::string settings;  ///< text: skipping, viewer, light maps
};

/// An HTML page that shows the results beside their pictures, which lie in its folder. It needs nothing else, no
/// network and no script.
std::string comparison_page(const PageFacts& facts, const std::vector<SceneResult>& scenes);

/// A scene drawn in one of the settings that a page compares.
struct SettingResult {
  std::string text;     ///< as given: "visibility=50 path=vertex"
  double milliseconds;  ///< a frame, the median
  double spread;        ///< frame times from the 10th to the 90th percentile
  std::string png;      ///< the picture as a file
};

/// How far the pictures of two settings are apart, in 1/255.
struct PairResult {
  std::size_t first;
  std::size_t second;  ///< > first
  double largest;
  double mean;
  std::string png;  ///< the heat map, of the pictures' size, as a file
};

/// What the settings of a page have in common.
struct SettingsFacts {
  std::string title;    ///< text: the scene
  std::string machine;  ///< text: what drew the pictures
  int width;            ///< pixels
  int height;
  int frames;  ///< timed of each setting
};

/// An HTML page that shows the pictures of any two settings on each other: flips them, wipes from one to the other,
/// shows their difference, and zooms to pixels and their values. It is a single file, pictures and script included, and
/// opens from a disk without a network.
///
/// settings  two or more
/// pairs     of all settings, the first one's with each other one first and in their order
std::string settings_page(const SettingsFacts& facts, const std::vector<SettingResult>& settings,
                          const std::vector<PairResult>& pairs);

}  // namespace litfog::demo
