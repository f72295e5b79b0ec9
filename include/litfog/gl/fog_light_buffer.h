// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/fog_light_block.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"

namespace litfog::gl {

/// The uniform buffer that holds a FogLightBlock.
///
/// threads  as GlName
class FogLightBuffer {
 public:
  FogLightBuffer();

  /// Uploads the whole block.
  void upload(const FogLightBlock& block);
  /// Binds the buffer and the program's LitfogLightBlock, if it has one, to a uniform buffer binding point.
  void bind(const Program& program, unsigned binding) const;

 private:
  BufferName name_;
};

/// Compares the members' offsets in the program's LitfogLightBlock, as the driver laid it out, with the C++ struct's:
/// the fog, the ambient colour and all members of the first, second and last light.
///
/// throws   Unsupported naming member, driver's offset and ours
/// threads  as GlName
void check_fog_light_layout(const Program& program);

}  // namespace litfog::gl
