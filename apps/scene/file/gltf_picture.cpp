// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_picture.h"

#include <fmt/format.h>
#include <webp/decode.h>

#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <new>
#include <string>

#include "image/png_text.h"
#include "model/float_limit.h"
#include "scene/file/gltf_uri.h"
#include "scene/file/gltf_value.h"
#include "scene/srgb.h"

namespace litfog::scene {
namespace {

constexpr std::size_t kMaxTexels = std::size_t{1} << 27;
constexpr std::size_t kMaxEncodedBytes = std::size_t{256} << 20;  // per picture file
constexpr int kMaxPictureSide = 16'384;
constexpr double kMaxTransform = 1e6;

/// The mean RGB, with each level looked up in a table.
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
  static const auto kValues = make_table(linear_from_srgb);
  return kValues;
}

}  // namespace

void TexelBudget::take(const JsonValue& owner, std::size_t texels) {
  texels_ += texels;
  if (texels_ > kMaxTexels) owner.fail(fmt::format("pictures must be at most {} pixels in all", kMaxTexels));
}

GltfPicture GltfPicture::sampled(const Sampling& sampling) const {
  Texels texels = *texels_;
  texels.sampling = sampling;
  return GltfPicture(std::move(texels), alpha_);
}

const std::shared_ptr<const Texels>& GltfPicture::covering_texels(const JsonValue& owner, TexelBudget& budget) {
  if (covering_) return covering_;
  if (alpha_.empty()) return covering_ = texels_;
  budget.take(owner, alpha_.size());
  Texels texels = *texels_;
  for (std::size_t i = 0; i < alpha_.size(); ++i) texels.rgba[4 * i + 3] = alpha_[i];
  return covering_ = std::make_shared<const Texels>(std::move(texels));
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

GltfCoordinates coordinates_of(const JsonValue& texture_info) {
  GltfCoordinates coordinates{.set = whole_number_or(texture_info, "texCoord", 0)};
  const auto transform = extension_of(texture_info, "KHR_texture_transform");
  if (!transform) return coordinates;
  const auto vec2_or = [&](const char* name, const glm::dvec2& absent) {
    const auto given = transform->optional(name);
    if (!given) return absent;
    const glm::dvec2 value = glm::make_vec2(numbers(*given, 2).data());
    if (!is_within(value.x, -kMaxTransform, kMaxTransform) || !is_within(value.y, -kMaxTransform, kMaxTransform))
      given->fail("must be at most 1e6");
    return value;
  };
  const glm::dvec2 offset = vec2_or("offset", glm::dvec2(0));
  const glm::dvec2 scale = vec2_or("scale", glm::dvec2(1));
  const double rotation = transform->number_or("rotation", 0);
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  coordinates.transform = glm::dmat3x2(scale.x * c, -scale.x * s, scale.y * s, scale.y * c, offset.x, offset.y);
  coordinates.set = whole_number_or(*transform, "texCoord", coordinates.set);
  return coordinates;
}

GltfPictures::GltfPictures(const GltfFile& file)
    : file_(file),
      textures_(items_of(file.root(), "textures")),
      images_(items_of(file.root(), "images")),
      samplers_(items_of(file.root(), "samplers")) {}

GltfPicture& GltfPictures::use(const JsonValue& texture_info) {
  const JsonValue& texture = textures_[index_in(textures_, texture_info.member("index"))];
  const std::size_t number = image_of(texture);
  const Sampling sampling = sampling_of(texture);
  std::map<Sampling, GltfPicture>& known = pictures_[number];
  if (const auto same = known.find(sampling); same != known.end()) return same->second;
  if (known.empty()) return known.emplace(sampling, read(images_[number], sampling)).first->second;
  const GltfPicture& other = known.begin()->second;
  budget_.take(images_[number], other.texels()->rgba.size() / 4);
  return known.emplace(sampling, other.sampled(sampling)).first->second;
}

std::size_t GltfPictures::image_of(const JsonValue& texture) const {
  if (const auto webp = extension_of(texture, "EXT_texture_webp")) {
    return index_in(images_, webp->member("source"));
  }
  const auto source = texture.optional("source");
  if (!source && extension_of(texture, "KHR_texture_basisu")) {
    texture.fail(texture.path_of("source"), "",
                 "must be given beside KHR_texture_basisu: this program reads PNG, JPEG and WebP, not KTX2; export the "
                 "file with such pictures");
  }
  return index_in(images_, source ? *source : texture.member("source"));
}

Sampling GltfPictures::sampling_of(const JsonValue& texture) const {
  Sampling sampling;
  const auto index = texture.optional("sampler");
  if (!index) return sampling;
  const JsonValue& sampler = samplers_[index_in(samplers_, *index)];
  const auto wrap = [&](const char* name) {
    switch (whole_number_or(sampler, name, 10497)) {
      case 10497:
        return Sampling::Wrap::repeat;
      case 33071:
        return Sampling::Wrap::clamp;
      case 33648:
        return Sampling::Wrap::mirror;
      default:
        sampler.member(name).fail("must be 10497, 33071 or 33648");
    }
  };
  sampling.wrap_u = wrap("wrapS");
  sampling.wrap_v = wrap("wrapT");
  constexpr std::size_t kNearest = 9728;
  constexpr std::size_t kLinear = 9729;
  const std::size_t magnified = whole_number_or(sampler, "magFilter", kLinear);
  if (magnified != kNearest && magnified != kLinear) sampler.member("magFilter").fail("must be 9728 or 9729");
  sampling.magnified = magnified == kNearest ? Sampling::Filter::nearest : Sampling::Filter::linear;
  constexpr std::size_t kMipmapped =
      9984;  // nearest in nearest, linear in nearest, nearest in linear, linear in linear
  const std::size_t minified = whole_number_or(sampler, "minFilter", kMipmapped + 3);
  const bool has_mipmaps = minified >= kMipmapped && minified <= kMipmapped + 3;
  if (!has_mipmaps && minified != kNearest && minified != kLinear) {
    sampler.member("minFilter").fail("must be 9728, 9729 or in [9984, 9987]");
  }
  sampling.minified = minified % 2 == 0 ? Sampling::Filter::nearest : Sampling::Filter::linear;
  if (has_mipmaps) {
    sampling.mipmaps = minified < kMipmapped + 2 ? Sampling::Mipmaps::nearest : Sampling::Mipmaps::linear;
  } else {
    sampling.mipmaps = Sampling::Mipmaps::none;
  }
  return sampling;
}

GltfPicture GltfPictures::read(const JsonValue& image, const Sampling& sampling) {
  const auto view = image.optional("bufferView");
  if (!view) return decode(image, read_gltf_picture(image, kMaxEncodedBytes), sampling);
  if (const auto uri = image.optional("uri")) uri->fail("must not stand beside bufferView");
  return decode(image, file_.view(*view), sampling);
}

GltfPicture GltfPictures::decode(const JsonValue& image, std::string_view bytes, const Sampling& sampling) {
  const image::Levels pixels = bytes.starts_with("RIFF") ? decode_webp(image, bytes) : decode_png_or_jpeg(image, bytes);
  const std::size_t count = pixels.values.size() / pixels.channels;
  Texels texels{pixels.width, pixels.height, std::vector<std::uint8_t>(count * 4, 255), sampling};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {  // a grey picture has one channel for all three
      texels.rgba[4 * i + channel] = pixels.values[i * pixels.channels + (pixels.channels < 3 ? 0 : channel)];
    }
  }
  if (pixels.channels != 2 && pixels.channels != 4) return GltfPicture(std::move(texels));
  std::vector<std::uint8_t> alpha(count);
  for (std::size_t i = 0; i < count; ++i) alpha[i] = pixels.values[(i + 1) * pixels.channels - 1];
  return GltfPicture(std::move(texels), std::move(alpha));
}

