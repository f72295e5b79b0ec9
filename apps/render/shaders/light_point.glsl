// SPDX-License-Identifier: Apache-2.0
// Shared by the vertex and the fragment shader of a light's point.

uniform float point_radii;  // the point's size in radii of its glare: beyond half of it nothing is left
