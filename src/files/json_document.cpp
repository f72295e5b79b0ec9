// SPDX-License-Identifier: Apache-2.0
#include "files/json_document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>
#include <utf8.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <map>
#include <new>
#include <utility>
#include <variant>

#include "files/hint.h"
#include "files/json_text.h"
#include "text/code_points.h"
#include "text/file_text.h"

namespace litfog::files {

/// A value as parsed.
struct JsonNode {
  using Array = std::vector<JsonNode>;
  using Object = std::map<std::string, JsonNode, std::less<>>;

  std::variant<std::monostate, bool, double, std::string, Array, Object> value;  // monostate: null
  std::size_t offset = 0;       ///< byte in the document's text where it starts
  std::size_t name_offset = 0;  ///< members: byte where the name starts
};

/// A part of a document's text from one source.
struct JsonSource {
  std::string name;
  std::size_t begin = 0;  ///< byte in the document's text
  bool has_lines = true;  ///< an option of the command line has none
};

/// The tree keeps its text: a location is a byte offset until a message needs its line and column.
struct JsonDocument {
  std::vector<JsonSource> sources;  ///< by their begins: the file itself, then values from with_value()
  std::string text;
  JsonNode root;

  InputError error(std::size_t offset, std::string_view what, std::string_view value, std::string_view rule) const;
  [[noreturn]] void fail(std::size_t offset, std::string_view what, std::string_view value,
                         std::string_view rule) const {
    throw error(offset, what, value, rule);
  }
  /// The text from an offset to the end of a number or literal, cut if long.
  std::string_view word_at(std::size_t offset) const;
};

namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxValues = 1'000'000;  // a member takes some 200 bytes: 64 MiB of "[],[]," would take 4 GiB
constexpr std::size_t kMaxShown = 40;          // characters of a number in a message
constexpr std::string_view kBetweenTokens = " \t\r\n,:";
constexpr std::string_view kWordEnds = " \t\r\n,:]}";
constexpr std::string_view kRangeRule = "must be within the range of a double";

/// The subject of a RapidJSON error (a text, a number or a string), and the broken rule.
struct SyntaxRule {
  std::string_view what;
  std::string_view rule;
};

/// found  the character at the error, nothing at the file's end
SyntaxRule syntax_rule(rapidjson::ParseErrorCode code, std::string_view found) {
  switch (code) {
    case rapidjson::kParseErrorDocumentEmpty:
    case rapidjson::kParseErrorValueInvalid:
      return {"text", "must be an object, an array, a string, a number, true, false or null"};
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return {"text", "must not follow the end of the document"};
    case rapidjson::kParseErrorObjectMissName:
      return {"text", "must be a member's name in quotes"};
    case rapidjson::kParseErrorObjectMissColon:
      return {"text", "must be ':'"};
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return {"text", "must be ',' or '}'"};
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return {"text", "must be ',' or ']'"};
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
      return {"string", "must have four hexadecimal digits after \\u"};
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return {"string", "must have one of \\udc00 to \\udfff after \\ud800 to \\udbff"};
    case rapidjson::kParseErrorStringEscapeInvalid:
      if (found != "\\") return {"string", "must not hold a control character that is not escaped"};
      return {"string", "must have one of \" \\ / b f n r t u after a backslash"};
    case rapidjson::kParseErrorStringMissQuotationMark:
      return {"string", "must end in a quotation mark"};
    case rapidjson::kParseErrorStringInvalidEncoding:
      return {"string", "must be UTF-8"};
    case rapidjson::kParseErrorNumberTooBig:
      return {"number", kRangeRule};
    case rapidjson::kParseErrorNumberMissFraction:
      return {"number", "must have a digit after the point"};
    case rapidjson::kParseErrorNumberMissExponent:
      return {"number", "must have a digit in its exponent"};
    case rapidjson::kParseErrorNone:  // GCOV_EXCL_START: the parser ends with none of these
    case rapidjson::kParseErrorTermination:
    case rapidjson::kParseErrorUnspecificSyntaxError:
      break;
  }
  return {"text", "must be JSON"};
}  // GCOV_EXCL_STOP

/// RapidJSON's own allocator returns null if memory is short, and its reader writes there.
struct ThrowingAllocator : rapidjson::CrtAllocator {
  // The names are RapidJSON's.
  void* Malloc(std::size_t size) { return given(CrtAllocator::Malloc(size), size); }
  void* Realloc(void* old, std::size_t old_size, std::size_t size) {
    return given(CrtAllocator::Realloc(old, old_size, size), size);
  }

