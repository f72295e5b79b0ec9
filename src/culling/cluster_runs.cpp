// SPDX-License-Identifier: Apache-2.0
#include "cluster_runs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "culling/cluster_runs.cpp"  // this file, once for each SIMD target
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace litfog::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// View space: x right, y up, z the depth. A light's sector with the apex p lies beyond a plane through the eye with the
// unit normal n if n.p + h(n) < 0. The sector's support h(n) is the largest distance along n from the apex to a point
// of the sector:
//   h = range                                     where the angle t between n and the axis is at most the half angle H
//   h = max(0, range cos(t - H))                  else: the cap's rim, or the apex.
// cos t and sin t are computed separately, because each is exact where the other is not. Lights are enlarged by a
// slack: kClusterSlack times the sum of their range and distance.

/// A mask as bits, the first lane's lowest.
template <class D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

/// The lowest bits, 1 to 64 of them.
inline std::uint64_t low_bits(std::size_t count) { return ~std::uint64_t{0} >> (64 - count); }

template <class V>
struct Vectors {
  V x;
  V y;
  V z;
};

template <class V>
HWY_INLINE V dot(const Vectors<V>& a, const Vectors<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// h over the range, from cos t, sin t, cos H and sin H.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V support(D d, V cos_t, V sin_t, V cos_h, V sin_h) {
  const V rim = hn::Max(hn::Zero(d), hn::MulAdd(cos_t, cos_h, hn::Mul(sin_t, sin_h)));
  return hn::IfThenElse(hn::Ge(cos_t, cos_h), hn::Set(d, 1.0f), rim);
}

/// The least and the most of a light's points along the normal (across, along) of a plane of columns or rows.
template <class V>
struct Span {
  V least;
  V most;
};

/// side  the light's coordinate along x for columns, along y for rows
template <class D, class V = hn::Vec<D>>
HWY_INLINE Span<V> span_along(D d, V across, V along, V side, V depth, V axis_side, V axis_other, V axis_depth, V range,
                              V cos_h, V sin_h) {
  const V distance = hn::MulAdd(across, side, hn::Mul(along, depth));
  const V cos_t = hn::MulAdd(across, axis_side, hn::Mul(along, axis_depth));
  const V in_plane = hn::MulSub(across, axis_depth, hn::Mul(along, axis_side));
  const V sin_t = hn::Sqrt(hn::MulAdd(axis_other, axis_other, hn::Mul(in_plane, in_plane)));
  const V most = support(d, cos_t, sin_t, cos_h, sin_h);
  const V least = support(d, hn::Neg(cos_t), sin_t, cos_h, sin_h);
  return {hn::NegMulAdd(range, least, distance), hn::MulAdd(range, most, distance)};
}

/// The lights of a block that meet the view's planes, one per lane.
struct BlockLights {
  float x[kLightBlock], y[kLightBlock], z[kLightBlock];
  float axis_x[kLightBlock], axis_y[kLightBlock], axis_z[kLightBlock];
  float range[kLightBlock], cos_h[kLightBlock], sin_h[kLightBlock], slack[kLightBlock];
  float least_depth[kLightBlock], most_depth[kLightBlock];
};

