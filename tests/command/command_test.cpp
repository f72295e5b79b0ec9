// SPDX-License-Identifier: Apache-2.0
#include "command/command.h"
#include "command/uncaught.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace litfog::test {
using namespace command;

namespace {

template <typename Error>
int status_after(const Error& error) {
  CLI::App app{"", "litfog-test"};
  char name[] = "litfog-test";
  char* arguments[] = {name, nullptr};
  return run_command(app, 1, arguments, [&]() -> ExitStatus { throw error; });
}

TEST(Command, InternalFaultIsNotBlamedOnTheInput) {
  EXPECT_EQ(status_after(std::logic_error("shader")), kInternalError);
  EXPECT_EQ(status_after(std::out_of_range("vector")), kInternalError);
}

TEST(Command, ExceptionDeterminesTheStatus) {
  EXPECT_EQ(status_after(std::invalid_argument("error")), kBadInput);
  EXPECT_EQ(status_after(InputError({"a.json", 1, 1}, "a", "1", "must be 2")), kBadInput);
  EXPECT_EQ(status_after(MissingCapability("no OpenGL")), kMissingCapability);
  EXPECT_EQ(status_after(OutputError("full")), kCannotWrite);
}

TEST(Command, ShortMemoryIsNotBlamedOnTheInput) {
  const std::system_error no_memory(std::make_error_code(std::errc::not_enough_memory));
  testing::internal::CaptureStderr();
  EXPECT_EQ(status_after(std::bad_alloc()), kInternalError);
  EXPECT_EQ(status_after(no_memory), kInternalError);
  const std::string words = std::string(program_invocation_short_name) + ": out of memory\n";
  EXPECT_EQ(testing::internal::GetCapturedStderr(), words + words);
}

TEST(CommandDeathTest, ShortMemoryOutsideOfTheCommandEndsItInWords) {
  const auto run_short = [] {
    expect_uncaught();
    throw std::bad_alloc();
  };
  EXPECT_EXIT([&]() noexcept { run_short(); }(), testing::ExitedWithCode(kInternalError), "^[^ ]+: out of memory\n$");
}

}  // namespace

}  // namespace litfog::test
