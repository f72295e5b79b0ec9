// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "litfog/input_error.h"

namespace litfog::test {

/// A schema of data/schemas. Those that it refers to lie there, too, and have no definition of the same name: valijson
/// takes the two for one.
class JsonSchema {
 public:
  /// kind  "light", "light-spec", "scene" or "camera-path"
  explicit JsonSchema(const std::string& kind);
  ~JsonSchema();

  /// What is wrong with a document, or nothing; text that is no JSON is wrong.
  std::string error_of(const std::string& text) const;

  /// error_of() each JSON file in a folder of data/, by its name.
  std::map<std::string, std::string> errors_in(const std::string& folder) const;

  /// The members that the schema's part at a JSON pointer, "/definitions/cone", lets an object have.
  std::set<std::string> members_at(const std::string& pointer) const;

 private:
  struct Parsed;
  std::unique_ptr<const Parsed> parsed_;
};

/// What read(path) says of a file with that text, written into the folder; nothing where it takes it.
template <typename Read>
std::string refusal_by(Read read, const std::filesystem::path& folder, const std::string& text) {
  const std::string path = folder / "f.json";
  std::ofstream(path) << text;
  try {
    read(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The members that a reader's sentence on an unknown one lists: "...: must be one of a, b; did you mean b?".
std::set<std::string> members_in(const std::string& sentence);

/// Documents that differ from one in a single place each: every member is left out, misnamed and replaced by values of
/// other types and signs, and so is every item of an array.
std::vector<std::string> changed_documents(const std::string& text);

}  // namespace litfog::test
