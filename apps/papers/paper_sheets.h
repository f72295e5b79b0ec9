// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog::papers {

/// Draws the figures of the four papers by their own programs, beside this demo's paths, each paper on a sheet in a
/// folder:
///
/// hales.png    figures 1 and 2 (two headlights, clear and in exp2 fog) by the sample program, the look-up paths,
///              unified and airlight, with their frame times beside his table 1; OpenGL's fixed pipeline; a flare and a
///              search light; cone maps scaled beyond 60 degrees
/// lacroix.png  figures 1 to 3: a point light on few and on more vertices, and per pixel; his equations as printed;
///              normal maps in tangent, world and object space; nested flags, with their frame time; parallax
/// cg.png       figures 5-1, 5-3, 5-5, 5-8, 5-11, 5-12, 5-14, 5-16, 5-17, 5-21 and 5-22; exercises 3, 4, 6 and 7;
///              attenuation and spots at the vertices, in three spaces; attenuation with clamp and cut and without
/// frazier.png  his maps; point lights, spots, disco and beacon; light map and base texture; overlapping lights in two
///              passes; one spot map for every angle; bump mapping; shadows by stencil and by maps
///
/// folder   made if it does not exist
/// width    pixels of each picture
/// frames   number timed for each program of table 1
/// throws   like drawing::PictureFolder and Renderer
void draw_paper_sheets(const std::string& folder, int width, int height, int frames);

}  // namespace litfog::papers
