// SPDX-License-Identifier: Apache-2.0
#include "files/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "command/temporary_directory.h"
#include "litfog/files/output_error.h"

namespace {

/// What fsync() of this program is called for, and how it, rename() and write() fail.
std::vector<std::filesystem::path>* synced = nullptr;
int sync_error = 0, rename_error = 0, write_error = 0;
bool is_write_short = false;

}  // namespace

extern "C" int fsync(int file) {
  if (synced != nullptr) synced->push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file)));
  if (sync_error != 0) {
    errno = sync_error;
    return -1;
  }
  return int(syscall(SYS_fsync, file));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  errno = rename_error;
  return rename_error != 0 ? -1 : int(syscall(SYS_rename, from, to));
}

/// Every other call is interrupted, and none writes more than a byte, where writing is short.
extern "C" ssize_t write(int file, const void* bytes, std::size_t size) {
  static bool is_interrupted = false;
  errno = write_error;
  if (write_error != 0) return -1;
  if (!is_write_short) return syscall(SYS_write, file, bytes, size);
  errno = EINTR;
  is_interrupted = !is_interrupted;
  return is_interrupted ? -1 : syscall(SYS_write, file, bytes, std::min<std::size_t>(size, 1));
}

namespace litfog::test {
using namespace files;

namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }
  std::size_t file_count() const { return std::size_t(std::distance(fs::directory_iterator(directory_.path()), {})); }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::perms mode(const std::string& name) const { return fs::status(path(name)).permissions(); }

 private:
  TemporaryDirectory directory_;
};

/// The status of a child process that runs a function, as waitpid() returns it.
int status_of_child(const std::function<void()>& run) {
  const pid_t child = fork();
  if (child == 0) {
    run();
    std::exit(0);  // not _Exit, by which coverage would lose what the child runs
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST_F(WholeFile, FileIsWrittenAndReplaced) {
  for (const std::string text : {"first", "second, longer", ""}) {
    write_whole_file(path("a"), text);
    EXPECT_EQ(read("a"), text);
  }
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, ReplacedFileKeepsItsMode) {
  const mode_t umask_before = umask(022);
  write_whole_file(path("a"), "new");
  EXPECT_EQ(mode("a"), fs::perms(0644));
  for (const fs::perms kept : {fs::perms(0600), fs::perms(0666), fs::perms(0640)}) {
    fs::permissions(path("a"), kept);
    write_whole_file(path("a"), "again");
    EXPECT_EQ(mode("a"), kept);
  }
  umask(umask_before);
}

TEST_F(WholeFile, LinkStaysAndItsTargetIsWritten) {
  fs::create_symlink("target", path("link"));  // which is not there yet
  write_whole_file(path("link"), "text");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read("target"), "text");
}

TEST_F(WholeFile, CircleOfLinksIsAnError) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_THROW(write_whole_file(path("a"), "text"), OutputError);
  EXPECT_TRUE(fs::is_symlink(path("a")));
}

TEST_F(WholeFile, FullDeviceIsAnError) { EXPECT_THROW(write_whole_file("/dev/full", "text"), OutputError); }

TEST_F(WholeFile, PlantedTemporaryIsNotOpened) {
  std::ofstream(path("victim")) << "precious";
  const std::string guess = "." + std::string("a.") + std::to_string(getpid()) + ".png";
  fs::create_symlink("victim", path(guess));
  write_whole_file(path("a.png"), "picture");
  EXPECT_EQ(read("victim"), "precious");
  EXPECT_TRUE(fs::is_symlink(path(guess)));
  EXPECT_EQ(read("a.png"), "picture");
}