/// Returns which lights meet all of the view's six planes.
HWY_INLINE std::uint64_t see_block(const ClusterPlanes& planes, const LightColumns& lights, std::size_t begin,
                                   BlockLights& block) {
  const hn::CappedTag<float, kLightBlock> d;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](float value) HWY_ATTR { return hn::Set(d, value); };
  const auto turn = [&](const float(&axis)[3], const Vectors<V>& v) HWY_ATTR {
    return dot(Vectors<V>{set(axis[0]), set(axis[1]), set(axis[2])}, v);
  };
  const auto turn_all = [&](const Vectors<V>& v) HWY_ATTR {
    return Vectors<V>{turn(planes.right, v), turn(planes.up, v), turn(planes.forward, v)};
  };
  std::uint64_t seen = 0;
  for (std::size_t k = 0; k < kLightBlock; k += hn::Lanes(d)) {
    const auto load = [&](const std::vector<float>& column)
                          HWY_ATTR { return hn::LoadU(d, column.data() + begin + k); };
    const auto from_eye = [&](int i, const std::vector<float>& column, const std::vector<float>& rest) HWY_ATTR {
      return hn::Add(hn::Sub(load(column), set(planes.eye[i])), hn::Sub(load(rest), set(planes.eye_rest[i])));
    };
    const Vectors<V> offset{from_eye(0, lights.x, lights.x_rest), from_eye(1, lights.y, lights.y_rest),
                            from_eye(2, lights.z, lights.z_rest)};
    const Vectors<V> apex = turn_all(offset);
    const Vectors<V> axis = turn_all({load(lights.axis_x), load(lights.axis_y), load(lights.axis_z)});
    const V distance = hn::Sqrt(dot(apex, apex));
    const V far = hn::MulAdd(distance, set(1.001f), set(planes.farthest_corner));  // beyond all corners
    const V range = hn::Min(load(lights.range), far);
    const V cos_h = load(lights.cos_half_angle);
    const V sin_h = load(lights.sin_half_angle);
    const V slack = hn::Mul(set(float(kClusterSlack)), hn::Add(distance, range));
    const V outside = hn::Neg(slack);

    const auto meets = [&](const EdgePlanes& edges, V side, V axis_side, V axis_other) HWY_ATTR {
      const std::size_t last = edges.parts;
      const Span<V> low = span_along(d, set(edges.across[0]), set(edges.along[0]), side, apex.z, axis_side, axis_other,
                                     axis.z, range, cos_h, sin_h);
      const Span<V> high = span_along(d, set(edges.across[last]), set(edges.along[last]), side, apex.z, axis_side,
                                      axis_other, axis.z, range, cos_h, sin_h);
      return hn::And(hn::Ge(low.most, outside), hn::Le(high.least, slack));
    };
    const Span<V> depth =
        span_along(d, set(0.0f), set(1.0f), set(0.0f), apex.z, axis.x, axis.y, axis.z, range, cos_h, sin_h);
    const auto meets_depths = hn::And(hn::Ge(depth.most, hn::Sub(set(planes.depths[0]), slack)),
                                      hn::Le(depth.least, hn::Add(set(planes.depths[planes.slices]), slack)));
    auto is_seen = hn::And(hn::Gt(range, hn::Zero(d)), meets_depths);
    is_seen = hn::And(is_seen, meets(planes.columns, apex.x, axis.x, axis.y));
    is_seen = hn::And(is_seen, meets(planes.rows, apex.y, axis.y, axis.x));
    const std::uint64_t bits = bits_of(d, is_seen);
    seen |= bits << k;
    if (bits == 0) continue;
    const auto store = [&](V values, float(&column)[kLightBlock]) HWY_ATTR { hn::StoreU(values, d, column + k); };
    store(apex.x, block.x);
    store(apex.y, block.y);
    store(apex.z, block.z);
    store(axis.x, block.axis_x);
    store(axis.y, block.axis_y);
    store(axis.z, block.axis_z);
    store(range, block.range);
    store(cos_h, block.cos_h);
    store(sin_h, block.sin_h);
    store(slack, block.slack);
    store(depth.least, block.least_depth);
    store(depth.most, block.most_depth);
  }
  return seen;
}

/// One light, the same in all lanes.
template <class D, class V = hn::Vec<D>>
struct OneLight {
  OneLight(D d, const BlockLights& block, std::size_t i)
      : apex{hn::Set(d, block.x[i]), hn::Set(d, block.y[i]), hn::Set(d, block.z[i])},
        axis{hn::Set(d, block.axis_x[i]), hn::Set(d, block.axis_y[i]), hn::Set(d, block.axis_z[i])},
        range(hn::Set(d, block.range[i])),
        cos_h(hn::Set(d, block.cos_h[i])),
        sin_h(hn::Set(d, block.sin_h[i])),
        slack(hn::Set(d, block.slack[i])) {}

  Vectors<V> apex;
  Vectors<V> axis;
  V range;
  V cos_h;
  V sin_h;
  V slack;
};

