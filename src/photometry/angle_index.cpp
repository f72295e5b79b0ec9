// SPDX-License-Identifier: Apache-2.0
#include "photometry/angle_index.h"

#include <limits>

namespace litfog {

AngleIndex::AngleIndex(std::span<const double> angles, std::size_t stride_given)
    : first(angles.front()), last(angles.back()), stride(stride_given) {
  const std::size_t count = angles.size() - 1;
  last_bucket = 2 * double(count);
  scale = last_bucket / (last - first);
  for (std::size_t bucket = 0, interval = 0; bucket <= 2 * count; ++bucket) {
    while (interval + 1 < count && bucket_of(angles[interval + 1]) < bucket) ++interval;
    intervals.push_back(std::uint32_t(interval));
  }
  for (std::size_t i = 0; i < count; ++i) {
    low.push_back(angles[i]);
    reciprocal.push_back(1 / (angles[i + 1] - angles[i]));
  }
  low.push_back(std::numeric_limits<double>::infinity());
}

}  // namespace litfog
