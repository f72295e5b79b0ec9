// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/pages.h"

#include <gtest/gtest.h>

#include "command/html_text.h"

namespace litfog::test {
using namespace command;
using namespace demo;
using namespace render;

namespace {

const PageFacts kFacts{
    .machine = "a <fast> card", .width = 640, .height = 360, .frames = 7, .settings = "nothing is skipped"};

SceneResult result(const std::string& name) {
  SceneResult scene{.name = name, .description = "lamps & <fog>", .conditions = "clear air", .lights = 3};
  for (const LightingPath& path : lighting_paths()) {
    scene.paths.push_back({.path = &path,
                           .milliseconds = 12.345,
                           .spread = 0.5,
                           .over_legacy = 1.234,
                           .largest_error = 0.98765,
                           .mean_error = 0.0123,
                           .excluded = 0});
  }
  return scene;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(ComparisonPage, EveryPathHasItsDescriptionAndMeasurements) {
  const std::string page = comparison_page(kFacts, {result("room")});
  for (const LightingPath& path : lighting_paths()) {
    EXPECT_EQ(count(page, "<h3>" + std::string(path.name) + "</h3>"), 1u) << path.name;
    EXPECT_NE(page.find(html_text(path.source)), page.npos) << path.name;
    EXPECT_NE(page.find(path.description), page.npos) << path.name;
  }
  for (const char* value : {">12.3<", ">1.23<", ">0.988<", ">0.0123<"}) EXPECT_GE(count(page, value), 10u) << value;
  EXPECT_NE(page.find("7 frames"), page.npos);
  EXPECT_EQ(page.find("pixels excluded"), page.npos);

  SceneResult scene = result("room");
  scene.paths[3].excluded = 26;
  EXPECT_EQ(count(comparison_page(kFacts, {scene}), "pixels excluded: 26<"), 1u);
}

TEST(ComparisonPage, TextsOfFilesAreEscaped) {
  const std::string page = comparison_page(kFacts, {result("a\"b<i>#1")});
  EXPECT_EQ(page.find("<i>"), page.npos);
  EXPECT_EQ(page.find("<fog>"), page.npos);
  EXPECT_EQ(page.find("<fast>"), page.npos);
  EXPECT_NE(page.find("<h2>a&quot;b&lt;i&gt;#1</h2>"), page.npos);
  EXPECT_NE(page.find("src=\"a%22b%3Ci%3E%231-radial-plane.png\""), page.npos);
}

TEST(ComparisonPage, EachSceneHasASectionAndNothingComesFromElsewhere) {
  const std::string page = comparison_page(kFacts, {result("room"), result("road")});
  EXPECT_EQ(count(page, "<section"), 2u);
  EXPECT_EQ(count(page, "<figure>"), 2 * (1 + lighting_paths().size()));
  for (const char* outside : {"http", "<script", "<link", "url(", "@import"})
    EXPECT_EQ(count(page, outside), 0u) << outside;
}

TEST(ComparisonPage, EveryPictureHasAnAlternativeText) {
  const std::string page = comparison_page(kFacts, {result("room")});
  EXPECT_EQ(count(page, "<img "), 1 + 3 * lighting_paths().size());
  EXPECT_EQ(count(page, "<img "), count(page, "alt=\"room"));
}

}  // namespace

}  // namespace litfog::test
