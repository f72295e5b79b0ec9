// SPDX-License-Identifier: Apache-2.0
#include "file_text.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "litfog/input_error.h"
#include "system_reason.h"

namespace litfog {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw InputError({.file = path}, "cannot be read: " + reason);
}

void expect_no_device(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_character_file(status) || fs::is_block_file(status)) fail(path, "Is a device");
}

/// Whether a pipe has a writer, or has had one since it was opened. A byte read to find out is returned in `byte`.
bool has_writer(int pipe, std::optional<char>& byte) {
  constexpr int kPatience = 1000;  // milliseconds
  pollfd polled{.fd = pipe, .events = POLLIN, .revents = 0};
  if (poll(&polled, 1, kPatience) != 0) return true;
  char next = 0;
  const ssize_t count = ::read(pipe, &next, 1);
  if (count == 1) byte = next;
  return count != 0;  // -1 with EAGAIN: a writer that has written nothing yet
}

/// A file's first bytes, and whether it has more.
std::pair<std::string, bool> read(const std::string& path, std::size_t max_bytes) {
  expect_no_device(path);  // first, because opening a device may have effects
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_file(path), std::fclose);
  std::string text;
  std::array<char, 65536> chunk;
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    const std::size_t taken = std::min(count, max_bytes - text.size());
    text.append(chunk.data(), taken);
    if (taken < count) return {std::move(text), true};
  }
  if (std::ferror(file.get())) fail(path, system_reason(errno));
  return {std::move(text), false};
}

}  // namespace

std::FILE* open_file(const std::string& path) {
  const int opened = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  struct stat status {};
  std::FILE* const file = opened >= 0 && fstat(opened, &status) == 0 ? fdopen(opened, "rb") : nullptr;
  if (!file) {
    const int error = errno;
    if (opened >= 0) close(opened);
    fail(path, system_reason(error));
  }
  std::optional<char> byte;
  if (S_ISFIFO(status.st_mode) && !has_writer(opened, byte)) {
    std::fclose(file);
    fail(path, "Is a pipe that nobody writes to");
  }
  if (byte) std::ungetc(static_cast<unsigned char>(*byte), file);
  fcntl(opened, F_SETFL, O_RDONLY);
  return file;
}

std::string read_file_text(const std::string& path, std::size_t max_bytes) {
  auto [text, has_more] = read(path, max_bytes);
  if (!has_more) return std::move(text);
  throw InputError({.file = path}, "file", "", "must not be larger than " + std::to_string(max_bytes) + " bytes");
}

std::string read_file_start(const std::string& path, std::size_t max_bytes) { return read(path, max_bytes).first; }

}  // namespace litfog
