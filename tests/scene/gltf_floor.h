// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "command/temporary_directory.h"
#include "litfog/input_error.h"
#include "scene/file/scene_file.h"
#include "scene/gltf_bytes.h"

namespace litfog::test {

/// Writes glTF files and reads them as scenes, above all one that a test changes.
class GltfFileTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const { return directory_.write(name, bytes); }
  /// As text, with the buffer in it.
  scene::Scene read(json file, const std::string& buffer = floor_bytes()) const {
    if (file.contains("buffers")) {
      file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
    }
    return scene::read_scene(write("scene.gltf", file.dump(1)));
  }
  /// The sentence without the file's name, line and column, which it has to have.
  std::string error_of(json file, const std::string& buffer = floor_bytes()) const {
    if (file.contains("buffers")) {
      file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
    }
    return error_as_given(file);
  }
  std::string error_as_given(const json& file) const {
    try {
      scene::read_scene(write("scene.gltf", file.dump(1)));
    } catch (const InputError& bad) {
      EXPECT_GT(bad.location().line, 0u) << bad.what();
      EXPECT_GT(bad.location().column, 0u) << bad.what();
      const std::string sentence = bad.what();
      return sentence.substr(sentence.find(": ") + 2);
    }
    return "no error";
  }

  json& primitive() { return file_["meshes"][0]["primitives"][0]; }
  json& material() { return file_["materials"][0]; }
  json& light() { return file_["extensions"]["KHR_lights_punctual"]["lights"][0]; }

  json file_ = floor_scene();

 private:
  TemporaryDirectory directory_;
};

/// A picture of a colour, as the bytes of a PNG file.
inline std::string png(const std::string& path, const std::vector<std::uint8_t>& rgb, int width) {
  const auto output = OIIO::ImageOutput::create(path);
  OIIO::ImageSpec spec(width, int(rgb.size()) / 3 / width, 3, OIIO::TypeDesc::UINT8);
  EXPECT_TRUE(output->open(path, spec) && output->write_image(OIIO::TypeDesc::UINT8, rgb.data()) && output->close());
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace litfog::test
