#include "mlab/mavlink/rover_device.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mlab/text/shown.h"
#include "mlab/vehicle/steering.h"

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;
using vehicle::Readiness;

// Its failsafe counts them, and some get lost.
constexpr milliseconds kBetweenHeartbeats{100};
constexpr milliseconds kHeartbeatLasts{5000};
// Who has been silent for so long is not the one to wait for.
constexpr milliseconds kGivenUpAfter{5000};
constexpr milliseconds kBetweenAsking{60};
constexpr milliseconds kNeededWithin{2000};
constexpr milliseconds kOthersWithin{10000};
// What it was told last is repeated so long, then that it is to stand.
constexpr milliseconds kCommandLasts{300};
// After such a pause its failsafe may have acted, because it did not hear us either.
constexpr milliseconds kFailsafeMayAct{700};
constexpr std::size_t kMostNotes = 32;
// Without a limit of its speed, what is too far for one step is told by this [m/s].
constexpr double kAnySpeed = 10.0;

/// What is to come how often.
struct Streamed {
  std::uint32_t id = 0;
  milliseconds every{0};
  bool is_needed = false;  ///< every rover has it
};

constexpr std::array<Streamed, 8> kStreams = {{
    {Heartbeat::kInfo.id, milliseconds{200}, true},
    {Attitude::kInfo.id, milliseconds{100}, true},
    {LocalPositionNed::kInfo.id, milliseconds{100}, true},
    {SysStatus::kInfo.id, milliseconds{1000}, true},
    {GlobalPositionInt::kInfo.id, milliseconds{200}, false},
    {BatteryStatus::kInfo.id, milliseconds{2000}, false},
    {DistanceSensor::kInfo.id, milliseconds{200}, false},
    {ObstacleDistance::kInfo.id, milliseconds{200}, false},
}};

double max_speed_of(const vehicle::Limits& limits) {
  return limits.kinematics.max_speed > 0.0 ? limits.kinematics.max_speed : kAnySpeed;
}

double seconds(vehicle::Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

/// What else came, which may be why nothing is heard.
std::string hint_of(const Refusals& refusals) {
  if (refusals.not_signed > 0) return ": what comes is not signed, and a key is set";
  if (refusals.wrong_signatures > 0) return ": what comes is signed with another key";
  if (refusals.replayed > 0) return ": what comes was signed more than a minute ago";
  if (refusals.version_1 > 0) return ": it speaks MAVLink 1; set its SERIALn_PROTOCOL to 2, MAVLink 2";
  if (refusals.skipped_bytes > 1000) return ": what comes is not MAVLink 2; is the line's speed right?";
  return "";
}

}  // namespace

RoverDevice::RoverDevice(std::unique_ptr<vehicle::Stream> stream, const RoverSettings& settings)
    : settings_(settings),
      name_("MAVLink rover at " + stream->name()),
      line_(std::move(stream), settings.self, settings.key, settings.signing_clock),
      parameters_(settings.self, settings.limits.standstill),
      readings_(settings.origin, max_speed_of(settings.limits)),
      control_(kCommandLasts),
      streams_seen_(kStreams.size()),
      streams_asked_(kStreams.size()) {}

RoverDevice::~RoverDevice() {
  // Nobody waits for an answer, and one datagram may get lost.
  for (int i = 0; heard_ && i < 3; ++i) control_.leave(*heard_, line_, now_);
}

void RoverDevice::work(Time now) {
  now_ = now;
  // Before anything is read: who has been silent, and speaks again just now, has been silent all the same.
  if (is_silent(now) && !std::exchange(was_silent_, true)) lose(now);
  read(now);
  const bool is_silent_now = is_silent(now);
  was_silent_ = is_silent_now;
  if (!line_.stream().is_open() || !is_silent_now || !peer_since_) peer_since_ = now;
  if (now - *peer_since_ > kGivenUpAfter) {
    peer_since_ = now;
    line_.stream().begin_anew(now);
  }
  say(now);
  if (!heard_) return;
  const double jump = readings_.jump(now);
  if (jump > 0.0 && jump != told_jump_) notice(now, 4, fmt::format("jumped by {:.1f} m, as it says", jump));
  told_jump_ = jump;
  const auto motion = is_silent_now ? std::nullopt : readings_.motion(now);
  const bool may_drive = !is_silent_now && trouble(now).readiness == Readiness::kReady;
  control_.work(*heard_, may_drive, motion ? &*motion : nullptr, line_, now);
}

