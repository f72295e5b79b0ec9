// SPDX-License-Identifier: Apache-2.0
#include "fit/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/double_limits.h"

namespace litfog::test {
namespace {

/// A line b0 + b1 x through points.
LeastSquaresProblem line(std::vector<double> x, std::vector<double> y) {
  const std::size_t count = x.size();
  return {count, differentiate<2>([x = std::move(x), y = std::move(y)](const auto* b, auto* residuals) {
            for (std::size_t i = 0; i < x.size(); ++i) residuals[i] = b[0] + b[1] * x[i] - y[i];
          })};
}

const std::vector<double> kOrigin{0, 0};

TEST(LeastSquares, LineHasItsClosedFormAndCovariance) {
  // Residuals of the best line 7/6 + x/2 are -1/6, 1/3, -1/6: variance 1/6, and (J'J)^-1 = {{5/6, -1/2}, {-1/2, 1/2}}.
  const LeastSquaresFit fit = fit_least_squares(line({0, 1, 2}, {1, 2, 2}), kOrigin);
  EXPECT_EQ(fit.status, LeastSquaresStatus::converged);
  EXPECT_NEAR(fit.parameters[0], 7 / 6., 1e-15);
  EXPECT_NEAR(fit.parameters[1], 0.5, 1e-15);
  EXPECT_NEAR(fit.objective, 1 / 12., 1e-16);
  ASSERT_TRUE(fit.covariance);
  const double covariance[] = {5 / 36., -1 / 12., -1 / 12., 1 / 12.};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR((*fit.covariance)[i], covariance[i], 1e-16) << i;
}

TEST(LeastSquares, ParametersStayWithinTheirBounds) {
  LeastSquaresProblem problem = line({0, 1, 2}, {1, 2, 2});
  problem.lower = {-kInfinity, -kInfinity};
  problem.upper = {1, kInfinity};
  const LeastSquaresFit fit = fit_least_squares(problem, kOrigin);
  EXPECT_EQ(fit.status, LeastSquaresStatus::converged);
  EXPECT_EQ(fit.parameters[0], 1);
  EXPECT_NEAR(fit.parameters[1], 0.6, 1e-15) << "(1 * 1 + 2 * 1) / (1 + 4)";
  ASSERT_TRUE(fit.covariance);
  EXPECT_EQ((*fit.covariance)[0], 0);
  EXPECT_EQ((*fit.covariance)[1], 0);
  EXPECT_NEAR((*fit.covariance)[3], 0.02, 1e-16) << "(0.4^2 + 0.2^2) / 2 of variance, over 5";
}

TEST(LeastSquares, CovarianceIsAbsentWhereTheDataDoNotIdentifyTheParameters) {
  EXPECT_FALSE(fit_least_squares(line({1, 1, 1}, {1, 2, 3}), kOrigin).covariance) << "one abscissa";
  EXPECT_FALSE(fit_least_squares(line({1, 2}, {1, 2}), kOrigin).covariance) << "no residual to spare";
  EXPECT_FALSE(fit_least_squares(line({1}, {1}), kOrigin).covariance) << "fewer residuals than parameters";
  EXPECT_TRUE(fit_least_squares(line({1e-9, 2e-9, 3e-9}, {1, 2, 4}), kOrigin).covariance) << "small is not singular";
}

TEST(LeastSquares, DescentStaysWhereTheModelHasAValue) {
  const auto logarithm = differentiate<1>([](const auto* b, auto* residuals) {
    using std::log;
    residuals[0] = log(b[0]) - 1.0;
    residuals[1] = log(b[0]) - 3.0;
  });
  const LeastSquaresFit undefined = fit_least_squares({2, logarithm}, std::vector<double>{-1});
  EXPECT_EQ(undefined.status, LeastSquaresStatus::undefined);
  EXPECT_EQ(undefined.parameters[0], -1);
  const LeastSquaresFit fit = fit_least_squares({2, logarithm}, std::vector<double>{1e3});
  EXPECT_EQ(fit.status, LeastSquaresStatus::converged);
  EXPECT_NEAR(fit.parameters[0], std::exp(2), 1e-14);
}

TEST(LeastSquares, OneDescentConvergesWherePlainStepsOvershoot) {
  const auto arc = differentiate<1>([](const auto* b, auto* residuals) {  // Newton's method diverges beyond 1.39
    using std::atan;
    residuals[0] = atan(b[0]);
  });
  const LeastSquaresFit near = fit_least_squares({1, arc}, std::vector<double>{3}, Descent::one);
  EXPECT_EQ(near.status, LeastSquaresStatus::converged);
  EXPECT_NEAR(near.parameters[0], 0, 1e-15);

  const auto bell = differentiate<1>([](const auto* b, auto* residuals) {  // no part of its tail's step is short enough
    using std::exp;
    residuals[0] = exp(-b[0] * b[0]) - 0.5;
  });
  const LeastSquaresFit far = fit_least_squares({1, bell}, std::vector<double>{5}, Descent::one);
  EXPECT_EQ(far.status, LeastSquaresStatus::converged);
  EXPECT_NEAR(std::abs(far.parameters[0]), std::sqrt(std::log(2)), 1e-14);
}

TEST(LeastSquares, FitWritesNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto overflowing = differentiate<1>([](const auto* b, auto* residuals) {
    using std::exp;
    residuals[0] = exp(exp(b[0])) - 2.0;
    residuals[1] = exp(b[0]) - 1.0;
  });
  const LeastSquaresFit fit = fit_least_squares({2, overflowing}, std::vector<double>{-20});
  const auto nowhere = [](auto, auto, auto) { return false; };
  EXPECT_EQ(fit_least_squares({1, nowhere}, kOrigin).status, LeastSquaresStatus::undefined);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(fit.status, LeastSquaresStatus::undefined);
}

}  // namespace
}  // namespace litfog::test
