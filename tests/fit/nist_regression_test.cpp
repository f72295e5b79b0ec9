// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "fit/least_squares.h"
#include "reference/ulp.h"

// The least squares against the nonlinear regressions of NIST's Statistical Reference Datasets, which are certified to
// 11 digits. Their figures are in tests/data/nist_strd.json.

namespace litfog::test {
namespace {

struct Observation {
  double y;
  std::vector<double> x;
};

struct Dataset {
  std::array<std::vector<double>, 2> starts;
  std::vector<double> certified;
  std::vector<double> deviations;
  double sum_of_squares = 0;
  std::vector<Observation> observations;
};

std::map<std::string, Dataset> read_datasets() {
  std::ifstream file(LITFOG_TEST_DATA_DIR "/nist_strd.json");
  std::map<std::string, Dataset> datasets;
  const auto document = nlohmann::json::parse(file);
  for (const auto& problem : document.at("problems")) {
    Dataset& dataset = datasets[problem.at("name")];
    problem.at("starts").get_to(dataset.starts);
    problem.at("certified").get_to(dataset.certified);
    problem.at("standard_deviations").get_to(dataset.deviations);
    problem.at("residual_sum_of_squares").get_to(dataset.sum_of_squares);
    for (const std::vector<double> row : problem.at("observations")) {
      dataset.observations.push_back({row.front(), {row.begin() + 1, row.end()}});
    }
  }
  return datasets;
}

using MakeResiduals = std::function<ResidualFunction(const std::vector<Observation>&)>;

/// Residuals y - model(b, x) for a model over any scalar.
template <std::size_t kParameters, typename Model>
MakeResiduals residuals_of(const Model& model) {
  return [model](const std::vector<Observation>& observations) {
    return differentiate<kParameters>([model, observations](const auto* b, auto* residuals) {
      for (std::size_t i = 0; i < observations.size(); ++i) {
        residuals[i] = observations[i].y - model(b, observations[i].x[0]);
      }
    });
  };
}

/// The models, by problem.
std::map<std::string, MakeResiduals> models() {
  using std::atan, std::cos, std::exp, std::log, std::pow, std::sin;
  const auto misra1a = residuals_of<2>([](const auto* b, double x) { return b[0] * (1.0 - exp(-b[1] * x)); });
  const auto chwirut = residuals_of<3>([](const auto* b, double x) { return exp(-b[0] * x) / (b[1] + b[2] * x); });
  const auto lanczos = residuals_of<6>(
      [](const auto* b, double x) { return b[0] * exp(-b[1] * x) + b[2] * exp(-b[3] * x) + b[4] * exp(-b[5] * x); });
  const auto gauss = residuals_of<8>([](const auto* b, double x) {
    const auto bell = [&](const auto& height, const auto& middle, const auto& width) {
      return height * exp(-(x - middle) * (x - middle) / (width * width));
    };
    return b[0] * exp(-b[1] * x) + bell(b[2], b[3], b[4]) + bell(b[5], b[6], b[7]);
  });
  const auto cubic_over_cubic = residuals_of<7>([](const auto* b, double x) {
    return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
  });
  const auto nelson = [](const std::vector<Observation>& observations) {
    return differentiate<3>([observations](const auto* b, auto* residuals) {
      for (std::size_t i = 0; i < observations.size(); ++i) {
        const auto& [y, x] = observations[i];
        residuals[i] = log(y) - (b[0] - b[1] * x[0] * exp(-b[2] * x[1]));
      }
    });
  };
  return {
      {"Bennett5", residuals_of<3>([](const auto* b, double x) { return b[0] * pow(b[1] + x, -1.0 / b[2]); })},
      {"BoxBOD", misra1a},
      {"Chwirut1", chwirut},
      {"Chwirut2", chwirut},
      {"DanWood", residuals_of<2>([](const auto* b, double x) { return b[0] * pow(x, b[1]); })},
      {"ENSO", residuals_of<9>([](const auto* b, double x) {
         const double turn = 2 * std::numbers::pi * x;
         return b[0] + b[1] * cos(turn / 12) + b[2] * sin(turn / 12) + b[4] * cos(turn / b[3]) +
                b[5] * sin(turn / b[3]) + b[7] * cos(turn / b[6]) + b[8] * sin(turn / b[6]);
       })},
      {"Eckerle4", residuals_of<3>([](const auto* b, double x) {
         return b[0] / b[1] * exp(-0.5 * (x - b[2]) * (x - b[2]) / (b[1] * b[1]));
       })},
      {"Gauss1", gauss},
      {"Gauss2", gauss},
      {"Gauss3", gauss},
      {"Hahn1", cubic_over_cubic},
      {"Kirby2", residuals_of<5>([](const auto* b, double x) {
         return (b[0] + x * (b[1] + x * b[2])) / (1.0 + x * (b[3] + x * b[4]));
       })},
      {"Lanczos1", lanczos},
      {"Lanczos2", lanczos},
      {"Lanczos3", lanczos},
      {"MGH09",
       residuals_of<4>([](const auto* b, double x) { return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]); })},
      {"MGH10", residuals_of<3>([](const auto* b, double x) { return b[0] * exp(b[1] / (x + b[2])); })},
      {"MGH17",
       residuals_of<5>([](const auto* b, double x) { return b[0] + b[1] * exp(-x * b[3]) + b[2] * exp(-x * b[4]); })},
      {"Misra1a", misra1a},
      {"Misra1b",
       residuals_of<2>([](const auto* b, double x) { return b[0] * (1.0 - pow(1.0 + b[1] * x / 2.0, -2.0)); })},
      {"Misra1c",
       residuals_of<2>([](const auto* b, double x) { return b[0] * (1.0 - pow(1.0 + 2.0 * b[1] * x, -0.5)); })},
      {"Misra1d", residuals_of<2>([](const auto* b, double x) { return b[0] * b[1] * x / (1.0 + b[1] * x); })},
      {"Nelson", nelson},
      {"Rat42", residuals_of<3>([](const auto* b, double x) { return b[0] / (1.0 + exp(b[1] - b[2] * x)); })},
      {"Rat43",
       residuals_of<4>([](const auto* b, double x) { return b[0] / pow(1.0 + exp(b[1] - b[2] * x), 1.0 / b[3]); })},
      {"Roszman1", residuals_of<4>([](const auto* b, double x) {
         return b[0] - b[1] * x - atan(b[2] / (x - b[3])) / std::numbers::pi;
       })},
      {"Thurber", cubic_over_cubic},
  };
}