 private:
  static void* given(void* memory, std::size_t size) {
    if (memory == nullptr && size > 0) throw std::bad_alloc();
    return memory;
  }
};

/// Builds the tree from RapidJSON's events. Errors state where a value begins and how a number was written, which the
/// events of nlohmann's library, the writer of JSON here, do not tell.
class TreeBuilder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TreeBuilder> {
 public:
  explicit TreeBuilder(JsonDocument& document)
      : document_(document), stream_(document.text.data(), document.text.size()) {}

  void parse() {
    constexpr unsigned kFlags =
        rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag | rapidjson::kParseNumbersAsStringsFlag;
    rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, ThrowingAllocator> reader;
    const rapidjson::ParseResult result = reader.Parse<kFlags>(stream_, *this);
    if (result.IsError()) fail_syntax(result.Code(), result.Offset());
  }

  // The names and the unused parameters are RapidJSON's.
  bool Null() {
    add_scalar(std::monostate());
    return true;
  }
  bool Bool(bool value) {
    add_scalar(value);
    return true;
  }
  bool RawNumber(const char*, rapidjson::SizeType, bool) {
    const std::size_t offset = token_offset();
    const std::size_t end = std::min(document_.text.find_first_of(kWordEnds, offset), document_.text.size());
    double number = 0;
    const auto [stop, error] = std::from_chars(document_.text.data() + offset, document_.text.data() + end, number);
    if (stop != document_.text.data() + end) {
      document_.fail(offset, "number", document_.word_at(offset), "must be decimal, such as 16 or -1.5e3");
    }
    if (error != std::errc()) document_.fail(offset, "number", document_.word_at(offset), kRangeRule);
    add_scalar(number);
    return true;
  }
  bool String(const char* text, rapidjson::SizeType size, bool) {
    expect_utf8(text, size);
    add_scalar(std::string(text, size));
    return true;
  }
  bool Key(const char* text, rapidjson::SizeType size, bool) {
    expect_utf8(text, size);
    const std::size_t offset = token_offset();
    auto& members = std::get<JsonNode::Object>(open_.back()->value);
    const auto [member, is_new] = members.try_emplace(std::string(text, size));
    if (!is_new) document_.fail(offset, quoted_excerpt(member->first), "", "must not be given twice");
    member->second.name_offset = offset;
    next_member_ = &member->second;
    last_token_end_ = stream_.Tell();
    return true;
  }
  bool StartObject() { return open(JsonNode::Object()); }
  bool StartArray() { return open(JsonNode::Array()); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }

 private:
  /// The start of the current event's token: only blanks, a comma or a colon separate it from the last token.
  std::size_t token_offset() const {
    return std::min(document_.text.find_first_not_of(kBetweenTokens, last_token_end_), document_.text.size());
  }

  /// RapidJSON has validated the string as written; but it takes an escape of the second half of a surrogate pair
  /// alone.
  void expect_utf8(const char* text, std::size_t size) const {
    if (utf8::is_valid(text, text + size)) return;
    document_.fail(token_offset(), "string", "", "must have one of \\ud800 to \\udbff before \\udc00 to \\udfff");
  }

  JsonNode& add_value(std::size_t offset) {
    if (++values_ > kMaxValues) {
      document_.fail(offset, "file", "", fmt::format("must not hold more than {} values", kMaxValues));
    }
    JsonNode* node = &document_.root;
    if (!open_.empty()) {
      auto* const items = std::get_if<JsonNode::Array>(&open_.back()->value);
      node = items ? &items->emplace_back() : next_member_;
    }
    node->offset = offset;
    return *node;
  }

  template <typename Value>
  void add_scalar(Value value) {
    add_value(token_offset()).value = std::move(value);
    last_token_end_ = stream_.Tell();
  }

  // Events of brackets precede their reading from the stream; events of all other tokens follow it.
  template <typename Container>
  bool open(Container container) {
    JsonNode& node = add_value(stream_.Tell());
    if (open_.size() == kMaxDepth) {
      document_.fail(node.offset, "nesting", "", fmt::format("must not be deeper than {}", kMaxDepth));
    }
    node.value = std::move(container);
    open_.push_back(&node);
    last_token_end_ = node.offset + 1;
    return true;
  }

  bool close() {
    open_.pop_back();
    last_token_end_ = stream_.Tell() + 1;
    return true;
  }

