// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <string>

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

  /// The members that the schema's part at a JSON pointer, "/definitions/cone", lets an object have, without "$schema".
  std::set<std::string> members_at(const std::string& pointer) const;

 private:
  struct Parsed;
  std::unique_ptr<const Parsed> parsed_;
};

/// What a reader of the kind's files says of a text; nothing where it takes it.
using Refusal = std::function<std::string(const std::string& text)>;

/// The refusals of a reader of files. It reads the text from a file in the folder.
template <typename Read>
Refusal refusal_by(Read read, const std::filesystem::path& folder) {
  return [=](const std::string& text) -> std::string {
    const std::string path = folder / "f.json";
    std::ofstream(path) << text;
    try {
      read(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
}

/// The members that a reader's sentence on an unknown one lists: "...: must be one of a, b; did you mean b?".
std::set<std::string> members_in(const std::string& sentence);

/// Expects schema and reader to take a document, and to refuse the same of those that differ from it in a single place:
/// every member is left out, misnamed and replaced by values of other types and signs, and so is every item of an
/// array.
///
/// is_across_members  whether a refusal is by a rule across members, which a schema cannot say
/// returns            how many documents both refuse
int expect_same_refusals(const JsonSchema& schema, const Refusal& refusal_of, const std::string& text,
                         const std::function<bool(const std::string& refusal)>& is_across_members);

/// Expects all JSON files in a folder of data/ to be valid, and to be at least so many.
void expect_bundled_valid(const JsonSchema& schema, const std::string& folder, std::size_t least);

}  // namespace litfog::test
