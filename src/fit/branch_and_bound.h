// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>

// Best-first branch and bound (Land and Doig 1960, "An automatic method of solving discrete programming problems"),
// over boxes of parameters. Internal.

namespace litfog {

/// When a box is examined (Clausen 1999, "Branch and bound algorithms - principles and examples").
enum class Evaluation {
  eager,  ///< when it is made; boxes are split in the order of their own bounds
  lazy,   ///< when its turn comes, with its parent's bound until then; for bounds that improve with the best known
};

struct BranchAndBoundResult {
  double lower_bound = std::numeric_limits<double>::infinity();  ///< of the objective in all boxes examined
  std::size_t boxes = 0;                                         ///< examined and not empty
  bool is_proven = false;                                        ///< no box is left open
};

/// Minimises over problem.root(). The problem keeps the best parameters known; it has
///     Box root()
///     bool contract(Box&)       removes what cannot be better than the best known; false if nothing is left
///     double examine(Box)       looks for better parameters in the box; returns a lower bound of the objective in it
///     bool is_closed(double)    whether no box with this bound can improve enough on the best known
///     std::optional<std::array<Box, 2>> split(Box)    nothing if the box is a point
/// max_boxes  number at which the search gives up; it may exceed this by one
template <Evaluation kEvaluation, typename Problem>
BranchAndBoundResult branch_and_bound(Problem& problem, std::size_t max_boxes) {
  struct Node {
    decltype(problem.root()) box;
    double bound;

    bool operator<(const Node& other) const { return bound > other.bound; }  // the queue's top has the smallest bound
  };
  BranchAndBoundResult result;
  const auto is_left_open = [&](Node& node) {
    if (!problem.contract(node.box)) return false;
    ++result.boxes;
    node.bound = std::max(node.bound, problem.examine(node.box));
    if (!problem.is_closed(node.bound)) return true;
    result.lower_bound = std::min(result.lower_bound, node.bound);
    return false;
  };
  std::priority_queue<Node> open;
  const auto add = [&](Node node) {
    if (kEvaluation == Evaluation::lazy || is_left_open(node)) open.push(node);
  };
  add({problem.root(), 0});
  while (!open.empty() && !problem.is_closed(open.top().bound) && result.boxes < max_boxes) {
    Node node = open.top();
    open.pop();
    if (kEvaluation == Evaluation::lazy && !is_left_open(node)) continue;
    if (const auto halves = problem.split(node.box)) {
      for (const auto& half : *halves) add({half, node.bound});
    } else {
      result.lower_bound = std::min(result.lower_bound, node.bound);  // GCOV_EXCL_LINE: branch_and_bound_test alone
    }
  }
  if (!open.empty()) result.lower_bound = std::min(result.lower_bound, open.top().bound);
  result.is_proven = open.empty() || problem.is_closed(open.top().bound);
  return result;
}

}  // namespace litfog
