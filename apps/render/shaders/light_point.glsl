// SPDX-License-Identifier: Apache-2.0
// What the shaders of a light's point share.

const float point_radii = 5.0;  // the point's size in radii of its glare: beyond 2.5 nothing of it is left
