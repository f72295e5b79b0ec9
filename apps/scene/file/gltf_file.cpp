// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "litfog/input_error.h"
#include "scene/file/gltf_compression.h"
#include "scene/file/gltf_uri.h"
#include "scene/file/gltf_value.h"
#include "text/file_text.h"

namespace litfog::scene {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;  // for a file, and for all buffers together

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// The chunks of a binary file (glTF 2.0, 4.4).
struct Chunks {
  std::string_view json;
  std::string_view buffer;  ///< empty if there is none
};

Chunks split(const std::string& path, std::string_view bytes) {
  constexpr std::size_t kChunkHeader = 8;
  constexpr std::size_t kHeaders = 12 + kChunkHeader;  // the file's and its first chunk's
  const auto expect = [&](bool is_so, std::string_view rule) {
    if (!is_so) throw InputError({.file = path}, rule);
  };
  expect(
      bytes.size() >= kHeaders && bytes.substr(16, 4) == "JSON" && little_endian(bytes, 12) <= bytes.size() - kHeaders,
      "must be a binary glTF file that begins with its JSON chunk");
  expect(little_endian(bytes, 4) == 2, "must be a binary glTF file of version 2");
  expect(little_endian(bytes, 8) <= bytes.size(), "must be as long as its header states");
  Chunks chunks{.json = bytes.substr(kHeaders, little_endian(bytes, 12)), .buffer = {}};
  const std::string_view rest = bytes.substr(kHeaders + chunks.json.size());
  if (rest.size() < kChunkHeader || rest.substr(4, 4) != "BIN\0"sv) return chunks;
  expect(little_endian(rest, 0) <= rest.size() - kChunkHeader, "must not end within its binary chunk");
  chunks.buffer = rest.substr(kChunkHeader, little_endian(rest, 0));
  return chunks;
}

void expect_version(const JsonValue& asset) {
  const JsonValue version = asset.member("version");
  if (!version.string().starts_with("2.")) version.fail("must be \"2.0\" or a later 2");
  const auto least = asset.optional("minVersion");
  if (least && least->string() != "2.0") least->fail("must be \"2.0\", which is what this program knows");
}

/// Parses a component type, which must be one of those allowed.
GltfComponent component_of(const JsonValue& type, std::initializer_list<GltfComponent> allowed) {
  const auto component = GltfComponent(whole_number(type));
  if (std::ranges::find(allowed, component) != allowed.end()) return component;
  std::vector<int> numbers;
  for (const GltfComponent each : allowed) numbers.push_back(int(each));
  type.fail(fmt::format("must be {}", fmt::join(numbers, " or ")));
}

}  // namespace

std::size_t size_of(GltfComponent component) {
  switch (component) {
    case GltfComponent::signed_byte:
    case GltfComponent::unsigned_byte:
      return 1;
    case GltfComponent::signed_short:
    case GltfComponent::unsigned_short:
      return 2;
    default:
      return 4;
  }
}

double GltfNumbers::at(std::size_t i, std::size_t component_index) const {
  const auto read = [&](auto zero) {
    std::memcpy(&zero, data + i * stride + component_index * sizeof(zero), sizeof(zero));
    return zero;
  };
  const auto fraction = [&](auto zero) {
    const double number = double(read(zero));
    return is_normalized ? std::max(number / double(std::numeric_limits<decltype(zero)>::max()), -1.0) : number;
  };
  switch (component) {
    case GltfComponent::signed_byte:
      return fraction(std::int8_t{});
    case GltfComponent::unsigned_byte:
      return fraction(std::uint8_t{});
    case GltfComponent::signed_short:
      return fraction(std::int16_t{});
    case GltfComponent::unsigned_short:
      return fraction(std::uint16_t{});
    case GltfComponent::unsigned_int:
      return double(read(std::uint32_t{}));
    default:
      return double(read(float{}));
  }
}

GltfFile::GltfFile(const std::string& path)
    : root_(read(path)),
      accessors_(items_of(root_, "accessors")),
      views_(items_of(root_, "bufferViews")),
      buffers_(items_of(root_, "buffers")) {
  expect_version(root_.member("asset"));
  read_buffers();
}

JsonValue GltfFile::read(const std::string& path) {
  std::string bytes = read_file_text(path, kMaxBytes);
  if (!bytes.starts_with("glTF")) return files::parse_json(std::move(bytes), path);
  const Chunks chunks = split(path, bytes);
  binary_chunk_ = chunks.buffer;
  return files::parse_json(std::string(chunks.json), path);
}

void GltfFile::read_buffers() {
  std::size_t total = 0;
  for (const JsonValue& buffer : buffers_) {  // before the first is read
    const JsonValue length = buffer.member("byteLength");
    total += whole_number(length);
    if (total > kMaxBytes) length.fail(fmt::format("buffers must be at most {} MiB in all", kMaxBytes >> 20));
  }
  for (const JsonValue& buffer : buffers_) {
    const JsonValue length = buffer.member("byteLength");
    const std::size_t size = whole_number(length);
    const bool has_uri = buffer.optional("uri").has_value();
    const bool is_chunk = bytes_.empty() && !binary_chunk_.empty() && !has_uri;
    if (!is_chunk && !has_uri) {  // holds decoded bytes of compressed views, or else fails where it is used
      bytes_.emplace_back();
      continue;
    }
    bytes_.push_back(is_chunk ? std::move(binary_chunk_) : read_gltf_buffer(buffer, size));
    if (size > bytes_.back().size()) {
      length.fail(fmt::format("must be at most the buffer's {} bytes", bytes_.back().size()));
    }
    bytes_.back().resize(size);  // a chunk is padded
  }
}

