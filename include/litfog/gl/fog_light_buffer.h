// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/fog_light_block.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "litfog/updater.h"

namespace litfog::gl {

/// The uniform buffer that holds a FogLightBlock.
///
/// threads  like GlName
class FogLightBuffer {
 public:
  FogLightBuffer();

  /// Uploads the whole block.
  void upload(const FogLightBlock& block);
  /// Uploads the fog alone.
  void upload(const FogHeader& header);
  /// Uploads the fog and the changed ranges of a FogUpdater's tables, or the whole tables the first time.
  ///
  /// throws  std::invalid_argument for more kinds or instances than kMaxFogLights
  void upload(const FogHeader& header, std::span<const FogLightKind> kinds, std::span<const FogLightInstance> instances,
              const FogLightChanges& changes);
  /// Binds the buffer and the program's LitfogLightBlock, if it has one, to a uniform buffer binding point.
  void bind(const Program& program, unsigned binding) const;

 private:
  BufferName name_;
  bool has_tables_ = false;
};

/// Compares the members' offsets in the program's LitfogLightBlock, as the driver laid it out, with the C++ struct's:
/// the fog, the ambient colour and all members of the first, second and last kind and instance.
///
/// throws   Unsupported naming member, driver's offset and ours
/// threads  like GlName
void check_fog_light_layout(const Program& program);

}  // namespace litfog::gl
