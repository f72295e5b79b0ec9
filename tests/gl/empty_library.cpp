// SPDX-License-Identifier: Apache-2.0
// A libEGL.so.1 or libOpenGL.so.0 without its functions, as a broken installation may have it.
extern "C" int litfog_empty_library();
int litfog_empty_library() { return 0; }
