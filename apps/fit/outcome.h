// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/exit_status.h"
#include "command/table.h"
#include "fit/input_list.h"
#include "fit/light_fit.h"
#include "fit/light_target.h"
#include "fit/two_lights.h"
#include "fit/verdict.h"

namespace litfog::fit {

/// One input and what became of it.
struct Outcome {
  Input input;
  std::string output;  ///< empty for none
  std::optional<LightFit> fit;
  std::optional<TwoLights> two;  ///< the lights that are written in place of the fit's, if that was chosen
  std::optional<Verdict> verdict;
  std::vector<std::string> advice;
  std::string light;   ///< text of its file: of two, the hot spot's
  std::string spill;   ///< text of the spill's file, if there are two
  std::string reason;  ///< why there is none
  command::ExitStatus status = command::kDone;

  bool has_light() const { return fit.has_value(); }
};

/// What is written, one light or two.
BeamData light_beam(const Outcome& outcome);
const std::optional<IlluminanceError>& illuminance_error(const Outcome& outcome);

/// Makes an outcome one without a light, by the exception that is being handled: every one is the input's own and names
/// it, except a usage error, which is thrown again.
void fail(Outcome& outcome);

/// What remains of an outcome when the next input has its turn.
struct Summary {
  command::ExitStatus status = command::kDone;
  std::vector<std::string> messages;      ///< for standard error
  std::vector<command::Table::Cell> row;  ///< a row for `columns`
  std::string report;                     ///< JSON
};

/// Candela, lumens and full angles are the light's, data_cd and data_lm those that its data state. Errors are signed
/// fractions in percent, fit less data; range_% is the largest of a table of attenuation or
/// illuminance.
const std::vector<std::string>& summary_columns();

/// has_report  whether the JSON report is wanted
Summary summary_of(const Outcome& outcome, bool has_report);

/// The files that a target was read from, as they are on the disk: a GLDF container for what is in it.
std::vector<std::string> files_of(const Input& input, const LightTarget& target);

}  // namespace litfog::fit
