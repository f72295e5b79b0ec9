// SPDX-License-Identifier: Apache-2.0
#include "text/file_text.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <fstream>
#include <new>
#include <thread>

#include "command/temporary_directory.h"
#include "litfog/input_error.h"
#include "text/system_reason.h"

namespace litfog::test {
namespace {

class FileText : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  static std::string error_of(const std::string& path, std::size_t max_bytes = 100) {
    try {
      read_file_text(path, max_bytes);
    } catch (const InputError& error) {
      EXPECT_EQ(error.location().file, path);
      EXPECT_EQ(error.location().line, 0u);
      return error.what();
    }
    return "none";
  }

  TemporaryDirectory directory_;
};

TEST(SystemReason, ShortMemoryIsNoReasonOfAFile) {
  EXPECT_EQ(system_reason(ENOENT), "No such file or directory");
  EXPECT_THROW(system_reason(ENOMEM), std::bad_alloc);
  EXPECT_THROW(system_reason(std::make_error_code(std::errc::not_enough_memory)), std::bad_alloc);
}

TEST_F(FileText, EveryByteIsRead) {
  std::string bytes(200'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = char(i % 251);
  EXPECT_EQ(read_file_text(directory_.write("bytes", bytes), bytes.size()), bytes);
  EXPECT_EQ(read_file_text(directory_.write("empty", ""), 0), "");
  EXPECT_EQ(read_file_start(directory_.write("long", "abcdef"), 3), "abc");
  EXPECT_EQ(read_file_start(directory_.write("short", "ab"), 3), "ab");
}

TEST_F(FileText, FileLargerThanTheLimitIsAnError) {
  const std::string file = directory_.write("lamp", "1234567");
  EXPECT_EQ(read_file_text(file, 7), "1234567");
  EXPECT_EQ(error_of(file, 6), file + ": file: must not be larger than 6 bytes");
  const std::string sparse = directory_.write("sparse", "");
  std::filesystem::resize_file(sparse, std::uintmax_t{1} << 40);
  EXPECT_EQ(error_of(sparse), sparse + ": file: must not be larger than 100 bytes");
}

TEST_F(FileText, PipeThatAThreadWritesIsReadToItsEnd) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "from a pipe"; });
  EXPECT_EQ(read_file_text(pipe, 100), "from a pipe");
  writer.join();
}

TEST_F(FileText, PipeThatNobodyWritesToIsAnError) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of(pipe), pipe + ": cannot be read: Is a pipe that nobody writes to");
}

TEST_F(FileText, MissingFileFolderOrDeviceIsAnError) {
  EXPECT_EQ(error_of(path("absent")), path("absent") + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_of(path("")), path("") + ": cannot be read: Is a directory");
  for (const char* device : {"/dev/zero", "/dev/null"}) {
    EXPECT_EQ(error_of(device), std::string(device) + ": cannot be read: Is a device");
  }
}

}  // namespace
}  // namespace litfog::test
