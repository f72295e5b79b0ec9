// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog::papers {

/// Draws the figures of the four papers by their own programs, beside this demo's paths, each paper on a sheet in a
/// folder:
///
/// hales.png    figures 1 and 2 (two headlights, clear and in exp2 fog) by the sample program, the look-up paths,
///              unified and airlight, with their frame times beside his table 1; cone maps scaled beyond 60 degrees
/// lacroix.png  figures 1 to 3: a point light on few and on more vertices, and per pixel; his equations as printed;
///              normal maps in tangent, world and object space; nested flags, with their frame time; parallax
/// cg.png       figures 5-12, 5-14, 5-16, 5-17 and 5-21; exercises 4, 6 and 7; attenuation with clamp and cut and
///              without; metals
/// frazier.png  the light map without texture; one spot map for every angle; two point lights in one pass; shadows
///
/// folder   made if it does not exist
/// width    pixels of each picture
/// frames   timed of each program for table 1
/// throws   what drawing::PictureFolder and Renderer throw
void draw_paper_sheets(const std::string& folder, int width, int height, int frames);

}  // namespace litfog::papers
