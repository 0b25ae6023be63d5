#include "mlab/ros2/readings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mlab/base/angle.h"
#include "mlab/text/shown.h"

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kBatteryLasts{10000};
constexpr milliseconds kJumpLasts{1000};
/// Where its odometry is on the map is told seldom by who has found it.
constexpr milliseconds kMapLasts{10000};
/// So long the place of a scanner is waited for, since tf_static may come later.
constexpr milliseconds kMountPatience{3000};
constexpr double kFarthestPlace = 1e7;  // [m]
constexpr double kFastest = 100.0;      // [m/s], [rad/s]
constexpr double kJump = 0.3;           // besides what it can drive [m]
constexpr double kStandingSpeed = 0.02;
constexpr double kStandingTurnRate = 0.05;
constexpr double kMostTilt = 0.35;   // a scanner that looks farther up or down sees the floor [rad]
constexpr double kLongestWay = 2.0;  // that a scan may have had to us; longer, its clock is another [s]
constexpr double kAheadOfUs = 0.1;   // by which a stamp may be later than now: clocks that almost agree [s]
constexpr std::size_t kMostNews = 32;

bool is_within(double value, double most) {
  return std::abs(value) <= most;
}

bool is_odometry(const Odometry& message) {
  return is_within(message.position.x, kFarthestPlace) && is_within(message.position.y, kFarthestPlace) &&
         is_within(message.speed, kFastest) && is_within(message.turn_rate, kFastest);
}

}  // namespace

Readings::Readings(Places places, std::vector<std::string> scanners, double max_speed)
    : places_(std::move(places)), max_speed_(max_speed) {
  for (std::string& one : scanners) scanners_.push_back({std::move(one), {}, {}, {}});
}

void Readings::take(const Heard& heard, Time now) {
  for (const Transform& one : heard.transforms) frames_.take(one, now);
  for (const Odometry& one : heard.odometry) take(one, now);
  for (const LaserScan& one : heard.scans) take(one, now);
  for (const BatteryState& one : heard.batteries) take(one, now);
}

// Of two who tell where it is only the first is believed, until it has been silent for a second.
bool Readings::is_from_elsewhere(const Odometry& message, Time now) {
  if (writer_ == 0 || writer_ == message.writer || now - writer_heard_at_ > kMotionLasts) {
    writer_ = message.writer;
    writer_heard_at_ = now;
    return false;
  }
  if (!std::exchange(is_second_told_, true))
    tell("is told of by two who publish its odometry: only the first is believed");
  return true;
}

void Readings::take(const Odometry& message, Time now) {
  if (is_from_elsewhere(message, now)) return;
  const auto placement = placement_of(message.position, message.orientation);
  const auto pose = placement ? flat(*placement) : std::nullopt;
  is_senseless_ = !pose || !is_odometry(message);
  is_unstamped_ = message.stamp == Stamp{};
  heard_at_ = now;
  if (is_senseless_ || is_unstamped_) return;
  const RobotClock::Verdict verdict = clock_.hear(message.stamp, now);
  if (verdict == RobotClock::Verdict::kLate) return;
  if (verdict == RobotClock::Verdict::kRestarted) begin_anew(now);
  base_frame_ = plain_frame(message.child_frame);
  odometry_frame_ = plain_frame(message.frame);
  if (!clock_.is_settled(now)) return;  // it may be of long ago
  const Time at = std::min(clock_.ours(message.stamp).value_or(now), now);
  const Moving next{*placement, *pose, message.speed, message.turn_rate, at};
  notice_jump(next, now);
  odometry_ = next;
  const bool stands = is_within(next.speed, kStandingSpeed) && is_within(next.turn_rate, kStandingTurnRate);
  stood_at_ = stands ? std::array{stood_at_[1], std::optional(at)} : std::array<std::optional<Time>, 2>{};
}

void Readings::notice_jump(const Moving& next, Time now) {
  if (!odometry_) return;
  const double dt = std::max(vehicle::seconds_between(odometry_->at, next.at), 0.0);
  const double speed = std::max({std::abs(next.speed), std::abs(odometry_->speed), max_speed_});
  const double way = geom::distance(next.pose.position, odometry_->pose.position);
  if (way <= speed * dt * 1.5 + kJump) return;
  jump_ = way;
  jumped_at_ = now;
  tell(fmt::format("has jumped by {:.1f} m, as its odometry says", way));
}

void Readings::begin_anew(Time /*now*/) {
  tell("has begun again: its clock runs from elsewhere");
  odometry_.reset();
  battery_.reset();
  stood_at_ = {};
  for (Scanner& one : scanners_) one.scan.reset();
}

std::optional<Readings::Time> Readings::time_of(Scanner& scanner, const Stamp& stamp, Time now) {
  const auto at = clock_.ours(stamp);
  const double age = at ? vehicle::seconds_between(*at, now) : kLongestWay + 1.0;
  if (age >= -kAheadOfUs && age <= kLongestWay) return std::min(*at, now);
  tell(scanner, at ? fmt::format("is {:.1f} s {} its odometry: is its clock another?", std::abs(age),
                                 age > 0.0 ? "behind" : "ahead of")
                   : "has times that its odometry's have nothing to do with");
  return std::nullopt;
}

