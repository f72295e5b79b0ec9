// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/light_clusters.h"
#include "litfog/updater.h"

// The structs behind handles of litfog.h that several files use.

struct litfog_updater {
  litfog::FogUpdater updater;
};

struct litfog_light_clusters {
  litfog::LightClusters clusters;
};
