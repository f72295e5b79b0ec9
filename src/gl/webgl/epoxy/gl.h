// SPDX-License-Identifier: Apache-2.0
#pragma once

// In place of libepoxy, which loads OpenGL's functions: those of WebGL 2, which are OpenGL ES 3.0's, are linked. What
// ES 3.0 lacks is declared for code that does not use it there.
#include <GLES3/gl32.h>
