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

/// The files that a command is going to write. They are checked before any work is done: none may be another's, none a
/// file that the command reads, directly or through another file. Devices and pipes are never the same file.
///
///     OutputFiles outputs;
///     outputs.add("--output", options.output);
///     outputs.add("--stats", options.stats);
///     for (const std::string& file : scene.files) outputs.expect_apart_from(file);
class OutputFiles {
 public:
  /// Throws a usage error (CLI::ValidationError) for an empty path and for the file of another output; OutputError for
  /// a folder, or if its folder does not exist. Removes from the folder what killed commands left of their outputs.
  void add(const std::string& option, const std::string& path);

  /// Adds standard output, if it goes to a file.
  void add_standard_output();

  /// Throws a usage error if an output is this file, which the command reads.
  void expect_apart_from(const std::string& input) const;

  /// Throws OutputError if an output would replace a document that people write: a light, its spec, a scene or a camera
  /// path. After expect_apart_from(), whose error says more.
  void expect_no_documents() const;

 private:
  /// What is known of a path's file: where it lies and, if it exists, its device and inode.
  struct Identity {
    std::filesystem::path path;
    std::optional<std::pair<dev_t, ino_t>> inode;

    static std::optional<Identity> of(const std::string& path);  ///< none of a device or a pipe
  };
  struct Output {
    std::string option;
    std::string path;
  };

  void add(const Output& output, const Identity& identity);
  /// The output of this file, or null.
  const Output* find(const Identity& identity) const;

  // Of thousands of outputs each is found at once.
  std::map<std::filesystem::path, Output> by_path_;
  std::map<std::pair<dev_t, ino_t>, Output> by_inode_;
  std::set<std::filesystem::path> folders_;
};

/// Throws OutputError if a light would replace anything but a light that litfog-fit has written.
void expect_fitted_light_or_nothing(const std::string& path);

/// Throws OutputError if a picture would replace anything but one of its path's ending, .png, .svg or .exr, as the
/// first bytes tell.
void expect_picture_or_nothing(const std::string& path);

}  // namespace litfog::command
