// SPDX-License-Identifier: Apache-2.0
#include "files/json_schema.h"

#include <gtest/gtest.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace litfog::test {
namespace {

using Json = nlohmann::json;

Json read_schema(const std::string& name) {
  std::ifstream file(std::filesystem::path(LITFOG_DATA_DIR) / "schemas" / name);
  return Json::parse(file);
}

/// Calls back with the document as each place of it is changed.
void change_each(Json& document, Json& place, const std::function<void()>& use) {
  for (const Json& other : {Json(nullptr), Json(true), Json(-1), Json(0), Json(1'000'000'000), Json("text"),
                            Json::array(), Json::object()}) {
    const Json kept = place;
    place = other;
    use();
    place = kept;
  }
  if (place.is_array()) {
    for (Json& item : place) change_each(document, item, use);
    const Json kept = place;
    place.push_back(place.empty() ? Json(1) : place.back());
    use();
    place = kept;
    if (place.empty()) return;
    place.erase(place.begin());
    use();
    place = kept;
  }
  if (!place.is_object()) return;
  const Json kept = place;
  for (const auto& [name, value] : kept.items()) {
    change_each(document, place[name], use);
    place.erase(name);
    use();
    place["un" + name] = value;
    use();
    place = kept;
  }
}

}  // namespace

struct JsonSchema::Parsed {
  Json document;
  valijson::Schema schema;
};

JsonSchema::JsonSchema(const std::string& kind) {
  auto parsed = std::make_unique<Parsed>();
  parsed->document = read_schema(kind + ".schema.json");
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(
      valijson::adapters::NlohmannJsonAdapter(parsed->document), parsed->schema,
      [](const std::string& uri) { return new Json(read_schema(uri)); }, [](const Json* document) { delete document; });
  parsed_ = std::move(parsed);
}

JsonSchema::~JsonSchema() = default;

std::string JsonSchema::error_of(const std::string& text) const {
  const Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return "no JSON";
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(document);
  if (validator.validate(parsed_->schema, adapter, &results)) return "";
  valijson::ValidationResults::Error error;
  results.popError(error);
  std::string message;
  for (const std::string& step : error.context) message += step;
  return message + ": " + error.description;
}

std::set<std::string> JsonSchema::members_at(const std::string& pointer) const {
  std::set<std::string> members;
  for (const auto& [name, schema] : parsed_->document.at(Json::json_pointer(pointer + "/properties")).items()) {
    members.insert(name);
  }
  members.erase("$schema");  // readers take it, and do not list it
  return members;
}

std::set<std::string> members_in(const std::string& sentence) {
  const std::string start = "must be one of ";
  const auto begin = sentence.find(start);
  if (begin == sentence.npos) return {};
  std::istringstream list(sentence.substr(begin + start.size(), sentence.find(';', begin) - begin - start.size()));
  std::set<std::string> members;
  for (std::string member; std::getline(list >> std::ws, member, ',');) members.insert(member);
  return members;
}

int expect_same_refusals(const JsonSchema& schema, const Refusal& refusal_of, const std::string& text,
                         const std::function<bool(const std::string& refusal)>& is_across_members) {
  EXPECT_EQ(refusal_of(text), "");
  EXPECT_EQ(schema.error_of(text), "");
  int refused = 0;
  Json document = Json::parse(text);
  change_each(document, document, [&] {
    const std::string changed = document.dump();
    const std::string refusal = refusal_of(changed), error = schema.error_of(changed);
    if (is_across_members(refusal)) return;
    EXPECT_EQ(error.empty(), refusal.empty()) << changed << "\n" << refusal << error;
    if (!refusal.empty()) ++refused;
  });
  return refused;
}

void expect_bundled_valid(const JsonSchema& schema, const std::string& folder, std::size_t least) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LITFOG_DATA_DIR) / folder)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    EXPECT_EQ(schema.error_of({std::istreambuf_iterator<char>(file), {}}), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, least);
}

}  // namespace litfog::test