/// The parts between planes that a light can be in. `beyond(plane, below, above)` tells for a vector of planes in which
/// lanes the whole light is below, and in which it is above.
template <class D, class Beyond>
HWY_INLINE std::uint64_t parts_between(D d, std::size_t parts, const Beyond& beyond) {
  std::uint64_t is_below = 0;  // bit i: of plane i + 1, which is between the parts i and i + 1
  std::uint64_t is_above = 0;
  for (std::size_t i = 0; i + 1 < parts; i += hn::Lanes(d)) {
    const auto [below, above] = beyond(i + 1);
    is_below |= bits_of(d, below) << i;
    is_above |= bits_of(d, above) << i;
  }
  const std::uint64_t all = low_bits(parts);
  const std::uint64_t inner = all >> 1;  // the planes that are between two parts
  return all & ~((is_below & inner) << 1) & ~(is_above & inner);
}

template <class D>
struct Sides {
  hn::Mask<D> below;
  hn::Mask<D> above;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE std::uint64_t parts_met(D d, const EdgePlanes& edges, const OneLight<D>& light, V side, V axis_side,
                                   V axis_other) {
  return parts_between(d, edges.parts, [&](std::size_t at) HWY_ATTR {
    const Span<V> span =
        span_along(d, hn::LoadU(d, edges.across.data() + at), hn::LoadU(d, edges.along.data() + at), side, light.apex.z,
                   axis_side, axis_other, light.axis.z, light.range, light.cos_h, light.sin_h);
    return Sides<D>{hn::Lt(span.most, hn::Neg(light.slack)), hn::Gt(span.least, light.slack)};
  });
}

/// A ball around all of a light's points between two planes through the eye: the ball around all of its points, moved
/// to the nearest point between the planes and shrunk by Pythagoras.
struct Ball {
  float depth;
  float square;  ///< square of the radius; < 0: no ball
};

inline Ball between(const EdgePlanes& edges, std::size_t part, float side, const Ball& ball) {
  const auto distance = [&](std::size_t plane) { return edges.across[plane] * side + edges.along[plane] * ball.depth; };
  const float below = -distance(part);
  if (below > 0) return {ball.depth + below * edges.along[part], ball.square - below * below};
  const float above = distance(part + 1);
  if (above > 0) return {ball.depth - above * edges.along[part + 1], ball.square - above * above};
  return ball;
}

/// The part of a row of clusters that lies at a light's depths.
struct Row {
  float nearest;
  float farthest;
  float low;  ///< tangents
  float high;
};

/// Whether a cluster lies beyond the plane that touches a light's cone along the generator next to the cluster's
/// centre. Half angles up to 90 degrees.
///   n = cos H u - sin H axis, u the unit vector from the axis towards the middle; all points of the cone have n.p <= 0
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_beside_cone(D d, const OneLight<D>& light, const Row& row, V left, V right) {
  const auto set = [d](float value) HWY_ATTR { return hn::Set(d, value); };
  const float depth = 0.5f * (row.nearest + row.farthest);
  const V half_depth = set(0.5f * depth);
  const Vectors<V> middle{hn::MulSub(half_depth, hn::Add(left, right), light.apex.x),
                          hn::Sub(set(0.5f * depth * (row.low + row.high)), light.apex.y),
                          hn::Sub(set(depth), light.apex.z)};
  const auto across_axis = [&](const Vectors<V>& v) HWY_ATTR {
    const V along = dot(v, light.axis);
    return Vectors<V>{hn::NegMulAdd(along, light.axis.x, v.x), hn::NegMulAdd(along, light.axis.y, v.y),
                      hn::NegMulAdd(along, light.axis.z, v.z)};
  };
  const Vectors<V> across = across_axis(across_axis(middle));  // twice, because near the axis once is only rounding
  // Nearer to the axis, rounding alone says where it lies. A shorter u is right for any middle.
  constexpr float kNearAxis = 1e-6f;  // of the way to the middle: ten of its roundings
  const V least_square = hn::MulAdd(set(kNearAxis * kNearAxis), dot(middle, middle), set(1e-30f));
  const V square = hn::Max(dot(across, across), least_square);
  const V scale = hn::Div(light.cos_h, hn::Sqrt(square));
  const auto component = [&](V c, V axis) HWY_ATTR { return hn::NegMulAdd(light.sin_h, axis, hn::Mul(scale, c)); };
  const Vectors<V> n{component(across.x, light.axis.x), component(across.y, light.axis.y),
                     component(across.z, light.axis.z)};
  // The cluster's points are depth times (x, y, 1). Takes the corner with the least n.p.
  const V least_x = hn::Min(hn::Mul(n.x, left), hn::Mul(n.x, right));
  const V least_y = hn::Min(hn::Mul(n.y, set(row.low)), hn::Mul(n.y, set(row.high)));
  const V per_depth = hn::Add(hn::Add(least_x, least_y), n.z);
  const V least = hn::Min(hn::Mul(per_depth, set(row.nearest)), hn::Mul(per_depth, set(row.farthest)));
  return hn::Gt(hn::Sub(least, dot(n, light.apex)), light.slack);
}

/// Appends the runs of a light that meets the view.
HWY_INLINE void append_runs(const ClusterPlanes& planes, const BlockLights& block, std::size_t i, std::uint32_t index,
                            std::vector<ClusterRun>& runs) {
  using D = hn::CappedTag<float, kMaxParts>;
  const D d;
  using V = hn::Vec<D>;
  const OneLight<D> light(d, block, i);
  const std::uint64_t columns = parts_met(d, planes.columns, light, light.apex.x, light.axis.x, light.axis.y);
  const std::uint64_t rows = parts_met(d, planes.rows, light, light.apex.y, light.axis.y, light.axis.x);
  const float least_depth = block.least_depth[i] - block.slack[i];
  const float most_depth = block.most_depth[i] + block.slack[i];
  const std::uint64_t slices = parts_between(d, planes.slices, [&](std::size_t at) HWY_ATTR {
    const V depth = hn::LoadU(d, planes.depths.data() + at);
    return Sides<D>{hn::Gt(depth, hn::Set(d, most_depth)), hn::Lt(depth, hn::Set(d, least_depth))};
  });
  const bool is_one = std::has_single_bit(columns) && std::has_single_bit(rows) && std::has_single_bit(slices);
  const bool is_convex = block.cos_h[i] >= 0;
  const float radius = block.range[i] + block.slack[i];
  const std::size_t first_column = std::size_t(std::countr_zero(columns));
  for (std::uint64_t rest = slices; rest != 0; rest &= rest - 1) {
    const auto slice = std::size_t(std::countr_zero(rest));
    const float nearest = std::max(planes.depths[slice], least_depth);
    const float farthest = std::min(planes.depths[slice + 1], most_depth);
    const float depth = std::min(std::max(block.z[i], nearest), farthest);
    const Ball in_slice{depth, radius * radius - (block.z[i] - depth) * (block.z[i] - depth)};
    for (std::uint64_t rest_rows = rows; rest_rows != 0; rest_rows &= rest_rows - 1) {
      const auto row = std::size_t(std::countr_zero(rest_rows));
      std::uint64_t met = columns;
      if (!is_one) {
        const Ball ball = between(planes.rows, row, block.y[i], in_slice);
        if (ball.square < 0) continue;
        const Row bounds{nearest, farthest, planes.rows.tangent[row], planes.rows.tangent[row + 1]};
        const V ball_depth = hn::Set(d, ball.depth);
        const V ball_radius = hn::Set(d, std::sqrt(ball.square));
        for (std::size_t at = first_column; at < 64 && columns >> at != 0; at += hn::Lanes(d)) {
          const auto above = [&](std::size_t plane) HWY_ATTR {
            return hn::MulAdd(hn::LoadU(d, planes.columns.across.data() + plane), light.apex.x,
                              hn::Mul(hn::LoadU(d, planes.columns.along.data() + plane), ball_depth));
          };
          auto is_apart = hn::Gt(hn::Max(hn::Neg(above(at)), above(at + 1)), ball_radius);
          if (is_convex) {
            const V left = hn::LoadU(d, planes.columns.tangent.data() + at);
            const V right = hn::LoadU(d, planes.columns.tangent.data() + at + 1);
            is_apart = hn::Or(is_apart, is_beside_cone(d, light, bounds, left, right));
          }
          met &= ~(bits_of(d, is_apart) << at);
        }
      }
      if (met != 0) runs.push_back({index, std::uint32_t(slice * planes.rows.parts + row), met});
    }
  }
}

std::size_t append_block(const ClusterPlanes& planes, const LightColumns& lights, std::size_t begin,
                         std::vector<ClusterRun>& runs) {
  BlockLights block;
  std::size_t in_clusters = 0;
  for (std::uint64_t seen = see_block(planes, lights, begin, block); seen != 0; seen &= seen - 1) {
    const auto i = std::size_t(std::countr_zero(seen));
    const std::size_t before = runs.size();
    append_runs(planes, block, i, std::uint32_t(begin + i), runs);
    in_clusters += runs.size() > before;
  }
  return in_clusters;
}

}  // namespace litfog::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace litfog {
namespace {

struct SplitFloat {
  float value;
  float rest;
};
SplitFloat split(double x) { return {float(x), float(x - double(float(x)))}; }

}  // namespace

