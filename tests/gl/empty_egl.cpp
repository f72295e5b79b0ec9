// SPDX-License-Identifier: Apache-2.0
// A libEGL.so.1 without its functions, as a broken installation may have it.
extern "C" int litfog_empty_egl();
int litfog_empty_egl() { return 0; }
