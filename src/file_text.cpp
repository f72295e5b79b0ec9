// SPDX-License-Identifier: Apache-2.0
#include "file_text.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "litfog/input_error.h"

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

}  // namespace

std::string read_file_text(const std::string& path, std::size_t max_bytes) {
  expect_no_device(path);  // before it is opened, which may already do something to it
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail(path, std::generic_category().message(errno));
  std::string text;
  std::array<char, 65536> chunk;
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    if (count > max_bytes - text.size()) {
      throw InputError({.file = path}, "file", "", "must not be larger than " + std::to_string(max_bytes) + " bytes");
    }
    text.append(chunk.data(), count);
  }
  if (std::ferror(file.get())) fail(path, std::generic_category().message(errno));
  return text;
}

}  // namespace litfog
