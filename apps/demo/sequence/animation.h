// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::demo {

/// Frames as one animated PNG that loops in any browser. Lossless, whereas a GIF of 256 colours a frame shows fog in
/// bands, and OpenImageIO's with bright specks. Written here, because Debian's libpng cannot.
///
/// frames             PNG files of one size, depth and colour type, at least one
/// frames_per_second  [1, 100]
/// throws             std::invalid_argument for a frame that is not a PNG file
/// source             W3C, "Portable Network Graphics (PNG) Specification (Third Edition)": acTL, fcTL, fdAT
std::string animated_png(const std::vector<std::string>& frames, int frames_per_second);

/// Whether a path ends like a film that ffmpeg makes: .mp4 (H.264) or .webm (VP9).
bool is_film_path(const std::string& path);

/// Throws MissingCapability if ffmpeg is not installed. Call it before drawing frames.
void require_film_maker();

/// The bytes of a film's file, by its path's ending. Odd sizes get a black column or row.
///
/// frames  PNG files of one size
/// throws  MissingCapability if ffmpeg is not installed or fails
std::string film(const std::string& path, const std::vector<std::string>& frames, int frames_per_second);

}  // namespace litfog::demo
