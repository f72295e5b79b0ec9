// SPDX-License-Identifier: Apache-2.0
// Hashes that are the same on every machine. Also compiled as C++ (scene/hash_random.h, which defines LITFOG_FUNCTION
// first).

#ifndef __cplusplus
#define LITFOG_FUNCTION
#endif

// Bijective 32-bit mixer ("lowbias32", Wellons 2018).
LITFOG_FUNCTION uint hash(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

// A number in [0, 1) of the upper 24 bits, which a float holds exactly.
LITFOG_FUNCTION float unit_float(uint bits) { return float(bits >> 8) * 5.9604644775390625e-8f; }

#undef LITFOG_FUNCTION
