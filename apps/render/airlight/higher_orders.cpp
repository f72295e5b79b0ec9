// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/higher_orders.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <utility>

#include "litfog/photometry/cookie_airlight.h"
#include "render/gpu/texture_unit.h"

namespace litfog::render {

HigherOrders::HigherOrders(const SceneLights& lights, std::span<const Cookie> cookies, const Atmosphere& atmosphere,
                           const HigherOrders& last)
    : cookie_moments_(last.cookie_moments_), phase_(atmosphere.phase) {
  const bool is_same = last.table && last.phase_ == phase_;
  table = is_same ? last.table : make_scattering_table(atmosphere);
  thin_ = is_same ? last.thin_ : make_thin_beams(atmosphere, *table);
  std::map<std::size_t, int> beam_of_cookie;
  std::vector<std::pair<Cone, int>> beam_of_cone;
  const auto add = [&](const BeamMoments& moments) {
    beams.push_back(make_scattered_beam(moments, thin_));
    return int(beams.size()) - 1;
  };
  add(beam_moments(Cone{}));  // kPointBeam
  const auto beam_of = [&](std::size_t light) {
    if (const scene::CookieUse* const use = lights.cookie(light)) {
      const auto [found, is_new] = beam_of_cookie.try_emplace(use->cookie, 0);
      if (!is_new) return found->second;
      const auto [moments, is_unknown] = cookie_moments_.try_emplace(use->cookie);
      if (is_unknown) moments->second = beam_moments(cookies[use->cookie]);
      return found->second = add(moments->second);
    }
    const Cone& cone = lights.lights()[light].light.cone;
    if (cone.is_point_light()) return kPointBeam;
    const auto found = std::ranges::find(beam_of_cone, cone, &std::pair<Cone, int>::first);
    if (found != beam_of_cone.end()) return found->second;
    return beam_of_cone.emplace_back(cone, add(beam_moments(cone))).second;
  };
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const ScatteringSource source = scattering_source(lights.lights()[i].light, atmosphere);
    sources.emplace_back(source.intensity, beam_of(i), source.phase_cosine, source.soft_range);
  }
}

void HigherOrderTextures::set(const HigherOrders& orders) {
  sources_.reset();
  if (!orders.table || orders.sources.empty()) return;
  sources_.emplace(orders.sources.data(), std::span(orders.sources).size_bytes(), BufferTexture::Texel::float4);
  bind_texture(kUploadUnit, beams_);
  interpolate_within_edges(GL_TEXTURE_2D);
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int count = int(orders.beams.size());
  const int in_column = std::clamp(count, 1, largest / kBeamDepths);
  const int columns = (count + in_column - 1) / in_column;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kBeamAngles * std::max(columns, 1), kBeamDepths * in_column, 0, GL_RGBA,
               GL_FLOAT, nullptr);
  for (int i = 0; i < count; ++i) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, kBeamAngles * (i / in_column), kBeamDepths * (i % in_column), kBeamAngles,
                    kBeamDepths, GL_RGBA, GL_FLOAT, orders.beams[std::size_t(i)].texels.data());
  }
  bind_texture(kUploadUnit, table_);
  interpolate_within_edges(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kScatteringAngles, kScatteringDepths, 0, GL_RED, GL_FLOAT,
               orders.table->logs.data());
}

void HigherOrderTextures::bind(PassTextures& textures) const {
  const unsigned unit = textures.unit("scattering_sources");
  const unsigned table = textures.unit("litfog_scattering_table");
  const unsigned beams = textures.unit("litfog_scattered_beams");
  if (is_empty()) return;
  sources_->bind(unit);
  bind_texture(table, table_);
  bind_texture(beams, beams_);
}

}  // namespace litfog::render
