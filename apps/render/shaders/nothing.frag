// SPDX-License-Identifier: Apache-2.0
// Draws no colour: for passes that mark pixels in the stencil.
void main() {}
