// SPDX-License-Identifier: Apache-2.0
#include "command/option_rule.h"
#include "core/value_errors.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace litfog::test {
using namespace command;

namespace {

std::string error_of(const std::string& arguments, const std::vector<OptionRule>& rules) {
  CLI::App app;
  for (const char* name : {"--fog", "--visibility", "--density"}) app.add_flag(name);
  app.parse(arguments);
  return sentence_of<CLI::ValidationError>([&] { check_options(app, rules); });
}

TEST(OptionRule, LongValueIsCutInItsError) {
  EXPECT_EQ(
      sentence_of<CLI::ValidationError>([&] { fail_option("--set", std::string(100'000, 'x'), "must be short"); }),
      "--set = " + std::string(200, 'x') + "...: must be short");
}

TEST(OptionRule, ExcludedOptionIsAUsageErrorWithItsReason) {
  EXPECT_EQ(error_of("--visibility", {{"--fog none", true, {"--density", "--visibility"}, "the air is clear"}}),
            "--visibility cannot be given with --fog none: the air is clear");
  EXPECT_EQ(error_of("--visibility", {{"--density", true, {"--visibility"}}}),
            "--visibility cannot be given with --density");
}

TEST(OptionRule, OtherOptionsAndConditionsAreAccepted) {
  EXPECT_EQ(error_of("--fog", {{"--density", true, {"--visibility"}}}), "no error");
  EXPECT_EQ(error_of("--fog --visibility", {{"--fog none", false, {"--visibility"}}}), "no error");
  EXPECT_EQ(error_of("--fog", {{"--fog none", true, {"--an-option-of-other-jobs"}}}), "no error");
}

}  // namespace

}  // namespace litfog::test