void GltfPictures::take(const JsonValue& image, int width, int height) {
  if (width > kMaxPictureSide || height > kMaxPictureSide) {
    image.fail(fmt::format("must be at most {} pixels a side", kMaxPictureSide));
  }
  budget_.take(image, std::size_t(width) * std::size_t(height));
}

image::Levels GltfPictures::decode_png_or_jpeg(const JsonValue& image, std::string_view bytes) {
  const bool is_png = bytes.starts_with("\x89PNG");
  if (!is_png && !bytes.starts_with("\xFF\xD8")) image.fail("must be a PNG, JPEG or WebP picture");
  try {
    const auto accept = [&](int width, int height) { take(image, width, height); };
    return is_png ? image::decode_png(bytes, accept) : image::image_library().decode_jpeg(bytes, accept);
  } catch (const image::ImageError& error) {
    image.fail(std::string("must be a sound picture: ") + error.what());
  }
}

/// Without OpenImageIO, which always multiplies WebP's colours by alpha (2.4).
image::Levels GltfPictures::decode_webp(const JsonValue& image, std::string_view bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
    image.fail("must be a PNG, JPEG or WebP picture");
  take(image, features.width, features.height);
  const std::size_t channels = features.has_alpha ? 4 : 3;
  const int stride = features.width * int(channels);
  image::Levels pixels{features.width, features.height, channels, {}};
  pixels.values.resize(std::size_t(stride) * std::size_t(features.height));
  WebPDecoderConfig config;
  WebPInitDecoderConfig(&config);
  config.output.colorspace = features.has_alpha ? MODE_RGBA : MODE_RGB;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {pixels.values.data(), stride, pixels.values.size()};
  const VP8StatusCode status = WebPDecode(data, bytes.size(), &config);
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != VP8_STATUS_OK) image.fail("must be a sound picture, not animated");
  return pixels;
}

}  // namespace litfog::scene
