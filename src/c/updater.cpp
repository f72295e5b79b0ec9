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
    const FogLightChanges found = updater_of(updater).set_fog(c::fog(fog));
    *changes = {.kinds = c::view_as<litfog_entry_range>(found.kinds),
                .kind_count = found.kinds.size(),
                .instances = c::view_as<litfog_entry_range>(found.instances),
                .instance_count = found.instances.size(),
                .effective_intensities = c::view_as<litfog_entry_range>(found.effective_intensities),
                .effective_intensity_count = found.effective_intensities.size()};
  });
}

litfog_status litfog_updater_solve_effective_intensities(litfog_updater* updater) {
  return c::call([&] { updater_of(updater).solve_effective_intensities(); });
}

litfog_status litfog_updater_effective_intensities(const litfog_updater* updater, const float** intensities,
                                                   size_t* count) {
  return c::call([&] {
    const std::span<const float> found = updater_of(updater).effective_intensities();
    c::at(intensities, "intensities");
    c::at(count, "count") = found.size();
    *intensities = found.data();
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
