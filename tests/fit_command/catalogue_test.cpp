// SPDX-License-Identifier: Apache-2.0
#include "fit/catalogue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "command/temporary_directory.h"
#include "litfog/files/output_error.h"

namespace litfog::test {
namespace {

using namespace fit;

constexpr const char* kSpec = R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 100},
  "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}})";

Outcome outcome_of(const Input& input) {
  Outcome outcome;
  outcome.input = input;
  outcome.fit = fit_light(read_spec(input.path), false);
  outcome.verdict = judge(*outcome.fit);
  return outcome;
}

TEST(Catalogue, LampIsDoneUnlessItsFileHasChangedSinceTheCatalogueWasBegun) {
  const TemporaryDirectory directory;
  const Input input{(directory.path() / "lamp.json").string(), "lamp"};
  const auto write = [&input] { std::ofstream(input.path) << kSpec; };
  const auto is_done = [&](bool is_written_meanwhile) {
    write();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Catalogue catalogue((directory.path() / "catalogue").string(), "", {input});
    const Outcome outcome = outcome_of(input);
    if (is_written_meanwhile) write();
    catalogue.add(outcome, summary_of(outcome, true));
    return catalogue.find(input).has_value();
  };
  EXPECT_TRUE(is_done(false));
  EXPECT_FALSE(is_done(true));
}

TEST(Catalogue, FilesOfARunThatWasEndedAreTheCataloguesOwn) {
  const TemporaryDirectory directory;
  const Input input{(directory.path() / "lamp.json").string(), "lamp"};
  std::ofstream(input.path) << kSpec;
  const std::string folder = (directory.path() / "catalogue").string();
  const std::filesystem::path picture = std::filesystem::path(folder) / "lamps/lamp.png";
  const Catalogue ended(folder, "", {input});
  std::filesystem::create_directory(picture);
  const Outcome outcome = outcome_of(input);
  EXPECT_THROW(ended.add(outcome, summary_of(outcome, true)), OutputError);
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder) / "lamps/lamp.svg")) << "it was begun";
  std::filesystem::remove(picture);
  const Catalogue next(folder, "", {input});
  EXPECT_FALSE(next.find(input));
  next.add(outcome, summary_of(outcome, true));
  EXPECT_TRUE(next.find(input));
}

}  // namespace
}  // namespace litfog::test
