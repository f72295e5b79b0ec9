// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::demo {

/// Frames as one animated PNG that plays for ever in any browser. Nothing is lost; a GIF of 256 colours a frame shows
/// fog in bands, and OpenImageIO's puts bright specks into it. Written here, because Debian's libpng does not write it.
///
/// frames             PNG files of one size, depth and colour type, at least one
/// frames_per_second  [1, 100]
/// throws             std::invalid_argument for a frame that is no PNG file
/// source             W3C, "Portable Network Graphics (PNG) Specification (Third Edition)": acTL, fcTL, fdAT
std::string animated_png(const std::vector<std::string>& frames, int frames_per_second);

/// Whether a path ends as films do that ffmpeg makes: .mp4 (H.264) or .webm (VP9).
bool is_film_path(const std::string& path);

/// Throws MissingCapability where ffmpeg is not installed: before frames are drawn.
void require_film_maker();

/// The bytes of a film's file, by its path's ending. Of odd sizes a column or a row is black.
///
/// frames  PNG files of one size
/// throws  MissingCapability where ffmpeg is not installed, or fails
std::string film(const std::string& path, const std::vector<std::string>& frames, int frames_per_second);

}  // namespace litfog::demo