  [[noreturn]] void fail_syntax(rapidjson::ParseErrorCode code, std::size_t offset) const;

  JsonDocument& document_;
  rapidjson::MemoryStream stream_;
  std::size_t last_token_end_ = 0;
  std::size_t values_ = 0;
  std::vector<JsonNode*> open_;  // stays valid: an array grows only while none of its items is open
  JsonNode* next_member_ = nullptr;
};

void TreeBuilder::fail_syntax(rapidjson::ParseErrorCode code, std::size_t offset) const {
  const std::string& text = document_.text;
  const auto [what, rule] = syntax_rule(code, text.substr(offset, 1));
  if (offset == text.size()) document_.fail(offset, "end of file", "", rule);
  const std::string rule_and_hint = std::string(rule) + hint_for_syntax(text, offset);
  const std::string_view word = document_.word_at(std::min(token_offset(), offset));
  if (what == "string") document_.fail(offset, what, "", rule);
  if (what == "number") document_.fail(offset, what, word, rule);
  document_.fail(offset, what, quoted_excerpt(word.empty() ? text.substr(offset, 1) : word), rule_and_hint);
}

/// A value in a message: as written, or its type if that would be long.
std::string shown(const JsonDocument& document, const JsonNode& node) {
  if (std::holds_alternative<JsonNode::Array>(node.value)) return "an array";
  if (std::holds_alternative<JsonNode::Object>(node.value)) return "an object";
  if (const auto* text = std::get_if<std::string>(&node.value)) return quoted_excerpt(*text);
  return std::string(document.word_at(node.offset));
}

}  // namespace

InputError JsonDocument::error(std::size_t offset, std::string_view what, std::string_view value,
                               std::string_view rule) const {
  const JsonSource& source = *std::prev(std::ranges::upper_bound(sources, offset, {}, &JsonSource::begin));
  if (!source.has_lines) return InputError({.file = source.name}, what, value, rule);
  const auto before = std::string_view(text).substr(source.begin, offset - source.begin);
  const auto line = std::size_t(std::ranges::count(before, '\n')) + 1;
  const std::size_t column = count_code_points(before.substr(before.rfind('\n') + 1)) + 1;
  return InputError({source.name, line, column}, what, value, rule);
}

std::string_view JsonDocument::word_at(std::size_t offset) const {
  const std::size_t end = std::min(text.find_first_of(kWordEnds, offset), text.size());
  return std::string_view(text).substr(offset, std::min(end - offset, kMaxShown));
}

JsonValue::JsonValue(std::shared_ptr<const JsonDocument> document)
    : document_(std::move(document)), node_(&document_->root) {}

JsonValue::JsonValue(std::shared_ptr<const JsonDocument> document, const JsonNode& node, std::string path)
    : document_(std::move(document)), node_(&node), path_(std::move(path)) {}

bool JsonValue::is_object() const { return std::holds_alternative<JsonNode::Object>(node_->value); }
bool JsonValue::is_array() const { return std::holds_alternative<JsonNode::Array>(node_->value); }
bool JsonValue::is_string() const { return std::holds_alternative<std::string>(node_->value); }

template <typename Type>
const Type& JsonValue::expect(std::string_view rule) const {
  const Type* const value = std::get_if<Type>(&node_->value);
  if (!value) fail(rule);
  return *value;
}

JsonValue JsonValue::member(std::string_view name) const {
  const auto value = optional(name);
  if (!value) fail(path_of(name), "", "must be given");
  return *value;
}

std::optional<JsonValue> JsonValue::optional(std::string_view name) const {
  const auto& members = expect<JsonNode::Object>("must be an object");
  const auto member = members.find(name);
  if (member == members.end()) return std::nullopt;
  return JsonValue(document_, member->second, path_of(name));
}

void JsonValue::allow_only(const std::vector<std::string_view>& names) const {
  const auto is_allowed = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
  for (const auto& [name, node] : expect<JsonNode::Object>("must be an object")) {
    if (is_allowed(name)) continue;
    if (name == "$schema" && is_allowed("litfog")) {
      member(name).string();
      continue;
    }
    document_->fail(node.name_offset, quoted_excerpt(name), "",
                    fmt::format("must be one of {}{}", fmt::join(names, ", "), hint_for_word(name, names)));
  }
}

std::vector<std::string_view> JsonValue::names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, node] : expect<JsonNode::Object>("must be an object")) names.push_back(name);
  return names;
}

