// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "litfog/input_error.h"

namespace litfog::files {

/// Reads JSON files. Every error is an InputError that names its location, one sentence like "file:line:column:
/// lamps[2].threshold = 7: must be in (0, 1)".
///
///     const JsonValue scene = read_json("airfield.json");
///     expect_header(scene, "scene", 1);
///     scene.allow_only({"litfog", "version", "fog", "lamps"});
///     const double density = scene.number_or("density", 0);                     // optional, with its default
///     for (const JsonValue& lamp : scene.member("lamps").items()) {             // required
///       const glm::dvec3 position = lamp.member("position").vec3();
///       if (const auto name = lamp.optional("name")) { names.push_back(name->string()); }
///       if (!(length(position) > 0)) lamp.member("position").fail("must not be the origin");
///     }
///
/// Lines and columns count from 1; a column is a code point, and a byte order mark is none.

struct JsonDocument;
struct JsonNode;

/// A view of one value that keeps the whole document alive. Each accessor throws InputError if the value is of another
/// type.
class JsonValue {
 public:
  explicit JsonValue(std::shared_ptr<const JsonDocument> document);

  bool is_object() const;
  bool is_array() const;
  bool is_string() const;

  JsonValue member(std::string_view name) const;  ///< a required member of an object
  std::optional<JsonValue> optional(std::string_view name) const;
  /// Fails at any other member of an object. Where "litfog" may stand, so may "$schema", a string for editors.
  void allow_only(const std::vector<std::string_view>& names) const;

  std::vector<std::string_view> names() const;  ///< names of an object's members
  std::vector<JsonValue> items() const;
  double number() const;  ///< always finite
  double number_or(std::string_view name, double absent) const;
  bool boolean() const;
  const std::string& string() const;
  glm::dvec3 vec3() const;  ///< an array of three numbers

  /// What is wrong with this value: "location: path = value: rule".
  InputError error(std::string_view rule) const;
  /// What is wrong at this value's location, in the caller's text. An empty value is left out.
  InputError error(std::string_view what, std::string_view value, std::string_view rule) const;
  [[noreturn]] void fail(std::string_view rule) const { throw error(rule); }
  [[noreturn]] void fail(std::string_view what, std::string_view value, std::string_view rule) const {
    throw error(what, value, rule);
  }

  /// Fails because this string is none of the allowed words.
  [[noreturn]] void fail_choice(const std::vector<std::string_view>& words) const;

  std::string_view name() const;                     ///< the last step of path(): "threshold"
  const std::string& path() const { return path_; }  ///< "lamps[2].threshold"; empty for the document itself
  std::string path_of(std::string_view name) const;  ///< path of a member, given or not
  const std::string& file() const;                   ///< the document's name as given to read_json

 private:
  friend class JsonEditor;
  JsonValue(std::shared_ptr<const JsonDocument> document, const JsonNode& node, std::string path);
  template <typename Type>
  const Type& expect(std::string_view rule) const;

  std::shared_ptr<const JsonDocument> document_;
  const JsonNode* node_;
  std::string path_;
};

/// Reads a JSON file of at most 64 MiB, a million values and a nesting of 64, in at most 500 MB of memory. UTF-8, with
/// or without byte order mark.
JsonValue read_json(const std::string& path);

/// Reads JSON from text; messages begin with the name.
JsonValue parse_json(std::string text, std::string name);

/// The contents of the file that a string names; nothing if the string names none. Throws InputError.
using FollowLink = std::function<std::optional<JsonValue>(const JsonValue& link)>;

/// A copy of a document with one value replaced, so that its reader applies all rules to the new value too. Missing
/// objects on the path are created; the reader decides whether they are allowed. The index after an array's last one
/// appends the value. A null removes the member or the item, after which later items have smaller indices.
///
///     const JsonValue seven = parse_json("7", "--set");
///     const JsonValue scene = with_value(read_json("airfield.json"), "lamps[2].threshold", seven, "--set");
///     scene.member("lamps").items()[2].member("threshold").fail("must be in (0, 1)");
///     // --set: lamps[2].threshold = 7: must be in (0, 1)
///
/// path    like JsonValue::path(), not empty
/// value   the root of its document
/// option  command-line option that errors name instead of a file, even errors of an array with the value as an item
/// follow  called for a string if the path names a member of it; its result replaces the string, and errors in it name
///         its own file
/// throws  InputError if the path leads nowhere: an array has no such item, a number no members
JsonValue with_value(const JsonValue& document, std::string_view path, const JsonValue& value, std::string_view option,
                     const FollowLink& follow = {});

/// Requires "litfog": kind and a "version" from 1 to the newest one that the caller knows.
void expect_header(const JsonValue& root, std::string_view kind, int newest_version);

}  // namespace litfog::files