void RoverDevice::lose(Time now) {
  notice(now, 4, fmt::format("has been silent for {:.1f} s", seconds(kSilentAfter)));
  control_.let_go(now);
  readings_.forget();
  parameters_.begin_anew();
  firmware_.begin_anew();
  streams_seen_.assign(kStreams.size(), std::nullopt);
  streams_asked_.assign(kStreams.size(), std::nullopt);
}

void RoverDevice::read(Time now) {
  line_.begin_reading();
  while (const auto frame = line_.next(now)) take(*frame, now);
}

void RoverDevice::take(const Frame& frame, Time now) {
  if (frame.component != kComponentAutopilot) return;
  if (frame.is<Heartbeat>()) take_heartbeat(frame, now);
  if (!heard_ || frame.system != heard_->system) return;
  if (frame_at_ && now - *frame_at_ > kFailsafeMayAct) control_.let_go(now);
  frame_at_ = now;
  for (std::size_t i = 0; i < kStreams.size(); ++i) {
    if (kStreams[i].id == frame.id) streams_seen_[i] = now;
  }
  bool has_begun_again = false;
  if (frame.is<Attitude>()) has_begun_again = readings_.take(frame.as<Attitude>(), now);
  if (frame.is<LocalPositionNed>()) has_begun_again = readings_.take(frame.as<LocalPositionNed>(), now);
  if (frame.is<GlobalPositionInt>()) has_begun_again = readings_.take(frame.as<GlobalPositionInt>(), now);
  if (has_begun_again) begin_anew(now);
  if (frame.is<BatteryStatus>()) readings_.take(frame.as<BatteryStatus>(), now);
  if (frame.is<DistanceSensor>()) readings_.take(frame.as<DistanceSensor>(), now);
  if (frame.is<ObstacleDistance>()) readings_.take(frame.as<ObstacleDistance>(), now);
  if (frame.is<ParamValue>()) parameters_.take(frame.as<ParamValue>(), now);
  if (frame.is<AutopilotVersion>()) firmware_.take(frame.as<AutopilotVersion>());
  if (frame.is<CommandAck>()) take_answer(frame.as<CommandAck>(), now);
  if (frame.is<StatusText>()) take_text(frame.as<StatusText>(), now);
  if (frame.is<SysStatus>()) {
    const auto message = frame.as<SysStatus>();
    readings_.take(message, now);
    fails_checks_ = (message.sensors_enabled & kPreArmBit) != 0 && (message.sensors_health & kPreArmBit) == 0;
  }
}

void RoverDevice::take_heartbeat(const Frame& frame, Time now) {
  const auto message = frame.as<Heartbeat>();
  const bool is_wanted =
      settings_.vehicle == 0 ? !heard_ || frame.system == heard_->system : frame.system == settings_.vehicle;
  if (!is_wanted || frame.system == 0) return;
  const bool is_rover = message.type == kTypeRover || message.type == kTypeBoat;
  if (!is_rover || message.autopilot != kAutopilotArdupilot) {
    if (!heard_)
      stranger_ = fmt::format(
          "is no rover under ArduPilot: its type is {}, its autopilot {}, expected 10 or 11, and 3",
          message.type, message.autopilot);
    return;
  }
  heard_ = Heard{frame.system, static_cast<Mode>(message.custom_mode), (message.base_mode & kArmedBit) != 0,
                 static_cast<State>(message.system_status), now};
}

void RoverDevice::take_answer(const CommandAck& message, Time now) {
  // Others ask, too.
  if (message.target_system != 0 && message.target_system != settings_.self) return;
  control_.take(message, now);
  firmware_.take(message);
}

void RoverDevice::take_text(const StatusText& message, Time now) {
  const std::string text = text::shown(text_of(message.text), 60);
  if (text.starts_with("PreArm:") || text.starts_with("Arm:")) check_text_ = text;
  notice(now, message.severity, "says: " + text);
}

void RoverDevice::notice(Time now, std::uint8_t severity, std::string text) {
  notes_.push_back({now, severity, std::move(text)});
  if (notes_.size() > kMostNotes) notes_.pop_front();
}

