// SPDX-License-Identifier: Apache-2.0
// Whether what is nearer hides a fragment. Included first, because #extension has to precede all declarations.
//
// Most drivers shade no hidden fragment. Mesa's llvmpipe shades them where a pixel has several samples, and a shader
// can save it no other work than loops. No fragment of a mask or pane counts as hidden: a mask's depth is tested after
// its texture, and panes lie in front of each other.

#include "material.glsl"

#if !defined MATERIAL_MASK && !defined MATERIAL_PANE
#extension GL_ARB_gpu_shader5 : enable
#extension GL_ARB_post_depth_coverage : enable
#ifdef GL_ARB_post_depth_coverage
layout(post_depth_coverage) in;
#define is_hidden() (gl_SampleMaskIn[0] == 0)
#endif
#endif

#ifndef is_hidden
#define is_hidden() false
#endif
