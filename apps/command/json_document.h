// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// JSON files read so that every refusal names its place: whatever is wrong, BadInput is thrown with the one sentence
/// "file:line:column: lamps[2].threshold = 7: must be in (0, 1)".
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

/// A value as parsed, with the place where it starts.
struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::size_t offset = 0;  ///< byte in the document's text
  bool boolean = false;
  double number = 0;
  std::string string;
  std::vector<JsonNode> items;
  std::map<std::string, JsonNode, std::less<>> members;
  std::size_t name_offset = 0;  ///< of a member: where its name starts
};

/// A view of one value that keeps the whole document alive. Each accessor throws BadInput where the value is of
/// another kind.
class JsonValue {
 public:
  explicit JsonValue(std::shared_ptr<const JsonDocument> document);

  bool is_object() const { return node_->kind == JsonNode::Kind::object; }
  bool is_array() const { return node_->kind == JsonNode::Kind::array; }
  bool is_string() const { return node_->kind == JsonNode::Kind::string; }

  JsonValue member(std::string_view name) const;  ///< a required member of an object
  std::optional<JsonValue> optional(std::string_view name) const;
  void allow_only(const std::vector<std::string_view>& names) const;  ///< refuses every other member of an object

  std::vector<JsonValue> items() const;
  double number() const;  ///< always finite
  double number_or(std::string_view name, double absent) const;
  bool boolean() const;
  const std::string& string() const;
  glm::dvec3 vec3() const;  ///< an array of three numbers

  /// Refuses this value: "place: path = value: rule".
  [[noreturn]] void fail(std::string_view rule) const;
  /// Refuses something at this value's place, named in the caller's words. An empty value is left out.
  [[noreturn]] void fail(std::string_view what, std::string_view value, std::string_view rule) const;

  const std::string& path() const { return path_; }  ///< "lamps[2].threshold"; empty for the document itself
  const std::string& file() const;                   ///< the document's name as given to read_json

 private:
  JsonValue(std::shared_ptr<const JsonDocument> document, const JsonNode& node, std::string path);
  JsonValue named(const JsonNode& node, std::string_view name) const;
  const JsonNode& expect(JsonNode::Kind kind, std::string_view rule) const;

  std::shared_ptr<const JsonDocument> document_;
  const JsonNode* node_;
  std::string path_;
};

/// Reads a JSON file of at most 64 MiB, a million values and a nesting of 64. UTF-8, with or without byte order mark.
JsonValue read_json(const std::string& path);

/// The same from text; the name stands in messages.
JsonValue parse_json(std::string text, std::string name);

/// Requires "litfog": kind and a "version" from 1 to the newest one that the caller knows.
void expect_header(const JsonValue& root, std::string_view kind, int newest_version);

/// Text as a JSON string with its quotes, escapes included; bytes that are no UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

/// Text for a message: quoted, and cut where it is long.
std::string quoted_excerpt(std::string_view text);
