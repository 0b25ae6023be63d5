#include "mlab/vehicle/messages.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::vehicle {
namespace {

constexpr double kFarthest = 1e7;     // from the origin [m]
constexpr double kFastest = 1000.0;   // [m/s], [rad/s], and their changes in a second
constexpr double kLongestAge = 60.0;  // [s]
constexpr int kMostScans = 64;
constexpr int kMostBeams = 8192;
constexpr std::size_t kLongestWhy = 200;       // characters
constexpr std::size_t kLongestCheckName = 40;  // likewise
constexpr auto kLastDrive = static_cast<std::uint32_t>(binding::kLastDrive);

/// A limit of a vehicle, by what the message calls it.
struct Quantity {
  std::string_view name;
  double (wire::OfferedVehicle::*get)() const;
  void (wire::OfferedVehicle::*set)(double value);
  double& (*in)(Limits& limits);
  double min;
  double max;
};

constexpr std::array kQuantities = {
    Quantity{"radius", &wire::OfferedVehicle::radius, &wire::OfferedVehicle::set_radius,
             [](Limits& l) -> double& { return l.radius; }, 0.0, 100.0},
    Quantity{"max_speed", &wire::OfferedVehicle::max_speed, &wire::OfferedVehicle::set_max_speed,
             [](Limits& l) -> double& { return l.kinematics.max_speed; }, 0.0, kFastest},
    Quantity{"min_speed", &wire::OfferedVehicle::min_speed, &wire::OfferedVehicle::set_min_speed,
             [](Limits& l) -> double& { return l.min_speed; }, -kFastest, 0.0},
    Quantity{"max_acceleration", &wire::OfferedVehicle::max_acceleration,
             &wire::OfferedVehicle::set_max_acceleration,
             [](Limits& l) -> double& { return l.kinematics.max_acceleration; }, 0.0, kFastest},
    Quantity{"max_turn_rate", &wire::OfferedVehicle::max_turn_rate, &wire::OfferedVehicle::set_max_turn_rate,
             [](Limits& l) -> double& { return l.kinematics.max_turn_rate; }, 0.0, kFastest},
    Quantity{"max_turn_acceleration", &wire::OfferedVehicle::max_turn_acceleration,
             &wire::OfferedVehicle::set_max_turn_acceleration,
             [](Limits& l) -> double& { return l.kinematics.max_turn_acceleration; }, 0.0, kFastest},
    Quantity{"axle", &wire::OfferedVehicle::axle, &wire::OfferedVehicle::set_axle,
             [](Limits& l) -> double& { return l.kinematics.axle; }, 0.0, 100.0},
    Quantity{"max_wheel_speed", &wire::OfferedVehicle::max_wheel_speed,
             &wire::OfferedVehicle::set_max_wheel_speed,
             [](Limits& l) -> double& { return l.kinematics.max_wheel_speed; }, 0.0, kFastest},
    Quantity{"wheelbase", &wire::OfferedVehicle::wheelbase, &wire::OfferedVehicle::set_wheelbase,
             [](Limits& l) -> double& { return l.kinematics.wheelbase; }, 0.001, 100.0},
    Quantity{"max_steer", &wire::OfferedVehicle::max_steer, &wire::OfferedVehicle::set_max_steer,
             [](Limits& l) -> double& { return l.kinematics.max_steer; }, 0.0, 1.57},
    Quantity{"standstill", &wire::OfferedVehicle::standstill, &wire::OfferedVehicle::set_standstill,
             [](Limits& l) -> double& { return l.standstill; }, 0.0, kLongestAge},
};

bool is_within(double value, double most) {
  return std::isfinite(value) && std::abs(value) <= most;
}

bool is_age(double age) {
  return age >= 0.0 && age <= kLongestAge;
}

double age_of(Clock::time_point at, Clock::time_point now) {
  return std::max(0.0, seconds_between(at, now));
}

Clock::time_point before(Clock::time_point time, double seconds) {
  return time - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void encode(const geom::Pose& pose, wire::Pose& out) {
  out.set_x(pose.position.x);
  out.set_y(pose.position.y);
  out.set_heading(pose.heading);
}

std::optional<geom::Pose> decode(const wire::Pose& pose) {
  if (!is_within(pose.x(), kFarthest) || !is_within(pose.y(), kFarthest) || !is_within(pose.heading(), 1e3))
    return std::nullopt;
  return geom::Pose{{pose.x(), pose.y()}, pose.heading()};
}

std::optional<Motion> decode(const wire::VehicleMotion& message, Clock::time_point arrived) {
  const auto pose = decode(message.pose());
  if (!pose || !is_within(message.speed(), kFastest) || !is_within(message.turn_rate(), kFastest) ||
      !is_age(message.age()))
    return std::nullopt;
  return Motion{*pose, message.speed(), message.turn_rate(), before(arrived, message.age())};
}

std::optional<Scan> decode(const wire::VehicleScan& message, Clock::time_point arrived) {
  const auto mount = decode(message.mount());
  const bool is_sound = mount && is_within(message.first_angle(), 10.0) && is_within(message.step(), 10.0) &&
                        is_within(message.beam_width(), 7.0) && message.beam_width() >= 0.0 &&
                        is_within(message.farthest(), kFarthest) && message.nearest() >= 0.0 &&
                        message.farthest() >= message.nearest() && is_age(message.age()) &&
                        message.distances_size() <= kMostBeams;
  if (!is_sound) return std::nullopt;
  Scan out;
  out.sensor = message.sensor();
  out.mount = *mount;
  out.first_angle = message.first_angle();
  out.step = message.step();
  out.beam_width = message.beam_width();
  out.nearest = message.nearest();
  out.farthest = message.farthest();
  out.distances.assign(message.distances().begin(), message.distances().end());
  for (const float distance : out.distances) {
    if (distance < 0.0F) return std::nullopt;
  }
  out.at = before(arrived, message.age());
  if (message.has_pose()) {
    out.pose = decode(message.pose());
    if (!out.pose) return std::nullopt;
  }
  return out;
}

void encode(const Fix& fix, Clock::time_point now, wire::VehicleFix& out) {
  out.set_latitude_deg(fix.place.latitude_deg);
  out.set_longitude_deg(fix.place.longitude_deg);
  out.set_x(fix.point.x);
  out.set_y(fix.point.y);
  out.set_north(fix.north);
  out.set_age(age_of(fix.at, now));
}

std::optional<Fix> decode(const wire::VehicleFix& message, Clock::time_point arrived) {
  const geography::GeoPoint place{message.latitude_deg(), message.longitude_deg()};
  if (!geography::is_between_the_caps(place) || !is_within(place.longitude_deg, 180.0) ||
      !is_within(message.x(), kFarthest) || !is_within(message.y(), kFarthest) ||
      !is_within(message.north(), 1e3) || !is_age(message.age()))
    return std::nullopt;
  return Fix{place, {message.x(), message.y()}, message.north(), before(arrived, message.age())};
}

}  // namespace

wire::OfferedVehicle offered(const std::string& kind, const Limits& limits_now, bool is_simulated) {
  wire::OfferedVehicle out;
  out.set_is_simulated(is_simulated);
  Limits limits = limits_now;
  out.set_kind(kind);
  out.set_drive(static_cast<std::uint32_t>(limits.kinematics.drive));
  for (const Quantity& one : kQuantities) (out.*one.set)(one.in(limits));
  return out;
}

std::expected<Limits, std::string> limits_of(const wire::OfferedVehicle& said) {
  Limits out;
  if (said.drive() == 0 || said.drive() > kLastDrive)
    return std::unexpected(fmt::format("its drive is {}, expected 1 to {}", said.drive(), kLastDrive));
  out.kinematics.drive = static_cast<binding::Drive>(said.drive());
  for (const Quantity& one : kQuantities) {
    const double value = (said.*one.get)();
    if (!(value >= one.min && value <= one.max))
      return std::unexpected(
          fmt::format("its {} is {}, expected {} to {}", one.name, value, one.min, one.max));
    one.in(out) = value;
  }
  return out;
}

void encode(const Report& report, Clock::time_point now, wire::VehicleReport& out) {
  out.set_readiness(static_cast<std::uint32_t>(report.readiness));
  out.set_why(report.why);
  out.set_is_global(report.is_global);
  if (report.motion) {
    wire::VehicleMotion& motion = *out.mutable_motion();
    encode(report.motion->pose, *motion.mutable_pose());
    motion.set_speed(report.motion->speed);
    motion.set_turn_rate(report.motion->turn_rate);
    motion.set_age(age_of(report.motion->at, now));
  }
  for (const Scan& scan : report.scans) {
    wire::VehicleScan& told = *out.add_scans();
    told.set_sensor(scan.sensor);
    encode(scan.mount, *told.mutable_mount());
    told.set_first_angle(scan.first_angle);
    told.set_step(scan.step);
    told.set_beam_width(scan.beam_width);
    told.set_nearest(scan.nearest);
    told.set_farthest(scan.farthest);
    told.mutable_distances()->Add(scan.distances.begin(), scan.distances.end());
    told.set_age(age_of(scan.at, now));
    if (scan.pose) encode(*scan.pose, *told.mutable_pose());
  }
  if (report.fix) encode(*report.fix, now, *out.mutable_fix());
  if (!report.battery) return;
  wire::VehicleBattery& battery = *out.mutable_battery();
  battery.set_share(report.battery->share);
  battery.set_voltage(report.battery->voltage);
  battery.set_age(age_of(report.battery->at, now));
}

std::expected<Report, std::string> decode(const wire::VehicleReport& message, Clock::time_point arrived) {
  constexpr auto kLast = static_cast<std::uint32_t>(kLastReadiness);
  Report out;
  if (message.readiness() > kLast)
    return std::unexpected(fmt::format("readiness is {}, expected 0 to {}", message.readiness(), kLast));
  out.readiness = static_cast<Readiness>(message.readiness());
  out.why = text::shown(message.why(), kLongestWhy);
  out.is_global = message.is_global();
  if (message.has_motion()) {
    out.motion = decode(message.motion(), arrived);
    if (!out.motion) return std::unexpected("its motion is none");
  }
  if (message.has_fix()) {
    out.fix = decode(message.fix(), arrived);
    if (!out.fix) return std::unexpected("its place on the Earth is none");
  }
  if (message.scans_size() > kMostScans)
    return std::unexpected(
        fmt::format("it has {} scans, at most {} are read", message.scans_size(), kMostScans));
  for (const wire::VehicleScan& one : message.scans()) {
    auto scan = decode(one, arrived);
    if (!scan) return std::unexpected(fmt::format("scan of sensor {} is none", one.sensor()));
    out.scans.push_back(std::move(*scan));
  }
  if (!message.has_battery()) return out;
  const wire::VehicleBattery& battery = message.battery();
  if (!(battery.share() >= 0.0 && battery.share() <= 1.0) || !is_within(battery.voltage(), 1e5) ||
      !is_age(battery.age()))
    return std::unexpected("its battery is none");
  out.battery = {battery.share(), battery.voltage(), before(arrived, battery.age())};
  return out;
}

std::string encode(const std::vector<Check>& checks) {
  wire::VehicleChecks out;
  for (const Check& one : checks) {
    if (static_cast<std::size_t>(out.checks_size()) == kMostChecks) break;
    wire::VehicleCheck& said = *out.add_checks();
    said.set_name(one.name);
    said.set_result(static_cast<std::uint32_t>(one.result));
    said.set_is(one.is);
    said.set_expected(one.expected);
  }
  return out.SerializeAsString();
}

std::expected<std::vector<Check>, std::string> decode_checks(std::string_view message) {
  constexpr auto kLast = static_cast<std::uint32_t>(CheckResult::kUnknown);
  wire::VehicleChecks read;
  if (!read.ParseFromArray(message.data(), static_cast<int>(message.size())))
    return std::unexpected("its checks can't be read");
  if (static_cast<std::size_t>(read.checks_size()) > kMostChecks)
    return std::unexpected(
        fmt::format("it has {} checks, at most {} are read", read.checks_size(), kMostChecks));
  std::vector<Check> out;
  for (const wire::VehicleCheck& one : read.checks()) {
    if (one.result() > kLast)
      return std::unexpected(fmt::format("result of a check is {}, expected 0 to {}", one.result(), kLast));
    out.push_back({text::shown(one.name(), kLongestCheckName), static_cast<CheckResult>(one.result()),
                   text::shown(one.is(), kLongestWhy), text::shown(one.expected(), kLongestWhy)});
    if (out.back().name.empty()) return std::unexpected("a check of it has no name");
  }
  return out;
}

bool is_sound(const wire::VehicleCommand& command) {
  return command.session() != 0 && command.number() != 0 && is_within(command.velocity_x(), kFastest) &&
         is_within(command.velocity_y(), kFastest) && is_within(command.spin(), kFastest) &&
         command.period() > 0.0 && command.period() <= 10.0;
}

}  // namespace mlab::vehicle
