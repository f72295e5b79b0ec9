// SPDX-License-Identifier: Apache-2.0
#include "files/hint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/value_errors.h"
#include "files/json_document.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace files;

namespace {

/// The sentence of what is wrong with a document, which is read as {"threshold": number, "color": number}.
std::string hint_error(const std::string& text) {
  return sentence_of<InputError>([&] {
    const JsonValue root = parse_json(text, "f");
    root.allow_only({"threshold", "color"});
    const double threshold = root.number_or("threshold", 0.5);
    if (!(threshold > 0 && threshold < 1)) root.member("threshold").fail("must be in (0, 1)");
    root.number_or("color", 0);
  });
}

TEST(Hint, MisspeltMemberIsNamed) {
  EXPECT_EQ(hint_error(R"({"treshold": 1})"),
            "f:1:2: \"treshold\": must be one of threshold, color; did you mean threshold?");
  EXPECT_EQ(hint_error(R"({"Colour": 1})"), "f:1:2: \"Colour\": must be one of threshold, color; did you mean color?");
  EXPECT_EQ(hint_error(R"({"weather": 1})"), "f:1:2: \"weather\": must be one of threshold, color");
}

TEST(Hint, SlipsOfEachKindAreFew) {
  for (const char* typed : {"extentm", "extent_mm", "extemt_m", "exetnt_m", "EXTENT_M", "extent"}) {
    EXPECT_EQ(hint_for_word(typed, {"range", "extent_m"}), "; did you mean extent_m?") << typed;
  }
  EXPECT_EQ(hint_for_word("ra", {"range"}), "");
  EXPECT_EQ(hint_for_word("manner", {"range"}), "");
  EXPECT_EQ(hint_for_word(std::string(1'000'000, 'a'), {"range"}), "");
}

TEST(Hint, NearestOfTwoWordsIsMeant) {
  EXPECT_EQ(hint_for_word("feld_angle_deg", {"beam_angle_deg", "field_angle_deg", "half_angle_deg"}),
            "; did you mean field_angle_deg?");
}

TEST(Hint, PercentageIsShownAsAFraction) {
  EXPECT_EQ(hint_error(R"({"threshold": 5})"), "f:1:15: threshold = 5: must be in (0, 1); 5 % is 0.05");
  EXPECT_EQ(hint_error(R"({"threshold": 1.1})"), "f:1:15: threshold = 1.1: must be in (0, 1); 1.1 % is 0.011");
  EXPECT_EQ(hint_error(R"({"threshold": "5 %"})"), "f:1:15: threshold = \"5 %\": must be a number; 5 % is 0.05");
  EXPECT_EQ(hint_error(R"({"threshold": "%"})"), "f:1:15: threshold = \"%\": must be a number");
  EXPECT_EQ(hint_error(R"({"threshold": 200})"), "f:1:15: threshold = 200: must be in (0, 1)");
  EXPECT_EQ(hint_error(R"({"threshold": -5})"), "f:1:15: threshold = -5: must be in (0, 1)");
}

TEST(Hint, OneInFloatsIsNoPercentage) {
  EXPECT_EQ(hint_error(R"({"threshold": 1.0000001192092896})"),
            "f:1:15: threshold = 1.0000001192092896: must be in (0, 1)");
}

TEST(Hint, NumberInQuotationMarksIsShownWithout) {
  EXPECT_EQ(hint_error(R"({"threshold": "0.05"})"),
            "f:1:15: threshold = \"0.05\": must be a number; write 0.05, without quotation marks");
  EXPECT_EQ(hint_for_quoted_number(" .5 "), "; write 0.5, without quotation marks") << "as JSON has it";
  EXPECT_EQ(hint_for_quoted_number("nan"), "") << "which JSON lacks";
  EXPECT_EQ(hint_for_quoted_number("inf"), "");
  EXPECT_EQ(hint_error(R"({"threshold": "low"})"), "f:1:15: threshold = \"low\": must be a number");
  EXPECT_EQ(hint_error(R"({"threshold": ""})"), "f:1:15: threshold = \"\": must be a number");
}

/// Any bytes, among them many that names, numbers and paths are made of.
rc::Gen<std::string> any_text() {
  static constexpr std::array<std::string_view, 19> kPieces{"[", "]",  ".",  "_", ",", "range", "0",    "5", "12", "%",
                                                            " ", "\n", "\"", "-", "e", "+",     "\xFF", "{", "}"};
  const auto piece = rc::gen::map(rc::gen::inRange<std::size_t>(0, kPieces.size() + 6), [](std::size_t i) {
    return i < kPieces.size() ? std::string(kPieces[i]) : std::string(1, char(i * 41));
  });
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const std::vector<std::string>& pieces) {
    std::string text;
    for (const std::string& part : pieces) text += part;
    return text;
  });
}

/// What a call makes of a copy of a text must be what it makes of the text among others.
template <typename Hint>
void expect_own_bytes_alone(const std::string& text, const Hint& hint) {
  const std::string whole = "5,[" + text + "]%5,";
  RC_ASSERT(hint(std::string_view(whole).substr(3, text.size())) == hint(std::string_view(text)));
}

RC_GTEST_PROP(Hint, AnyBytesAreReadWithinTheirEnds, ()) {
  const std::string text = *any_text();
  expect_own_bytes_alone(text, [](std::string_view of) { return hint_for_number(of); });
  expect_own_bytes_alone(text, [](std::string_view of) { return hint_for_quoted_number(of); });
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_word(of, {"range_m", text}); });
  expect_own_bytes_alone(text, [](std::string_view of) { return hint_for_fraction(5, of); });
  const auto offset = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_syntax(of, offset); });
}

RC_GTEST_PROP(Hint, AnyNamesPathsAndValuesAreReadOrRefused, ()) {
  const std::string name = *any_text();
  const std::string value = *any_text();
  std::string quoted = "\"";
  for (const char c : name) {
    if (c != '"' && static_cast<unsigned char>(c) >= ' ') quoted += c;
  }
  hint_error("{" + quoted + "\": 1}");
  hint_error("{\"threshold\": " + value + "}");
  try {
    const JsonValue document = parse_json(R"({"threshold": 0.5, "lights": [{"range": 1}]})", "f");
    if (!name.empty()) with_value(document, name, parse_json("7", "--set"), "--set").allow_only({"threshold"});
  } catch (const InputError&) {
  }
}

}  // namespace
}  // namespace litfog::test
