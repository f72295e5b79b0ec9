// SPDX-License-Identifier: Apache-2.0
#include "scene/model/parameter_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "model/float_limit.h"

namespace litfog::scene {
namespace {

/// The shortest decimal that gives the float, so that 0.12f is listed as 0.12.
double shortest_decimal(float value) {
  char text[32];
  const char* const end = std::to_chars(text, std::end(text), value).ptr;
  double decimal = 0;
  std::from_chars(text, end, decimal);
  return decimal;
}

}  // namespace

std::optional<std::string> find_error(const ParameterInfo& parameter, double value) {
  value = snapped(value, parameter.minimum, parameter.maximum);
  if (!(value >= parameter.minimum && value <= parameter.maximum)) {
    return fmt::format("must be in [{}, {}]", parameter.minimum, parameter.maximum);
  }
  if (parameter.is_whole && value != std::floor(value)) return "must be a whole number";
  return std::nullopt;
}

void ParameterList::add(std::string_view name, float& member, double minimum, double maximum) {
  entries_.push_back(
      {{name, shortest_decimal(member), minimum, maximum, false}, [&member](double value) { member = float(value); }});
}

void ParameterList::add(std::string_view name, int& member, double minimum, double maximum) {
  entries_.push_back(
      {{name, double(member), minimum, maximum, true}, [&member](double value) { member = int(value); }});
}

void ParameterList::add_rule(std::function<std::optional<std::string>()> rule) { rules_.push_back(std::move(rule)); }

std::vector<ParameterInfo> ParameterList::infos() const {
  std::vector<ParameterInfo> infos;
  for (const Entry& entry : entries_) infos.push_back(entry.info);
  return infos;
}

void ParameterList::set(const ModelParameters& parameters) const {
  for (const auto& [name, value] : parameters) {
    const auto entry = std::ranges::find(entries_, name, [](const Entry& each) { return each.info.name; });
    if (entry == entries_.end()) {
      throw std::invalid_argument(fmt::format("{} = {}: must be a parameter of the model", name, value));
    }
    if (const auto rule = find_error(entry->info, value)) {
      throw std::invalid_argument(fmt::format("{} = {}: {}", name, value, *rule));
    }
    entry->set(snapped(value, entry->info.minimum, entry->info.maximum));
  }
  for (const auto& rule : rules_) {
    if (const auto error = rule()) throw std::invalid_argument(*error);
  }
}

}  // namespace litfog::scene
