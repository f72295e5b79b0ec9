// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string_view>

namespace litfog::command {

/// A sign of life on standard error, where somebody watches, of what takes more than two seconds.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the text in place of the last one, at most five times a second.
  void show(std::string_view text);

 private:
  bool is_watched_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace litfog::command
