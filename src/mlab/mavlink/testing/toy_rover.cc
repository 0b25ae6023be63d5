#include "mlab/mavlink/testing/toy_rover.h"

#include <algorithm>
#include <cmath>

namespace mlab::mavlink::testing {
namespace {

using std::chrono::milliseconds;

double seconds_of(vehicle::Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

void ToyLink::put(std::deque<Datagram>& queue, std::span<const std::byte> bytes, Time now) {
  if (is_cut || random.uniform() < loss) return;
  queue.push_back({now + delay, {bytes.begin(), bytes.end()}});
}

std::optional<std::vector<std::byte>> ToyLink::take(std::deque<Datagram>& queue, Time now) {
  if (queue.empty() || queue.front().at > now) return std::nullopt;
  auto out = std::move(queue.front().bytes);
  queue.pop_front();
  return out;
}

std::span<const std::byte> ToyStream::read(Time now) {
  last_ = ToyLink::take(link_.to_device, now).value_or(std::vector<std::byte>{});
  return last_;
}

bool ToyStream::write(std::span<const std::byte> bytes, Time now) {
  link_.put(link_.to_rover, bytes, now);
  return true;
}

ToyRover::ToyRover(ToyLink& link, const std::optional<Key>& key)
    : parameters{{"FS_GCS_ENABLE", 1}, {"FS_ACTION", 2},     {"FS_TIMEOUT", 1.5},  {"SYSID_MYGCS", 255},
                 {"GUID_TIMEOUT", 1},  {"FS_EKF_ACTION", 1}, {"FS_CRASH_CHECK", 1}},
      link_(link),
      signatures_(key ? std::optional<Signatures>(std::in_place, *key) : std::nullopt),
      reader_(signatures_ ? &*signatures_ : nullptr),
      writer_(1, 1, signatures_ ? &*signatures_ : nullptr) {}

std::uint32_t ToyRover::boot_ms(Time now) const {
  return static_cast<std::uint32_t>(std::chrono::duration_cast<milliseconds>(now - *began_).count());
}

void ToyRover::work(Time now) {
  if (!began_) restart(now);
  while (const auto bytes = ToyLink::take(link_.to_rover, now)) {
    reader_.feed(*bytes);
    while (const auto frame = reader_.next(signing_time)) take(*frame, now);
  }
  const bool is_alone = heard_ground_station_at && seconds_of(now - *heard_ground_station_at) >
                                                       static_cast<double>(parameters["FS_TIMEOUT"]);
  if (parameters["FS_GCS_ENABLE"] == 0.0F || !is_armed) {
    state = is_armed ? State::kActive : State::kStandby;
  } else if (is_alone) {
    mode = Mode::kHold;
    state = State::kCritical;
  } else {
    state = State::kActive;
  }
  move(seconds_of(now - moved_at_), now);
  moved_at_ = now;
  stream(now);
}

void ToyRover::restart(Time now) {
  began_ = now - milliseconds(100);
  moved_at_ = now;
  mode = Mode::kManual;
  is_armed = false;
  speed = yaw_rate = 0.0;
  intervals_ = {{Heartbeat::kInfo.id, milliseconds(1000)}};
  sent_at_.clear();
}

void ToyRover::say(const std::string& text, Time now) {
  StatusText message;
  message.severity = 2;
  message.text = field_of<50>(text);
  send(message, now);
}

void ToyRover::take(const Frame& frame, Time now) {
  if (frame.is<Heartbeat>() && static_cast<float>(frame.system) == parameters["SYSID_MYGCS"])
    heard_ground_station_at = now;
  if (frame.is<CommandLong>()) take_command(frame.as<CommandLong>(), now);
  if (frame.is<ParamRequestRead>() || frame.is<ParamSet>()) {
    const bool is_set = frame.is<ParamSet>();
    const auto id = is_set ? frame.as<ParamSet>().param_id : frame.as<ParamRequestRead>().param_id;
    const auto found = parameters.find(std::string(text_of(id)));
    if (found == parameters.end()) return;
    if (is_set) found->second = frame.as<ParamSet>().param_value;
    ParamValue answer;
    answer.param_value = found->second;
    answer.param_id = id;
    send(answer, now);
  }
  if (frame.is<SetPositionTargetLocalNed>()) {
    const auto message = frame.as<SetPositionTargetLocalNed>();
    if (mode != Mode::kGuided || message.type_mask != kVelocityAndTurnRate ||
        message.coordinate_frame != kFrameBodyNed)
      return;
    set_point_at = now;
    if (runs_away) return;
    speed = message.vx;
    yaw_rate = message.yaw_rate;
  }
}

void ToyRover::take_command(const CommandLong& message, Time now) {
  commands.push_back(message);
  CommandAck answer;
  answer.command = message.command;
  const auto deny = [&](Result result) { answer.result = static_cast<std::uint8_t>(result); };
  if (message.command == kSetMessageInterval) {
    intervals_[static_cast<std::uint32_t>(message.params[0])] =
        std::chrono::microseconds(static_cast<std::int64_t>(message.params[1]));
  } else if (message.command == kRequestMessage && version != Version::kUnsupported &&
             message.params[0] == static_cast<float>(AutopilotVersion::kInfo.id)) {
    if (version == Version::kMute) return;
    AutopilotVersion told;
    told.flight_sw_version = 0x040507ff;
    told.flight_custom_version = field_of<8>("9c2f1e4a");
    send(told, now);
  } else if (message.command == kDoSetMode) {
    if (refuses_modes) {
      deny(Result::kFailed);
    } else {
      if (static_cast<Mode>(message.params[1]) != mode && !runs_away) speed = yaw_rate = 0.0;
      mode = static_cast<Mode>(message.params[1]);
    }
  } else if (message.command == kArmDisarm && message.params[0] == 1.0F) {
    if (passes_checks)
      is_armed = true;
    else
      deny(Result::kFailed);
  } else if (message.command == kArmDisarm) {
    if (message.params[1] == kForced) ++forced_disarms;
    is_armed = false;
  } else {
    deny(Result::kUnsupported);
  }
  send(answer, now);
}

void ToyRover::move(double dt, Time now) {
  const bool is_told = mode == Mode::kGuided && set_point_at &&
                       seconds_of(now - *set_point_at) <= static_cast<double>(parameters["GUID_TIMEOUT"]);
  if (!is_armed || (!is_told && !runs_away)) speed = yaw_rate = 0.0;
  north += speed * std::cos(yaw) * dt;
  east += speed * std::sin(yaw) * dt;
  yaw += yaw_rate * dt;
}

void ToyRover::stream(Time now) {
  const auto is_due = [&](std::uint32_t id) {
    const auto wanted = intervals_.find(id);
    if (wanted == intervals_.end()) return false;
    const auto last = sent_at_.find(id);
    if (last != sent_at_.end() && now - last->second < wanted->second) return false;
    sent_at_[id] = now;
    return true;
  };
  if (is_due(Heartbeat::kInfo.id))
    send(Heartbeat{static_cast<std::uint32_t>(mode), kTypeRover, kAutopilotArdupilot,
                   static_cast<std::uint8_t>(is_armed ? kArmedBit : 0), static_cast<std::uint8_t>(state), 3},
         now);
  if (is_due(Attitude::kInfo.id))
    send(Attitude{boot_ms(now), 0, 0, static_cast<float>(std::remainder(yaw, 2.0 * std::numbers::pi)), 0, 0,
                  static_cast<float>(yaw_rate)},
         now);
  if (is_due(LocalPositionNed::kInfo.id))
    send(LocalPositionNed{boot_ms(now), static_cast<float>(north), static_cast<float>(east), 0,
                          static_cast<float>(speed * std::cos(yaw)),
                          static_cast<float>(speed * std::sin(yaw)), 0},
         now);
  if (is_due(SysStatus::kInfo.id)) {
    SysStatus message;
    message.sensors_enabled = kPreArmBit;
    message.sensors_health = passes_checks ? kPreArmBit : 0;
    message.voltage_battery = 12600;
    message.battery_remaining = 80;
    send(message, now);
  }
}

}  // namespace mlab::mavlink::testing
