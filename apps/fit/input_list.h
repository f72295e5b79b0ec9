// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "litfog/photometry/gldf.h"

namespace litfog::fit {

/// A light spec or photometric file that is to be fitted.
struct Input {
  std::string path;
  std::string name;  ///< for its outputs: its file's name, in a folder or container with what lies between, without
                     ///< the ending
  std::exception_ptr error = nullptr;                        ///< why it cannot be fitted, where that is known already
  std::shared_ptr<const GldfContainer> container = nullptr;  ///< that it lies in
};

/// A path's extension in lower case, ".json" of LAMP.JSON.
std::string ending_of(const std::filesystem::path& path);

/// What the arguments name, in their order; what lies in one argument in alphabetical order. An argument is
///   a file, of which a GLDF container stands for the photometric files in it;
///   a folder: all light specs and photometric files in it and its folders, known by their endings and what is in them;
///   the name of a light that comes with litfog, such as landing-lamp, where no file has that name.
/// A name that is nothing of all this stays as it is, for the error of reading it, and so do files that may be light
/// specs or photometric files and cannot be read. A folder that cannot be searched and a container that cannot be read
/// are inputs with an error. Names that differ only in their ending keep it: lamp.ies and lamp.ldt.
///
/// Throws a usage error for an empty argument, and a folder of nothing.
std::vector<Input> list_inputs(const std::vector<std::string>& arguments);

}  // namespace litfog::fit
