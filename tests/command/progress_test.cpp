// SPDX-License-Identifier: Apache-2.0
#include "command/progress.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "command/no_more_threads.h"

namespace litfog::command {
namespace {

/// A terminal that standard error goes to.
class Terminal {
 public:
  Terminal() {
    int terminal = -1;
    if (openpty(&reader_, &terminal, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no terminal");
    usual_ = dup(STDERR_FILENO);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
  }
  ~Terminal() {
    dup2(usual_, STDERR_FILENO);
    close(usual_);
    close(reader_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// What was written since the last call.
  std::string text() const {
    EXPECT_EQ(write(STDERR_FILENO, "!", 1), 1);
    std::string text;
    for (char c = 0; read(reader_, &c, 1) == 1 && c != '!';) text += c;
    return text;
  }

 private:
  int reader_ = -1;
  int usual_ = -1;
};

constexpr std::chrono::milliseconds kUntilShown(2300);

TEST(Progress, LineIsShownAfterTwoSecondsWhileTheCallerWaits) {
  const Terminal terminal;
  {
    Progress progress;
    progress.show("loading");
    progress.show("compiling\nshaders");
    EXPECT_EQ(terminal.text(), "");
    std::this_thread::sleep_for(kUntilShown);
    const std::string shown = terminal.text();
    EXPECT_TRUE(shown.starts_with("\r\x1B[Kcompiling\\x0ashaders (")) << shown;
    Progress::clear();
    EXPECT_TRUE(terminal.text().starts_with("\r\x1B[K"));
    progress.print("wrong");
    EXPECT_NE(terminal.text().find("wrong\r\n"), std::string::npos);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  EXPECT_TRUE(terminal.text().ends_with("\r\x1B[K"));
}

TEST(Progress, FileHasALineAfterFiveSeconds) {
  testing::internal::CaptureStderr();
  {
    Progress progress;
    progress.show("compiling");
    std::this_thread::sleep_for(std::chrono::milliseconds(5500));
    progress.show("drawing");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "compiling (5 s)\n");
}

TEST(Progress, NothingIsShownWhereNoThreadCanStart) {
  const Terminal terminal;
  const test::NoMoreThreads limit;
  Progress progress;
  progress.show("compiling");
  progress.print("wrong");
  EXPECT_EQ(terminal.text(), "wrong\r\n");
}

}  // namespace
}  // namespace litfog::command
