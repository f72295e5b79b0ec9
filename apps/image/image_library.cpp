// SPDX-License-Identifier: Apache-2.0
#include "image/image_library.h"

#include <dlfcn.h>

#include "command/bundled_data.h"
#include "command/exit_status.h"

namespace litfog::image {
namespace {

const ImageLibrary& loaded() {
  const std::string path = command::bundled_plugin("litfog-openimageio.so", LITFOG_OPENIMAGEIO);
  void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed
  void* const entry = handle ? dlsym(handle, "litfog_image_library") : nullptr;
  if (!entry) throw command::MissingCapability(std::string("OpenImageIO cannot be loaded: ") + dlerror());
  return *reinterpret_cast<const ImageLibrary* (*)()>(entry)();
}

}  // namespace

const ImageLibrary& image_library() {
  static const ImageLibrary& library = loaded();
  return library;
}

}  // namespace litfog::image
