// SPDX-License-Identifier: Apache-2.0
#include "render/light/light_map_store.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "litfog/gl/unsupported.h"
#include "render/gpu/texture_unit.h"
#include "scene/light_frame.h"

namespace litfog::render {
namespace {

using Shape = LookupTexture::Shape;

constexpr std::size_t kMaxTexels = std::size_t{1} << 29;  // 1 GiB at two bytes a texel

std::size_t square(int side) { return std::size_t(side) * std::size_t(side); }

}  // namespace

LightMapStore::LightMapStore(const scene::Scene& scene, const SceneLights& lights, const RenderSettings& settings)
    : set_(settings.path->maps), size_(settings.papers.map_size), cone_coverage_(settings.papers.cone_maps) {
  if (set_ == LightMapSet::none) return;
  expect_room(lights);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  if (set_ == LightMapSet::pair) {
    distance_.emplace(Shape::square, pair_size(size_), make_distance_map(pair_size(size_)));
  }
  if (set_ == LightMapSet::radial) {
    squares_.emplace(Shape::square, size_, make_square_map(size_));
    distance_.emplace(Shape::line, size_, make_square_ramp(size_));
  }
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    const Cone& cone = light.light.cone;
    const scene::CookieUse* const cookie = lights.cookie(i);
    const Maps maps{set_ == LightMapSet::radial ? nullptr : range_map(light, lights.extents()[i]),
                    cookie ? cookie_map(scene, cookie->cookie) : cone_map(cone)};
    auto found = std::ranges::find(maps_, maps);
    if (found == maps_.end()) found = maps_.insert(maps_.end(), maps);
    const double across = cone_coordinate_scale(cone, size_, cone_coverage_);
    glm::dmat3 cone_from_world;
    if (cookie) {
      cone_from_world = scene::cookie_from_world(light.direction, cookie->roll);
    } else if (set_ == LightMapSet::radial) {
      cone_from_world = glm::dmat3(across, 0, 0, 0, across, 0, 0, 0, 1) * scene::basis_from_world(light.direction);
    } else {
      const scene::Mount mount = lights.mount(i);
      cone_from_world =
          glm::dmat3(1, 0, 0, 0, across, 0, 0, 0, across) * scene::light_from_world(mount.light, mount.vehicle);
    }
    kinds_.push_back(int(found - maps_.begin()));
    cones_from_world_.emplace_back(cone_from_world);
  }
}

void LightMapStore::expect_room(const SceneLights& lights) const {
  std::set<RangeProfile> ranges;
  std::vector<Cone> cones;
  std::size_t texels = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights.lights()[i].light;
    if (set_ != LightMapSet::radial) ranges.insert(range_profile(light.attenuation, lights.extents()[i]));
    if (lights.cookie(i)) continue;
    const Cone cone = stored_cone(light.cone);
    if (std::ranges::find(cones, cone) != cones.end()) continue;
    cones.push_back(cone);
    texels += 6 * square(cone_side(cone));
  }
  texels += ranges.size() * square(range_side()) * std::size_t(is_volume() ? range_side() : 1);
  if (texels > kMaxTexels) {
    throw gl::Unsupported(
        "the scene's lights are of too many shapes for this path: their light maps would take more than 1 GiB; "
        "a smaller --map-size may do");
  }
}

int LightMapStore::range_side() const { return is_volume() ? size_ : pair_size(size_); }

/// A point light's map is white.
int LightMapStore::cone_side(const Cone& cone) const { return cone.is_point_light() ? 1 : size_; }

/// Frazier's spot has the same texels at every angle: those of 45 degrees, where the scale is 1.
Cone LightMapStore::stored_cone(const Cone& cone) const {
  const bool is_disc = cone_coverage_ == ConeMaps::one_disc && is_scaled(cone, cone_coverage_);
  return is_disc ? Cone::cosine(std::numbers::pi / 4, 0) : cone;
}

const LookupTexture* LightMapStore::range_map(const PlacedLight& light, double extent) {
  const RangeProfile profile = range_profile(light.light.attenuation, extent);
  const auto found = range_maps_.find(profile);
  if (found != range_maps_.end()) return &found->second;
  const int side = range_side();
  LookupTexture map(is_volume() ? Shape::volume : Shape::square, side,
                    is_volume() ? make_range_volume(profile, side) : make_range_map(profile, side));
  return &range_maps_.emplace(profile, std::move(map)).first->second;
}

const LookupTexture* LightMapStore::cone_map(const Cone& given) {
  const Cone cone = stored_cone(given);
  for (const auto& [known, map] : cone_maps_) {
    if (known == cone) return &map;
  }
  const int side = cone_side(cone);
  const CubeAxis axis = set_ == LightMapSet::radial ? CubeAxis::minus_z : CubeAxis::plus_x;
  return &cone_maps_
              .emplace_back(cone, LookupTexture(Shape::cube, side, make_cone_cube(cone, axis, side, cone_coverage_)))
              .second;
}

const LookupTexture* LightMapStore::cookie_map(const scene::Scene& scene, std::size_t cookie) {
  const auto found = cookie_maps_.find(cookie);
  if (found != cookie_maps_.end()) return &found->second;
  const Cookie& image = scene.cookies[cookie];
  return &cookie_maps_.try_emplace(cookie, Shape::cube, image.size, make_cookie_cube(image)).first->second;
}

void LightMapStore::bind(int kind) const {
  const Maps& maps = maps_[std::size_t(kind)];
  (maps.range ? *maps.range : *squares_).bind(kRangeMapUnit);
  maps.cone->bind(kConeMapUnit);
  if (distance_) distance_->bind(kDistanceMapUnit);
}

LayeredTexture upload_cookies(const std::vector<Cookie>& cookies) {
  const int size = std::ranges::max(cookies, {}, &Cookie::size).size;
  MapTexels texels;
  for (const Cookie& cookie : cookies) {
    const MapTexels faces = make_cookie_cube(cookie.size == size ? cookie : resize_cookie(cookie, size));
    texels.insert(texels.end(), faces.begin(), faces.end());
  }
  return LayeredTexture(size, 6 * int(cookies.size()), texels);
}

}  // namespace litfog::render