void LightColumns::resize(std::size_t count) {
  const std::size_t padded = (count + kLightBlock - 1) / kLightBlock * kLightBlock;
  for (auto* column :
       {&x, &y, &z, &x_rest, &y_rest, &z_rest, &axis_x, &axis_y, &axis_z, &range, &cos_half_angle, &sin_half_angle}) {
    column->resize(padded);
    std::fill(column->begin() + std::ptrdiff_t(std::min(count, size)), column->end(), 0.0f);
  }
  size = count;
}

void LightColumns::set(std::size_t light, const LightBounds& bounds) {
  const glm::dvec3 axis = glm::normalize(bounds.direction);
  const double half_angle = std::min(bounds.half_angle, std::numbers::pi);
  const SplitFloat split_x = split(bounds.position.x);
  const SplitFloat split_y = split(bounds.position.y);
  const SplitFloat split_z = split(bounds.position.z);
  x[light] = split_x.value;
  y[light] = split_y.value;
  z[light] = split_z.value;
  x_rest[light] = split_x.rest;
  y_rest[light] = split_y.rest;
  z_rest[light] = split_z.rest;
  axis_x[light] = float(axis.x);
  axis_y[light] = float(axis.y);
  axis_z[light] = float(axis.z);
  cos_half_angle[light] = float(std::cos(half_angle));
  sin_half_angle[light] = float(std::sin(half_angle));
  set_range(light, bounds.range);
}

