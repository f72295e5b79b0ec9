// SPDX-License-Identifier: Apache-2.0
// litfog: the profiles of cones as lights state them (LitfogInstance, LitfogAirlight). C++ includes this file, too.

#ifndef LITFOG_CONE_PROFILE_GLSL
#define LITFOG_CONE_PROFILE_GLSL

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#define LITFOG_PROFILE_NONE 0.0  // a point light
#define LITFOG_PROFILE_COSINE 1.0
#define LITFOG_PROFILE_SMOOTHSTEP 2.0
#define LITFOG_PROFILE_COOKIE 3.0  // belongs to the including program (light.glsl)

#endif