/// The data follow the model exactly: the residuals are the rounding of the figures.
constexpr std::string_view kWithoutNoise = "Lanczos1";

/// Largest relative error of computed values.
double largest_error(const std::vector<double>& computed, const std::vector<double>& certified) {
  double largest = 0;
  for (std::size_t i = 0; i < certified.size(); ++i) {
    const double error = std::abs(computed.at(i) - certified[i]) / std::abs(certified[i]);
    if (!(error <= largest)) largest = error;
  }
  return largest;
}

TEST(NistRegression, EveryModelHasItsCertifiedSumOfSquaresAtItsCertifiedParameters) {
  const auto model_of = models();
  WorstError error("sum of squares", "26 NIST problems, as certified", 2e-10, "relative");
  for (const auto& [name, dataset] : read_datasets()) {
    if (name == kWithoutNoise) continue;
    std::vector<double> residuals(dataset.observations.size());
    ASSERT_TRUE(model_of.at(name)(dataset.observations)(dataset.certified, residuals, {}));
    double sum = 0;
    for (const double residual : residuals) sum += residual * residual;
    error.add(std::abs(sum / dataset.sum_of_squares - 1), [&, &problem = name] { return problem; });
  }
  error.check();
}

TEST(NistRegression, LeastSquaresFindsEveryCertifiedSolutionFromBothStarts) {
  const auto model_of = models();
  WorstError parameters("parameters", "27 NIST problems from 2 starts", 1e-10, "relative");
  WorstError deviations("standard deviations", "26 NIST problems from 2 starts", 1e-10, "relative");
  int starts = 0;
  for (const auto& [name, dataset] : read_datasets()) {
    const LeastSquaresProblem problem{dataset.observations.size(), model_of.at(name)(dataset.observations)};
    for (const auto& start : dataset.starts) {
      SCOPED_TRACE(name);
      const LeastSquaresFit fit = fit_least_squares(problem, start);
      EXPECT_EQ(fit.status, LeastSquaresStatus::converged);
      const auto describe = [&, &problem_name = name] { return problem_name; };
      parameters.add(largest_error(fit.parameters, dataset.certified), describe);
      ++starts;
      ASSERT_TRUE(fit.covariance);
      if (name == kWithoutNoise) continue;
      std::vector<double> found;
      const std::size_t n = start.size();
      for (std::size_t i = 0; i < n; ++i) found.push_back(std::sqrt((*fit.covariance)[i * n + i]));
      deviations.add(largest_error(found, dataset.deviations), describe);
    }
  }
  parameters.check();
  deviations.check();
  EXPECT_EQ(starts, 54);
}

}  // namespace
}  // namespace litfog::test
