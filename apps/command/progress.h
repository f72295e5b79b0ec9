// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <string>
#include <string_view>
#include <thread>

#include "command/wall_timer.h"

namespace litfog::command {

/// Progress on standard error: what is done, and for how long the whole has taken. A terminal has a line of it after
/// two seconds; a file or a pipe has one after 5 seconds and then after ever longer pauses, each twice the last. A
/// program has one at a time.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Replaces the text. The line goes on while the caller waits, for a driver that compiles or a file that is read.
  void show(std::string_view text);

  /// Prints a line that stays, on a terminal or not: an error that does not end the work.
  void print(std::string_view line);

  /// Takes away the line of the program's progress, until it is shown again: before something else is printed.
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