std::vector<std::string> RoverDevice::take_news() {
  std::vector<std::string> out;
  for (Note& one : take_notes()) out.push_back(std::move(one.text));
  return out;
}

std::vector<Note> RoverDevice::take_notes() {
  std::vector<Note> out(notes_.begin(), notes_.end());
  notes_.clear();
  return out;
}

void RoverDevice::begin_anew(Time now) {
  notice(now, 4, "has begun again: its clock runs from the start");
  readings_.begin_anew();
  parameters_.begin_anew();
  firmware_.begin_anew();
  control_.let_go(now);
  fails_checks_ = false;
  check_text_.clear();
  streams_seen_.assign(kStreams.size(), std::nullopt);
  streams_asked_.assign(kStreams.size(), std::nullopt);
}

void RoverDevice::say(Time now) {
  if (!beat_at_ || now - *beat_at_ >= kBetweenHeartbeats) {
    beat_at_ = now;
    Heartbeat message;
    message.type = kTypeGroundStation;
    message.autopilot = kAutopilotNone;
    message.system_status = static_cast<std::uint8_t>(State::kActive);
    line_.send(message, now);
  }
  const bool is_due = !asked_at_ || now - *asked_at_ >= kBetweenAsking;
  if (heard_ && !is_silent(now) && is_due) ask(now);
}

void RoverDevice::ask(Time now) {
  asked_at_ = now;
  for (std::size_t i = 0; i < kStreams.size(); ++i) {
    const Streamed& one = kStreams[i];
    const auto awaited = std::max<milliseconds>(one.every * 3, milliseconds(1000));
    const bool comes = streams_asked_[i] && streams_seen_[i] && now - *streams_seen_[i] < awaited;
    const auto again = one.is_needed ? kNeededWithin : kOthersWithin;
    if (comes || (streams_asked_[i] && now - *streams_asked_[i] < again)) continue;
    streams_asked_[i] = now;
    CommandLong message;
    message.command = kSetMessageInterval;
    message.params[0] = static_cast<float>(one.id);
    message.params[1] = static_cast<float>(std::chrono::microseconds(one.every).count());
    line_.send_to(heard_->system, message, now);
    return;
  }
  if (const auto name = parameters_.to_ask(now)) {
    ParamRequestRead message;
    message.param_id = field_of<16>(*name);
    line_.send_to(heard_->system, message, now);
    return;
  }
  if (firmware_.is_to_be_asked(now)) {
    CommandLong message;
    message.command = kRequestMessage;
    message.params[0] = static_cast<float>(AutopilotVersion::kInfo.id);
    line_.send_to(heard_->system, message, now);
    return;
  }
  if (!settings_.writes_parameters) return;
  if (const auto write = parameters_.to_write(now)) {
    notice(now, 5, fmt::format("is told to set {} to {}", write->name, write->value));
    ParamSet message;
    message.param_id = field_of<16>(write->name);
    message.param_value = static_cast<float>(write->value);
    line_.send_to(heard_->system, message, now);
  }
}

bool RoverDevice::is_silent(Time now) const {
  return !frame_at_ || now - *frame_at_ > kSilentAfter;
}

RoverDevice::Trouble RoverDevice::silence(Time now) const {
  if (!line_.stream().is_open()) return {Readiness::kAbsent, line_.stream().why()};
  if (!is_silent(now)) return {};
  if (!heard_) {
    if (!stranger_.empty()) return {Readiness::kFaulty, stranger_};
    return {Readiness::kSilent, "has not been heard yet" + hint_of(line_.refusals())};
  }
  return {Readiness::kSilent, fmt::format("has said nothing for {:.1f} s", seconds(now - *frame_at_))};
}

RoverDevice::Trouble RoverDevice::state_trouble(Time now) const {
  if (now - heard_->at > kHeartbeatLasts)
    return {Readiness::kNotReady,
            fmt::format("has not said its mode for {:.1f} s", seconds(now - heard_->at))};
  switch (heard_->state) {
    case State::kPowerOff:
    case State::kTermination:
      return {Readiness::kFaulty, "is shutting down"};
    case State::kCritical:
    case State::kEmergency:
      return {Readiness::kNotReady,
              fmt::format("acts by its own failsafe, in mode {}", name_of(heard_->mode))};
    case State::kUninitialised:
    case State::kBoot:
    case State::kCalibrating:
      return {Readiness::kNotReady, "is starting"};
    case State::kStandby:
    case State::kActive:
      return {};
  }
  return {Readiness::kFaulty,
          fmt::format("tells a state that there is not: {}", static_cast<unsigned>(heard_->state))};
}

