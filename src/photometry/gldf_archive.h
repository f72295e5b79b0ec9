// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unzip.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace litfog {

inline constexpr int kMaxGldfEntries = 10'000;
/// Largest total size to which a container's photometric files may unpack.
inline constexpr std::uint64_t kMaxGldfBytes = std::uint64_t{256} << 20;

/// The directory of a GLDF container's zip archive, read once, so that each entry is found without reading it again.
/// Threads may read entries at once.
class GldfArchive {
 public:
  /// Throws InputError for a file that is not a zip archive, or has more than kMaxGldfEntries.
  explicit GldfArchive(std::string path);

  const std::string& path() const { return path_; }

  /// The bytes of an entry, named with slashes: at most kMaxPhotometricBytes, whatever the archive says. Throws
  /// InputError.
  std::string read(const std::string& entry) const;

  /// Throws InputError if entries unpack to more than kMaxGldfBytes together, or two of them share packed bytes. No
  /// honest archive has such entries. Missing entries are ignored.
  void expect_sound(const std::vector<std::string>& entries) const;

 private:
  struct Entry {
    unz64_file_pos position;  // in the directory
    std::uint64_t packed_bytes, bytes;
    bool is_known;  // stored or deflated; minizip would give what bzip2 packed as it is
  };

  const Entry* find(const std::string& entry) const;

  std::string path_;
  std::map<std::string, Entry, std::less<>> entries_;  // by names as stored, with slashes
};

}  // namespace litfog
