// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/course.h"
#include "core/value_errors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace litfog::test {
namespace {

using command::kNotNegative;
using demo::Course;
using demo::parse_course;
using demo::parse_point_course;
using demo::Steps;

TEST(Course, NumberIsTheSameInAllFrames) {
  const Course<double> course = parse_course("--x", "400", kNotNegative);
  EXPECT_TRUE(course.is_constant());
  EXPECT_FALSE(course.frames());
  EXPECT_EQ(course.at(7, 9), 400);
}

TEST(Course, ListHasAFrameForEachOfItsNumbers) {
  const Course<double> course = parse_course("--x", "4,0,inf", kNotNegative);
  EXPECT_EQ(course.frames(), 3);
  EXPECT_EQ(course.at(0, 3), 4);
  EXPECT_EQ(course.at(1, 3), 0);
  EXPECT_TRUE(std::isinf(course.at(2, 3)));
}

TEST(Course, RangeGoesEvenlyFromOneEndExactlyToTheOther) {
  const Course<double> course = parse_course("--x", "0.1..0.7:4", kNotNegative);
  EXPECT_EQ(course.frames(), 4);
  EXPECT_EQ(course.at(0, 4), 0.1);
  EXPECT_EQ(course.at(3, 4), 0.7);
  EXPECT_FALSE(parse_course("--x", "1..2", kNotNegative).frames());
}

TEST(Course, NumbersBetweenDecimalEndsHaveNoRoundingDigits) {
  ASSERT_NE(std::lerp(1.5, 0, 4.0 / 5), 0.3);
  const auto numbers = [](double from, double to, int count) {
    const Course<double> course{.values = {from, to}, .is_range = true};
    std::string text;
    for (int frame = 0; frame < count; ++frame) text += fmt::format(" {}", course.at(frame, count));
    return text;
  };
  EXPECT_EQ(numbers(1.5, 0, 6), " 1.5 1.2 0.9 0.6 0.3 0");
  ASSERT_LT(std::lerp(-0.1, 0.2, 1.0 / 3), 0);
  EXPECT_EQ(numbers(-0.1, 0.2, 4), " -0.1 0 0.1 0.2");
  for (const double end : {1e-9, 1e-3, 0.1, 1e3, 1e6, 1e14, 1e15, 1e40}) {
    const Course<double> course{.values = {0, end}, .is_range = true};
    for (int frame = 0; frame < 7; ++frame) {
      EXPECT_NEAR(course.at(frame, 7), frame * end / 6, 1e-14 * end) << end << ", " << frame;
    }
  }
  const Course<double> zeros{.values = {0, 0}, .is_range = true};
  EXPECT_EQ(zeros.at(1, 3), 0);
}

TEST(Course, RatiosOfNeighboursAreTheSame) {
  const Course<double> course = parse_course("--x", "2000..20:5", kNotNegative, Steps::ratio);
  EXPECT_EQ(course.at(0, 5), 2000);
  EXPECT_NEAR(course.at(2, 5), 200, 1e-12);
  EXPECT_EQ(course.at(4, 5), 20);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(course.at(i, 5) / course.at(i + 1, 5), std::sqrt(10.0), 1e-14) << i;
}

TEST(Course, PointsGoFromOneToTheOther) {
  const Course<glm::dvec3> course = parse_point_course("--x", "0,-2,1e1..-4,2,20:3");
  EXPECT_EQ(course.frames(), 3);
  EXPECT_EQ(course.at(0, 3), glm::dvec3(0, -2, 10));
  EXPECT_EQ(course.at(1, 3), glm::dvec3(-2, 0, 15));
  EXPECT_EQ(course.at(2, 3), glm::dvec3(-4, 2, 20));
  EXPECT_TRUE(parse_point_course("--x", "1,2,3").is_constant());
}

TEST(Course, WrongTextsAreErrorsOfTheirOption) {
  const auto error = [](const std::string& text) -> std::string {
    return sentence_of<CLI::ValidationError>([&] { parse_course("--x", text, kNotNegative, Steps::ratio); });
  };
  EXPECT_EQ(error("1,x"), "--x = x: must be a number >= 0 or inf");
  EXPECT_EQ(error("1,"), "--x = \"\": must be a number >= 0 or inf");
  EXPECT_EQ(error("-1..2"), "--x = -1: must be a number >= 0 or inf");
  EXPECT_EQ(error("1..2:1"), "--x = 1..2:1: must have from 2 to 1000 frames after ':'");
  EXPECT_EQ(error("1..2:1001"), "--x = 1..2:1001: must have from 2 to 1000 frames after ':'");
  EXPECT_EQ(error("1..2:"), "--x = 1..2:: must have from 2 to 1000 frames after ':'");
  for (const char* text : {"0..2", "2..inf"}) {
    EXPECT_EQ(error(text),
              std::string("--x = ") + text + ": must begin and end at finite numbers > 0: its steps are ratios");
  }
}

TEST(Course, WordsWithDotsAreNoCourses) {
  for (const char* text : {"1..2", "-1e3..0.5:24", "0..9:x", "1..", "..2", "1,2,3", "[1..2]", "[0,1]..[2,3]"}) {
    EXPECT_TRUE(demo::is_meant_as_course(text)) << text;
  }
  for (const char* text : {"../lights/a.json", "lights/../a.json", "1", "1.5", "[1,2,3]", "a..b", "a,1"}) {
    EXPECT_FALSE(demo::is_meant_as_course(text)) << text;
  }
}

}  // namespace
}  // namespace litfog::test
