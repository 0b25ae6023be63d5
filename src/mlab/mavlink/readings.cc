#include "mlab/mavlink/readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mlab/base/angle.h"
#include "mlab/mavlink/ardupilot.h"

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

constexpr double kPi = std::numbers::pi;
// Beyond these nothing that drives on the ground is, or moves.
constexpr double kFarthestPlace = 1e6;
constexpr double kFastest = 100.0;
constexpr double kFastestTurn = 50.0;
// A jump is what no speed explains, and this much more: filters correct themselves by less all the time [m].
constexpr double kJump = 1.0;
constexpr double kCentimetre = 0.01;
// Of heading or position in a second; who sends more often is known less far back.
constexpr std::size_t kMostSamples = 64;
// What is said as often goes out in one go; where one of both got lost, an older pair is better than what is
// of two moments.
constexpr milliseconds kOneGo{20};
constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

bool is_within(double value, double most) {
  return std::isfinite(value) && std::abs(value) <= most;
}

std::optional<vehicle::Battery> battery_of(int percent, double voltage, Readings::Time now) {
  if (percent < 0 || percent > 100) return std::nullopt;
  return vehicle::Battery{percent / 100.0, voltage, now};
}

float distance_of(std::uint16_t cm, std::uint16_t min_cm, std::uint16_t max_cm) {
  if (cm < min_cm) return kUnknown;
  return cm > max_cm ? kNothing : static_cast<float>(cm * kCentimetre);
}

}  // namespace

bool Readings::hear(std::uint32_t kind, std::uint32_t boot_ms, Time now, bool& is_new) {
  const auto verdict = clock_.hear(kind, boot_ms, now);
  is_new = verdict == BootClock::Verdict::kGood;
  if (verdict == BootClock::Verdict::kLate) ++dropped_;
  return verdict == BootClock::Verdict::kRestarted;
}

bool Readings::take(const Attitude& message, Time now) {
  if (!is_within(message.yaw, 4.0 * kPi) || !is_within(message.yawspeed, kFastestTurn)) {
    ++dropped_;
    return false;
  }
  bool is_new = false;
  if (hear(0, message.time_boot_ms, now, is_new)) return true;
  if (!is_new) return false;
  keep(turned_, Turning{base::wrap_angle(kPi / 2.0 - message.yaw), -message.yawspeed, message.time_boot_ms});
  notice_how_it_comes();
  return false;
}

bool Readings::take(const LocalPositionNed& message, Time now) {
  if (!is_within(message.x, kFarthestPlace) || !is_within(message.y, kFarthestPlace) ||
      !is_within(message.vx, kFastest) || !is_within(message.vy, kFastest)) {
    ++dropped_;
    return false;
  }
  bool is_new = false;
  if (hear(1, message.time_boot_ms, now, is_new)) return true;
  if (!is_new) return false;
  const Moving next{{message.y, message.x}, {message.vy, message.vx}, message.time_boot_ms};
  notice_jump(next, now);
  keep(moved_, next);
  notice_how_it_comes();
  return false;
}

template <class Sample>
void Readings::keep(Past<Sample>& past, const Sample& next) {
  past.push_back(next);
  while (past.size() > kMostSamples || milliseconds(next.boot_ms - past.front().boot_ms) > kMotionLasts)
    past.pop_front();
}

template <class Sample>
Sample Readings::sample_at(const Past<Sample>& past, std::uint32_t boot_ms) {
  const auto after = std::ranges::upper_bound(past, boot_ms, {}, &Sample::boot_ms);
  if (after == past.begin()) return past.front();
  const Sample& a = *std::prev(after);
  if (after == past.end() || a.boot_ms == boot_ms) return a;
  return between(a, *after, static_cast<double>(boot_ms - a.boot_ms) / (after->boot_ms - a.boot_ms));
}

Readings::Turning Readings::between(const Turning& a, const Turning& b, double share) {
  return {base::wrap_angle(a.heading + share * base::wrap_angle(b.heading - a.heading)),
          std::lerp(a.rate, b.rate, share), a.boot_ms};
}

Readings::Moving Readings::between(const Moving& a, const Moving& b, double share) {
  return {a.position + (b.position - a.position) * share, a.velocity + (b.velocity - a.velocity) * share,
          a.boot_ms};
}

void Readings::notice_jump(const Moving& next, Time now) {
  if (moved_.empty()) return;
  const Moving& last = moved_.back();
  const double dt = (next.boot_ms - last.boot_ms) / 1000.0;
  const double speed = std::max({length(next.velocity), length(last.velocity), max_speed_});
  const double way = geom::distance(next.position, last.position);
  if (way <= speed * dt * 1.5 + kJump) return;
  jump_ = way;
  jumped_at_ = now;
}

