// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string_view>

namespace litfog::command {

/// Progress on standard error of what takes more than two seconds, if that is a terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Replaces the text shown, at most five times a second.
  void show(std::string_view text);

  /// Prints a line that stays, on a terminal or not: an error that does not end the work.
  void print(std::string_view line);

 private:
  void clear();

  bool is_watched_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace litfog::command
