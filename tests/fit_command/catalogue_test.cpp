// SPDX-License-Identifier: Apache-2.0
#include "fit/catalogue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "command/temporary_directory.h"

namespace litfog::test {
namespace {

using namespace fit;

constexpr const char* kSpec = R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 100},
  "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}})";

TEST(Catalogue, LampIsDoneUnlessItsFileHasChangedSinceTheCatalogueWasBegun) {
  const TemporaryDirectory directory;
  const Input input{(directory.path() / "lamp.json").string(), "lamp"};
  const auto write = [&input] { std::ofstream(input.path) << kSpec; };
  const auto is_done = [&](bool is_written_meanwhile) {
    write();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Catalogue catalogue((directory.path() / "catalogue").string(), "", {input});
    Outcome outcome;
    outcome.input = input;
    outcome.fit = fit_light(read_spec(input.path), false);
    outcome.verdict = judge(*outcome.fit);
    if (is_written_meanwhile) write();
    catalogue.add(outcome, summary_of(outcome, true));
    return catalogue.find(input).has_value();
  };
  EXPECT_TRUE(is_done(false));
  EXPECT_FALSE(is_done(true));
}

}  // namespace
}  // namespace litfog::test