bool Readings::take(const GlobalPositionInt& message, Time now) {
  const bool is_somewhere = message.lat != 0 || message.lon != 0;
  if (!is_somewhere || std::abs(message.lat) > 900'000'000 || std::abs(message.lon) > 1'800'000'000) {
    ++dropped_;
    return false;
  }
  bool is_new = false;
  if (hear(2, message.time_boot_ms, now, is_new)) return true;
  if (!is_new) return false;
  place_ = {base::radians(message.lat * 1e-7), base::radians(message.lon * 1e-7),
            clock_.time_of(message.time_boot_ms, now)};
  place_boot_ms_ = message.time_boot_ms;
  return false;
}

void Readings::take(const SysStatus& message, Time now) {
  const double voltage = message.voltage_battery == 65535 ? 0.0 : message.voltage_battery / 1000.0;
  if (const auto told = battery_of(message.battery_remaining, voltage, now)) battery_ = told;
}

void Readings::take(const BatteryStatus& message, Time now) {
  // Others are of cameras and the like.
  if (message.id != 0) return;
  double voltage = 0.0;
  for (const std::uint16_t cell : message.voltages) voltage += cell == 65535 ? 0.0 : cell / 1000.0;
  if (const auto told = battery_of(message.battery_remaining, voltage, now)) battery_ = told;
}

void Readings::take(const DistanceSensor& message, Time now) {
  const bool is_level = message.orientation < 8;
  const bool is_range = message.min_distance < message.max_distance;
  if (!is_level || !is_range || !is_within(message.horizontal_fov, 2.0 * kPi)) {
    ++dropped_;
    return;
  }
  vehicle::Scan scan;
  scan.sensor = 1U + message.orientation;
  scan.mount.heading = base::wrap_angle(-message.orientation * kPi / 4.0);
  scan.beam_width = std::max(message.horizontal_fov, 0.0F);
  scan.nearest = message.min_distance * kCentimetre;
  scan.farthest = message.max_distance * kCentimetre;
  const float distance = distance_of(message.current_distance, message.min_distance, message.max_distance);
  scan.distances = {message.signal_quality == 1 ? kUnknown : distance};
  // Some sensors have no clock.
  scan.at = message.time_boot_ms == 0 ? now : clock_.time_of(message.time_boot_ms, now);
  keep(std::move(scan));
}

void Readings::take(const ObstacleDistance& message, Time now) {
  const double step_deg = message.increment_f != 0.0F ? static_cast<double>(message.increment_f)
                                                      : static_cast<double>(message.increment);
  const bool is_turned = message.frame == kFrameGlobal;
  const bool is_known =
      message.frame == kFrameBodyFrd ||
      (is_turned && !turned_.empty() && now - clock_.time_of(turned_.back().boot_ms, now) < kMotionLasts);
  if (!is_known || !is_within(step_deg, 360.0) || std::abs(step_deg) < 0.01 ||
      !is_within(message.angle_offset, 360.0) || message.min_distance >= message.max_distance) {
    ++dropped_;
    return;
  }
  const auto count = static_cast<std::size_t>(std::clamp(std::floor(360.0 / std::abs(step_deg) + 1e-6), 1.0,
                                                         static_cast<double>(message.distances.size())));
  vehicle::Scan scan;
  scan.nearest = message.min_distance * kCentimetre;
  scan.farthest = message.max_distance * kCentimetre;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t cm = message.distances[i];
    scan.distances.push_back(cm == 65535 ? kUnknown
                                         : distance_of(cm, message.min_distance, message.max_distance));
  }
  // Theirs go clockwise, ours counter-clockwise: what was first is last, unless they go the other way.
  double first = -base::radians(message.angle_offset);
  scan.step = base::radians(std::abs(step_deg));
  scan.beam_width = scan.step;
  if (step_deg > 0.0) {
    first -= scan.step * static_cast<double>(count - 1);
    std::ranges::reverse(scan.distances);
  }
  // From north instead of from its nose.
  if (is_turned) first += kPi / 2.0 - turned_.back().heading;
  scan.first_angle = base::wrap_angle(first);
  // Since it began, or since 1970, by a clock that nobody here knows.
  const std::uint64_t ms = message.time_usec / 1000;
  const bool is_of_boot = ms > 0 && ms <= std::numeric_limits<std::uint32_t>::max();
  scan.at = is_of_boot ? clock_.time_of(static_cast<std::uint32_t>(ms), now) : now;
  keep(std::move(scan));
}

