// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/higher_orders.h"

#include <epoxy/gl.h>

#include <span>

#include "litfog/photometry/cookie_airlight.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

HigherOrders::HigherOrders(const SceneLights& lights, std::span<const Cookie> cookies, const Atmosphere& atmosphere)
    : table(make_scattering_table(atmosphere)) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights.lights()[i].light;
    const scene::CookieUse* const use = lights.cookie(i);
    const ScatteringSource source =
        use ? scattering_source(light, cookies[use->cookie], atmosphere) : scattering_source(light, atmosphere);
    sources.emplace_back(source.intensity, source.flux, source.cone_cosine, source.phase_cosine);
  }
}

void HigherOrderTextures::set(const HigherOrders& orders) {
  sources_.reset();
  if (!orders.table || orders.sources.empty()) return;
  sources_.emplace(orders.sources.data(), std::span(orders.sources).size_bytes(), BufferTexture::Texel::float4);
  bind_texture(kUploadUnit, table_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kScatteringAngles, kScatteringDepths, 0, GL_RED, GL_FLOAT,
               orders.table->logs.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void HigherOrderTextures::bind(PassTextures& textures) const {
  const unsigned unit = textures.unit("scattering_sources");
  const unsigned table = textures.unit("litfog_scattering_table");
  if (is_empty()) return;
  sources_->bind(unit);
  bind_texture(table, table_);
}

}  // namespace litfog::render
