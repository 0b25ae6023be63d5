#include "mlab/model_vehicles/mavlink_rover_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "mlab/base/angle.h"
#include "mlab/mavlink/ardupilot.h"
#include "mlab/mavlink/frame.h"
#include "mlab/model_vehicles/body.h"
#include "mlab/vehicle/earth.h"

namespace mlab::model_vehicles {
namespace {

using mavlink::Mode;
using mavlink::Result;

constexpr double kPi = std::numbers::pi;
constexpr std::uint8_t kSelf = 1;      // SYSID_THISMAV
constexpr double kStartsWithin = 3.0;  // until then it neither hears nor says anything [s]
constexpr std::size_t kRoverBeams = 72;
constexpr double kRoverReach = 10.0;            // of its beams, from its middle [m]
constexpr double kRoverRadius = 0.3;            // [m]
constexpr std::uint16_t kMinDistance = 20;      // [cm]
constexpr std::uint16_t kMaxDistance = 1000;    // [cm]
constexpr std::uint16_t kRoverVoltage = 12600;  // [mV]
constexpr double kRoverLasts = 2 * 3600.0;      // its battery [s]
// Bits of a set-point's mask: what of it is to be ignored.
constexpr std::uint16_t kNoPosition = 0x3;
constexpr std::uint16_t kNoVelocity = 0x18;
constexpr std::uint16_t kNoAcceleration = 0xC0;
constexpr std::uint16_t kNoTurnRate = 0x800;

binding::BodySpec mavlink_rover_body(const MavlinkRoverSpec& spec) {
  binding::BodySpec body;
  body.radius = kRoverRadius;
  body.kinematics = {.drive = binding::Drive::kDifferential,
                     .axle = 0.5,
                     .max_speed = spec.max_speed,
                     .max_acceleration = spec.max_acceleration,
                     .max_turn_rate = spec.max_turn_rate};
  body.ring = {.count = kRoverBeams, .range = kRoverReach - kRoverRadius};
  return body;
}

std::int32_t degrees_e7(double degrees) {
  return static_cast<std::int32_t>(std::llround(degrees * 1e7));
}

}  // namespace

struct MavlinkRoverModel::Parts {
  Body body;
  geography::Projection earth;
  geom::Point origin;  // of its filter [m, world]
  double north = 0.0;  // there, counter-clockwise from the world's x [rad]
  std::map<std::string, float, std::less<>> parameters;
  mavlink::FrameReader reader;
  mavlink::FrameWriter writer{kSelf, mavlink::kComponentAutopilot};
  std::string said;
  double scan_lag;
  std::deque<std::pair<double, mavlink::ObstacleDistance>> measured;  // and when it is said
  double time = 0.0;                                                  // since it was switched on [s]
  double worked = 0.0;
  Mode mode = Mode::kManual;
  bool is_armed = false;
  bool is_critical = false;
  double pilots_speed = 0.0;
  double speed = 0.0;  // of the last set-point
  double turn_rate = 0.0;
  std::optional<double> set_point_at;
  std::optional<double> station_at;       // when its ground station was heard
  std::map<std::uint32_t, double> every;  // messages, by their number [s]
  std::map<double, double> said_at;       // what is said that often: all of it in one go, as ArduPilot does

  Parts(const overlay::Overlay& world, const MavlinkRoverSpec& spec)
      : body(world, mavlink_rover_body(spec), spec.place, 1),
        earth(world.projection.value_or(geography::Projection::around(spec.earth))),
        parameters{{"FS_GCS_ENABLE", 1.0F},
                   {"FS_ACTION", 2.0F},
                   {"FS_TIMEOUT", 1.5F},
                   {"SYSID_MYGCS", 255.0F},
                   {"FS_EKF_ACTION", 1.0F},
                   {"FS_CRASH_CHECK", 1.0F},
                   {"GUID_TIMEOUT", static_cast<float>(spec.guided_timeout)}},
        scan_lag(spec.scan_lag) {
    switch_on();
  }

