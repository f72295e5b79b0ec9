// SPDX-License-Identifier: Apache-2.0
#pragma once

// Replaces libepoxy, which loads OpenGL's functions: those of WebGL 2, which are OpenGL ES 3.0's, are linked instead.
// Functions that ES 3.0 lacks are declared for code that does not use them there.
#include <GLES3/gl32.h>

inline bool epoxy_is_desktop_gl() { return false; }
inline int epoxy_gl_version() { return 30; }
inline bool epoxy_has_gl_extension(const char* /*extension*/) { return false; }

inline void glClearDepth(double depth) { glClearDepthf(float(depth)); }

#define GL_NEGATIVE_ONE_TO_ONE 0x935E
#define GL_ZERO_TO_ONE 0x935F
#define GL_LOWER_LEFT 0x8CA1
inline void glClipControl(GLenum /*origin*/, GLenum /*depth*/) {}
