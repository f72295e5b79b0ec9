// SPDX-License-Identifier: Apache-2.0
// Included before litfog's own files. In a scene with cookies, cube_cookie.glsl replaces it.
