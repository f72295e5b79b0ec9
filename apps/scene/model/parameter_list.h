// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::scene {

/// A parameter of a model. Its unit is in its name: _m metres, _deg degrees; none for counts, seeds and fractions.
struct ParameterInfo {
  std::string_view name;
  double default_value;
  double minimum;
  double maximum;
  bool is_whole;  ///< whole numbers only
};

/// What is wrong with a value ("must be a whole number", "must be in [0.5, 40]"), or nothing.
std::optional<std::string> find_error(const ParameterInfo& parameter, double value);

/// The largest seed of a model.
inline constexpr double kMaxSeed = 1e6;

/// What a scene file states about a model besides its name: {"model":"spruce", "height_m":9, "seed":3}.
using ModelParameters = std::map<std::string, double, std::less<>>;

/// The parameters that are members of one struct. A model's struct has a function describe(ParameterList&) that adds
/// its own members, then those of the structs it holds; the default is what a member holds when it is added. The list
/// refers to the struct, which must outlive it.
class ParameterList {
 public:
  void add(std::string_view name, float& member, double minimum, double maximum);
  void add(std::string_view name, int& member, double minimum, double maximum);

  /// Adds a rule across parameters, which returns what is wrong with them, or nothing.
  void add_rule(std::function<std::optional<std::string>()> rule);

  std::vector<ParameterInfo> infos() const;

  /// Sets the members of these names.
  /// throws std::invalid_argument for an unknown name, a value out of its range or a broken rule
  void set(const ModelParameters& parameters) const;

 private:
  struct Entry {
    ParameterInfo info;
    std::function<void(double)> set;
  };
  std::vector<Entry> entries_;
  std::vector<std::function<std::optional<std::string>()>> rules_;
};

}  // namespace litfog::scene
