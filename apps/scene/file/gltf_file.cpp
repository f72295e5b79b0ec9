// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "command/exit_status.h"
#include "litfog/input_error.h"
#include "scene/file/gltf_members.h"

namespace litfog::scene {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

std::string whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  if (file) bytes.assign(std::istreambuf_iterator<char>(file), {});
  if (!file) throw InputError({.file = path}, "cannot be read");
  return bytes;
}

std::uint32_t little_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// The JSON of a binary file: its first chunk.
std::string json_chunk(const std::string& path, const std::string& bytes) {
  constexpr std::size_t kHeaders = 20;  // of the file and of the chunk
  if (bytes.size() < kHeaders || !bytes.starts_with("glTF") || bytes.compare(16, 4, "JSON") != 0 ||
      little_endian(bytes, 12) > bytes.size() - kHeaders) {
    throw InputError({.file = path}, "must be a binary glTF file that begins with its JSON chunk");
  }
  if (little_endian(bytes, 4) != 2) throw InputError({.file = path}, "must be a binary glTF file of version 2");
  return bytes.substr(kHeaders, little_endian(bytes, 12));
}

/// For tinygltf: a picture's own bytes, decoded when a material wants it. Those in a buffer are not checked yet.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// For tinygltf: reads a file that the file names, and notes it in `files`, a std::vector<std::string>.
bool read_named_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& path, void* files) {
  static_cast<std::vector<std::string>*>(files)->push_back(path);
  return tinygltf::ReadWholeFile(bytes, error, path, nullptr);
}

}  // namespace

GltfPlace operator/(GltfPlace place, std::string name) {
  place.emplace_back(std::move(name));
  return place;
}
GltfPlace operator/(GltfPlace place, std::size_t index) {
  place.emplace_back(index);
  return place;
}

double GltfNumbers::at(std::size_t i, std::size_t component) const {
  const unsigned char* element = data + i * stride;
  const auto read = [&](auto zero) {
    std::memcpy(&zero, element + component * sizeof(zero), sizeof(zero));
    return zero;
  };
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return double(read(std::uint8_t{})) / (is_normalized ? 255.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return double(read(std::uint16_t{})) / (is_normalized ? 65535.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return double(read(std::uint32_t{}));
    default:
      return double(read(float{}));
  }
}

GltfFile::GltfFile(const std::string& path) : path_(path), files_{path}, root_(load()) {}

/// Reads the whole file twice: by litfog's own JSON reader, which bounds its size and depth and knows the places of
/// what is refused later, and by tinygltf, which also brings the buffers.
JsonValue GltfFile::load() {
  std::error_code error;
  if (std::filesystem::file_size(path_, error) > kMaxBytes && !error) {
    throw InputError({.file = path_}, fmt::format("must be at most {} MiB", kMaxBytes >> 20));
  }
  const std::string bytes = whole_file(path_);
  const bool is_binary = std::filesystem::path(path_).extension() == ".glb";
  JsonValue root = files::parse_json(is_binary ? json_chunk(path_, bytes) : bytes, path_);
  expect_gltf_members(root);
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(&keep_encoded, nullptr);
  loader.SetFsCallbacks(
      {&tinygltf::FileExists, &tinygltf::ExpandFilePath, &read_named_file, &tinygltf::WriteWholeFile, &files_});
  const std::string folder = std::filesystem::absolute(path_).parent_path().string();
  std::string errors;
  std::string warnings;
  bool is_loaded = false;
  try {
    const auto length = static_cast<unsigned>(bytes.size());
    is_loaded = is_binary
                    ? loader.LoadBinaryFromMemory(&model_, &errors, &warnings,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), length, folder)
                    : loader.LoadASCIIFromString(&model_, &errors, &warnings, bytes.data(), length, folder);
  } catch (const std::exception& failure) {  // tinygltf's slips over empty buffers
    errors = failure.what();
  }
  if (!is_loaded) {
    std::ranges::replace(errors, '\n', ' ');
    while (errors.ends_with(' ') || errors.ends_with('.')) errors.pop_back();
    throw InputError({.file = path_}, "must be a glTF 2.0 file: " + errors);
  }
  return root;
}

void GltfFile::refuse(const GltfPlace& place, const std::string& rule) const {
  JsonValue value = root_;
  for (const auto& step : place) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      value = value.items().at(*index);
      continue;
    }
    const std::string& name = std::get<std::string>(step);
    const auto member = value.optional(name);
    if (!member) value.fail((value.path().empty() ? "" : value.path() + ".") + name, "", rule);
    value = *member;
  }
  value.fail(rule);
}

std::size_t GltfFile::index(const GltfPlace& place, int value, std::size_t size) const {
  if (value < 0 || std::size_t(value) >= size) {
    refuse(place, size == 0 ? "must not be given: there are none" : fmt::format("must be in [0, {}]", size - 1));
  }
  return std::size_t(value);
}

GltfNumbers GltfFile::numbers(const GltfPlace& place, int number, int type,
                              std::initializer_list<int> component_types) const {
  const std::size_t at = index(place, number, model_.accessors.size());
  const tinygltf::Accessor& accessor = model_.accessors[at];
  const GltfPlace own = GltfPlace{} / "accessors" / at;
  if (accessor.type != type) refuse(own / "type", "must be that of what it is used for");
  const bool is_known = std::ranges::find(component_types, accessor.componentType) != component_types.end();
  if (!is_known) refuse(own / "componentType", "must be one that glTF allows for what it is used for");
  if (accessor.sparse.isSparse) refuse(own / "sparse", "must not be given: this program reads dense accessors only");
  const std::span<const unsigned char> bytes = view(own / "bufferView", accessor.bufferView);
  const auto& buffer_view = model_.bufferViews[std::size_t(accessor.bufferView)];
  const auto element = std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType)) *
                                   tinygltf::GetNumComponentsInType(std::uint32_t(type)));
  const std::size_t stride = buffer_view.byteStride == 0 ? element : buffer_view.byteStride;
  const bool fits = accessor.count > 0 && accessor.byteOffset <= bytes.size() &&
                    bytes.size() - accessor.byteOffset >= element &&
                    (bytes.size() - accessor.byteOffset - element) / stride >= accessor.count - 1;
  if (!fits) refuse(own / "count", "must be > 0 and within its buffer view");
  return {bytes.data() + accessor.byteOffset, stride, accessor.count, accessor.componentType, accessor.normalized};
}

std::span<const unsigned char> GltfFile::view(const GltfPlace& place, int number) const {
  const std::size_t at = index(place, number, model_.bufferViews.size());
  const tinygltf::BufferView& view = model_.bufferViews[at];
  const GltfPlace own = GltfPlace{} / "bufferViews" / at;
  const auto& bytes = model_.buffers[index(own / "buffer", view.buffer, model_.buffers.size())].data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    refuse(own / "byteLength", "must end within its buffer");
  }
  return std::span(bytes).subspan(view.byteOffset, view.byteLength);
}

}  // namespace litfog::scene
