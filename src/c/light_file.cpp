// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_file.h"

#include <algorithm>

#include "c/call.h"
#include "c/convert.h"
#include "text/code_points.h"

using namespace litfog;

litfog_status litfog_read_light(const char* path, litfog_light* light, char* name, size_t name_size) {
  return c::call([&] {
    c::at(path, "path");
    c::at(light, "light");
    c::array(name, name_size, "name");
    const Light read = read_light(path);
    *light = c::light_of(read);
    if (name_size == 0) return;
    std::size_t length = std::min(read.name.size(), name_size - 1);
    if (length < read.name.size()) {
      while (length > 0 && !starts_code_point(read.name[length])) --length;
    }
    *std::copy_n(read.name.data(), length, name) = '\0';
  });
}
