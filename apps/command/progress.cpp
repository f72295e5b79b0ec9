// SPDX-License-Identifier: Apache-2.0
#include "command/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "command/printable.h"

namespace litfog::command {

using Clock = std::chrono::steady_clock;

Progress::Progress() : is_watched_(isatty(STDERR_FILENO) != 0), next_(Clock::now() + std::chrono::seconds(2)) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (is_shown_) std::fputs("\r\x1B[K", stderr);
  is_shown_ = false;
}

void Progress::print(std::string_view line) {
  clear();
  fmt::print(stderr, "{}\n", printable(line));
}

void Progress::show(std::string_view text) {
  if (!is_watched_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(200);
  fmt::print(stderr, "\r\x1B[K{}", printable(text));
  is_shown_ = true;
}

}  // namespace litfog::command
