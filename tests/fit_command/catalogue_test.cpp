// SPDX-License-Identifier: Apache-2.0
#include "fit/catalogue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "command/exit_status.h"
#include "command/program_folder.h"
#include "command/temporary_directory.h"
#include "litfog/files/output_error.h"

namespace litfog::test {
namespace {

using namespace fit;

constexpr const char* kSpec = R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 100},
  "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}})";

FittedLamp fitted(const Input& input) {
  Outcome outcome;
  outcome.input = input;
  outcome.fit = fit_light(read_spec(input.path), false);
  outcome.verdict = judge(*outcome.fit);
  const Summary summary = summary_of(outcome, true);
  return {std::move(outcome), summary};
}

TEST(Catalogue, LampIsDoneUnlessItsFileHasChangedSinceTheCatalogueWasBegun) {
  const TemporaryDirectory directory;
  const Input input{(directory.path() / "lamp.json").string(), "lamp"};
  const auto write = [&input] { std::ofstream(input.path) << kSpec; };
  const auto is_done = [&](bool is_written_meanwhile) {
    write();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Catalogue catalogue((directory.path() / "catalogue").string(), "", {input});
    const std::vector lamps{fitted(input)};
    if (is_written_meanwhile) write();
    catalogue.add(lamps);
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
  const std::vector lamps{fitted(input)};
  EXPECT_THROW(ended.add(lamps), OutputError);
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder) / "lamps/lamp.svg")) << "it was begun";
  std::filesystem::remove(picture);
  const Catalogue next(folder, "", {input});
  EXPECT_FALSE(next.find(input));
  next.add(lamps);
  EXPECT_TRUE(next.find(input));
}

TEST(Catalogue, LampsWhosePicturesAreNotFinishedAreDoneByTheNextRun) {
  const TemporaryDirectory directory;
  const auto input_of = [&](const std::string& name) {
    const Input input{(directory.path() / (name + ".json")).string(), name};
    std::ofstream(input.path) << kSpec;
    return input;
  };
  const std::vector inputs{input_of("first"), input_of("second")};
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const Catalogue catalogue((directory.path() / "catalogue").string(), "", inputs);
  const std::vector lamps{fitted(inputs[0]), fitted(inputs[1])};
  write_program(directory.path() / "gnuplot", "echo '<svg></svg>'; kill -9 $$");
  {
    const ProgramFolder folder(directory.path());
    EXPECT_THROW(catalogue.add(lamps), command::MissingCapability);
  }
  for (const Input& input : inputs) EXPECT_FALSE(catalogue.find(input));
  catalogue.add(lamps);
  for (const Input& input : inputs) EXPECT_TRUE(catalogue.find(input));
}

}  // namespace
}  // namespace litfog::test
