// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/outcome.h"

namespace litfog::fit {

/// What a catalogue keeps of an input that gave a light.
struct FittedLamp {
  Outcome outcome;
  Summary summary;
};

/// A folder of lights with their pictures, and a page that shows them:
///
///     index.html            opens from the disk; needs nothing but the files beside it, and no script
///     lamps/NAME.json       the light
///     lamps/NAME.svg        its fit (fit_figure.h)
///     lamps/NAME.png        its beam in fog (fog_picture.h)
///     lamps/NAME.record     what the next run needs in order to leave the lamp as it is
///
/// A lamp is left as it is where its three files are as they were written and its record is of the same input and
/// options, made by this program from files that are as they were: of the same size and time of modification. The
/// record is written last, so that a run which was ended goes on where it was; until then there is one that says
/// nothing. Inputs that gave no light have none, and are tried again.
class Catalogue {
 public:
  /// The folder is made if it is not there. Throws OutputError where it cannot be, and where the page or a lamp's file
  /// would replace one that is no catalogue's.
  ///
  /// options  whatever changes a light, as text
  /// inputs   all that are to be shown; none has been read for its light
  Catalogue(const std::string& folder, const std::string& options, const std::vector<Input>& inputs);

  /// The files that add() writes: the light, and others with other endings.
  std::string light_path(const Input& input) const;

  /// What is recorded of an input, unless it must be fitted anew.
  std::optional<Summary> find(const Input& input) const;

  /// Writes inputs' lights, pictures and records; those before one that fails are whole. Threads may call it at once,
  /// for different inputs. Throws OutputError, and MissingCapability without gnuplot.
  void add(const std::vector<FittedLamp>& lamps) const;

  /// Writes the page. `summaries` are the inputs' own, in their order. Throws OutputError.
  void write_page(const std::vector<Input>& inputs, const std::vector<Summary>& summaries) const;

 private:
  void expect_own_page() const;
  void expect_own_files(const Input& input) const;
  std::filesystem::path file_of(const Input& input, const char* ending) const;

  std::filesystem::path folder_;
  std::string options_;
  timespec begun_;
};

}  // namespace litfog::fit
