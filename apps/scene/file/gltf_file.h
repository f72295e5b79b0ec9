// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

/// An accessor's "componentType".
enum class GltfComponent {
  signed_byte = 5120,
  unsigned_byte = 5121,
  signed_short = 5122,
  unsigned_short = 5123,
  unsigned_int = 5125,
  floating = 5126,
};

/// An accessor's "type".
struct GltfType {
  std::string_view name;
  std::size_t components;
};
inline constexpr GltfType kGltfScalar{"SCALAR", 1};
inline constexpr GltfType kGltfVec2{"VEC2", 2};
inline constexpr GltfType kGltfVec3{"VEC3", 3};
inline constexpr GltfType kGltfVec4{"VEC4", 4};
inline constexpr GltfType kGltfMat4{"MAT4", 16};  ///< column by column

/// Size of a component in bytes.
std::size_t size_of(GltfComponent component);

/// An accessor's numbers, checked against its buffer. They live as long as the file.
struct GltfNumbers {
  const char* data = nullptr;  ///< null: not given
  std::size_t stride = 0;      ///< bytes
  std::size_t count = 0;
  std::size_t components = 1;
  GltfComponent component = GltfComponent::floating;
  bool is_normalized = false;
  std::shared_ptr<const std::string> made = nullptr;  ///< owns the data if the file does not hold them as such

  double at(std::size_t i, std::size_t component_index) const;
  glm::vec2 vec2(std::size_t i) const { return {at(i, 0), at(i, 1)}; }
  glm::vec3 vec3(std::size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
};

/// A glTF 2.0 file with its buffers, at most 1 GiB in all; pictures stay encoded. The JSON is checked where it is used;
/// errors name the location of the wrong value.
class GltfFile {
 public:
  /// throws  InputError
  explicit GltfFile(const std::string& path);

  const JsonValue& root() const { return root_; }

  /// An accessor's numbers, which must have one of these types and component types.
  ///
  /// throws  InputError
  GltfNumbers numbers(const JsonValue& accessor_index, std::initializer_list<GltfType> types,
                      std::initializer_list<GltfComponent> components) const;
  /// numbers() without the data.
  GltfNumbers format(const JsonValue& accessor_index, std::initializer_list<GltfType> types,
                     std::initializer_list<GltfComponent> components) const;
  /// The bytes of a buffer view, decoded if they are compressed (EXT_meshopt_compression).
  ///
  /// throws  InputError
  std::string_view view(const JsonValue& view_index) const;

 private:
  /// Reads the JSON, and a binary file's buffer.
  JsonValue read(const std::string& path);
  void read_buffers();
  /// The range of a buffer that a buffer view or its compression states.
  std::string_view part_of_buffer(const JsonValue& view) const;
  /// Replaces some of an accessor's numbers by its sparse values (glTF 2.0, 3.6.2.3).
  void replace_sparse(const JsonValue& sparse, GltfNumbers& numbers) const;

  std::string binary_chunk_;  // a binary file's first buffer
  JsonValue root_;
  std::vector<JsonValue> accessors_;
  std::vector<JsonValue> views_;
  std::vector<JsonValue> buffers_;
  std::vector<std::string> bytes_;                      // one per buffer
  mutable std::map<std::size_t, std::string> decoded_;  // by view
  mutable std::size_t decoded_bytes_ = 0;
};

}  // namespace litfog::scene