RoverDevice::Trouble RoverDevice::trouble(Time now) const {
  if (const Trouble one = silence(now); one.readiness != Readiness::kReady) return one;
  if (const Trouble one = state_trouble(now); one.readiness != Readiness::kReady) return one;
  if (std::string why = control_.taken_by(*heard_); !why.empty()) return {Readiness::kTaken, std::move(why)};
  if (std::string why = parameters_.problem(); !why.empty()) return {Readiness::kNotReady, std::move(why)};
  if (!readings_.motion(now))
    return {Readiness::kNotReady,
            "does not say where it is: it has no position yet, or its link is too slow"};
  if (const double jump = readings_.jump(now); jump > 0.0)
    return {Readiness::kNotReady, fmt::format("jumped by {:.1f} m, as it says", jump)};
  if (fails_checks_ && !heard_->is_armed)
    return {Readiness::kNotReady, check_text_.empty() ? "fails its own checks before arming"
                                                      : "fails its own checks before arming: " + check_text_};
  return {};
}

RoverDevice::Trouble RoverDevice::mode_trouble() const {
  if (!control_.refusal().empty()) {
    const std::string& why = control_.refusal();
    return {Readiness::kStandby, check_text_.empty() ? why : why + ": " + check_text_};
  }
  if (!heard_->is_armed) return {Readiness::kStandby, "is not armed"};
  if (heard_->mode != Mode::kGuided)
    return {Readiness::kStandby, fmt::format("is in mode {}, not GUIDED", name_of(heard_->mode))};
  return {};
}

const vehicle::Report& RoverDevice::report(Time now) {
  Trouble one = trouble(now);
  if (one.readiness == Readiness::kReady) one = mode_trouble();
  report_.readiness = one.readiness;
  report_.why = std::move(one.why);
  report_.is_global = settings_.origin.has_value();
  report_.motion = readings_.motion(now);
  report_.fix = settings_.origin ? std::nullopt : readings_.fix(now);
  report_.battery = is_silent(now) ? std::nullopt : readings_.battery(now);
  readings_.scans(now, report_.scans);
  return report_;
}

std::vector<vehicle::Check> RoverDevice::checks(Time now) {
  using enum vehicle::CheckResult;
  std::vector<vehicle::Check> out;
  if (const Trouble silent = silence(now); silent.readiness != Readiness::kReady)
    out.push_back({"autopilot", kFail, silent.why, "is heard"});
  else
    out.push_back({"autopilot", kPass,
                   fmt::format("is in mode {}, {}", name_of(heard_->mode),
                               heard_->is_armed ? "and armed" : "not armed"),
                   ""});
  out.push_back(firmware_.check());
  out.push_back({"signing", settings_.key ? kPass : kWarn,
                 settings_.key ? "all is signed, and nothing else is taken"
                               : "nothing is signed: who reaches its link can drive it",
                 ""});
  if (fails_checks_)
    out.push_back({"checks before arming", kFail,
                   check_text_.empty() ? "it says that they fail" : check_text_, "pass"});
  for (const ParameterCheck& one : parameters_.checks()) {
    const auto wrong = one.is_needed ? kFail : kWarn;
    out.push_back({"parameter " + one.name,
                   !one.value     ? kUnknown
                   : one.is_right ? kPass
                                  : wrong,
                   one.value ? fmt::format("is {}", *one.value) : "has not told it yet",
                   fmt::format("{}: {}", one.wanted, one.why)});
  }
  return out;
}

void RoverDevice::drive(const vehicle::Command& command, Time now) {
  if (!std::isfinite(command.speed) || !std::isfinite(command.turn_rate)) {
    stop(now);
    return;
  }
  // What comes back after a silence stands until somebody wants it to drive who knows that.
  if (!is_silent(now)) control_.drive(vehicle::cut_to(settings_.limits, command), now);
}

void RoverDevice::stop(Time now) {
  control_.stop(false, now);
}

void RoverDevice::stop_in_emergency(Time now) {
  control_.stop(true, now);
}

void RoverDevice::engage(Time /*now*/) {
  control_.engage();
}

}  // namespace mlab::mavlink
