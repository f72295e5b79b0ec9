// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "litfog/photometry/luminaire.h"

namespace litfog {

class GldfArchive;

/// A GLDF container (Global Lighting Data Format, gldf.io: a zip archive with a product.xml). It reads the archive's
/// directory once, then any of the photometric files. Threads may read files concurrently.
///
///     const GldfContainer container("set.gldf");
///     for (const std::string& file : container.files()) use(container.read(file));
class GldfContainer {
 public:
  /// Throws InputError; also for a container without photometric files, of more than 10,000 entries, or whose
  /// photometric files unpack to more than 256 MiB together or share their packed bytes.
  explicit GldfContainer(const std::string& path);

  /// The photometric files in the order of product.xml, as paths that read_luminaire() takes: "lamp.gldf/ldc/spot.ldt".
  /// A file defined twice is listed once. Web links are left out. Names in the archive are in UTF-8 or code page 850,
  /// with slashes or, as Windows writes them, backslashes.
  const std::vector<std::string>& files() const { return files_; }

  /// Reads one of files(). Throws InputError.
  Luminaire read(const std::string& file) const;

 private:
  std::shared_ptr<const GldfArchive> archive_;
  std::vector<std::string> files_;
};

/// GldfContainer::files() of a container, for a single use. Throws InputError like the constructor.
std::vector<std::string> list_gldf(const std::string& path);

}  // namespace litfog
