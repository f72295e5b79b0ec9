// SPDX-License-Identifier: Apache-2.0
#include "litfog/updater.h"

#include "c/call.h"
#include "c/convert.h"
#include "c/handles.h"
#include "c/layout.h"

using namespace litfog;

namespace {

FogUpdater& updater_of(litfog_updater* updater) { return c::at(updater, "updater").updater; }
const FogUpdater& updater_of(const litfog_updater* updater) { return c::at(updater, "updater").updater; }

litfog_fog_light_changes changes_of(const FogLightChanges& found) {
  return {.kinds = c::view_as<litfog_entry_range>(found.kinds),
          .kind_count = found.kinds.size(),
          .instances = c::view_as<litfog_entry_range>(found.instances),
          .instance_count = found.instances.size(),
          .sources = c::view_as<litfog_entry_range>(found.sources),
          .source_count = found.sources.size()};
}

}  // namespace

litfog_status litfog_updater_create(double skip_budget_255, litfog_updater** updater) {
  return c::call([&] {
    c::at(updater, "updater");
    *updater = new litfog_updater{FogUpdater(skip_budget_255)};
  });
}

void litfog_updater_destroy(litfog_updater* updater) { delete updater; }

litfog_status litfog_updater_add(litfog_updater* updater, const litfog_placed_light* light,
                                 litfog_light_handle* handle) {
  return c::call([&] {
    c::at(handle, "handle");
    *handle = c::to_c<litfog_light_handle>(updater_of(updater).add(c::placed_light(light)));
  });
}

litfog_status litfog_updater_change(litfog_updater* updater, litfog_light_handle handle,
                                    const litfog_placed_light* light) {
  return c::call([&] { updater_of(updater).change(c::to_cpp(handle), c::placed_light(light)); });
}

litfog_status litfog_updater_switch_light(litfog_updater* updater, litfog_light_handle handle, int32_t is_on) {
  return c::call([&] { updater_of(updater).switch_light(c::to_cpp(handle), is_on != 0); });
}

litfog_status litfog_updater_set_time(litfog_updater* updater, double seconds) {
  return c::call([&] { updater_of(updater).set_time(seconds); });
}

litfog_status litfog_updater_remove(litfog_updater* updater, litfog_light_handle handle) {
  return c::call([&] { updater_of(updater).remove(c::to_cpp(handle)); });
}

litfog_status litfog_updater_set_fog(litfog_updater* updater, const litfog_fog* fog,
                                     litfog_fog_light_changes* changes) {
  return c::call([&] {
    c::at(changes, "changes");
    *changes = changes_of(updater_of(updater).set_fog(c::fog(fog)));
  });
}

litfog_status litfog_updater_set_atmosphere(litfog_updater* updater, const litfog_atmosphere* atmosphere,
                                            double eye_height, litfog_fog_light_changes* changes) {
  return c::call([&] {
    c::at(changes, "changes");
    *changes = changes_of(updater_of(updater).set_atmosphere(c::atmosphere(atmosphere), eye_height));
  });
}

litfog_status litfog_updater_solve_sources(litfog_updater* updater) {
  return c::call([&] { updater_of(updater).solve_sources(); });
}

litfog_status litfog_updater_sources(const litfog_updater* updater, const litfog_fog_light_source** sources,
                                     size_t* count) {
  return c::call([&] {
    const std::span<const FogLightSource> found = updater_of(updater).sources();
    c::at(sources, "sources");
    c::at(count, "count") = found.size();
    *sources = c::view_as<litfog_fog_light_source>(found);
  });
}

litfog_status litfog_updater_tables(const litfog_updater* updater, litfog_fog_light_tables* tables) {
  return c::call([&] {
    const FogUpdater& from = updater_of(updater);
    c::at(tables, "tables") = {.kinds = c::view_as<litfog_fog_light_kind>(from.kinds()),
                               .kind_count = from.kinds().size(),
                               .instances = c::view_as<litfog_fog_light_instance>(from.instances()),
                               .instance_count = from.instances().size()};
  });
}

litfog_status litfog_updater_statistics(const litfog_updater* updater, litfog_fog_update_statistics* statistics) {
  return c::call([&] {
    c::at(statistics, "statistics") = c::to_c<litfog_fog_update_statistics>(updater_of(updater).statistics());
  });
}

litfog_status litfog_updater_instance_of(const litfog_updater* updater, litfog_light_handle handle, size_t* instance) {
  return c::call([&] { c::at(instance, "instance") = updater_of(updater).instance_of(c::to_cpp(handle)); });
}

litfog_status litfog_updater_kind_of(const litfog_updater* updater, litfog_light_handle handle, size_t* kind) {
  return c::call([&] { c::at(kind, "kind") = updater_of(updater).kind_of(c::to_cpp(handle)); });
}
