// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fit/light_fit.h"
#include "command/plot.h"

/// Targets, fits and what lies between them, over range and over angle.
Figure fit_figure(const LightFit& fit);