std::vector<JsonValue> JsonValue::items() const {
  std::vector<JsonValue> values;
  for (const JsonNode& node : expect<JsonNode::Array>("must be an array")) {
    values.push_back({document_, node, fmt::format("{}[{}]", path_, values.size())});
  }
  return values;
}

double JsonValue::number() const {
  const auto* const text = std::get_if<std::string>(&node_->value);
  if (text) fail("must be a number" + hint_for_quoted_number(*text));
  return expect<double>("must be a number");
}

double JsonValue::number_or(std::string_view name, double absent) const {
  const auto value = optional(name);
  return value ? value->number() : absent;
}

bool JsonValue::boolean() const { return expect<bool>("must be true or false"); }

const std::string& JsonValue::string() const { return expect<std::string>("must be a string"); }

glm::dvec3 JsonValue::vec3() const {
  constexpr const char* kRule = "must be an array of three numbers";
  if (expect<JsonNode::Array>(kRule).size() != 3) fail(kRule);
  const auto components = items();
  return {components[0].number(), components[1].number(), components[2].number()};
}

void JsonValue::fail_choice(const std::vector<std::string_view>& words) const {
  fail(fmt::format("must be one of {}{}", fmt::join(words, ", "), hint_for_word(string(), words)));
}

InputError JsonValue::error(std::string_view rule) const {
  const auto* const number = std::get_if<double>(&node_->value);
  const std::string hint = number ? hint_for_fraction(*number, rule) : "";
  return error(path_, shown(*document_, *node_), std::string(rule) + hint);
}

InputError JsonValue::error(std::string_view what, std::string_view value, std::string_view rule) const {
  return document_->error(node_->offset, what.empty() ? "document" : what, value, rule);
}

