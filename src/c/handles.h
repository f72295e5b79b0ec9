// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/light_clusters.h"
#include "litfog/updater.h"

// What the handles of litfog.h stand for that more than one file takes.

struct litfog_updater {
  litfog::FogUpdater updater;
};

struct litfog_light_clusters {
  litfog::LightClusters clusters;
};
