// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_file.h"

#include <algorithm>

#include "c/call.h"
#include "c/convert.h"
#include "files/json_text.h"

using namespace litfog;

litfog_status litfog_read_light(const char* path, litfog_light* light, char* name, size_t name_size) {
  return c::call([&] {
    c::at(path, "path");
    c::at(light, "light");
    c::array(name, name_size, "name");
    const Light read = read_light(path);
    *light = c::light_of(read);
    if (name_size == 0) return;
    *std::ranges::copy(files::start_of(read.name, name_size - 1), name).out = '\0';
  });
}
