// SPDX-License-Identifier: Apache-2.0
#include "command/output_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/option_rule.h"
#include "files/json_document.h"
#include "files/whole_file.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"
#include "text/ascii_text.h"
#include "text/file_text.h"

namespace litfog::command {

namespace fs = std::filesystem;

namespace {

/// The litfog document that an output would replace.
std::optional<files::JsonValue> replaced_document(const std::string& path) try {
  if (!files::would_replace(path)) return std::nullopt;
  const files::JsonValue root = files::read_json(path);
  const auto kind = root.is_object() ? root.optional("litfog") : std::nullopt;
  return kind && kind->is_string() ? std::optional(root) : std::nullopt;
} catch (const InputError&) {  // not JSON
  return std::nullopt;
}

}  // namespace

std::optional<OutputFiles::Identity> OutputFiles::Identity::of(const std::string& path) {
  Identity identity;
  struct stat status;
  if (stat(path.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode)) return std::nullopt;
    identity.inode = {status.st_dev, status.st_ino};
  }
  std::error_code error;
  const fs::path absolute = fs::absolute(files::behind_links(path), error);
  identity.path = fs::weakly_canonical(absolute, error);
  if (error) identity.path = absolute.lexically_normal();  // the name is too long
  return identity;
}

const OutputFiles::Output* OutputFiles::find(const Identity& identity) const {
  if (const auto found = by_path_.find(identity.path); found != by_path_.end()) return &found->second;
  if (!identity.inode) return nullptr;
  const auto found = by_inode_.find(*identity.inode);
  return found != by_inode_.end() ? &found->second : nullptr;
}

void OutputFiles::add(const std::string& option, const std::string& path) {
  if (path.empty()) fail_option(option, path, "must not be empty");
  files::expect_writable(path);
  const auto identity = Identity::of(path);
  if (!identity) return;
  const fs::path folder = identity->path.parent_path();
  if (folders_.insert(folder).second) files::remove_stale_temporaries(folder);
  if (const Output* const other = find(*identity)) {
    fail_option(option, path, "must not be the file of " + (other->option == option ? "two inputs" : other->option));
  }
  add({option, path}, *identity);
}

void OutputFiles::add(const Output& output, const Identity& identity) {
  by_path_.emplace(identity.path, output);
  if (identity.inode) by_inode_.emplace(*identity.inode, output);
}

void OutputFiles::add_standard_output() {
  const std::string path = "/proc/self/fd/" + std::to_string(STDOUT_FILENO);
  if (const auto identity = Identity::of(path); identity && identity->inode) {
    add({"standard output", identity->path.string()}, *identity);
  }
}

void OutputFiles::expect_apart_from(const std::string& input) const {
  const auto identity = Identity::of(input);
  if (!identity) return;
  if (const Output* const output = find(*identity)) {
    fail_option(output->option, output->path, "must not be a file that is read, " + input);
  }
}

void OutputFiles::expect_no_documents() const {
  for (const auto& [file, output] : by_path_) {
    const auto document = replaced_document(output.path);
    if (!document) continue;
    throw OutputError(fmt::format("{}: cannot be written: exists, and is a litfog document, a {}", output.path,
                                  document->member("litfog").string()));
  }
}

void expect_fitted_light_or_nothing(const std::string& path) {
  if (!files::would_replace(path)) return;
  const auto document = replaced_document(path);
  if (document && document->member("litfog").string() == "light" && document->optional("fit")) return;
  throw OutputError(fmt::format(
      "{}: cannot be written: exists, and is no light that litfog-fit has written; --force replaces it", path));
}

void expect_picture_or_nothing(const std::string& path) {
  if (!files::would_replace(path)) return;
  const std::string start = read_file_start(path, 1024), ending = lower(fs::path(path).extension().string());
  const bool is_picture = ending == ".svg"   ? start.find("<svg") != start.npos
                          : ending == ".exr" ? start.starts_with("\x76\x2f\x31\x01")
                                             : start.starts_with("\x89PNG");
  if (is_picture) return;
  throw OutputError(
      fmt::format("{}: cannot be written: exists, and is no {} file; --force replaces it", path, ending.substr(1)));
}

}  // namespace litfog::command
