// SPDX-License-Identifier: Apache-2.0
#include "command/table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reference/double_limits.h"

namespace litfog::test {
using namespace command;

namespace {

Table two_rows() { return {{"name", "x", "status"}, {{"a, \"b\"\n", 1.0 / 3, "ok"}, {"\xC3\xA4", kInfinity, "bad"}}}; }

TEST(Table, TextIsAlignedByCodePoints) {
  const Table table{{"name", "x", "status"},
                    {{"abc", 1.0 / 3, "ok"}, {"\xC3\xA4", 1e-9, "bad"}, {"", kInfinity, "ok"}}};
  EXPECT_EQ(format_table(table, TableFormat::text),
            "name         x  status\n"
            "abc   0.333333  ok\n"
            "\xC3\xA4        1e-09  bad\n"
            "-          inf  ok\n");
}

TEST(Table, WholeNumbersAreShownInFull) {
  const Table table{{"x"}, {{1234567.0}, {-200000.0}, {-0.0}, {1234567.5}, {1e9}}};
  EXPECT_EQ(format_table(table, TableFormat::text),
            "          x\n    1234567\n    -200000\n          0\n1.23457e+06\n      1e+09\n");
}

TEST(Table, TerminalGetsNoCommands) {
  EXPECT_EQ(format_table({{"name", "x"}, {{"\x1B[2J\n\xFF", 1.0}}}, TableFormat::text),
            "name             x\n\\x1b[2J\\x0a\\xff  1\n");
}

TEST(Table, CsvQuotesWhatNeedsItAndKeepsEveryDigit) {
  EXPECT_EQ(format_table(two_rows(), TableFormat::csv),
            "name,x,status\n\"a, \"\"b\"\"\n\",0.3333333333333333,ok\n\xC3\xA4,inf,bad\n");
}

TEST(Table, JsonReadsBackExactlyWithInfinityAsText) {
  const auto json = nlohmann::json::parse(format_table(two_rows(), TableFormat::json));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["name"], "a, \"b\"\n");
  EXPECT_EQ(json[0]["x"].get<double>(), 1.0 / 3);
  EXPECT_EQ(json[0]["status"], "ok");
  EXPECT_EQ(json[1]["name"], "\xC3\xA4");
  EXPECT_EQ(json[1]["x"], "inf");
}

TEST(Table, EmptyCellIsADashOrNothingOrNull) {
  const Table table{{"a", "b"}, {{1.0, "x"}, {std::monostate{}, std::monostate{}}}};
  EXPECT_EQ(format_table(table, TableFormat::text), "a  b\n1  x\n-  -\n");
  EXPECT_EQ(format_table(table, TableFormat::csv), "a,b\n1,x\n,\n");
  const auto row = nlohmann::json::parse(format_table(table, TableFormat::json))[1];
  EXPECT_TRUE(row["a"].is_null() && row["b"].is_null());
}

TEST(Table, TableWithoutRowsIsWellFormed) {
  const Table table{{"a", "b"}, {}};
  EXPECT_EQ(format_table(table, TableFormat::text), "a  b\n");
  EXPECT_EQ(format_table(table, TableFormat::csv), "a,b\n");
  EXPECT_EQ(nlohmann::json::parse(format_table(table, TableFormat::json)), nlohmann::json::array());
}

}  // namespace

}  // namespace litfog::test