TEST_F(WholeFile, NameMayBeAsLongAsTheFileSystemTakes) {
  const std::string longest = std::string(251, 'a') + ".png";
  write_whole_file(path(longest), "picture");
  EXPECT_EQ(read(longest), "picture");
  EXPECT_THROW(write_whole_file(path("a" + longest), "picture"), OutputError);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, PipeIsWrittenByAThread) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  auto writer = std::async(std::launch::async, [&] { write_whole_file(path("pipe"), "text"); });
  EXPECT_EQ(read("pipe"), "text");
  writer.get();
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(WholeFile, StandardOutputIsWritten) {
  const int status = status_of_child([&] {
    if (std::freopen(path("log").c_str(), "wb", stdout) == nullptr) std::_Exit(1);
    std::fputs("before\n", stdout);
    write_whole_file("/dev/stdout", "text\n");
    write_whole_file(path("log"), "again\n");
    std::fputs("behind\n", stdout);
    std::fflush(stdout);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read("log"), "before\ntext\nagain\nbehind\n");
}

TEST_F(WholeFile, FolderIsNotReplaced) {
  EXPECT_THROW(expect_writable(path("")), OutputError);
  EXPECT_THROW(write_whole_file(path(""), "text"), OutputError);
  EXPECT_THROW(write_whole_file(path("none/a"), "text"), OutputError);
}

TEST_F(WholeFile, FileThatCannotBeMadeIsNotWritable) {
  EXPECT_THROW(expect_writable("/proc/a"), OutputError);  // a folder that takes no files
  EXPECT_THROW(expect_writable(path("none/a")), OutputError);
}

TEST_F(WholeFile, OnlyAFileWithTextWouldBeReplaced) {
  EXPECT_FALSE(would_replace(path("a")));
  write_whole_file(path("a"), "");
  EXPECT_FALSE(would_replace(path("a")));
  write_whole_file(path("a"), "text");
  EXPECT_TRUE(would_replace(path("a")));
  EXPECT_FALSE(would_replace("/dev/null"));
}

TEST_F(WholeFile, TryingWhetherAFileIsWritableLeavesTheFolderAsItWas) {
  write_whole_file(path("a"), "earlier");
  expect_writable(path("a"));
  expect_writable(path("b"));
  expect_writable("/dev/full");
  EXPECT_EQ(read("a"), "earlier");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, LimitOfSizeLeavesNothingBehind) {
  write_whole_file(path("a"), "earlier");
  const int status = status_of_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_whole_file(path("a"), std::string(5000, 'x'));
    } catch (const OutputError&) {
      std::_Exit(4);
    }
  });
  EXPECT_EQ(WEXITSTATUS(status), 4);
  EXPECT_EQ(read("a"), "earlier");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, FileIsOnTheDiskBeforeItTakesItsNameAndThenItsFolder) {
  std::vector<fs::path> files;
  synced = &files;
  write_whole_file(path("a"), "text");
  synced = nullptr;
  ASSERT_EQ(files.size(), 2u);
  EXPECT_TRUE(files[0].filename().string().starts_with(".litfog-")) << files[0];
  EXPECT_EQ(files[0].parent_path(), fs::path(path("a")).parent_path());
  EXPECT_EQ(files[1], fs::path(path("a")).parent_path());
}

TEST_F(WholeFile, FileThatDoesNotReachTheDiskIsAnError) {
  write_whole_file(path("a"), "earlier");
  sync_error = EIO;
  EXPECT_THROW(write_whole_file(path("a"), "text"), OutputError);
  sync_error = EINVAL;  // from a file system that cannot tell
  write_whole_file(path("b"), "text");
  sync_error = 0;
  EXPECT_EQ(read("a"), "earlier");
  EXPECT_EQ(read("b"), "text");
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(WholeFile, FileThatCannotBeWrittenOrTakeItsNameIsAnErrorAndLeavesNothing) {
  write_whole_file(path("a"), "earlier");
  for (int* const error : {&write_error, &rename_error}) {
    for (const int reason : {EIO, ENOSPC, EDQUOT, EROFS}) {
      *error = reason;
      EXPECT_THROW(write_whole_file(path("a"), "text"), OutputError);
      *error = 0;
      EXPECT_EQ(read("a"), "earlier");
      EXPECT_EQ(file_count(), 1u);
    }
  }
}

TEST_F(WholeFile, WritingGoesOnWhereItWasInterrupted) {
  is_write_short = true;
  write_whole_file(path("a"), "some text");
  is_write_short = false;
  EXPECT_EQ(read("a"), "some text");
}

TEST_F(WholeFile, TemporaryOfAKilledProcessIsRemovedLater) {
  for (int attempt = 0; attempt < 5; ++attempt) {
    const pid_t child = fork();
    if (child == 0) {
      const std::string text(1 << 20, 'x');
      for (;;) write_whole_file(path("a"), text);
    }
    while (file_count() < 2) std::this_thread::yield();  // until a temporary is there
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    remove_stale_temporaries(path(""));
    EXPECT_LE(file_count(), 1u);
  }
}

TEST_F(WholeFile, TemporaryThatIsWrittenToIsNotRemoved) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string text(1 << 12, 'x');
    try {
      for (int i = 0; i < 100; ++i) write_whole_file(path("a"), text);
    } catch (const OutputError&) {
      std::_Exit(4);
    }
    std::_Exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) remove_stale_temporaries(path(""));
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(WholeFile, OnlyTemporariesAreRemoved) {
  const std::string stale = ".litfog-0123456789abcdef";
  for (const char* name : {"a", ".litfog-", ".litfog-0123456789abcdeg", ".litfog-0123456789abcdef0", "litfog"}) {
    std::ofstream(path(name)) << "text";
  }
  fs::create_symlink("a", path(".litfog-0000000000000001"));
  fs::create_directory(path(".litfog-0000000000000002"));
  ASSERT_EQ(mkfifo(path(".litfog-0000000000000003").c_str(), 0600), 0);
  std::ofstream(path(stale)) << "text";
  const std::size_t before = file_count();
  remove_stale_temporaries(path(""));
  EXPECT_EQ(file_count(), before - 1);
  EXPECT_FALSE(fs::exists(path(stale)));
  remove_stale_temporaries(path("none"));
}

}  // namespace

}  // namespace litfog::test
