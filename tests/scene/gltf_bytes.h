// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::test {

using nlohmann::json;

inline std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// A floor of 20 m by 20 m at height 0, u to +x and v to +z, from (0, 0) to (1, 1): 4 vertices, 2 triangles.
inline std::string floor_bytes() {
  return bytes_of(std::vector<float>{-10, 0, -10, 10, 0, -10, 10, 0, 10, -10, 0, 10}) +
         bytes_of(std::vector<float>{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}) +
         bytes_of(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}) + bytes_of(std::vector<std::uint16_t>{0, 2, 1, 0, 3, 2});
}

/// The floor under a camera that looks at it from 5 m, at a slant, and a point light of 40 cd 2 m above it.
inline json floor_scene() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "point", "name": "lamp", "color": [1, 0.5, 0.25], "intensity": 40}]}},
    "nodes": [
      {"mesh": 0},
      {"camera": 0, "translation": [0, 5, 5], "rotation": [-0.38268343, 0, 0, 0.92387953]},
      {"translation": [0.5, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
                                "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 1, 1], "metallicFactor": 0}}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-10, 0, -10], "max": [10, 0, 10]},
      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
      {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [
      {"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
      {"buffer": 0, "byteOffset": 96, "byteLength": 32}, {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
    "buffers": [{"byteLength": 140}]})");
}

inline void append_word(std::string& bytes, std::size_t value) {
  const auto word = std::uint32_t(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof(word));  // little-endian, as the machines here
}

inline std::string binary_file(const json& scene, std::string buffer) {
  std::string text = scene.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4);
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes, 28 + text.size() + buffer.size());
  append_word(bytes, text.size());
  bytes += "JSON" + text;
  append_word(bytes, buffer.size());
  return bytes + std::string("BIN\0", 4) + buffer;
}

}  // namespace litfog::test
