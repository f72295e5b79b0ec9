// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog {

/// The photometric files in a GLDF container (Global Lighting Data Format, gldf.io: a zip archive with a product.xml),
/// in the order of its product.xml, as paths that read_luminaire() takes: "lamp.gldf/ldc/spot.ldt". One
/// that is defined twice is listed once. Those that the container only links to, on the net, are left out. Names in
/// the archive are UTF-8 or of code page 850.
///
/// throws     InputError; also for a container without photometric files
std::vector<std::string> list_gldf(const std::string& path);

}  // namespace litfog
