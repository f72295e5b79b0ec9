// SPDX-License-Identifier: Apache-2.0
// Common to both shaders of a light's point.

uniform float point_radii;  // the point's size in radii of its glare: beyond half of it nothing is left
