// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/fog_light_block.h"
#include "litfog/gl/program.h"

namespace litfog::gl {

/// The uniform buffer that holds a FogLightBlock.
class FogLightBuffer {
 public:
  FogLightBuffer();
  ~FogLightBuffer();
  FogLightBuffer(const FogLightBuffer&) = delete;
  FogLightBuffer& operator=(const FogLightBuffer&) = delete;

  /// Uploads the block whole.
  void upload(const FogLightBlock& block);
  /// Binds buffer and program's block to a uniform buffer binding point.
  void bind(const Program& program, unsigned binding) const;

 private:
  unsigned id_ = 0;
};

/// Compares every member's offset in the program's FogLightBlock, as the driver laid it out, with the C++ struct's.
///
/// throws Unsupported naming member, driver's offset and ours
void check_fog_light_layout(const Program& program);

}  // namespace litfog::gl
