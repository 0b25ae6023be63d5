#include "mlab/vehicle/mrv2/mrv2.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mlab/base/overloaded.h"
#include "mlab/vehicle/mrv2/messages.h"
#include "mlab/vehicle/steering.h"
#include "mlab/vehicle/their_clock.h"

namespace mlab::vehicle {
namespace mrv2 {
namespace {

using std::chrono::milliseconds;

constexpr auto kSaidEvery = milliseconds(100);
constexpr auto kSaidAtMostEvery = milliseconds(50);  // a slow line has to keep up
constexpr auto kAskedEvery = milliseconds(500);
constexpr auto kGivenUpAfter = std::chrono::seconds(5);
/// So many pieces of what has come are read at once; the rest waits.
constexpr int kMostReads = 8;
/// Rounding of the line [m], [m/s].
constexpr double kRounding = 0.002;
constexpr double kRadius = 0.4;
/// For the vehicle to notice that a command is over [s].
constexpr double kNotices = 0.1;

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

const auto kSilent = duration_of(kMrv2SilentAfter);

Limits limits_of(const Mrv2Settings& settings) {
  Limits limits;
  limits.kinematics = {.drive = binding::Drive::kSynchro,
                       .max_speed = settings.max_speed,
                       .max_acceleration = settings.braking,
                       .max_turn_rate = settings.max_turn_rate};
  limits.radius = kRadius;
  limits.standstill = settings.hold + settings.max_speed / settings.braking + kNotices;
  return limits;
}

class Mrv2Device final : public Device {
 public:
  Mrv2Device(std::unique_ptr<Stream> stream, const Mrv2Settings& settings)
      : stream_(std::move(stream)),
        name_("MRV-2 at " + stream_->name()),
        limits_(limits_of(settings)),
        hold_(duration_of(settings.hold)) {}
  ~Mrv2Device() override {
    if (stream_->is_open()) send(Stop{}, worked_at_);
  }
  Mrv2Device(const Mrv2Device&) = delete;
  Mrv2Device& operator=(const Mrv2Device&) = delete;

  const std::string& name() const override { return name_; }
  const Limits& limits() const override { return limits_; }
  void work(Clock::time_point now) override;
  const Report& report(Clock::time_point now) override;
  std::vector<Check> checks(Clock::time_point now) override;
  void drive(const Command& command, Clock::time_point now) override;
  void stop(Clock::time_point now) override;

 private:
  struct Given {
    Command command;
    Clock::time_point at;
  };

  void read(Clock::time_point now);
  void take(const Identity& identity, Clock::time_point now);
  void take(const State& state, Clock::time_point now);
  void take(const Ranges& ranges, Clock::time_point now);
  /// Another boot is another vehicle: nothing of the old one holds.
  void belongs_to(std::uint16_t boot);
  void forget();
  void speak(Clock::time_point now);
  void send(const Message& message, Clock::time_point now);
  bool is_heard(Clock::time_point now) const { return motion_.has_value() && now - motion_->at <= kSilent; }
  std::pair<Readiness, std::string> readiness(Clock::time_point now) const;

  std::unique_ptr<Stream> stream_;
  const std::string name_;
  const Limits limits_;
  const Clock::duration hold_;

  std::uint64_t opening_ = 0;
  FrameReader frames_;
  std::optional<std::uint16_t> boot_;
  TheirClock clock_;
  std::optional<Identity> identity_;
  std::optional<Motion> motion_;
  std::optional<Scan> scan_;
  Battery battery_;
  std::uint8_t flags_ = 0;

