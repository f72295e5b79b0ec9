// SPDX-License-Identifier: Apache-2.0
#include "command/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "command/exit_status.h"

namespace litfog::command {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// What a link stands for, whether that is there yet or not: the link itself is to stay.
fs::path behind_links(fs::path path) {
  constexpr int kMaxLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == kMaxLinks) throw CannotWrite(path.string() + ": cannot be written: is a link to itself");
    path = folder_of(path) / fs::read_symlink(path, error);
  }
  return path;
}

}  // namespace

void expect_place_for_file(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw CannotWrite(path + ": cannot be written: is a folder");
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, error)) throw CannotWrite(path + ": cannot be written: no folder " + folder.string());
}

void write_whole_file(const std::string& path, const std::function<void(const std::string& temporary)>& write) {
  const fs::path target = behind_links(path);
  expect_place_for_file(target.string());
  // A device (/dev/full, a pipe) cannot be replaced; it is written straight.
  std::error_code error;
  const bool is_special = fs::exists(target, error) && !fs::is_regular_file(target, error);
  if (is_special) return write(path);
  const std::string name = "." + target.stem().string() + "." + std::to_string(getpid()) + target.extension().string();
  const fs::path temporary = folder_of(target) / name;
  try {
    write(temporary.string());
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, target, error);
  if (!error) return;
  const std::string reason = error.message();
  fs::remove(temporary, error);
  throw CannotWrite(path + ": cannot be written: " + reason);
}

void write_whole_file(const std::string& path, std::string_view text) {
  write_whole_file(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw CannotWrite(path + ": cannot be written: " + std::strerror(errno));
  });
}

}  // namespace litfog::command
