// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/json_document.h"
#include "model/float_limit.h"

namespace litfog::demo {
namespace {

using files::JsonValue;
using Key = CameraPath::Key;

glm::dvec3 point_of(const JsonValue& value) {
  const glm::dvec3 point = value.vec3();
  const auto is_coordinate = [](double x) { return is_within(x, -scene::kMaxCoordinate, scene::kMaxCoordinate); };
  if (is_coordinate(point.x) && is_coordinate(point.y) && is_coordinate(point.z)) return point;
  value.fail(fmt::format("must have coordinates in [{}, {}]", -scene::kMaxCoordinate, scene::kMaxCoordinate));
}

double field_of_view_of(const JsonValue& value) {
  const double degrees = snapped(value.number(), scene::kMinFieldOfViewDeg, scene::kMaxFieldOfViewDeg);
  if (degrees >= scene::kMinFieldOfViewDeg && degrees <= scene::kMaxFieldOfViewDeg) return glm::radians(degrees);
  value.fail(fmt::format("must be in [{}, {}]", scene::kMinFieldOfViewDeg, scene::kMaxFieldOfViewDeg));
}

double seconds_of(const JsonValue& value) {
  const double seconds = snapped(value.number(), -scene::kMaxSeconds, scene::kMaxSeconds);
  if (std::abs(seconds) <= scene::kMaxSeconds) return seconds;
  value.fail("must be in [-1e9, 1e9]");
}

}  // namespace

scene::Camera CameraPath::at(double fraction) const {
  const double seconds = std::lerp(keys_.front().seconds, keys_.back().seconds, fraction);
  const auto after = std::ranges::lower_bound(keys_, seconds, {}, &Key::seconds);
  const auto end = std::size_t(std::clamp<std::ptrdiff_t>(after - keys_.begin(), 1, std::ssize(keys_) - 1));
  const Key& from = keys_[end - 1];
  const Key& to = keys_[end];
  const double width = to.seconds - from.seconds;
  const double s = (seconds - from.seconds) / width;
  const auto curve = [&](auto Key::*member) {
    // Hermite cubic; an end of the path has the slope of its only chord.
    const auto slope = [&](std::size_t key) {
      const Key& before = keys_[key > 0 ? key - 1 : 0];
      const Key& next = keys_[std::min(key + 1, keys_.size() - 1)];
      return (next.*member - before.*member) * (width / (next.seconds - before.seconds));
    };
    return from.*member + (to.*member - from.*member) * (s * s * (3 - 2 * s)) +
           slope(end - 1) * (s * (1 - s) * (1 - s)) - slope(end) * (s * s * (1 - s));
  };
  return {.position = curve(&Key::position),
          .target = curve(&Key::target),
          .field_of_view = float(std::clamp(curve(&Key::field_of_view), glm::radians(scene::kMinFieldOfViewDeg),
                                            glm::radians(scene::kMaxFieldOfViewDeg)))};
}

CameraPath read_camera_path(const std::string& file, double field_of_view) {
  const JsonValue root = files::read_json(file);
  expect_header(root, "camera-path", 1);
  root.allow_only({"litfog", "version", "keyframes"});
  const JsonValue list = root.member("keyframes");
  const auto items = list.items();
  if (items.size() < 2) list.fail("must hold two keyframes or more");
  const bool has_times = items.front().optional("time_s").has_value();
  std::vector<Key> keys;
  for (const JsonValue& item : items) {
    item.allow_only({"time_s", "position", "target", "field_of_view_deg"});
    const auto time = item.optional("time_s");
    if (time && !has_times) time->fail("must be given of all keyframes or of none");
    const double seconds = has_times ? seconds_of(item.member("time_s")) : double(keys.size());
    if (!keys.empty() && !(seconds > keys.back().seconds)) time->fail("must be after the keyframe before");
    const auto angle = item.optional("field_of_view_deg");
    keys.push_back({.seconds = seconds,
                    .position = point_of(item.member("position")),
                    .target = point_of(item.member("target")),
                    .field_of_view = angle ? field_of_view_of(*angle) : field_of_view});
  }
  return CameraPath(std::move(keys));
}

}  // namespace litfog::demo