void Readings::keep(vehicle::Scan scan) {
  const std::uint32_t sensor = scan.sensor;
  scans_.insert_or_assign(sensor, std::move(scan));
}

void Readings::begin_anew() {
  clock_.begin_anew();
  comes_in_one_go_ = false;
  forget();
}

void Readings::forget() {
  turned_.clear();
  moved_.clear();
  battery_.reset();
  place_.reset();
  scans_.clear();
  jump_ = 0.0;
}

// What was said of both in one go; nothing: they do not come so.
std::optional<std::pair<Readings::Turning, Readings::Moving>> Readings::newest_pair() const {
  for (auto turned = turned_.rbegin(); turned != turned_.rend(); ++turned) {
    for (auto moved = moved_.rbegin(); moved != moved_.rend(); ++moved) {
      const std::int64_t apart = std::int64_t{turned->boot_ms} - moved->boot_ms;
      if (std::abs(apart) <= kOneGo.count()) return std::pair(*turned, *moved);
    }
  }
  return std::nullopt;
}

// Vehicles send both by timers of their own, which may part and meet.
void Readings::notice_how_it_comes() {
  constexpr std::ptrdiff_t kNoLoss = 4;  // of each without the other: that is not what got lost
  const auto pair = newest_pair();
  const auto after_it = [&](const auto& past) {
    const std::uint32_t last = pair ? std::max(pair->first.boot_ms, pair->second.boot_ms) : 0;
    return std::ranges::count_if(past, [&](const auto& one) { return !pair || one.boot_ms > last; });
  };
  if (after_it(turned_) >= kNoLoss && after_it(moved_) >= kNoLoss)
    comes_in_one_go_ = false;
  else
    comes_in_one_go_ = comes_in_one_go_ || pair;
}

std::optional<vehicle::Motion> Readings::motion(Time now) const {
  if (turned_.empty() || moved_.empty()) return std::nullopt;
  auto told = comes_in_one_go_ ? newest_pair() : std::nullopt;
  if (!told) {
    if (comes_in_one_go_) return std::nullopt;  // one of both got lost each time
    const std::uint32_t both = std::min(turned_.back().boot_ms, moved_.back().boot_ms);
    told = {sample_at(turned_, both), sample_at(moved_, both)};
    told->first.boot_ms = told->second.boot_ms = both;
  }
  const auto& [turning, moving] = *told;
  vehicle::Motion out;
  out.at = clock_.time_of(std::min(turning.boot_ms, moving.boot_ms), now);
  if (now - out.at > kMotionLasts) return std::nullopt;
  out.pose = {moving.position, turning.heading};
  if (origin_) out.pose.position = *origin_ + (moving.position - geom::Point{});
  out.speed = dot(moving.velocity, {std::cos(turning.heading), std::sin(turning.heading)});
  out.turn_rate = turning.rate;
  return out;
}

std::optional<vehicle::Battery> Readings::battery(Time now) const {
  return battery_ && now - battery_->at <= kBatteryLasts ? battery_ : std::nullopt;
}

std::optional<Place> Readings::place(Time now) const {
  return place_ && now - place_->at <= kMotionLasts ? place_ : std::nullopt;
}

std::optional<vehicle::Fix> Readings::fix(Time now) const {
  const auto there = place(now);
  if (!there || moved_.empty()) return std::nullopt;
  const Moving then = sample_at(moved_, place_boot_ms_);
  // What was said of its place may be newer, or older, than what is known of its own frame.
  const double later = (static_cast<double>(place_boot_ms_) - static_cast<double>(then.boot_ms)) / 1000.0;
  const bool is_between = place_boot_ms_ <= moved_.back().boot_ms && place_boot_ms_ >= moved_.front().boot_ms;
  vehicle::Fix out;
  out.place = {base::degrees(there->latitude), base::degrees(there->longitude)};
  out.point = is_between ? then.position : then.position + then.velocity * later;
  out.north = kPi / 2.0;
  out.at = there->at;
  return out;
}

void Readings::scans(Time now, std::vector<vehicle::Scan>& out) const {
  out.clear();
  for (const auto& [sensor, scan] : scans_) {
    if (now - scan.at <= kScanLasts) out.push_back(scan);
  }
}

double Readings::jump(Time now) const {
  return jump_ > 0.0 && now - jumped_at_ <= kJumpLasts ? jump_ : 0.0;
}

}  // namespace mlab::mavlink