GltfNumbers GltfFile::format(const JsonValue& accessor_index, std::initializer_list<GltfType> types,
                             std::initializer_list<GltfComponent> components) const {
  const JsonValue& accessor = accessors_[index_in(accessors_, accessor_index)];
  const JsonValue type_name = accessor.member("type");
  const auto type = std::ranges::find(types, type_name.string(), &GltfType::name);
  if (type == types.end()) {
    std::vector<std::string_view> names;
    for (const GltfType& each : types) names.push_back(each.name);
    type_name.fail(fmt::format("must be {}", fmt::join(names, " or ")));
  }
  const GltfComponent component = component_of(accessor.member("componentType"), components);
  const auto normalized = accessor.optional("normalized");
  const JsonValue count = accessor.member("count");
  const GltfNumbers format{.stride = size_of(component) * type->components,
                           .count = whole_number(count),
                           .components = type->components,
                           .component = component,
                           .is_normalized = normalized && normalized->boolean()};
  if (format.count == 0) count.fail("must be > 0 and within its buffer view");
  return format;
}

GltfNumbers GltfFile::numbers(const JsonValue& accessor_index, std::initializer_list<GltfType> types,
                              std::initializer_list<GltfComponent> components) const {
  const JsonValue& accessor = accessors_[index_in(accessors_, accessor_index)];
  GltfNumbers numbers = format(accessor_index, types, components);
  const JsonValue count = accessor.member("count");
  const std::size_t element = numbers.stride;
  const auto sparse = accessor.optional("sparse");
  if (const auto view_index = accessor.optional("bufferView")) {
    const std::string_view bytes = view(*view_index);
    if (const auto given = views_[index_in(views_, *view_index)].optional("byteStride")) {
      numbers.stride = whole_number(*given);
      if (numbers.stride < element || numbers.stride > 252 || numbers.stride % 4 != 0) {
        given->fail(fmt::format("must be a multiple of 4, at most 252 and at least an element's {} bytes", element));
      }
    }
    const std::size_t offset = whole_number_or(accessor, "byteOffset", 0);
    const bool fits = offset <= bytes.size() && bytes.size() - offset >= element &&
                      (bytes.size() - offset - element) / numbers.stride >= numbers.count - 1;
    if (!fits) count.fail("must be > 0 and within its buffer view");
    numbers.data = bytes.data() + offset;
  } else {
    if (numbers.count > kMaxBytes / element) count.fail("must be one that fits into a GiB");
    numbers.made = std::make_shared<const std::string>(element, '\0');  // all 0 (glTF 2.0, 5.1.1)
    numbers.data = numbers.made->data();
    numbers.stride = 0;
  }
  if (sparse) replace_sparse(*sparse, numbers);
  return numbers;
}

void GltfFile::replace_sparse(const JsonValue& sparse, GltfNumbers& numbers) const {
  const std::size_t element = size_of(numbers.component) * numbers.components;
  std::string dense(numbers.count * element, '\0');
  for (std::size_t i = 0; i < numbers.count; ++i) {
    std::memcpy(&dense[i * element], numbers.data + i * numbers.stride, element);
  }
  const JsonValue count_given = sparse.member("count");
  const std::size_t count = whole_number(count_given);
  const auto part = [&](const JsonValue& owner, std::size_t size) {
    const std::string_view bytes = view(owner.member("bufferView"));
    const std::size_t offset = whole_number_or(owner, "byteOffset", 0);
    if (offset > bytes.size() || (bytes.size() - offset) / size < count) {
      count_given.fail("must be within its buffer views");
    }
    return bytes.data() + offset;
  };
  const JsonValue indices = sparse.member("indices");
  using enum GltfComponent;
  GltfNumbers index{
      .count = count,
      .component = component_of(indices.member("componentType"), {unsigned_byte, unsigned_short, unsigned_int})};
  index.stride = size_of(index.component);
  index.data = part(indices, index.stride);
  const char* const values = part(sparse.member("values"), element);
  for (std::size_t i = 0; i < count; ++i) {
    const auto replaced = std::size_t(index.at(i, 0));
    if (replaced >= numbers.count) indices.fail("must be those of its elements");
    std::memcpy(&dense[replaced * element], values + i * element, element);
  }
  numbers.made = std::make_shared<const std::string>(std::move(dense));
  numbers.data = numbers.made->data();
  numbers.stride = element;
}

std::string_view GltfFile::part_of_buffer(const JsonValue& view) const {
  const std::size_t buffer = index_in(buffers_, view.member("buffer"));
  const std::string_view bytes = bytes_[buffer];
  if (bytes.empty()) buffers_[buffer].member("uri");  // fails
  const std::size_t offset = whole_number_or(view, "byteOffset", 0);
  const JsonValue length = view.member("byteLength");
  const std::size_t size = whole_number(length);
  if (offset > bytes.size() || size > bytes.size() - offset) length.fail("must end within its buffer");
  return bytes.substr(offset, size);
}

std::string_view GltfFile::view(const JsonValue& view_index) const {
  const std::size_t index = index_in(views_, view_index);
  const JsonValue& view = views_[index];
  const auto compression = extension_of(view, kMeshopt);
  if (!compression) return part_of_buffer(view);
  const auto known = decoded_.find(index);
  if (known != decoded_.end()) return known->second;
  std::string decoded = decode_meshopt(*compression, part_of_buffer(*compression), kMaxBytes - decoded_bytes_);
  decoded_bytes_ += decoded.size();
  return decoded_.emplace(index, std::move(decoded)).first->second;
}

}  // namespace litfog::scene
