// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace litfog::command {

/// The files that a command will write, checked before any work. All must differ from each other, and from the files
/// that the command reads, directly or through another file. Devices and pipes always count as different.
///
///     OutputFiles outputs;
///     outputs.add("--output", options.output);
///     outputs.add("--stats", options.stats);
///     for (const std::string& file : scene.files) outputs.expect_apart_from(file);
class OutputFiles {
 public:
  /// Throws a usage error (CLI::ValidationError) for an empty path and for the file of another output; OutputError for
  /// a folder, or if its folder does not exist. Removes partial outputs of killed commands from the folder.
  void add(const std::string& option, const std::string& path);

  /// Adds standard output if it is a file.
  void add_standard_output();

  /// Throws a usage error if an output is this file, which the command reads.
  void expect_apart_from(const std::string& input) const;

  /// Throws OutputError if an output would replace a document that people write: a light, its spec, a scene or a camera
  /// path. Call it after expect_apart_from(), whose error says more.
  void expect_no_documents() const;

 private:
  /// A file's identity: its path and, if it exists, its device and inode.
  struct Identity {
    std::filesystem::path path;
    std::optional<std::pair<dev_t, ino_t>> inode;

    static std::optional<Identity> of(const std::string& path);  ///< nothing for a device or a pipe
  };
  struct Output {
    std::string option;
    std::string path;
  };

  void add(const Output& output, const Identity& identity);
  /// The output with this file, or null.
  const Output* find(const Identity& identity) const;

  // Fast look-up among thousands of outputs.
  std::map<std::filesystem::path, Output> by_path_;
  std::map<std::pair<dev_t, ino_t>, Output> by_inode_;
  std::set<std::filesystem::path> folders_;
};

/// Throws OutputError if a light would replace anything but a light that litfog-fit has written.
void expect_fitted_light_or_nothing(const std::string& path);

/// Throws OutputError if a picture would replace anything but a file whose first bytes are of the path's ending: .png,
/// .svg or .exr.
void expect_picture_or_nothing(const std::string& path);

}  // namespace litfog::command