std::string JsonValue::path_of(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

std::string_view JsonValue::name() const { return std::string_view(path_).substr(path_.rfind('.') + 1); }

const std::string& JsonValue::file() const { return document_->sources.front().name; }

JsonValue read_json(const std::string& path) { return parse_json(read_file_text(path, kMaxBytes), path); }

JsonValue parse_json(std::string text, std::string name) {
  if (utf8::starts_with_bom(text)) text.erase(0, std::size(utf8::bom));
  const auto document = std::make_shared<JsonDocument>();
  document->sources.push_back({.name = std::move(name)});
  document->text = std::move(text);
  if (const auto zero = document->text.find('\0'); zero != std::string::npos) {  // an end of input to RapidJSON
    document->fail(zero, "file", "", "must be text, without zero bytes");
  }
  TreeBuilder(*document).parse();
  return JsonValue(document);
}

/// Puts values into a copy of a document.
class JsonEditor {
 public:
  JsonEditor(const JsonValue& document, std::string_view option, const FollowLink& follow)
      : document_(std::make_shared<JsonDocument>(*document.document_)), option_(option), follow_(follow) {}

  JsonValue with(std::string_view path, const JsonValue& value) {
    const std::size_t begin = append(*value.document_);
    document_->sources.back() = {.name = option_, .begin = begin, .has_lines = false};
    const bool is_removal = std::holds_alternative<std::monostate>(value.document_->root.value);
    JsonNode* node = &document_->root;
    JsonNode* holder = nullptr;
    for (std::size_t end = 0; end < path.size();) {
      holder = node;
      const std::string_view parent = path.substr(0, end);
      if (path[end] == '[') {
        const std::size_t close = path.find(']', end);
        if (close == path.npos) fail_path(path);
        JsonNode& array = *node;
        const bool may_append = close + 1 == path.size() && !is_removal;
        node = &item(array, parent, path.substr(0, close + 1), path.substr(end + 1, close - end - 1), may_append);
        end = close + 1;
        if (end == path.size()) array.offset = begin;  // errors of the whole array are then the change's
      } else {
        if (end > 0 && path[end++] != '.') fail_path(path);
        const std::size_t stop = std::min(path.find_first_of(".[", end), path.size());
        const bool has_items = stop < path.size() && path[stop] == '[';
        node = &member(*node, parent, path.substr(end, stop - end), begin, has_items);
        end = stop;
      }
    }
    if (is_removal && holder)
      remove(*holder, *node);
    else
      put(*value.document_, *node, begin);
    return JsonValue(document_);
  }

 private:
  [[noreturn]] void fail(std::string_view what, std::string_view value, std::string_view rule) const {
    throw InputError({.file = option_}, what.empty() ? "document" : what, value, rule);
  }
  [[noreturn]] void fail_path(std::string_view path) const {
    fail(quoted_excerpt(path), "", "must be a member such as lights[0].position");
  }

  JsonNode& item(JsonNode& array, std::string_view parent, std::string_view path, std::string_view index,
                 bool may_append) const {
    std::size_t i = 0;
    const auto [stop, error] = std::from_chars(index.data(), index.data() + index.size(), i);
    if (index.empty() || stop != index.data() + index.size()) fail_path(path);
    auto* const items = std::get_if<JsonNode::Array>(&array.value);
    if (!items) fail(parent, shown(*document_, array), fmt::format("must be an array, to have {}", path));
    if (error == std::errc() && i == items->size() && may_append) items->emplace_back();
    if (error != std::errc() || i >= items->size()) {
      fail(path, "",
           items->empty() ? fmt::format("is not there: {} is empty", parent)
                          : fmt::format("is not there: the last one is {}[{}]", parent, items->size() - 1));
    }
    return (*items)[i];
  }

  JsonNode& member(JsonNode& object, std::string_view parent, std::string_view name, std::size_t name_offset,
                   bool has_items) {
    const std::string path = parent.empty() ? std::string(name) : fmt::format("{}.{}", parent, name);
    if (name.empty()) fail_path(path);
    if (follow_ && std::holds_alternative<std::string>(object.value)) {
      if (const auto linked = follow_(JsonValue(document_, object, std::string(parent)))) {
        put(*linked->document_, object, append(*linked->document_));
      }
    }
    auto* const members = std::get_if<JsonNode::Object>(&object.value);
    if (!members) fail(parent, shown(*document_, object), fmt::format("must be an object, to have {}", path));
    const auto [found, is_new] = members->try_emplace(std::string(name));
    if (is_new) {
      found->second = {.value = JsonNode::Object(), .offset = name_offset, .name_offset = name_offset};
      if (has_items) found->second.value = JsonNode::Array();
    }
    return found->second;
  }

  /// Removes a value from the array or object that holds it.
  static void remove(JsonNode& holder, const JsonNode& node) {
    if (auto* const items = std::get_if<JsonNode::Array>(&holder.value)) {
      items->erase(items->begin() + (&node - items->data()));
    } else {
      std::erase_if(std::get<JsonNode::Object>(holder.value),
                    [&node](const auto& each) { return &each.second == &node; });
    }
  }

  /// Appends the text of another document. Returns where it begins.
  std::size_t append(const JsonDocument& other) {
    document_->text += '\n';  // ends the last word before it
    const std::size_t begin = document_->text.size();
    document_->text += other.text;
    for (JsonSource source : other.sources) {
      source.begin += begin;
      document_->sources.push_back(std::move(source));
    }
    return begin;
  }

  /// Replaces a value by another document, whose text has been appended.
  static void put(const JsonDocument& other, JsonNode& node, std::size_t begin) {
    const std::size_t name_offset = node.name_offset;
    node = other.root;
    shift(node, begin);
    node.name_offset = name_offset;
  }

  static void shift(JsonNode& node, std::size_t by) {
    node.offset += by;
    node.name_offset += by;
    if (auto* const items = std::get_if<JsonNode::Array>(&node.value)) {
      for (JsonNode& item : *items) shift(item, by);
    } else if (auto* const members = std::get_if<JsonNode::Object>(&node.value)) {
      for (auto& [name, member] : *members) shift(member, by);
    }
  }

  std::shared_ptr<JsonDocument> document_;
  std::string option_;
  const FollowLink& follow_;
};

JsonValue with_value(const JsonValue& document, std::string_view path, const JsonValue& value, std::string_view option,
                     const FollowLink& follow) {
  return JsonEditor(document, option, follow).with(path, value);
}

void expect_header(const JsonValue& root, std::string_view kind, int newest_version) {
  const JsonValue litfog = root.member("litfog");
  if (litfog.string() != kind) {
    const bool can_be_fitted = kind == "light" && litfog.string() == "light-spec";
    litfog.fail(fmt::format("must be \"{}\"{}", kind, can_be_fitted ? "; litfog-fit makes a light of a spec" : ""));
  }
  const JsonValue version = root.member("version");
  const double number = version.number();
  for (int known = 1; known <= newest_version; ++known) {
    if (number == known) return;
  }
  version.fail(newest_version == 1
                   ? std::string("must be 1, the one that this program reads")
                   : fmt::format("must be from 1 to {}, the ones that this program reads", newest_version));
}

}  // namespace litfog::files
