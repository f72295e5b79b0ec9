// SPDX-License-Identifier: Apache-2.0
#include "files/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <random>
#include <utility>

#include "litfog/files/output_error.h"
#include "text/system_reason.h"

namespace litfog::files {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const std::string& path, const std::string& reason) {
  throw OutputError(fmt::format("{}: cannot be written: {}", path, reason));
}

constexpr std::string_view kTemporaryBegin = ".litfog-";
constexpr std::size_t kTemporaryDigits = 16;  // hexadecimal

bool is_temporary(std::string_view name) {
  return name.starts_with(kTemporaryBegin) && name.size() == kTemporaryBegin.size() + kTemporaryDigits &&
         name.find_first_not_of("0123456789abcdef", kTemporaryBegin.size()) == name.npos;
}

/// Returns whether the written data has reached the disk, else errno says why not. A file system that cannot tell
/// counts as success.
bool sync(int file) {
  while (fsync(file) != 0) {
    if (errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP) return true;
    if (errno != EINTR) return false;
  }
  return true;
}

/// Syncs a folder's names. A folder that may not be read cannot be synced.
bool sync_folder(const fs::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return true;
  const bool is_synced = sync(file);
  const int reason = errno;
  close(file);
  errno = reason;
  return is_synced;
}

/// An empty file with an unguessable name. It is removed unless it has been renamed. While open it is locked, so that
/// remove_stale_temporaries() leaves it alone.
class TemporaryFile {
 public:
  /// mode  as for open(): the process's umask applies
  TemporaryFile(const fs::path& folder, mode_t mode) {
    do {
      make(folder, mode);
    } while (is_open() && !lock());
  }
  ~TemporaryFile() {
    if (file_ >= 0) close(file_);
    if (is_there_) unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  // Each returns whether it succeeded, else errno says why not.
  bool is_open() const { return file_ >= 0; }
  bool set_mode(mode_t mode) const { return fchmod(file_, mode) == 0; }
  bool fill(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(file_, text.data(), text.size());
      if (written < 0 && errno != EINTR) return false;
      text.remove_prefix(std::size_t(std::max<ssize_t>(written, 0)));
    }
    return sync(file_);
  }
  bool rename_to(const fs::path& target) {
    is_there_ = rename(path_.c_str(), target.c_str()) != 0;
    return !is_there_;
  }

 private:
  void make(const fs::path& folder, mode_t mode) {
    std::random_device random;
    path_ = (folder / fmt::format("{}{:08x}{:08x}", kTemporaryBegin, random(), random())).string();
    // O_EXCL: opens neither an existing file nor a link.
    file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  }
  /// Returns whether the file exists, locked or on a file system without locks. Otherwise another process took it for a
  /// stale file before it was locked, and it is closed.
  bool lock() {
    struct stat status {};
    const bool is_taken = flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!is_taken && fstat(file_, &status) == 0 && status.st_nlink > 0) return true;
    close(std::exchange(file_, -1));  // GCOV_EXCL_START: two processes would have to meet within these lines
    unlink(path_.c_str());
    return false;
  }  // GCOV_EXCL_STOP

  std::string path_;
  int file_ = -1;
  bool is_there_ = true;
};

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// Throws OutputError if a path is a folder or its folder does not exist.
void expect_folder(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) fail_to_write(path.string(), "is a folder");
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, error)) fail_to_write(path.string(), "no folder " + folder.string());
}

/// The standard stream that goes to a file, or null.
std::FILE* standard_stream_to(const struct stat& file) {
  for (std::FILE* stream : {stdout, stderr}) {
    struct stat status;
    const bool is_known = fstat(fileno(stream), &status) == 0;
    if (is_known && status.st_dev == file.st_dev && status.st_ino == file.st_ino) return stream;
  }
  return nullptr;
}

void write_to(std::FILE* stream, const std::string& path, std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!is_written || std::fflush(stream) != 0) fail_to_write(path, system_reason(errno));
}

void write_in_place(const std::string& path, std::string_view text) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail_to_write(path, system_reason(errno));
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int reason = errno;
  if (std::fclose(file) != 0) fail_to_write(path, system_reason(errno));
  if (!is_written) fail_to_write(path, system_reason(reason));
}

}  // namespace

fs::path behind_links(fs::path path) {
  constexpr int kMaxLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == kMaxLinks) fail_to_write(path.string(), "is a link to itself");
    path = folder_of(path) / fs::read_symlink(path, error);
  }
  return path;
}

void expect_writable(const std::string& path) {
  struct stat earlier;
  const bool exists = stat(path.c_str(), &earlier) == 0;
  if (exists && !S_ISDIR(earlier.st_mode) && (!S_ISREG(earlier.st_mode) || standard_stream_to(earlier))) return;
  const fs::path target = behind_links(path);
  expect_folder(target);
  const TemporaryFile file(folder_of(target), 0600);
  if (!file.is_open()) fail_to_write(path, system_reason(errno));
}

bool would_replace(const std::string& path) {
  struct stat earlier;
  return stat(path.c_str(), &earlier) == 0 && S_ISREG(earlier.st_mode) && earlier.st_size > 0 &&
         !standard_stream_to(earlier);
}

void write_whole_file(const std::string& path, std::string_view text) {
  struct stat earlier;
  const bool exists = stat(path.c_str(), &earlier) == 0;
  if (exists && !S_ISDIR(earlier.st_mode)) {
    if (std::FILE* const stream = standard_stream_to(earlier)) return write_to(stream, path, text);
    if (!S_ISREG(earlier.st_mode)) return write_in_place(path, text);
  }
  const fs::path target = behind_links(path);
  expect_folder(target);
  const mode_t mode = exists ? earlier.st_mode & mode_t{0777} : mode_t{0666};
  TemporaryFile file(folder_of(target), mode);
  const bool is_written = file.is_open() && (!exists || file.set_mode(mode)) && file.fill(text) &&
                          file.rename_to(target) && sync_folder(folder_of(target));
  if (!is_written) fail_to_write(path, system_reason(errno));
}

void remove_stale_temporaries(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    if (!is_temporary(entry->path().filename().string())) continue;
    const int file = open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status;
    const bool is_file = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    if (is_file && flock(file, LOCK_EX | LOCK_NB) == 0) unlink(entry->path().c_str());
    close(file);
  }
}

}  // namespace litfog::files
