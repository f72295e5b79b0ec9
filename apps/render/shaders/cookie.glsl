// SPDX-License-Identifier: Apache-2.0
// Stands before litfog's own files. A scene with cookies has cube_cookie.glsl in its place.
