// SPDX-License-Identifier: Apache-2.0
#include "command/json_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "command/exit_status.h"
#include "command/number.h"

using namespace litfog::command;

/// The text stays with the tree: a place is a byte offset until a message wants its line and column.
struct JsonDocument {
  std::string name;
  std::string text;
  JsonNode root;

  [[noreturn]] void fail(std::size_t offset, std::string_view sentence) const;
};

namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = 1'000'000;  // a value takes some 200 bytes: 64 MiB of "[],[]," would take 4 GiB
constexpr std::size_t kMaxShown = 40;          // of a value in a message
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool starts_code_point(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// Builds the tree from nlohmann's events. They carry no places, so a cursor follows them through the same text: what
/// stands between two tokens is only white space, commas and colons, and a token reported as sound ends simply.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(JsonDocument& document) : document_(document) {
    if (document.text.starts_with(kByteOrderMark)) cursor_ = kByteOrderMark.size();
  }

  bool null() override {
    add_scalar(JsonNode::Kind::null);
    return true;
  }
  bool boolean(bool value) override {
    add_scalar(JsonNode::Kind::boolean).boolean = value;
    return true;
  }
  bool number_integer(number_integer_t) override { return add_number(); }
  bool number_unsigned(number_unsigned_t) override { return add_number(); }
  bool number_float(number_float_t, const string_t&) override { return add_number(); }
  bool string(string_t& value) override {
    begin_value(JsonNode::Kind::string).string = std::move(value);
    skip_string();
    return true;
  }
  bool binary(binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(JsonNode::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    skip_to_token();
    const auto [member, is_new] = open_.back()->members.try_emplace(name);
    if (!is_new) document_.fail(cursor_, quoted_excerpt(name) + ": must not be given twice");
    member->second.name_offset = cursor_;
    next_member_ = &member->second;
    skip_string();
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) override {
    std::string reason = reason_of(error);
    if (error.id == kNumberOverflow)
      reason = fmt::format("number = {:.40}: must be within the range of a double", token);
    const std::size_t end = std::min(position, document_.text.size());
    document_.fail(end - std::min(end, length_of_last_token(reason, token)), reason);
  }

 private:
  static constexpr int kNumberOverflow = 406;

  /// "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error while parsing value - unexpected
  /// ']'; last read: ...", less its own place, its number and the echo of the input.
  static std::string reason_of(const nlohmann::json::exception& error) {
    std::string_view reason = error.what();
    if (const auto place = reason.find("column "); place != reason.npos)
      reason.remove_prefix(reason.find(": ", place) + 2);
    const auto echo = reason.find("; last read: ");
    if (echo == reason.npos) return std::string(reason);
    const auto expected = reason.find("; expected ", echo);  // stands behind the echo
    return std::string(reason.substr(0, echo)) + std::string(reason.substr(std::min(expected, reason.size())));
  }

  /// nlohmann counts the bytes read: a refused token starts that much before. Its text is only kept for some.
  static std::size_t length_of_last_token(std::string_view reason, std::string_view token) {
    const auto is_about = [reason](std::string_view what) { return reason.find(what) != reason.npos; };
    if (is_about("unexpected end of input")) return 0;
    if (is_about("unexpected string") || is_about("unexpected number") || is_about("number =")) return token.size();
    if (is_about("unexpected true") || is_about("unexpected null")) return 4;
    if (is_about("unexpected false")) return 5;
    return 1;  // a bracket, a comma, or the byte at which a token broke
  }

  void skip_to_token() { cursor_ = document_.text.find_first_not_of(" \t\r\n,:", cursor_); }

  void skip_string() {
    for (++cursor_; document_.text[cursor_] != '"'; ++cursor_) {
      if (document_.text[cursor_] == '\\') ++cursor_;
    }
    ++cursor_;
  }

  JsonNode& begin_value(JsonNode::Kind kind) {
    skip_to_token();
    if (++values_ > kMaxValues)
      document_.fail(cursor_, fmt::format("file: must not hold more than {} values", kMaxValues));
    JsonNode* node = &document_.root;
    if (!open_.empty()) {
      node = open_.back()->kind == JsonNode::Kind::object ? next_member_ : &open_.back()->items.emplace_back();
    }
    node->kind = kind;
    node->offset = cursor_;
    return *node;
  }

  JsonNode& add_scalar(JsonNode::Kind kind) {
    JsonNode& node = begin_value(kind);
    cursor_ = std::min(document_.text.find_first_of(" \t\r\n,:]}", cursor_), document_.text.size());
    return node;
  }

  bool add_number() {
    JsonNode& node = add_scalar(JsonNode::Kind::number);
    // Parsed again from the text: nlohmann rounds 1e-999 to 0 in silence.
    const auto text = std::string_view(document_.text).substr(node.offset, cursor_ - node.offset);
    const auto number = parse_number(text);
    if (!number)
      document_.fail(node.offset, fmt::format("number = {:.40}: must be within the range of a double", text));
    node.number = *number;
    return true;
  }

  bool open(JsonNode::Kind kind) {
    JsonNode& node = begin_value(kind);
    if (open_.size() == kMaxDepth)
      document_.fail(cursor_, fmt::format("nesting: must not be deeper than {}", kMaxDepth));
    open_.push_back(&node);
    ++cursor_;
    return true;
  }

  bool close() {
    skip_to_token();
    ++cursor_;
    open_.pop_back();
    return true;
  }

  JsonDocument& document_;
  std::size_t cursor_ = 0;
  std::size_t values_ = 0;
  std::vector<JsonNode*> open_;  // stays valid: an array grows only while none of its items is open
  JsonNode* next_member_ = nullptr;
};

