// SPDX-License-Identifier: Apache-2.0
#include "fit/cookie_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "command/exit_status.h"
#include "command/whole_file.h"

namespace litfog::fit {

void write_cookie(const std::string& path, const litfog::Cookie& cookie) {
  OIIO::ImageSpec spec(cookie.size, 6 * cookie.size, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("ImageDescription",
                 "litfog cookie: a light's intensity per its peak by direction; the faces +x -x +y -y +z -z of a cube "
                 "map from the top, as glTexImage2D takes them; the axis is -z, +y is up");
  std::vector<unsigned char> bytes;  // first, so that a full disk is noticed
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("exr");
  if (!output) throw command::CannotWrite(path + ": cannot be written: " + OIIO::geterror());
  if (!output->set_ioproxy(&memory) || !output->open(path, spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, cookie.texels.data()) || !output->close()) {
    throw command::CannotWrite(path + ": cannot be written: " + output->geterror());
  }
  command::write_whole_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace litfog::fit
