// SPDX-License-Identifier: Apache-2.0
#include "render/light_map_store.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "litfog/gl/unsupported.h"
#include "render/gpu/texture_unit.h"
#include "scene/light_frame.h"

namespace litfog::render {
namespace {

using Shape = LookupTexture::Shape;

constexpr std::size_t kMaxTexels = std::size_t{1} << 29;  // of two bytes: 1 GiB

}  // namespace

LightMapStore::LightMapStore(const scene::Scene& scene, const SceneLights& lights, const RenderSettings& settings)
    : set_(settings.path->maps), size_(settings.map_size), cone_kind_(settings.cone_maps) {
  const LightMapSet set = set_;
  const int size = size_;
  if (set == LightMapSet::none) return;
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  if (set == LightMapSet::pair) {
    distance_.emplace(Shape::square, pair_size(size), make_distance_map(pair_size(size)));
  }
  if (set == LightMapSet::radial) {
    squares_.emplace(Shape::square, size, make_square_map(size));
    distance_.emplace(Shape::line, size, make_square_ramp(size));
  }
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PlacedLight& light = lights.lights()[i];
    const Cone& cone = light.light.cone;
    const scene::CookieUse* const cookie = lights.cookie(i);
    const Maps maps{set == LightMapSet::radial ? &*squares_ : range_map(light, lights.extents()[i]),
                    cookie ? cookie_map(scene, cookie->cookie) : cone_map(cone)};
    auto found = std::ranges::find(maps_, maps);
    if (found == maps_.end()) found = maps_.insert(maps_.end(), maps);
    const double across = cone_coordinate_scale(cone, size, cone_kind_);
    glm::dmat3 cone_from_world;
    if (cookie) {
      cone_from_world = scene::cookie_from_world(light.direction, cookie->roll);
    } else if (set == LightMapSet::radial) {
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

void LightMapStore::expect_room(std::size_t texels) {
  texels_ += texels;
  if (texels_ > kMaxTexels) {
    throw gl::Unsupported(
        "the scene's lights are of too many shapes for this path: their light maps would take more than 1 GiB; "
        "a smaller --map-size may do");
  }
}

const LookupTexture* LightMapStore::range_map(const PlacedLight& light, double extent) {
  const RangeProfile profile = range_profile(light.light.attenuation, extent);
  const auto found = range_maps_.find(profile);
  if (found != range_maps_.end()) return &found->second;
  const bool is_volume = set_ == LightMapSet::volume;
  const int side = is_volume ? size_ : pair_size(size_);
  expect_room(std::size_t(side) * std::size_t(side) * std::size_t(is_volume ? side : 1));
  LookupTexture map(is_volume ? Shape::volume : Shape::square, side,
                    is_volume ? make_range_volume(profile, side) : make_range_map(profile, side));
  return &range_maps_.emplace(profile, std::move(map)).first->second;
}

const LookupTexture* LightMapStore::cone_map(const Cone& cone) {
  // Frazier's spot: the same texels at every angle. Its own is 45 degrees, at which the scale is 1.
  const bool is_disc = cone_kind_ == ConeMaps::one_disc && is_scaled(cone, cone_kind_);
  const Cone held = is_disc ? Cone::cosine(std::numbers::pi / 4, 0) : cone;
  for (const auto& [known, map] : cone_maps_) {
    if (known == held) return &map;
  }
  const int side = cone.profile == ConeProfile::none ? 1 : size_;  // a point light's is white
  expect_room(6 * std::size_t(side) * std::size_t(side));
  const CubeAxis axis = set_ == LightMapSet::radial ? CubeAxis::minus_z : CubeAxis::plus_x;
  return &cone_maps_.emplace_back(held, LookupTexture(Shape::cube, side, make_cone_cube(held, axis, side, cone_kind_)))
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
  maps.range->bind(kRangeMapUnit);
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