bool Readings::mount(Scanner& scanner, const std::string& frame, vehicle::Scan& scan, Time now) {
  const auto placement = frames_.find(frame, base_frame_, now - kMapLasts);
  if (!placement) {
    if (!scanner.waits_for_mount_since) scanner.waits_for_mount_since = now;
    if (now - *scanner.waits_for_mount_since < kMountPatience) return false;
    tell(scanner, fmt::format("is taken to be in the middle and to look ahead: no tf leads from `{}` to `{}`",
                              text::shown(base_frame_), text::shown(frame)));
    return true;
  }
  scanner.waits_for_mount_since.reset();
  const auto seen = flat(*placement);
  if (!seen || tilt_of(*placement) > kMostTilt) {
    tell(scanner, "is not used: it looks up or down");
    return false;
  }
  if (is_upside_down(*placement)) {
    scan.first_angle = -scan.first_angle;
    scan.step = -scan.step;
  }
  scan.mount = *seen;
  tell(scanner, "");
  return true;
}

void Readings::take(const LaserScan& message, Time now) {
  if (message.topic >= scanners_.size() || !clock_.is_settled(now) || base_frame_.empty()) return;
  Scanner& scanner = scanners_[message.topic];
  vehicle::Scan scan;
  if (std::string problem = read_scan(message, scan); !problem.empty()) {
    tell(scanner, "is not used: it " + problem);
    return;
  }
  const auto at = time_of(scanner, message.stamp, now);
  if (!at || (scanner.scan && scanner.scan->at >= *at)) return;
  scan.at = *at;
  if (mount(scanner, message.frame, scan, now)) scanner.scan = std::move(scan);
}

void Readings::take(const BatteryState& message, Time now) {
  // Where it is not measured it is no number; some say per cent all the same.
  const double share = message.percentage > 1.5F ? message.percentage / 100.0 : message.percentage;
  if (!(share >= 0.0 && share <= 1.01)) return;
  const bool is_voltage = message.voltage > 0.0F && message.voltage < 10'000.0F;
  battery_ = vehicle::Battery{std::min(share, 1.0), is_voltage ? message.voltage : 0.0, now};
}

std::optional<geom::Pose> Readings::odometry_pose(Time now) const {
  if (!odometry_ || now - odometry_->at > kMotionLasts) return std::nullopt;
  return odometry_->pose;
}

std::optional<Placement> Readings::map_to_odometry(Time now) const {
  if (places_.map_frame.empty()) return Placement{};
  return frames_.find(odometry_frame_, places_.map_frame, now - kMapLasts);
}

std::optional<vehicle::Motion> Readings::motion(Time now) const {
  if (!odometry_ || now - odometry_->at > kMotionLasts) return std::nullopt;
  const auto outer = map_to_odometry(now);
  const auto pose = outer ? flat(*outer * odometry_->placement) : std::nullopt;
  if (!pose) return std::nullopt;
  vehicle::Motion out{*pose, odometry_->speed, odometry_->turn_rate, odometry_->at};
  if (places_.origin) out.pose.position = *places_.origin + (pose->position - geom::Point{});
  return out;
}

std::string Readings::why_no_motion(Time now) const {
  if (!heard_at_) return "has not been heard yet";
  // Without the time that has gone by: who keeps what changes would keep a line for each tenth of a second.
  if (now - *heard_at_ > kMotionLasts) return "has said nothing for more than a second";
  if (is_unstamped_) return "does not say when: its odometry has no times";
  if (is_senseless_) return "makes no sense: its odometry is no place and no speed";
  if (!clock_.is_settled(now) || !odometry_)
    return "has only just been heard, and its times can't be counted on yet";
  if (now - odometry_->at > kMotionLasts) return "tells only where it was long ago";
  return fmt::format("does not know where it is on the map: no tf leads from `{}` to `{}`",
                     text::shown(places_.map_frame), text::shown(odometry_frame_));
}

void Readings::scans(Time now, std::vector<vehicle::Scan>& out) const {
  out.clear();
  for (const Scanner& one : scanners_) {
    if (one.scan && now - one.scan->at <= kMotionLasts) out.push_back(*one.scan);
  }
}

// Told seldom; who says nothing else has none either.
std::optional<vehicle::Battery> Readings::battery(Time now) const {
  const bool is_there = odometry_ && now - odometry_->at <= kMotionLasts;
  return is_there && battery_ && now - battery_->at <= kBatteryLasts ? battery_ : std::nullopt;
}

double Readings::jump(Time now) const {
  return jump_ > 0.0 && now - jumped_at_ <= kJumpLasts ? jump_ : 0.0;
}

bool Readings::has_stood_since(Time then) const {
  return stood_at_[0].has_value() && *stood_at_[0] > then;
}

void Readings::tell(std::string news) {
  if (news_.size() < kMostNews) news_.push_back(std::move(news));
}

void Readings::tell(Scanner& scanner, std::string problem) {
  if (problem == scanner.told) return;
  const bool is_mended = problem.empty();
  // What changes from one to the next, such as an age, is told once.
  const bool is_first = scanner.told.empty() || is_mended;
  scanner.told = std::move(problem);
  if (is_first) tell(fmt::format("scanner {} {}", scanner.topic, is_mended ? "is well again" : scanner.told));
}

std::vector<std::string> Readings::take_news() {
  return std::exchange(news_, {});
}

}  // namespace mlab::ros2
