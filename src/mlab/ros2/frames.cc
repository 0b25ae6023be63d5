#include "mlab/ros2/frames.h"

#include <algorithm>
#include <cmath>

namespace mlab::ros2 {
namespace {

constexpr std::size_t kLongestName = 200;
constexpr int kDeepest = 64;             // a chain that is longer has a ring in it
constexpr double kFarthestOrigin = 1e7;  // [m]
constexpr double kLeastNorm = 0.01;      // of what is meant to have length 1

bool is_finite(const Vector3& v) {
  return std::abs(v.x) <= kFarthestOrigin && std::abs(v.y) <= kFarthestOrigin &&
         std::abs(v.z) <= kFarthestOrigin;
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

Vector3 turned(const Quaternion& q, const Vector3& v) {
  const Quaternion out = q * Quaternion{v.x, v.y, v.z, 0.0} * Quaternion{-q.x, -q.y, -q.z, q.w};
  return {out.x, out.y, out.z};
}

}  // namespace

std::optional<Placement> placement_of(const Vector3& translation, const Quaternion& rotation) {
  const double square =
      rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z + rotation.w * rotation.w;
  if (!is_finite(translation) || !(square >= kLeastNorm && square <= 1.0 / kLeastNorm)) return std::nullopt;
  const double by = 1.0 / std::sqrt(square);
  return Placement{translation, {rotation.x * by, rotation.y * by, rotation.z * by, rotation.w * by}};
}

Placement operator*(const Placement& outer, const Placement& inner) {
  const Vector3 moved = turned(outer.rotation, inner.translation);
  const Vector3& from = outer.translation;
  return {{from.x + moved.x, from.y + moved.y, from.z + moved.z}, outer.rotation * inner.rotation};
}

Placement inverse(const Placement& placement) {
  const Quaternion& q = placement.rotation;
  const Quaternion back{-q.x, -q.y, -q.z, q.w};
  const Vector3 moved = turned(back, placement.translation);
  return {{-moved.x, -moved.y, -moved.z}, back};
}

std::optional<geom::Pose> flat(const Placement& placement) {
  const Vector3 ahead = turned(placement.rotation, {1.0, 0.0, 0.0});
  if (ahead.x * ahead.x + ahead.y * ahead.y < ahead.z * ahead.z) return std::nullopt;
  return geom::Pose{{placement.translation.x, placement.translation.y}, std::atan2(ahead.y, ahead.x)};
}

bool is_upside_down(const Placement& placement) {
  return turned(placement.rotation, {0.0, 0.0, 1.0}).z < 0.0;
}

double tilt_of(const Placement& placement) {
  return std::acos(std::clamp(std::abs(turned(placement.rotation, {0.0, 0.0, 1.0}).z), 0.0, 1.0));
}

std::string_view plain_frame(std::string_view frame) {
  while (frame.starts_with('/')) frame.remove_prefix(1);
  return frame;
}

void Frames::take(const Transform& transform, vehicle::Clock::time_point now) {
  const std::string_view parent = plain_frame(transform.parent);
  const std::string_view child = plain_frame(transform.child);
  const auto placement = placement_of(transform.translation, transform.rotation);
  if (!placement || parent.empty() || child.empty() || parent == child || parent.size() > kLongestName ||
      child.size() > kLongestName)
    return;
  const auto known = parents_.find(child);
  if (known == parents_.end() && parents_.size() >= kMostFrames) return;
  // Of several robots on one topic frames may have one name; those of its own topic are surely its own.
  if (known != parents_.end() && known->second.is_own && !transform.is_own) return;
  parents_.insert_or_assign(std::string(child), Parent{std::string(parent), *placement, transform.is_static,
                                                       transform.is_own, now});
}

Frames::Root Frames::root_of(std::string_view frame, vehicle::Clock::time_point since) const {
  Root out{frame, {}};
  for (int i = 0; i < kDeepest; ++i) {
    const auto above = parents_.find(out.name);
    if (above == parents_.end() || (!above->second.is_static && above->second.at < since)) break;
    out = {above->second.name, above->second.placement * out.placement};
  }
  return out;
}

std::optional<Placement> Frames::find(std::string_view frame, std::string_view within,
                                      vehicle::Clock::time_point since) const {
  const std::string_view from = plain_frame(frame);
  const std::string_view to = plain_frame(within);
  if (from == to) return Placement{};
  const Root one = root_of(from, since);
  const Root other = root_of(to, since);
  if (one.name != other.name) return std::nullopt;
  return inverse(other.placement) * one.placement;
}

}  // namespace mlab::ros2
