// SPDX-License-Identifier: Apache-2.0
#include "c/call.h"
#include "c/convert.h"
#include "c/handles.h"
#include "c/layout.h"
#include "litfog/light_bounds.h"
#include "litfog/light_clusters.h"
#include "litfog/view_frustum.h"
#include "model/require.h"

using namespace litfog;

struct litfog_view_frustum {
  ViewFrustum frustum;
};

namespace {

const ViewFrustum& frustum_of(const litfog_view_frustum* frustum) { return c::at(frustum, "frustum").frustum; }
LightClusters& clusters_of(litfog_light_clusters* clusters) { return c::at(clusters, "clusters").clusters; }
LightBounds bounds_of(const litfog_light_bounds* bounds) { return c::to_cpp(c::at(bounds, "bounds")); }
View view_of(const litfog_view* view) { return c::to_cpp(c::at(view, "view")); }

}  // namespace

litfog_status litfog_bounds_of(const litfog_placed_light* light, double range, litfog_light_bounds* bounds) {
  return c::call([&] {
    const PlacedLight placed = c::placed_light(light);
    require(find_error(placed));
    const LightBounds found = litfog::bounds_of(placed, range);
    require(find_error(found));
    c::at(bounds, "bounds") = c::to_c<litfog_light_bounds>(found);
  });
}

litfog_status litfog_can_light(const litfog_light_bounds* bounds, const double* low, const double* high, int32_t* can) {
  return c::call(
      [&] { c::at(can, "can") = can_light(bounds_of(bounds), c::vector(low, "low"), c::vector(high, "high")); });
}

litfog_status litfog_default_view(litfog_view* view) {
  return c::call([&] { c::at(view, "view") = c::to_c<litfog_view>(View{}); });
}

litfog_status litfog_view_frustum_create(const litfog_view* view, litfog_view_frustum** frustum) {
  return c::call([&] {
    c::at(frustum, "frustum");
    *frustum = new litfog_view_frustum{ViewFrustum(view_of(view))};
  });
}

void litfog_view_frustum_destroy(litfog_view_frustum* frustum) { delete frustum; }

litfog_status litfog_view_frustum_can_see_ball(const litfog_view_frustum* frustum, const double* centre, double radius,
                                               int32_t* can) {
  return c::call([&] { c::at(can, "can") = frustum_of(frustum).can_see(c::vector(centre, "centre"), radius); });
}

litfog_status litfog_view_frustum_can_see_light(const litfog_view_frustum* frustum, const litfog_light_bounds* bounds,
                                                int32_t* can) {
  return c::call([&] { c::at(can, "can") = frustum_of(frustum).can_see(bounds_of(bounds)); });
}

litfog_status litfog_light_clusters_create(const litfog_cluster_grid* grid, litfog_light_clusters** clusters) {
  return c::call([&] {
    c::at(clusters, "clusters");
    *clusters = new litfog_light_clusters{LightClusters(grid == nullptr ? ClusterGrid{} : c::to_cpp(*grid))};
  });
}

void litfog_light_clusters_destroy(litfog_light_clusters* clusters) { delete clusters; }

litfog_status litfog_light_clusters_resize(litfog_light_clusters* clusters, size_t count) {
  return c::call([&] { clusters_of(clusters).resize(count); });
}

litfog_status litfog_light_clusters_set_light(litfog_light_clusters* clusters, size_t light,
                                              const litfog_light_bounds* bounds) {
  return c::call([&] { clusters_of(clusters).set_light(light, bounds_of(bounds)); });
}

litfog_status litfog_updater_bound_lights(const litfog_updater* updater, litfog_light_clusters* clusters,
                                          const litfog_atmosphere* atmosphere, double step, int32_t lamp_leg) {
  return c::call([&] {
    const FogUpdater& from = c::at(updater, "updater").updater;
    from.bound_lights(clusters_of(clusters), c::atmosphere(atmosphere), step, c::lamp_leg(lamp_leg));
  });
}

litfog_status litfog_updater_reach_of_kind(const litfog_updater* updater, size_t kind,
                                           const litfog_atmosphere* atmosphere, double step, int32_t lamp_leg,
                                           double* range) {
  return c::call([&] {
    const FogUpdater& from = c::at(updater, "updater").updater;
    c::at(range, "range") = from.reach_of_kind(kind, c::atmosphere(atmosphere), step, c::lamp_leg(lamp_leg));
  });
}

litfog_status litfog_light_clusters_update(litfog_light_clusters* clusters, const litfog_view* view, int32_t* changed) {
  return c::call([&] {
    const bool has_changed = clusters_of(clusters).update(view_of(view));
    if (changed != nullptr) *changed = has_changed;
  });
}

litfog_status litfog_light_clusters_lists(const litfog_light_clusters* clusters, litfog_cluster_lists* lists) {
  return c::call([&] {
    const LightClusters& from = c::at(clusters, "clusters").clusters;
    const ClusterLookup lookup = from.lookup();
    c::at(lists, "lists") = {.clusters = c::view_as<litfog_cluster>(from.clusters()),
                             .cluster_count = from.clusters().size(),
                             .lights = from.light_list().data(),
                             .light_count = from.light_list().size(),
                             .slice_scale = lookup.slice_scale,
                             .slice_bias = lookup.slice_bias,
                             .table = from.table().data(),
                             .table_size = from.table().size()};
  });
}
