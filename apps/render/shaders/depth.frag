// SPDX-License-Identifier: Apache-2.0
// A surface's depth alone.

void main() {}
