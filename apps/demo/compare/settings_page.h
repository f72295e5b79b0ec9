// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace litfog::demo {

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
