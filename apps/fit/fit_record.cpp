// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_record.h"

#include <nlohmann/json.hpp>

#include "files/light_json.h"

namespace litfog::fit {

namespace {

using Json = nlohmann::ordered_json;

template <typename Matrix>
Json covariance_of(const std::optional<Matrix>& rows) {
  return rows ? Json(*rows) : Json("not identifiable");
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json range_record(const AttenuationFit& fit) {
  Json active = Json::array();
  for (const auto constraint : fit.active) active.push_back(litfog::name_of(constraint));
  std::optional<std::array<std::array<double, 3>, 3>> covariance;
  if (fit.covariance) {
    covariance.emplace();
    for (std::size_t i = 0; i < fit.covariance->size(); ++i) (*covariance)[i / 3][i % 3] = (*fit.covariance)[i];
  }
  Json record{
      {"status", name_of(fit.status)},      {"objective", fit.objective},   {"rms", fit.rms_error},
      {"largest_error", fit.largest_error}, {"active", std::move(active)},  {"covariance", covariance_of(covariance)},
      {"kkt_residual", fit.kkt_residual},   {"iterations", fit.iterations}, {"boxes", fit.boxes}};
  return record;
}

Json profile_record(const ConeProfileFit& fit, const ConeTarget& target) {
  Json covariance = "not identifiable";
  if (fit.covariance) {
    const std::size_t count = fitted_parameters(fit.cone.profile).size();
    covariance = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = (*fit.covariance)[i].begin();
      covariance.push_back(std::vector(row, row + std::ptrdiff_t(count)));
    }
  }
  return {{"cone", Json::parse(files::cone_json(fit.cone))},
          {"status", name_of(fit.status)},
          {"objective", fit.objective},
          {"lower_bound", fit.lower_bound},
          {"rms", fit.rms},
          {"largest_error", fit.largest_error},
          {"largest_error_deg", files::degrees(fit.largest_error_angle)},
          {"flux_error", number_or_null(fit.flux_error)},
          {"beam_angle_error", number_or_null(fit.beam_angle_error)},
          {"field_angle_error", number_or_null(fit.field_angle_error)},
          {"active", active_constraints(fit.cone, target)},
          {"covariance", std::move(covariance)},
          {"kkt_residual", fit.kkt_residual},
          {"iterations", fit.iterations},
          {"boxes", fit.boxes}};
}

}  // namespace

std::string fit_record(const LightFit& fit) {
  std::string members;
  const auto add = [&members](const std::string& name, const Json& value) {
    members += (members.empty() ? "\n    \"" : ",\n    \"") + name + "\": " + value.dump();
  };
  if (fit.range) add("range", range_record(*fit.range));
  if (fit.cone) {
    Json record{{"profile", facts_of(fit.cone->best().cone.profile).name}};
    for (const ConeProfileFit& each : fit.cone->profiles) {
      record[facts_of(each.cone.profile).name] = profile_record(each, *fit.target.cone);
    }
    add("cone", record);
  }
  if (fit.beam()) add("asymmetry", fit.target.asymmetry);
  return "{" + members + "\n  }";
}

}  // namespace litfog::fit
