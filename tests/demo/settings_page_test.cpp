// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/pages.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "drawing/picture_file.h"

namespace litfog::test {
namespace {

using demo::PairResult;
using demo::SettingResult;
using demo::settings_page;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

std::string page(const std::string& words = "as it is") {
  const std::vector<SettingResult> settings{
      {words, 12.345, 0.5, "png 1"}, {"visibility=50", 24.69, 0.25, "png 2"}, {"no-skip", 6.1725, 1, "png 3"}};
  const std::vector<PairResult> pairs{
      {0, 1, 98.765, 1.2345, "heat 1"}, {0, 2, 0, 0, "heat 2"}, {1, 2, 7, 0.5, "heat 3"}};
  return settings_page({.title = "a <room>", .machine = "a \"fast\" card", .width = 64, .height = 36, .frames = 7},
                       settings, pairs);
}

TEST(SettingsPage, HoldsAllPicturesItselfAndNothingComesFromElsewhere) {
  const std::string html = page();
  EXPECT_EQ(count(html, "data:image/png;base64,"), 6u);
  for (const char* picture : {"cG5nIDE=", "cG5nIDI=", "cG5nIDM=", "aGVhdCAx", "aGVhdCAy", "aGVhdCAz"}) {
    EXPECT_EQ(count(html, std::string("\"data:image/png;base64,") + picture + "\""), 1u) << picture;
  }
  for (const char* outside : {"http", "<link", "src=\"", "url(", "@import", "fetch(", "import "}) {
    EXPECT_EQ(count(html, outside), 0u) << outside;
  }
}

TEST(SettingsPage, TableStatesTimesAndDifferencesFromTheFirst) {
  const std::string html = page();
  EXPECT_NE(html.find(">12.3</span></td><td>1.00</td><td></td><td></td>"), html.npos);
  EXPECT_NE(html.find(">24.7</span></td><td>2.00</td><td>98.8</td><td>1.23</td>"), html.npos);
  EXPECT_NE(html.find(">6.17</span></td><td>0.50</td><td>0</td><td>0</td>"), html.npos);
  EXPECT_NE(html.find("{first: 1, second: 2, largest: \"7\", mean: \"0.5\", picture: \"data:"), html.npos);
  EXPECT_NE(html.find("medians of 7 frames"), html.npos);
}

TEST(SettingsPage, EachSettingCanBeChosenForEitherSide) {
  const std::string html = page();
  EXPECT_EQ(count(html, "<option value=\"1\">2: visibility=50</option>"), 2u);
  EXPECT_EQ(count(html, "<option "), 6u);
  EXPECT_EQ(matches(html, "data-mode=\"(\\w+)\""), (std::set<std::string>{"a", "b", "wipe", "difference"}));
}

TEST(SettingsPage, EveryElementThatTheScriptAsksForIsThere) {
  const std::string html = page();
  const std::set<std::string> ids = matches(html, " id=\"(\\w+)\"");
  const std::set<std::string> wanted = matches(html, "byId\\('(\\w+)'\\)");
  EXPECT_GE(wanted.size(), 12u);
  for (const std::string& id : wanted) EXPECT_TRUE(ids.contains(id)) << id;
}

TEST(SettingsPage, TextsAreEscaped) {
  const std::string html = page("</script><b>\"\\\xFF");
  EXPECT_EQ(count(html, "</script>"), 1u);
  EXPECT_EQ(count(html, "<b>"), 0u);
  EXPECT_EQ(count(html, "<room>"), 0u);
  EXPECT_NE(html.find("const names = [\"\\u003c/script>\\u003cb>\\\"\\\\\\\\xff\", "), html.npos);
}

}  // namespace
}  // namespace litfog::test
