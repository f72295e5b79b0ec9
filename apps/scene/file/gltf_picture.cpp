// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_picture.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <string>

#include "scene/file/gltf_uri.h"
#include "scene/file/gltf_value.h"

namespace litfog::scene {
namespace {

constexpr std::size_t kMaxTexels = std::size_t{1} << 27;
constexpr std::size_t kMaxEncodedBytes = std::size_t{256} << 20;  // of a picture's file
constexpr int kMaxPictureSide = 16'384;

/// The mean RGB, each level replaced by its value in a table.
glm::vec3 mean_of(const Texels& texels, const std::array<float, 256>& value_of_level) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    for (int channel = 0; channel < 3; ++channel) {
      sum[channel] += double(value_of_level[texels.rgba[i + std::size_t(channel)]]);
    }
  }
  return sum / double(texels.rgba.size() / 4);
}

template <typename Value>
std::array<float, 256> make_table(const Value& value_of) {
  std::array<float, 256> table;
  for (std::size_t level = 0; level < table.size(); ++level) table[level] = value_of(float(level) / 255.0f);
  return table;
}

const std::array<float, 256>& linear_values() {
  static const auto kValues = make_table([](float srgb) { return OIIO::sRGB_to_linear(srgb); });
  return kValues;
}

}  // namespace

void TexelBudget::take(const JsonValue& owner, std::size_t texels) {
  texels_ += texels;
  if (texels_ > kMaxTexels) owner.fail(fmt::format("pictures must be at most {} pixels in all", kMaxTexels));
}

glm::vec3 GltfPicture::mean() {
  static const auto kValues = make_table([](float level) { return level; });
  if (!mean_) mean_ = mean_of(*texels_, kValues);
  return *mean_;
}

glm::vec3 GltfPicture::linear_mean() {
  if (!linear_mean_) linear_mean_ = mean_of(*texels_, linear_values());
  return *linear_mean_;
}

float linear_value(std::uint8_t srgb_level) { return linear_values()[srgb_level]; }

GltfPictures::GltfPictures(const GltfFile& file)
    : file_(file), textures_(items_of(file.root(), "textures")), images_(items_of(file.root(), "images")) {}

GltfPicture& GltfPictures::use(const JsonValue& texture_info) {
  if (const auto set = texture_info.optional("texCoord"); set && whole_number(*set) != 0) {
    set->fail("must be 0: this program reads TEXCOORD_0 only");
  }
  const JsonValue& texture = textures_[index_in(textures_, texture_info.member("index"))];
  const std::size_t number = index_in(images_, texture.member("source"));
  const auto known = pictures_.find(number);
  if (known != pictures_.end()) return known->second;
  return pictures_.emplace(number, read(images_[number])).first->second;
}

Texels GltfPictures::read(const JsonValue& image) {
  const auto view = image.optional("bufferView");
  if (!view) return decode(image, read_gltf_uri(image, "picture", kMaxEncodedBytes));
  if (const auto uri = image.optional("uri")) uri->fail("must not stand beside bufferView");
  return decode(image, file_.view(*view));
}

Texels GltfPictures::decode(const JsonValue& image, std::string_view bytes) {
  const bool is_png = bytes.starts_with("\x89PNG");
  if (!is_png && !bytes.starts_with("\xFF\xD8")) image.fail("must be a PNG or JPEG picture");
  OIIO::Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
  const std::string format = is_png ? "png" : "jpeg";
  const auto input = OIIO::ImageInput::create(format);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // else colours come multiplied by alpha
  OIIO::ImageSpec spec;
  if (!input) image.fail("must be a picture of a kind that this OpenImageIO reads: " + OIIO::geterror());
  if (!input->set_ioproxy(&reader) || !input->open("picture." + format, spec, config)) {
    image.fail("must be a sound picture: " + input->geterror());
  }
  if (spec.width > kMaxPictureSide || spec.height > kMaxPictureSide) {
    image.fail(fmt::format("must be at most {} pixels a side", kMaxPictureSide));
  }
  budget_.take(image, spec.image_pixels());
  const auto channels = std::size_t(spec.nchannels);
  std::vector<std::uint8_t> pixels(spec.image_pixels() * channels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
    image.fail("must be a sound picture: " + input->geterror());
  }
  Texels texels{spec.width, spec.height, std::vector<std::uint8_t>(spec.image_pixels() * 4, 255)};
  for (std::size_t i = 0; i < spec.image_pixels(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {  // a grey picture has one for all three
      texels.rgba[4 * i + channel] = pixels[i * channels + (channels < 3 ? 0 : channel)];
    }
  }
  return texels;
}

}  // namespace litfog::scene
