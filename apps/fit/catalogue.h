// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fit/outcome.h"

namespace litfog::fit {

/// A folder of lights with their pictures, and a page that shows them:
///
///     index.html            opens from the disk; needs nothing but the files beside it; its own script sorts the table
///     lamps/NAME.json       the light
///     lamps/NAME.svg        its fit (light_pictures.h)
///     lamps/NAME.png        its beam in fog (likewise)
class Catalogue {
 public:
  /// The folder is made if it is not there. Throws OutputError where it cannot be, and where the page or a lamp's file
  /// would replace one that is no catalogue's.
  ///
  /// inputs  all that are to be shown
  Catalogue(const std::string& folder, const std::vector<Input>& inputs);

  /// The light's file, which add() writes.
  std::string light_path(const Input& input) const;

  /// Writes the lights and pictures of outcomes with a fit; those before one that fails are whole. Threads may call it
  /// at once, for different inputs. Throws OutputError, and MissingCapability without gnuplot.
  void add(const std::vector<const Outcome*>& outcomes) const;

  /// Writes the page. `summaries` are the inputs' own, in their order. Throws OutputError.
  void write_page(const std::vector<Input>& inputs, const std::vector<Summary>& summaries) const;

 private:
  std::string file_of(const Input& input, const char* ending) const;

  std::filesystem::path folder_;
};

}  // namespace litfog::fit
