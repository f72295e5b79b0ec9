// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/plan/lighting_path.h"

namespace litfog::demo {

/// A scene drawn by a lighting path. Errors are in 1/255 against the path's own reference.
struct PathResult {
  const render::LightingPath* path;
  double milliseconds;  ///< median per frame
  double spread;        ///< frame times from the 10th to the 90th percentile
  double over_legacy;   ///< milliseconds over the legacy path's
  double largest_error;
  double mean_error;
  std::size_t excluded;  ///< pixels
};

/// A scene drawn by all paths, and the names of the picture files.
struct SceneResult {
  std::string name;
  std::string description;
  std::string conditions;  ///< text: the fog, and the display if not the default
  std::size_t lights;
  std::vector<PathResult> paths = {};  ///< the default path first

  std::string drawn_file(const render::LightingPath& path) const;
  std::string error_file(const render::LightingPath& path) const;
  /// SCENE-reference.png for the default path.
  std::string reference_file(const render::LightingPath& path) const;
  std::string sheet_file() const;
};

/// File names of all pictures of a scene.
std::vector<std::string> picture_files(const std::string& scene);

/// Facts common to all results of a page.
struct PageFacts {
  std::string machine;  ///< text: what drew the pictures
  int width;            ///< pixels
  int height;
  int frames;            ///< number timed for each path
  std::string settings;  ///< text: skipping, viewer, light maps
};

/// An HTML page that shows the results beside their pictures, which lie in its folder. Needs neither network nor
/// script.
std::string comparison_page(const PageFacts& facts, const std::vector<SceneResult>& scenes);

/// A scene drawn in one of the settings that a page compares.
struct SettingResult {
  std::string text;     ///< as given: "visibility=50 path=vertex"
  double milliseconds;  ///< median per frame
  double spread;        ///< frame times from the 10th to the 90th percentile
  std::string png;      ///< the picture as a file
};

/// The difference between the pictures of two settings, in 1/255.
struct PairResult {
  std::size_t first;
  std::size_t second;  ///< > first
  double largest;
  double mean;
  std::string png;  ///< the heat map as a file, of the pictures' size
};

/// Facts common to all settings of a page.
struct SettingsFacts {
  std::string title;    ///< text: the scene
  std::string machine;  ///< text: what drew the pictures
  int width;            ///< pixels
  int height;
  int frames;  ///< number timed for each setting
};

/// An HTML page that compares the pictures of any two settings: flips them, wipes from one to the other, shows their
/// difference, and zooms to pixels and their values. A single file with pictures and script, which opens from a disk
/// without a network.
///
/// settings  two or more
/// pairs     of all settings, first the pairs of the first setting, in order
std::string settings_page(const SettingsFacts& facts, const std::vector<SettingResult>& settings,
                          const std::vector<PairResult>& pairs);

}  // namespace litfog::demo
