// SPDX-License-Identifier: Apache-2.0
// When the depth of a fragment is tested. Included first, because #extension must precede all declarations.
//
// Most drivers test depth first and shade no hidden fragment. Mesa's llvmpipe shades 4 x 2 pixels at once, half a block
// of 4 x 4, and branches only at the ends of loops. With several samples a pixel, it saves work in either order:
// - Depth first, its own choice. Both halves of a block are shaded, even one that a small triangle does not touch. With
//   GL_ARB_post_depth_coverage a shader can tell hidden fragments, and end its loops early.
// - Depth late (TESTS_DEPTH_LATE), if a shader writes the stencil's reference. Hidden fragments are shaded, but halves
//   that a triangle does not touch are not. Without it a frame by `unified` and peak takes 1.1 (room) to 1.2
//   (headlights) times as long, 960 x 540 with four samples.
// Fragments of masks and panes never count as hidden: a mask's depth is tested after its texture, and panes cover each
// other.

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