  void switch_on();
  void take(const mavlink::Frame& frame);
  void take(const mavlink::CommandLong& message, std::uint8_t from);
  void take(const mavlink::SetPositionTargetLocalNed& message);
  void answer(const std::array<char, 16>& name);
  Result obey(const mavlink::CommandLong& message);
  void enter(Mode next);
  void watch();
  void move(double dt);
  void stream(double dt);
  mavlink::Heartbeat heartbeat() const;
  mavlink::SysStatus status() const;
  static mavlink::AutopilotVersion version();
  mavlink::LocalPositionNed local_position(std::uint32_t boot_ms) const;
  mavlink::GlobalPositionInt global_position(std::uint32_t boot_ms) const;
  mavlink::ObstacleDistance distances(std::uint32_t boot_ms);
  double parameter(std::string_view name) const { return static_cast<double>(parameters.find(name)->second); }
  template <class Message>
  void say(const Message& message) {
    const auto bytes = writer.write(message);
    said.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  template <class Message>
  bool is_due(double dt) {
    const auto wanted = every.find(Message::kInfo.id);
    if (wanted == every.end() || wanted->second <= 0.0) return false;
    const auto last = said_at.find(wanted->second);
    if (last != said_at.end() && last->second < time && time - last->second < wanted->second - dt / 2)
      return false;
    said_at[wanted->second] = time;
    return true;
  }
};

// Its filter begins where it stands.
void MavlinkRoverModel::Parts::switch_on() {
  time = 0.0;
  mode = Mode::kManual;
  is_armed = is_critical = false;
  pilots_speed = 0.0;
  set_point_at.reset();
  station_at.reset();
  every = {{mavlink::Heartbeat::kInfo.id, 1.0}};
  said_at.clear();
  measured.clear();
  reader.begin_anew();
  origin = body.truth().pose.position;
  north = vehicle::north_at(earth, earth.to_earth(origin));
}

void MavlinkRoverModel::Parts::enter(Mode next) {
  mode = next;
  set_point_at.reset();
}

void MavlinkRoverModel::Parts::take(const mavlink::Frame& frame) {
  if (frame.is<mavlink::Heartbeat>() && frame.system == parameter("SYSID_MYGCS") &&
      frame.as<mavlink::Heartbeat>().type == mavlink::kTypeGroundStation)
    station_at = time;
  if (frame.is<mavlink::CommandLong>()) take(frame.as<mavlink::CommandLong>(), frame.system);
  if (frame.is<mavlink::SetPositionTargetLocalNed>()) take(frame.as<mavlink::SetPositionTargetLocalNed>());
  if (frame.is<mavlink::ParamRequestRead>()) answer(frame.as<mavlink::ParamRequestRead>().param_id);
  if (!frame.is<mavlink::ParamSet>()) return;
  const auto message = frame.as<mavlink::ParamSet>();
  const auto found = parameters.find(mavlink::text_of(message.param_id));
  if (found != parameters.end()) found->second = message.param_value;
  answer(message.param_id);
}

void MavlinkRoverModel::Parts::answer(const std::array<char, 16>& name) {
  const auto found = parameters.find(mavlink::text_of(name));
  if (found == parameters.end()) return;
  mavlink::ParamValue message;
  message.param_id = name;
  message.param_value = found->second;
  message.param_count = static_cast<std::uint16_t>(parameters.size());
  message.param_type = 9;
  say(message);
}

void MavlinkRoverModel::Parts::take(const mavlink::CommandLong& message, std::uint8_t from) {
  if (message.target_system != kSelf) return;
  mavlink::CommandAck out;
  out.command = message.command;
  out.result = static_cast<std::uint8_t>(obey(message));
  out.target_system = from;
  say(out);
}

Result MavlinkRoverModel::Parts::obey(const mavlink::CommandLong& message) {
  const auto& p = message.params;
  switch (message.command) {
    case mavlink::kSetMessageInterval:
      if (p[0] == static_cast<float>(mavlink::DistanceSensor::kInfo.id)) return Result::kUnsupported;
      every[static_cast<std::uint32_t>(p[0])] = static_cast<double>(p[1]) / 1e6;
      return Result::kAccepted;
    case mavlink::kRequestMessage:
      if (p[0] != static_cast<float>(mavlink::AutopilotVersion::kInfo.id)) return Result::kUnsupported;
      say(version());
      return Result::kAccepted;
    case mavlink::kDoSetMode:
      enter(static_cast<Mode>(p[1]));
      return Result::kAccepted;
    case mavlink::kArmDisarm:
      is_armed = p[0] == 1.0F;
      return Result::kAccepted;
    default:
      return Result::kUnsupported;
  }
}

// As ArduPilot's Rover reads it: nothing answers, and what is not meant so is dropped.
void MavlinkRoverModel::Parts::take(const mavlink::SetPositionTargetLocalNed& message) {
  const std::uint16_t mask = message.type_mask;
  const bool is_velocity = (mask & kNoPosition) != 0 && (mask & kNoVelocity) == 0 &&
                           (mask & kNoAcceleration) == kNoAcceleration && (mask & kNoTurnRate) == 0;
  if (message.target_system != kSelf || mode != Mode::kGuided || !is_velocity ||
      message.coordinate_frame != mavlink::kFrameBodyNed)
    return;
  set_point_at = time;
  speed = std::copysign(geom::length(geom::Offset{message.vx, message.vy}), static_cast<double>(message.vx));
  turn_rate = -static_cast<double>(message.yaw_rate);
}

// Its failsafe for a ground station that is not heard any more.
void MavlinkRoverModel::Parts::watch() {
  const bool is_alone = station_at && time - *station_at > parameter("FS_TIMEOUT");
  const bool acts = is_armed && is_alone && parameter("FS_GCS_ENABLE") > 0.0;
  if (acts && !is_critical) enter(Mode::kHold);
  is_critical = acts;
}

void MavlinkRoverModel::Parts::move(double dt) {
  const bool is_told =
      mode == Mode::kGuided && set_point_at && time - *set_point_at <= parameter("GUID_TIMEOUT");
  double wanted = 0.0;
  if (is_told) wanted = speed;
  if (mode == Mode::kManual) wanted = pilots_speed;
  body.step(is_armed ? wanted : 0.0, is_armed && is_told ? turn_rate : 0.0, dt);
}

mavlink::Heartbeat MavlinkRoverModel::Parts::heartbeat() const {
  mavlink::Heartbeat out;
  out.custom_mode = static_cast<std::uint32_t>(mode);
  out.type = mavlink::kTypeRover;
  out.autopilot = mavlink::kAutopilotArdupilot;
  out.base_mode = static_cast<std::uint8_t>(1U | (is_armed ? mavlink::kArmedBit : 0U));
  mavlink::State state = is_armed ? mavlink::State::kActive : mavlink::State::kStandby;
  if (is_critical) state = mavlink::State::kCritical;
  out.system_status = static_cast<std::uint8_t>(state);
  return out;
}

mavlink::SysStatus MavlinkRoverModel::Parts::status() const {
  mavlink::SysStatus out;
  out.sensors_present = out.sensors_enabled = out.sensors_health = mavlink::kPreArmBit;
  out.voltage_battery = kRoverVoltage;
  out.battery_remaining = static_cast<std::int8_t>(std::max(0.0, 100.0 * (1.0 - worked / kRoverLasts)));
  return out;
}

mavlink::AutopilotVersion MavlinkRoverModel::Parts::version() {
  mavlink::AutopilotVersion out;
  out.flight_sw_version = 0x040507ff;
  return out;
}

mavlink::LocalPositionNed MavlinkRoverModel::Parts::local_position(std::uint32_t boot_ms) const {
  const Truth truth = body.truth();
  const geom::Offset way = truth.pose.position - origin;
  const geom::Offset to_north{std::cos(north), std::sin(north)};
  const geom::Offset to_east{std::sin(north), -std::cos(north)};
  const double yaw = north - truth.pose.heading;
  mavlink::LocalPositionNed out;
  out.time_boot_ms = boot_ms;
  out.x = static_cast<float>(dot(way, to_north));
  out.y = static_cast<float>(dot(way, to_east));
  out.vx = static_cast<float>(truth.speed * std::cos(yaw));
  out.vy = static_cast<float>(truth.speed * std::sin(yaw));
  return out;
}

mavlink::GlobalPositionInt MavlinkRoverModel::Parts::global_position(std::uint32_t boot_ms) const {
  const geography::GeoPoint place = earth.to_earth(body.truth().pose.position);
  mavlink::GlobalPositionInt out;
  out.time_boot_ms = boot_ms;
  out.lat = degrees_e7(place.latitude_deg);
  out.lon = degrees_e7(place.longitude_deg);
  out.hdg = 65535;
  return out;
}

mavlink::ObstacleDistance MavlinkRoverModel::Parts::distances(std::uint32_t boot_ms) {
  mavlink::ObstacleDistance out;
  out.time_usec = std::uint64_t{boot_ms} * 1000;
  out.increment = 360 / kRoverBeams;
  out.min_distance = kMinDistance;
  out.max_distance = kMaxDistance;
  out.frame = mavlink::kFrameBodyFrd;
  out.distances.fill(kMaxDistance + 1);
  for (const percept::RangeReading& one : body.ranges()) {
    const double clockwise = -static_cast<double>(one.angle) / (2.0 * kPi) * kRoverBeams;
    const auto beam =
        static_cast<std::size_t>(std::llround(clockwise) + std::int64_t{kRoverBeams}) % kRoverBeams;
    const double distance = kRoverRadius + static_cast<double>(one.distance);
    if (one.hit) out.distances[beam] = static_cast<std::uint16_t>(std::lround(100.0 * distance));
  }
  return out;
}

void MavlinkRoverModel::Parts::stream(double dt) {
  const auto boot_ms = static_cast<std::uint32_t>(std::llround(time * 1000.0));
  if (is_due<mavlink::Heartbeat>(dt)) say(heartbeat());
  if (is_due<mavlink::SysStatus>(dt)) say(status());
  if (is_due<mavlink::Attitude>(dt)) {
    const Truth truth = body.truth();
    mavlink::Attitude out;
    out.time_boot_ms = boot_ms;
    out.yaw = static_cast<float>(base::wrap_angle(north - truth.pose.heading));
    out.yawspeed = static_cast<float>(-truth.turn_rate);
    say(out);
  }
  if (is_due<mavlink::LocalPositionNed>(dt)) say(local_position(boot_ms));
  if (is_due<mavlink::GlobalPositionInt>(dt)) say(global_position(boot_ms));
  if (is_due<mavlink::ObstacleDistance>(dt)) measured.emplace_back(time + scan_lag, distances(boot_ms));
  while (!measured.empty() && measured.front().first <= time) {
    say(measured.front().second);
    measured.pop_front();
  }
}

MavlinkRoverModel::MavlinkRoverModel(const overlay::Overlay& world, const MavlinkRoverSpec& spec)
    : parts_(std::make_unique<Parts>(world, spec)) {}

MavlinkRoverModel::~MavlinkRoverModel() = default;

void MavlinkRoverModel::receive(std::string_view bytes) {
  if (parts_->time < kStartsWithin) return;
  parts_->reader.feed(std::as_bytes(std::span(bytes)));
  while (const auto frame = parts_->reader.next()) parts_->take(*frame);
}

std::string MavlinkRoverModel::step(double dt) {
  Parts& p = *parts_;
  p.time += dt;
  p.worked += dt;
  p.watch();
  p.move(dt);
  if (p.time >= kStartsWithin) p.stream(dt);
  return std::exchange(p.said, {});
}

void MavlinkRoverModel::restart() {
  parts_->switch_on();
}

ModelVehicle::Truth MavlinkRoverModel::truth() const {
  return parts_->body.truth();
}

void MavlinkRoverModel::take_by_pilot(double speed) {
  parts_->enter(Mode::kManual);
  parts_->pilots_speed = speed;
}

void MavlinkRoverModel::hold_by_pilot() {
  parts_->enter(Mode::kHold);
}

}  // namespace mlab::model_vehicles
