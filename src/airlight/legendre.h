// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#include "airlight_text.h"

namespace litfog {

/// Calls a function with the eight nodes of Gauss and Legendre between two numbers, and with their weights.
template <typename Add>
void add_gauss(double from, double to, const Add& add) {
  using Nodes = airlight_text::Text<double, airlight_text::NoCookie>;
  for (std::size_t node = 28; node < 36; ++node) {
    add(std::lerp(from, to, Nodes::litfog_gauss_nodes[node]), (to - from) * Nodes::litfog_gauss_weights[node]);
  }
}

/// Calls a function with the Legendre polynomials of a cosine and with their derivatives.
template <int kOrders, typename Use>
void for_each_polynomial(double x, const Use& use) {
  double before = 0, now = 1, slope_before = 0, slope = 0;
  for (int order = 0; order < kOrders; ++order) {
    use(std::size_t(order), now, slope);
    const double n = order + 1;
    const double next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
    const double next_slope = slope_before + (2 * n - 1) * now;
    before = now;
    now = next;
    slope_before = slope;
    slope = next_slope;
  }
}

}  // namespace litfog
