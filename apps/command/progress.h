// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <string>
#include <string_view>
#include <thread>

#include "command/wall_timer.h"

namespace litfog::command {

/// Progress on standard error: the current step and the time so far. A terminal shows a line after two seconds; a file
/// or a pipe gets one after 5 seconds and then after ever longer pauses, each twice the last. One at a time per
/// program.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Replaces the text. The line is updated while the caller waits for a driver or a file.
  void show(std::string_view text);

  /// Prints a line that stays, on a terminal or not: an error that does not end the work.
  void print(std::string_view line);

  /// Clears the program's progress line until it is shown again. Call it before printing something else.
  static void clear();

 private:
  void keep_shown(const std::stop_token& stop);  // on a terminal
  void keep_log(const std::stop_token& stop);    // elsewhere
  std::string line() const;

  std::string text_;
  WallTimer timer_;
  std::condition_variable_any stopped_;
  std::jthread thread_;
};

}  // namespace litfog::command
