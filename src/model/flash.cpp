// SPDX-License-Identifier: Apache-2.0
#include "litfog/flash.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "float_limit.h"

namespace litfog {
namespace {

struct SingleFlashFields {
  const char* start;
  const char* duration;
  const char* intensity;
};

constexpr std::array<SingleFlashFields, kMaxFlashes> kFields{{
    {"flash.flashes[0].start", "flash.flashes[0].duration", "flash.flashes[0].intensity"},
    {"flash.flashes[1].start", "flash.flashes[1].duration", "flash.flashes[1].intensity"},
    {"flash.flashes[2].start", "flash.flashes[2].duration", "flash.flashes[2].intensity"},
    {"flash.flashes[3].start", "flash.flashes[3].duration", "flash.flashes[3].intensity"},
    {"flash.flashes[4].start", "flash.flashes[4].duration", "flash.flashes[4].intensity"},
    {"flash.flashes[5].start", "flash.flashes[5].duration", "flash.flashes[5].intensity"},
    {"flash.flashes[6].start", "flash.flashes[6].duration", "flash.flashes[6].intensity"},
    {"flash.flashes[7].start", "flash.flashes[7].duration", "flash.flashes[7].intensity"},
}};

double end_of(const SingleFlash& flash) { return flash.start + flash.duration; }

std::span<const SingleFlash> flashes_of(const Flash& flash) { return std::span(flash.flashes).first(flash.count); }

}  // namespace

std::optional<ValueError> find_error(const Flash& flash) {
  if (flash.count > kMaxFlashes) return ValueError{"flash.count", double(flash.count), "must be at most 8"};
  if (flash.count == 0) return std::nullopt;
  if (!(flash.period > 0 && flash.period <= kMaxFlashPeriod)) {
    return ValueError{"flash.period", flash.period, "must be in (0, 3600]"};
  }
  double end = 0;
  for (std::size_t i = 0; i < flash.count; ++i) {
    const SingleFlash& single = flash.flashes[i];
    if (!is_within(single.start, end, std::numeric_limits<double>::infinity())) {
      return ValueError{kFields[i].start, single.start, "must be >= 0 and not before the end of the flash before it"};
    }
    if (!(single.duration > 0)) return ValueError{kFields[i].duration, single.duration, "must be > 0"};
    end = end_of(single);
    if (!is_within(end, 0, flash.period)) {
      return ValueError{kFields[i].duration, single.duration, "must end within the period"};
    }
    if (!(end > single.start)) {
      return ValueError{kFields[i].duration, single.duration, "must be longer than a rounding of the start"};
    }
    if (!(single.intensity > 0 && single.intensity <= kMaxFlashIntensity)) {
      return ValueError{kFields[i].intensity, single.intensity, "must be in (0, 1e6]"};
    }
  }
  return std::nullopt;
}

double flash_at(const Flash& flash, double seconds) {
  if (flash.count == 0) return 1;
  const double time = std::fmod(seconds, flash.period);
  double factor = 0;
  for (const SingleFlash& single : flashes_of(flash)) {
    if (time >= single.start) factor = time < end_of(single) ? single.intensity : 0;
  }
  return factor;
}

double largest_flash(const Flash& flash) {
  if (flash.count == 0) return 1;
  return std::ranges::max_element(flashes_of(flash), {}, &SingleFlash::intensity)->intensity;
}

}  // namespace litfog
