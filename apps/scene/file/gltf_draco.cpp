// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_compression.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

#include "scene/file/gltf_value.h"

namespace litfog::scene {
namespace {

draco::DataType draco_type(GltfComponent component) {
  switch (component) {
    case GltfComponent::signed_byte:
      return draco::DT_INT8;
    case GltfComponent::unsigned_byte:
      return draco::DT_UINT8;
    case GltfComponent::signed_short:
      return draco::DT_INT16;
    case GltfComponent::unsigned_short:
      return draco::DT_UINT16;
    case GltfComponent::unsigned_int:
      return draco::DT_UINT32;
    default:
      return draco::DT_FLOAT32;
  }
}

GltfNumbers holding(GltfNumbers format, std::string bytes) {
  format.made = std::make_shared<const std::string>(std::move(bytes));
  format.data = format.made->data();
  return format;
}

}  // namespace

struct GltfDraco::Mesh {
  std::unique_ptr<const draco::Mesh> decoded;
};

GltfDraco::GltfDraco(const GltfFile& file, const JsonValue& compression)
    : compression_(compression), attributes_(compression.member("attributes")) {
  const std::string_view bytes = file.view(compression.member("bufferView"));
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) compression.fail(fmt::format("must be sound: {}", decoded.status().error_msg_string()));
  mesh_ = std::make_unique<const Mesh>(Mesh{std::move(decoded).value()});
}

GltfDraco::~GltfDraco() = default;

std::optional<GltfNumbers> GltfDraco::attribute(std::string_view name, GltfNumbers format) const {
  const auto id = attributes_.optional(name);
  if (!id) return std::nullopt;
  const draco::Mesh& mesh = *mesh_->decoded;
  const draco::PointAttribute* const attribute = mesh.GetAttributeByUniqueId(std::uint32_t(whole_number(*id)));
  const bool is_as_stated = attribute && attribute->data_type() == draco_type(format.component) &&
                            std::size_t(attribute->num_components()) == format.components &&
                            mesh.num_points() == format.count;
  if (!is_as_stated) id->fail("must be an attribute of the compressed mesh, as its accessor states");
  std::string bytes(format.count * format.stride, '\0');
  for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
    attribute->GetMappedValue(draco::PointIndex(point), &bytes[point * format.stride]);
  }
  return holding(format, std::move(bytes));
}

GltfNumbers GltfDraco::indices() const {
  const draco::Mesh& mesh = *mesh_->decoded;
  std::string bytes;
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& corner : mesh.face(face)) {
      const std::uint32_t index = corner.value();
      bytes.append(reinterpret_cast<const char*>(&index), sizeof(index));
    }
  }
  return holding({.stride = sizeof(std::uint32_t),
                  .count = 3 * std::size_t(mesh.num_faces()),
                  .component = GltfComponent::unsigned_int},
                 std::move(bytes));
}

}  // namespace litfog::scene
