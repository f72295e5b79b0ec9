// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_compression.h"

#include <meshoptimizer.h>

#include "scene/file/gltf_value.h"

namespace litfog::scene {

std::string decode_meshopt(const JsonValue& compression, std::string_view bytes, std::size_t max_bytes) {
  const JsonValue count_given = compression.member("count");
  const JsonValue stride_given = compression.member("byteStride");
  const JsonValue mode = compression.member("mode");
  const std::size_t count = whole_number(count_given);
  const std::size_t stride = whole_number(stride_given);
  const bool are_attributes = mode.string() == "ATTRIBUTES";
  const bool are_triangles = mode.string() == "TRIANGLES";
  if (!are_attributes && !are_triangles && mode.string() != "INDICES") {
    mode.fail("must be ATTRIBUTES, TRIANGLES or INDICES");
  }
  if (are_attributes ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4) {
    stride_given.fail("must be a multiple of 4 in [4, 256], or 2 or 4 of indices");
  }
  if (count == 0 || count > max_bytes / stride) count_given.fail("must be > 0, and all views within a GiB");
  if (are_triangles && count % 3 != 0) count_given.fail("must be three a triangle");
  std::string decoded(count * stride, '\0');
  const auto* const given = reinterpret_cast<const unsigned char*>(bytes.data());
  const int error = are_attributes  ? meshopt_decodeVertexBuffer(decoded.data(), count, stride, given, bytes.size())
                    : are_triangles ? meshopt_decodeIndexBuffer(decoded.data(), count, stride, given, bytes.size())
                                    : meshopt_decodeIndexSequence(decoded.data(), count, stride, given, bytes.size());
  if (error != 0) compression.fail("must be sound");
  const auto filter = compression.optional("filter");
  if (!filter || filter->string() == "NONE") return decoded;
  const bool is_octahedral = filter->string() == "OCTAHEDRAL";
  const bool is_quaternion = filter->string() == "QUATERNION";
  if (!is_octahedral && !is_quaternion && filter->string() != "EXPONENTIAL") {
    filter->fail("must be NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
  }
  if (!are_attributes || (is_octahedral && stride != 4 && stride != 8) || (is_quaternion && stride != 8)) {
    filter->fail("must be of attributes: octahedral ones of 4 or 8 bytes, quaternions of 8");
  }
  const auto undo = is_octahedral   ? meshopt_decodeFilterOct
                    : is_quaternion ? meshopt_decodeFilterQuat
                                    : meshopt_decodeFilterExp;
  undo(decoded.data(), count, stride);
  return decoded;
}

}  // namespace litfog::scene
