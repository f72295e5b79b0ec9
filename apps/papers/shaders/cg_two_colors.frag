// SPDX-License-Identifier: Apache-2.0
// Lights with separate specular and diffuse colours, as in OpenGL and Direct3D. "We are also using the
// same value for the light's diffuse and specular colors instead of allowing different values for each of these."
// (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", section 5.2.1). Here highlights are blue.

#include "depth_test.glsl"
#define specular_color(diffuse_color) ((diffuse_color) * vec3(0.1, 0.3, 1.0))
#include "path/cg.frag"
