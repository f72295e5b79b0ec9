// SPDX-License-Identifier: Apache-2.0
// When the depth of a fragment is tested. Included first, because #extension has to precede all declarations.
//
// Most drivers test it first and shade no hidden fragment. Mesa's llvmpipe shades 4 x 2 pixels at once, half a block of
// 4 x 4, and has no branches but the ends of loops. Where a pixel has several samples, it leaves something out of either
// order:
// - Depths first, its own choice. Both halves of a block are shaded, even one that a small triangle does not touch. With
//   GL_ARB_post_depth_coverage a shader can tell hidden fragments, and end its loops early.
// - Depths late (TESTS_DEPTH_LATE), if a shader writes the stencil's reference. Hidden fragments are shaded, but halves
//   that a triangle does not touch are not. Without it a frame by `unified` and peak takes 1.1 (room) to 1.2
//   (headlights) times as long, 960 x 540 with four samples.
// No fragment of a mask or pane counts as hidden: a mask's depth is tested after its texture, and panes lie in front of
// each other.

#include "generated/material.glsl"

#ifdef TESTS_DEPTH_LATE
#extension GL_ARB_shader_stencil_export : require
#elif !defined MATERIAL_MASK && !defined MATERIAL_PANE
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
