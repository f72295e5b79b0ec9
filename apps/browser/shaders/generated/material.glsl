// SPDX-License-Identifier: Apache-2.0
// No material of the scene has more than a colour and normals.