void LightColumns::set_range(std::size_t light, double metres) {
  range[light] = metres > 0 ? std::max(float(metres), std::numeric_limits<float>::min()) : 0;
}

EdgePlanes::EdgePlanes(std::uint32_t count, double low, double high) : parts(count) {
  for (std::uint32_t i = 0; i <= count; ++i) {
    const double t = low + (high - low) * (double(i) / count);
    tangent[i] = float(t);
    across[i] = float(1 / std::hypot(1, t));
    along[i] = float(-t / std::hypot(1, t));
  }
}

ClusterPlanes::ClusterPlanes(const ClusterGrid& grid, const View& view)
    : columns(grid.columns, view.left, view.right), rows(grid.rows, view.bottom, view.top), slices(grid.slices) {
  const glm::dmat3 axes = axes_of(view);
  for (int i = 0; i < 3; ++i) {
    const SplitFloat coordinate = split(view.eye[i]);
    eye[i] = coordinate.value;
    eye_rest[i] = coordinate.rest;
    right[i] = float(axes[0][i]);
    up[i] = float(axes[1][i]);
    forward[i] = float(axes[2][i]);
  }
  const double x = std::max(std::abs(view.left), std::abs(view.right));
  const double y = std::max(std::abs(view.bottom), std::abs(view.top));
  farthest_corner = float(view.farthest * glm::length(glm::dvec3(x, y, 1)));
  for (std::uint32_t i = 0; i <= slices; ++i) depths[i] = float(slice_depth(grid, view, i));
}

HWY_EXPORT(append_block);

std::size_t append_cluster_runs(const ClusterPlanes& planes, const LightColumns& lights, std::size_t begin,
                                std::vector<ClusterRun>& runs) {
  return HWY_DYNAMIC_DISPATCH(append_block)(planes, lights, begin, runs);
}

}  // namespace litfog
#endif
