// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

/// The way to a value from a glTF file's root: names of members and places in arrays.
using GltfPlace = std::vector<std::variant<std::string, std::size_t>>;

GltfPlace operator/(GltfPlace place, std::string name);
GltfPlace operator/(GltfPlace place, std::size_t index);

/// An accessor's numbers, checked against its buffer. They live as long as the file.
struct GltfNumbers {
  const unsigned char* data = nullptr;  ///< null: not given
  std::size_t stride = 0;               ///< bytes
  std::size_t count = 0;
  int component_type = 0;  ///< TINYGLTF_COMPONENT_TYPE_...
  bool is_normalized = false;

  double at(std::size_t i, std::size_t component) const;
  glm::vec3 vec3(std::size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
};

/// A glTF 2.0 file with its buffers, at most 1 GiB; pictures stay encoded. What it says is of the kinds that glTF wants
/// (expect_gltf_members); whether it makes sense is for those to ask who use it, by these functions, whose refusals
/// name the place.
class GltfFile {
 public:
  /// throws  InputError
  explicit GltfFile(const std::string& path);

  const std::string& path() const { return path_; }
  const tinygltf::Model& model() const { return model_; }
  /// The file and all that it names: buffers and pictures.
  const std::vector<std::string>& files() const { return files_; }

  /// Refuses the value at a place of the file: throws InputError.
  [[noreturn]] void refuse(const GltfPlace& place, const std::string& rule) const;
  /// An index into one of the file's arrays.
  std::size_t index(const GltfPlace& place, int value, std::size_t size) const;
  /// An accessor's numbers, which have to be of a type (TINYGLTF_TYPE_...) and one of some component types.
  GltfNumbers numbers(const GltfPlace& place, int number, int type, std::initializer_list<int> component_types) const;
  /// The bytes of a buffer view.
  std::span<const unsigned char> view(const GltfPlace& place, int number) const;

 private:
  JsonValue load();

  std::string path_;
  std::vector<std::string> files_;
  tinygltf::Model model_;
  JsonValue root_;
};

}  // namespace litfog::scene
