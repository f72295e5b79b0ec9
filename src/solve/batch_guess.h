// SPDX-License-Identifier: Apache-2.0
#pragma once

// Constants of the batch's first guesses. A step of third order or more follows each guess, so the guess need only be
// near: the constants were fitted by hand to two or three digits. For each constant batch_guess_test.cpp computes its
// formula's largest relative error, and the smallest such error for any value of the constant, and asserts the
// statements here.

namespace litfog::batch_guess {

/// log(1 + m) = m (1 + m (k[0] + m (k[1] + m k[2]))) on [0, 1]: slope 1 at 0, and k[0] + k[1] + k[2] = log 2 - 1 for
/// the true value at 1. Error 2.4e-3.
inline constexpr float kLog1p[] = {-0.48625f, 0.2625f, -0.0831f};

/// The bits of x^(1/3), read as an integer, are a third of those of x plus two thirds of those of 1 (710235477.3),
/// minus a balance for the error of the bits as a logarithm. Error 3.5 %; no other value gains a fifth.
inline constexpr int kCubeRootBits = 709921077;

/// e^u - 1 - u = z at u = log(1 + s + z (1 - 1 / (3 + 3 k s))), s = sqrt(2 z): the series in s for small z, log z for
/// large. Error 7e-4.
inline constexpr float kDepthBend = 0.18f;

/// The stationary point in exp fog is u - log(1 + w u^2 / (u + k + l w)), with u that of Q = 0 and w = 2 B / (A + 2 B).
/// Error 1.7 %; no other k and l gain a tenth.
inline constexpr float kExpDamping = 3.5f;
inline constexpr float kExpDampingByWeight = 0.84f;

/// Near 0 the stationary point in exp2 fog is s (1 - k s^2), s^4 = p^(4/3) + q, where s^2 is below the limit; one
/// substitution follows. Error 2.4 %; no other k gains a tenth.
inline constexpr float kExp2Bend = 0.18f;
inline constexpr float kExp2Limit = 1.5f;

}  // namespace litfog::batch_guess
