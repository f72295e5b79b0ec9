// SPDX-License-Identifier: Apache-2.0
#include "command/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <system_error>

#include "command/printable.h"

namespace litfog::command {
namespace {

std::mutex mutex;  // guards all that follows, and texts
bool is_shown = false;

void clear_line() {
  if (is_shown) std::fputs("\r\x1B[K", stderr);
  is_shown = false;
}

}  // namespace

Progress::Progress() {
  try {
    thread_ = std::jthread(
        [this](const std::stop_token& stop) { isatty(STDERR_FILENO) != 0 ? keep_shown(stop) : keep_log(stop); });
  } catch (const std::system_error&) {  // no thread is left: work goes on without a progress line
  }
}

Progress::~Progress() {
  thread_ = {};
  clear();
}

void Progress::clear() {
  const std::lock_guard lock(mutex);
  clear_line();
}

void Progress::print(std::string_view line) {
  const std::lock_guard lock(mutex);
  clear_line();
  fmt::print(stderr, "{}\n", printable(line));
}

void Progress::show(std::string_view text) {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex);
  text_ = text;
}

void Progress::keep_shown(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  std::chrono::milliseconds pause(2000);
  while (!stopped_.wait_for(lock, stop, pause, [&stop] { return stop.stop_requested(); })) {
    pause = std::chrono::milliseconds(200);
    if (text_.empty()) continue;
    std::fputs(("\r\x1B[K" + line()).c_str(), stderr);
    is_shown = true;
  }
}

void Progress::keep_log(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  std::chrono::seconds pause(5);
  while (!stopped_.wait_for(lock, stop, pause, [&stop] { return stop.stop_requested(); })) {
    pause *= 2;
    if (!text_.empty()) std::fputs((line() + "\n").c_str(), stderr);
  }
}

std::string Progress::line() const { return fmt::format("{} ({:.0f} s)", printable(text_), timer_.seconds()); }

}  // namespace litfog::command