std::string read_text(const std::string& path) {
  const auto fail = [&path] { throw BadInput(path + ": cannot be read: " + std::strerror(errno)); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail();
  std::string text;
  std::array<char, 65536> chunk;
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    text.append(chunk.data(), count);
    if (text.size() > kMaxBytes)
      throw BadInput(fmt::format("{}: file: must not be larger than {} bytes", path, kMaxBytes));
  }
  if (std::ferror(file.get())) fail();
  return text;
}

/// A value as a message shows it: as written, or its kind where that would be long.
std::string shown(const JsonDocument& document, const JsonNode& node) {
  switch (node.kind) {
    case JsonNode::Kind::array:
      return "an array";
    case JsonNode::Kind::object:
      return "an object";
    case JsonNode::Kind::string:
      return quoted_excerpt(node.string);
    case JsonNode::Kind::null:
    case JsonNode::Kind::boolean:
    case JsonNode::Kind::number:
      break;
  }
  const std::size_t end = std::min(document.text.find_first_of(" \t\r\n,]}", node.offset), document.text.size());
  return document.text.substr(node.offset, std::min(end - node.offset, kMaxShown));
}

}  // namespace

void JsonDocument::fail(std::size_t offset, std::string_view sentence) const {
  const std::size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const auto place = std::string_view(text).substr(0, offset).substr(std::min(begin, offset));
  const auto line = std::count(place.begin(), place.end(), '\n') + 1;
  const auto column = std::count_if(place.begin() + static_cast<std::ptrdiff_t>(place.rfind('\n') + 1), place.end(),
                                    starts_code_point) +
                      1;
  throw BadInput(fmt::format("{}:{}:{}: {}", name, line, column, sentence));
}

JsonValue::JsonValue(std::shared_ptr<const JsonDocument> document)
    : document_(std::move(document)), node_(&document_->root) {}

JsonValue::JsonValue(std::shared_ptr<const JsonDocument> document, const JsonNode& node, std::string path)
    : document_(std::move(document)), node_(&node), path_(std::move(path)) {}

JsonValue JsonValue::named(const JsonNode& node, std::string_view name) const {
  return {document_, node, path_ + (path_.empty() ? "" : ".") + std::string(name)};
}

