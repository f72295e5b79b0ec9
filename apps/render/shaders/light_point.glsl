// SPDX-License-Identifier: Apache-2.0
// Common to both shaders of a light's point.

const float point_radii = 5.0;  // the point's size in radii of its glare: beyond 2.5 nothing of it is left
