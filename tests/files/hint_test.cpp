// SPDX-License-Identifier: Apache-2.0
#include "files/hint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "files/json_document.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace files;

namespace {

/// The sentence of what is wrong with a document, which is read as {"threshold": number, "color": number}.
std::string error_of(const std::string& text) {
  try {
    const JsonValue root = parse_json(text, "f");
    root.allow_only({"threshold", "color"});
    const double threshold = root.number_or("threshold", 0.5);
    if (!(threshold > 0 && threshold < 1)) root.member("threshold").fail("must be in (0, 1)");
    root.number_or("color", 0);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(Hint, MisspeltMemberIsNamed) {
  EXPECT_EQ(error_of(R"({"treshold": 1})"),
            "f:1:2: \"treshold\": must be one of threshold, color; did you mean threshold?");
  EXPECT_EQ(error_of(R"({"Colour": 1})"), "f:1:2: \"Colour\": must be one of threshold, color; did you mean color?");
  EXPECT_EQ(error_of(R"({"weather": 1})"), "f:1:2: \"weather\": must be one of threshold, color");
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
  EXPECT_EQ(error_of(R"({"threshold": 5})"), "f:1:15: threshold = 5: must be in (0, 1); 5 % is 0.05");
  EXPECT_EQ(error_of(R"({"threshold": 1.1})"), "f:1:15: threshold = 1.1: must be in (0, 1); 1.1 % is 0.011");
  EXPECT_EQ(error_of(R"({"threshold": "5 %"})"), "f:1:15: threshold = \"5 %\": must be a number; 5 % is 0.05");
  EXPECT_EQ(error_of(R"({"threshold": "2,5%"})"), "f:1:15: threshold = \"2,5%\": must be a number; 2.5 % is 0.025");
  EXPECT_EQ(error_of(R"({"threshold": 200})"), "f:1:15: threshold = 200: must be in (0, 1)");
  EXPECT_EQ(error_of(R"({"threshold": -5})"), "f:1:15: threshold = -5: must be in (0, 1)");
}

TEST(Hint, OneInFloatsIsNoPercentage) {
  EXPECT_EQ(error_of(R"({"threshold": 1.0000001192092896})"),
            "f:1:15: threshold = 1.0000001192092896: must be in (0, 1)");
}

TEST(Hint, NumberInQuotationMarksIsShownWithout) {
  EXPECT_EQ(error_of(R"({"threshold": "0.05"})"),
            "f:1:15: threshold = \"0.05\": must be a number; write 0.05, without quotation marks");
  EXPECT_EQ(hint_for_quoted_number(" .5 "), "; write 0.5, without quotation marks") << "as JSON has it";
  EXPECT_EQ(hint_for_quoted_number("nan"), "") << "which JSON lacks";
  EXPECT_EQ(hint_for_quoted_number("inf"), "");
  EXPECT_EQ(error_of(R"({"threshold": "low"})"), "f:1:15: threshold = \"low\": must be a number");
  EXPECT_EQ(error_of(R"({"threshold": ""})"), "f:1:15: threshold = \"\": must be a number");
}

TEST(Hint, NumberWithItsUnitIsToStandAlone) {
  EXPECT_EQ(hint_for_number("120 m", "range.extent_m"), "; write 120 alone");
  EXPECT_EQ(hint_for_number("3000K", "color_temperature_k"), "; write 3000 alone");
  EXPECT_EQ(hint_for_number("20\u00b0", "cone.beam_angle_deg"), "; write 20 alone");
  EXPECT_EQ(hint_for_number("24 Degrees", "cone.beam_angle_deg[0]"), "; write 24 alone");
  EXPECT_EQ(hint_for_number("5 lx", "range.illuminance.lx"), "; write 5 alone");
}

TEST(Hint, NumberOfAnotherUnitIsToldTheRightOne) {
  EXPECT_EQ(hint_for_number("20%", "cone.beam_angle_deg"), "; its unit is degrees");
  EXPECT_EQ(hint_for_number("400 ft", "range.extent_m"), "; its unit is metres");
  EXPECT_EQ(hint_for_number("20 knots", "threshold"), "");
  EXPECT_EQ(hint_for_number("5 m", "m"), "") << "a name, not a unit";
}

TEST(Hint, CommaBetweenItemsIsNotTakenForADecimalOne) {
  for (const char* text : {R"({"beam_angle_deg": [24,6})", R"({"beam_angle_deg": [24,6 8,5]})", R"({"a": [1,2,)",
                           R"({"a": [1,1e999]})", R"({"a": [2,-]})"}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find(": must "), std::string::npos) << error;
    EXPECT_EQ(error.find("write"), std::string::npos) << error;
  }
}

TEST(Hint, DecimalCommaIsShownAsAPoint) {
  EXPECT_EQ(error_of(R"({"threshold": "0,05"})"),
            "f:1:15: threshold = \"0,05\": must be a number; write 0.05, with a decimal point");
  EXPECT_EQ(error_of(R"({"threshold": 0,05})"),
            "f:1:17: text = \"05\": must be a member's name in quotes; write 0.05, with a decimal point");
  EXPECT_EQ(error_of(R"({"threshold": 12,5, "color": 1})"),
            "f:1:18: text = \"5\": must be a member's name in quotes; write 12.5, with a decimal point");
  EXPECT_EQ(error_of(R"({"color": [0,05, 1]})"),
            "f:1:15: text = \"5\": must be ',' or ']'; write 0.05, with a decimal point");
  EXPECT_EQ(error_of(R"({"threshold": 1,200})"),
            "f:1:17: text = \"200\": must be a member's name in quotes; write 1.200 or 1200");
  EXPECT_EQ(hint_for_number("1,200"), "; write 1.200 or 1200");
  EXPECT_EQ(hint_for_number("1,200,000"), "");
  EXPECT_EQ(hint_for_number(",5"), "");
  EXPECT_EQ(hint_for_number("5,"), "");
  EXPECT_EQ(error_of(R"({"threshold": 0.5, color: 1})"), "f:1:20: text = \"color\": must be a member's name in quotes");
}

TEST(Hint, NameThatEndsInABracketHasNoIndexWithoutItsOther) {
  const std::string_view before_and_name = "_m range]";
  EXPECT_EQ(hint_for_number("5 ft", before_and_name.substr(3)), "") << "what stands before a name is not its unit";
  EXPECT_EQ(hint_for_number("5 ft", "range_m]"), "");
  EXPECT_EQ(hint_for_number("5 ft", "]"), "");
  EXPECT_EQ(hint_for_word("range]", {"range"}), "; did you mean range?");
  EXPECT_EQ(error_of(R"({"range]": 1})"), "f:1:2: \"range]\": must be one of threshold, color");
}

/// Any bytes, among them many that names, numbers and paths are made of.
rc::Gen<std::string> any_text() {
  static constexpr std::array<std::string_view, 26> kPieces{
      "[",  "]", ".", "_",        ",",  "_m", "_deg", "m", "ft", "deg",  "range", "0", "5",
      "12", "%", " ", "\xC2\xB0", "\n", "\"", "-",    "e", "+",  "\xFF", "{",     "}", ":"};
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
  const std::string whole = "_m[" + text + "]_m5,";
  RC_ASSERT(hint(std::string_view(whole).substr(3, text.size())) == hint(std::string_view(text)));
}

RC_GTEST_PROP(Hint, AnyBytesAreReadWithinTheirEnds, ()) {
  const std::string text = *any_text();
  const std::string member = *any_text();
  expect_own_bytes_alone(member, [&](std::string_view of) { return hint_for_number(text, of); });
  expect_own_bytes_alone(member, [&](std::string_view of) { return hint_for_number("5 ft", of); });
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_number(of, member); });
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_quoted_number(of, member); });
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_word(of, {"range_m", member}); });
  expect_own_bytes_alone(text, [&](std::string_view of) { return hint_for_fraction(5, of); });
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
  error_of("{" + quoted + "\": 1}");
  error_of("{\"threshold\": " + value + "}");
  try {
    const JsonValue document = parse_json(R"({"threshold": 0.5, "lights": [{"range": 1}]})", "f");
    if (!name.empty()) with_value(document, name, parse_json("7", "--set"), "--set").allow_only({"threshold"});
  } catch (const InputError&) {
  }
}

}  // namespace
}  // namespace litfog::test