const JsonNode& JsonValue::expect(JsonNode::Kind kind, std::string_view rule) const {
  if (node_->kind != kind) fail(rule);
  return *node_;
}

JsonValue JsonValue::member(std::string_view name) const {
  const auto value = optional(name);
  if (!value) fail(path_ + (path_.empty() ? "" : ".") + std::string(name), "", "must be given");
  return *value;
}

std::optional<JsonValue> JsonValue::optional(std::string_view name) const {
  const auto& members = expect(JsonNode::Kind::object, "must be an object").members;
  const auto member = members.find(name);
  if (member == members.end()) return std::nullopt;
  return named(member->second, name);
}

void JsonValue::allow_only(const std::vector<std::string_view>& names) const {
  for (const auto& [name, node] : expect(JsonNode::Kind::object, "must be an object").members) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    document_->fail(node.name_offset,
                    fmt::format("{}: must be one of {}", quoted_excerpt(name), fmt::join(names, ", ")));
  }
}

std::vector<JsonValue> JsonValue::items() const {
  std::vector<JsonValue> values;
  for (const JsonNode& node : expect(JsonNode::Kind::array, "must be an array").items) {
    values.push_back({document_, node, fmt::format("{}[{}]", path_, values.size())});
  }
  return values;
}

double JsonValue::number() const { return expect(JsonNode::Kind::number, "must be a number").number; }

double JsonValue::number_or(std::string_view name, double absent) const {
  const auto value = optional(name);
  return value ? value->number() : absent;
}

bool JsonValue::boolean() const { return expect(JsonNode::Kind::boolean, "must be true or false").boolean; }

const std::string& JsonValue::string() const { return expect(JsonNode::Kind::string, "must be a string").string; }

glm::dvec3 JsonValue::vec3() const {
  constexpr const char* kRule = "must be an array of three numbers";
  if (!is_array() || node_->items.size() != 3) fail(kRule);
  const auto components = items();
  return {components[0].number(), components[1].number(), components[2].number()};
}

void JsonValue::fail(std::string_view rule) const { fail(path_, shown(*document_, *node_), rule); }

void JsonValue::fail(std::string_view what, std::string_view value, std::string_view rule) const {
  if (what.empty()) what = "document";
  document_->fail(node_->offset,
                  value.empty() ? fmt::format("{}: {}", what, rule) : fmt::format("{} = {}: {}", what, value, rule));
}

const std::string& JsonValue::file() const { return document_->name; }

JsonValue read_json(const std::string& path) { return parse_json(read_text(path), path); }

JsonValue parse_json(std::string text, std::string name) {
  const auto document = std::make_shared<JsonDocument>();
  document->name = std::move(name);
  document->text = std::move(text);
  if (const auto zero = document->text.find('\0'); zero != std::string::npos) {  // an end of input to nlohmann
    document->fail(zero, "file: must be text, without zero bytes");
  }
  TreeBuilder builder(*document);
  nlohmann::json::sax_parse(document->text, &builder);
  return JsonValue(document);
}

void expect_header(const JsonValue& root, std::string_view kind, int newest_version) {
  const JsonValue litfog = root.member("litfog");
  if (litfog.string() != kind) litfog.fail(fmt::format("must be \"{}\"", kind));
  const JsonValue version = root.member("version");
  const double number = version.number();
  for (int known = 1; known <= newest_version; ++known) {
    if (number == known) return;
  }
  version.fail(newest_version == 1
                   ? std::string("must be 1, the one that this program reads")
                   : fmt::format("must be from 1 to {}, the ones that this program reads", newest_version));
}

std::string json_quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string quoted_excerpt(std::string_view text) {
  if (text.size() <= kMaxShown) return json_quoted(text);
  std::size_t end = kMaxShown;
  while (end > 0 && !starts_code_point(text[end])) --end;
  return json_quoted(text.substr(0, end)) + "...";
}
