// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "light_fit.h"
#include "plot.h"

/// Targets, fits and what lies between them, over range and over angle.
Figure fit_figure(const LightFit& fit);
