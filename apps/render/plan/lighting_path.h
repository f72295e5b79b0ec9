// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "litfog/gl/shader_library.h"

namespace litfog::render {

/// How a surface reflects the light that reaches it. Colours are linear; the reflectance is the base texture.
enum class SurfaceModel {
  /// Emissive + ambient + diffuse + specular, specular zero where diffuse is (Randima Fernando and Mark Kilgard 2003,
  /// "The Cg Tutorial", section 5.2).
  basic,
  /// Emissive + (ambient + directional + sum of the lights x N.L) x base texture (Steven Hales 2004, "Realtime Pixel
  /// Lighting Using Fragment Programs").
  diffuse,
  /// Emissive + (ambient + directional + sum of the lights) x base texture. Only the directional light depends on the
  /// surface's orientation, by N.L (Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL",
  /// which has no directional light).
  unshaded,
};

/// How light falls with range r up to the extent E. Beyond E it is 0.
enum class RangeLaw {
  attenuation,  ///< min(1, 1 / (C + L r + Q r^2)), the model's
  radial,       ///< 1 - r^2 / E^2 (Frazier 2000)
  unbounded,    ///< 1 / (C + L r + Q r^2), neither clamped nor ended by an extent (The Cg Tutorial, example 5-6; Jason
                ///< Lacroix 2005, "Let There Be Light!", equation 3)
};

/// Where lighting is computed, which decides how near a picture comes to the surface model's formula.
enum class Evaluation {
  fragment,  ///< at each fragment: the exact formula
  lookup,    ///< at each fragment, range and angle from textures: as exact as their texels are dense
  vertex,    ///< partly or wholly at the vertices: as exact as the triangles are small
};

/// How a pass's colour is combined with the surface's earlier passes.
enum class Blend {
  replace,
  add,
  multiply,
  over,  ///< adds it to alpha times the earlier colour
};

/// How a pass takes its lights.
struct LightFeed {
  enum class Kind {
    none,  ///< drawn once, without lights
    all,   ///< drawn once, with all lights that can reach the surface
    /// Drawn once for each batch of lights; later batches are added. Without lights drawn once, or not at all with
    /// Blend::add.
    batches,
  };
  Kind kind = Kind::none;
  std::size_t batch_size = 0;  ///< batches: at most this many lights, which share their maps
  bool lists_rest = false;     ///< batches: the first of several also reads all lights from the light list
  /// batches: each light adds its lit fog by the look-up for its light on the surface. Otherwise a surface's first pass
  /// adds the lit fog of all lights by the cones' formula.
  bool bring_fog = false;
  /// all: shaders take kMaxUniformLights lights, each with a flag that says whether it exists. Otherwise shaders are
  /// compiled for about as many lights as exist, up to kMaxUnrolledLights.
  bool has_flags = false;
};

/// One pass over a surface. Shaders are files in apps/render/shaders.
struct SurfacePass {
  std::string_view vertex;
  std::string_view geometry = {};  ///< empty: none
  std::string_view fragment;
  Blend blend = Blend::replace;
  LightFeed lights = {};
  bool shows_fog = true;  ///< adds the fog's light when it first draws a surface
};

/// The textures in which a path looks up its lights.
enum class LightMapSet {
  none,
  volume,  ///< Hales: 3-D range map, cone cube map about +x
  pair,    ///< Hales: two 2-D maps for the range, cone cube map about +x
  radial,  ///< Frazier: x^2 + y^2 in 2-D, z^2 in 1-D, cone cube map about -z
};

/// A published way to light a pixel.
struct LightingPath {
  std::string_view name;
  std::string_view description = {};
  std::string source = {};  ///< paper and section
  SurfaceModel surface = SurfaceModel::basic;
  RangeLaw range = RangeLaw::attenuation;
  Evaluation evaluation = Evaluation::fragment;
  bool has_normal_maps = false;        ///< otherwise vertex normals
  bool has_lit_fog = true;             ///< otherwise the ambient fog colour alone
  bool takes_airlight = false;         ///< lamps light each fragment, so that fog can dim them and shadows hide them
  bool takes_scattered_light = false;  ///< light that the fog scatters reaches its surfaces (ScatteredLight)
  bool has_reference = true;           ///< measure::PathModel has its formulas
  /// hidden_range.h bounds the light from surfaces, all of which passes through the fog, so that fog can hide them.
  bool has_light_bound = false;
  bool pairs_lights = false;  ///< a batch is lit by its first light's range, so no light can be left out
  LightMapSet maps = LightMapSet::none;
  std::vector<SurfacePass> passes;
  std::span<const gl::ShaderSource> shaders = {};  ///< files of its passes that the renderer lacks

  /// Whether a surface may be drawn more than once, which needs a stencil.
  bool has_several_passes() const { return passes.size() > 1 || passes[0].lights.kind == LightFeed::Kind::batches; }
  /// Whether panes (scene::Material::opacity) are drawn as panes, not as masks.
  bool draws_panes() const { return !has_several_passes(); }
  /// Whether the cones of the lit fog before surfaces come from the light maps.
  bool has_mapped_fog() const { return passes[0].lights.bring_fog; }
};

/// The ten paths that are compared, the default one first.
std::span<const LightingPath> lighting_paths();

/// The ten paths, then the papers' sample programs, exercises and intermediate pictures.
std::span<const LightingPath> all_paths();

/// Draws the base texture without light and fog: the lower limit of the paths' cost. Not one of the paths.
const LightingPath& unlit_path();

/// Draws a surface's number of lights as red, and 1 as green. Not one of the paths.
const LightingPath& light_count_path();

/// Normal maps in object space (Lacroix 2005). Not one of the paths: bundled scenes have maps in tangent space.
const LightingPath& object_space_path();

/// A path that rasterises exactly the samples of `other` but writes the attributes of a GeometryBuffer.
const LightingPath& geometry_path(const LightingPath& other);

/// Draws only the fog before a surface, for any path.
const SurfacePass& fog_alone_pass();

/// Draws only a surface's depth, for any path.
const SurfacePass& depth_pass();

/// One of all_paths(). Null if none has that name.
const LightingPath* find_lighting_path(std::string_view name);

}  // namespace litfog::render