  std::optional<Given> given_;
  std::optional<Clock::time_point> stopped_at_;  // until it is seen to stand
  Command said_;
  Clock::time_point said_at_;
  Clock::time_point asked_at_;
  Clock::time_point worked_at_;
  Clock::time_point heard_at_;
  Report report_;
};

void Mrv2Device::work(Clock::time_point now) {
  worked_at_ = now;
  read(now);
  if (!is_heard(now)) given_.reset();  // it stands until the next `drive`, though it may be back before that
  if (!stream_->is_open()) {
    heard_at_ = now;
    return;
  }
  if (now - heard_at_ > kGivenUpAfter) {
    stream_->begin_anew(now);
    heard_at_ = now;
  }
  if (!identity_.has_value() && now - asked_at_ >= kAskedEvery) {
    send(Ask{}, now);
    asked_at_ = now;
  }
  speak(now);
}

void Mrv2Device::read(Clock::time_point now) {
  for (int i = 0; i < kMostReads; ++i) {
    const std::span<const std::byte> bytes = stream_->read(now);
    if (stream_->openings() != opening_) {
      opening_ = stream_->openings();
      frames_.begin_anew();
      forget();
    }
    if (bytes.empty()) return;
    frames_.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    while (const auto frame = frames_.next()) {
      const auto message = message_of(*frame);
      if (!message.has_value()) continue;
      std::visit(base::Overloaded{
                     [&](const Identity& m) { take(m, now); }, [&](const State& m) { take(m, now); },
                     [&](const Ranges& m) { take(m, now); }, [](const auto&) {}},  // what is said to vehicles
                 *message);
    }
  }
}

void Mrv2Device::take(const Identity& identity, Clock::time_point) {
  belongs_to(identity.boot);
  identity_ = identity;
}

void Mrv2Device::take(const State& state, Clock::time_point now) {
  belongs_to(state.boot);
  if (!clock_.hear(state.time, now) || !clock_.is_settled(now)) return;
  const Clock::time_point at = clock_.ours(state.time);
  if (now - at <= kSilent) heard_at_ = now;
  motion_ = {state.pose, state.speed, state.turn_rate, at};
  battery_ = {state.charge, state.voltage, at};
  flags_ = state.flags;
  const bool stands = state.speed == 0.0 && state.turn_rate == 0.0;
  if (stopped_at_.has_value() && stands && at > *stopped_at_) stopped_at_.reset();
}

void Mrv2Device::take(const Ranges& ranges, Clock::time_point now) {
  belongs_to(ranges.boot);
  const bool fits = identity_.has_value() && ranges.distances.size() == identity_->sensors;
  if (!clock_.hear(ranges.time, now) || !clock_.is_settled(now) || !fits) return;
  Scan scan;
  // Beams of the ring begin at the vehicle's edge, those of a scan in its middle.
  const double edge = identity_->radius;
  scan.step = 2.0 * std::numbers::pi / identity_->sensors;
  scan.beam_width = identity_->beam_width;
  scan.nearest = edge + identity_->nearest;
  scan.farthest = edge + identity_->range;
  scan.at = clock_.ours(ranges.time);
  for (const float distance : ranges.distances) {
    const bool is_told =
        distance >= identity_->nearest - kRounding && distance <= identity_->range + kRounding;
    const double there = std::clamp(edge + distance, scan.nearest, scan.farthest);
    scan.distances.push_back(std::isinf(distance) ? distance
                             : is_told            ? static_cast<float>(there)
                                                  : std::numeric_limits<float>::quiet_NaN());
  }
  scan_ = std::move(scan);
}

void Mrv2Device::belongs_to(std::uint16_t boot) {
  if (boot_ == boot) return;
  forget();
  boot_ = boot;
}

void Mrv2Device::forget() {
  boot_.reset();
  clock_.forget();
  identity_.reset();
  motion_.reset();
  scan_.reset();
  given_.reset();
}

void Mrv2Device::drive(const Command& command, Clock::time_point now) {
  stopped_at_.reset();
  given_.reset();
  if (readiness(now).first != Readiness::kReady) return;
  given_ = {cut_to(limits_, command), now};
  speak(now);
}

void Mrv2Device::stop(Clock::time_point now) {
  given_.reset();
  stopped_at_ = now;
  said_at_ = {};
  speak(now);
}

void Mrv2Device::speak(Clock::time_point now) {
  if (!stream_->is_open()) return;
  const auto since = now - said_at_;
  const bool is_due = since >= kSaidEvery;
  if (stopped_at_.has_value()) {
    if (!is_due) return;
    send(Stop{}, now);
    said_at_ = now;
    return;
  }
  if (!given_.has_value() || !clock_.is_known() || now - given_->at >= hold_) return;
  if (since < kSaidAtMostEvery || (!is_due && given_->command == said_)) return;
  const std::uint32_t good_until = clock_.theirs(given_->at + hold_);
  send(Drive{*boot_, good_until, given_->command.speed, given_->command.turn_rate}, now);
  said_ = given_->command;
  said_at_ = now;
}

void Mrv2Device::send(const Message& message, Clock::time_point now) {
  const std::string bytes = bytes_of(message);
  stream_->write(std::as_bytes(std::span(bytes)), now);
}

std::pair<Readiness, std::string> Mrv2Device::readiness(Clock::time_point now) const {
  if (!stream_->is_open()) return {Readiness::kAbsent, stream_->why()};
  if (!is_heard(now)) return {Readiness::kSilent, fmt::format("has said nothing for {} s", kMrv2SilentAfter)};
  if (!identity_.has_value()) return {Readiness::kNotReady, "has not yet told what it is"};
  if (identity_->max_acceleration < limits_.kinematics.max_acceleration - kRounding)
    return {Readiness::kNotReady,
            fmt::format("brakes with {} m/s^2; expected are at least {} m/s^2", identity_->max_acceleration,
                        limits_.kinematics.max_acceleration)};
  if ((flags_ & State::kMotorFault) != 0) return {Readiness::kFaulty, "says that a motor has failed"};
  if ((flags_ & State::kStopPressed) != 0) return {Readiness::kTaken, "has its emergency stop pressed"};
  return {Readiness::kReady, ""};
}

const Report& Mrv2Device::report(Clock::time_point now) {
  std::tie(report_.readiness, report_.why) = readiness(now);
  report_.motion.reset();
  report_.battery.reset();
  report_.scans.clear();
  if (!stream_->is_open() || !is_heard(now)) return report_;
  report_.motion = motion_;
  report_.battery = battery_;
  if (scan_.has_value() && now - scan_->at <= kSilent) report_.scans.push_back(*scan_);
  return report_;
}

std::vector<Check> Mrv2Device::checks(Clock::time_point now) {
  std::vector<Check> out;
  const std::string expected = fmt::format("at most {:.2g} s", limits_.standstill);
  if (identity_.has_value())
    out.push_back({"watchdog",
                   identity_->watchdog <= limits_.standstill ? CheckResult::kPass : CheckResult::kFail,
                   fmt::format("brakes {:.2g} s after its last command", identity_->watchdog), expected});
  else
    out.push_back({"watchdog", CheckResult::kUnknown, "has not yet told what it is", expected});
  const auto of_flag = [&](std::string name, State::Flag flag, std::string is, std::string is_not) {
    const bool is_set = (flags_ & flag) != 0;
    if (is_heard(now))
      out.push_back({std::move(name), is_set ? CheckResult::kFail : CheckResult::kPass,
                     std::move(is_set ? is : is_not), ""});
    else
      out.push_back({std::move(name), CheckResult::kUnknown, "says nothing", ""});
  };
  of_flag("emergency stop", State::kStopPressed, "is pressed", "is not pressed");
  of_flag("motors", State::kMotorFault, "says that one has failed", "says that none has failed");
  return out;
}

/// What is wrong with a setting; empty: nothing.
std::string fault_of(const Mrv2Settings& settings) {
  const auto is_positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!is_positive(settings.max_speed))
    return fmt::format("the MRV-2's speed is {} m/s; expected is more than 0", settings.max_speed);
  if (!is_positive(settings.max_turn_rate))
    return fmt::format("the MRV-2's turn rate is {} rad/s; expected is more than 0", settings.max_turn_rate);
  if (!is_positive(settings.braking))
    return fmt::format("the MRV-2's braking is {} m/s^2; expected is more than 0", settings.braking);
  if (!is_positive(settings.hold) || settings.hold <= 0.2)
    return fmt::format("commands hold for {} s; expected is more than 0.2 s", settings.hold);
  return {};
}

}  // namespace
}  // namespace mrv2

std::expected<std::unique_ptr<Device>, std::string> make_mrv2_over(std::unique_ptr<Stream> stream,
                                                                   const Mrv2Settings& settings) {
  std::string fault = mrv2::fault_of(settings);
  if (!fault.empty()) return std::unexpected(std::move(fault));
  return std::make_unique<mrv2::Mrv2Device>(std::move(stream), settings);
}

std::expected<std::unique_ptr<Device>, std::string> make_mrv2(std::string_view address,
                                                              const Mrv2Settings& settings) {
  const auto parsed = parse_address(address);
  if (!parsed.has_value()) return std::unexpected(parsed.error().message);
  return make_mrv2_over(make_stream(*parsed), settings);
}

}  // namespace mlab::vehicle
