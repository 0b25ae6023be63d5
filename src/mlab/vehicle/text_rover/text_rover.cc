#include "mlab/vehicle/text_rover/text_rover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mlab/vehicle/lines.h"
#include "mlab/vehicle/steering.h"
#include "mlab/vehicle/their_clock.h"

namespace mlab::vehicle {
namespace text_rover {
namespace {

using std::chrono::milliseconds;

constexpr auto kSilentAfter = milliseconds(1000);
constexpr auto kGivenUpAfter = milliseconds(5000);
constexpr auto kHolds = milliseconds(800);  // a command, from when it was given
constexpr auto kToldEvery = milliseconds(100);
constexpr int kMostReads = 8;
constexpr double kStandstill = 2.0;  // what holds for 0.8 s, then 0.5 m/s at 0.5 m/s^2, and a bit [s]
constexpr double kFastest = 0.5;     // [m/s]
constexpr double kBraking = 0.5;     // [m/s^2]
constexpr double kRadius = 0.2;      // [m]
constexpr double kReach = 3.0;       // of its eight sensors, from its edge [m]
constexpr std::size_t kSensors = 8;

class TextRover final : public Device {
 public:
  TextRover(std::unique_ptr<Stream> stream, const TextRoverSettings& settings)
      : stream_(std::move(stream)), name_("text rover at " + stream_->name()) {
    limits_.kinematics = {.drive = binding::Drive::kDifferential,
                          .max_speed = settings.max_speed,
                          .max_acceleration = kBraking,
                          .max_turn_rate = settings.max_turn_rate};
    limits_.radius = kRadius;
    limits_.standstill = kStandstill;
  }
  ~TextRover() override { say("S", worked_at_); }
  TextRover(const TextRover&) = delete;
  TextRover& operator=(const TextRover&) = delete;

  const std::string& name() const override { return name_; }
  const Limits& limits() const override { return limits_; }

  void work(Clock::time_point now) override {
    worked_at_ = now;
    for (int i = 0; i < kMostReads; ++i) {
      const auto bytes = stream_->read(now);
      if (std::exchange(opening_, stream_->openings()) != stream_->openings()) begin_anew();
      if (bytes.empty()) break;
      lines_.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      while (const auto line = lines_.next()) {
        if (const auto words = words_of(*line)) take(*words, now);
      }
    }
    if (!stream_->is_open()) heard_at_ = now;
    if (now - heard_at_ > kGivenUpAfter) {
      stream_->begin_anew(now);
      heard_at_ = now;
    }
    if (is_stopping_ && now - told_at_ >= kToldEvery) say("S", now);
  }

  const Report& report(Clock::time_point now) override {
    const auto is_fresh = [&](const auto& told) {
      return told.has_value() && now - told->at <= kSilentAfter;
    };
    report_ = {};
    if (!stream_->is_open()) {
      report_.why = stream_->why();
      return report_;
    }
    if (is_fresh(scan_)) report_.scans = {*scan_};
    if (is_fresh(battery_)) report_.battery = battery_;
    if (!is_fresh(motion_)) {
      report_.readiness = Readiness::kSilent;
      report_.why = "has not told for 1 s where it is";
      return report_;
    }
    report_.motion = motion_;
    report_.readiness = Readiness::kReady;
    return report_;
  }

  std::vector<Check> checks(Clock::time_point /*now*/) override {
    const bool is_open = stream_->is_open();
    return {{"line", is_open ? CheckResult::kPass : CheckResult::kFail, is_open ? "is open" : stream_->why(),
             "is open"},
            // It is what the rover is told with each command; nothing that it says confirms it.
            {"watchdog", CheckResult::kUnknown, "does not say whether it brakes when a command is over",
             fmt::format("stands within {} s after its last command: try it", kStandstill)}};
  }

  void drive(const Command& command, Clock::time_point now) override {
    is_stopping_ = false;
    if (report(now).readiness != Readiness::kReady) return;
    const Command cut = cut_to(limits_, command);
    if (cut == told_ && now - told_at_ < kToldEvery) return;
    told_ = cut;
    say(fmt::format("V {} {:.3f} {:.3f}", clock_.theirs(now + kHolds), cut.speed, cut.turn_rate), now);
  }

  void stop(Clock::time_point now) override {
    is_stopping_ = true;
    stopped_at_ = now;
    told_ = {};
    say("S", now);
  }

 private:
  void take(const Words& words, Clock::time_point now) {
    const std::vector<double>& n = words.numbers;
    const bool is_finite = std::ranges::all_of(n, [](double number) { return std::isfinite(number); });
    if (!is_finite && words.word != 'R') return;  // nothing but a distance may be endless
    if (n.empty() || !(n[0] >= 0.0 && n[0] <= std::numeric_limits<std::uint32_t>::max())) return;
    const auto time = static_cast<std::uint32_t>(n[0]);
    if (!clock_.is_known() && words.word != 'P') return;
    if (!clock_.hear(time, now)) {
      begin_anew();  // it was switched off and on
      clock_.hear(time, now);
    }
    if (!clock_.is_settled(now)) return;  // it may be of long ago
    const Clock::time_point at = clock_.ours(time);
    if (words.word == 'P' && n.size() == 6) {
      motion_ = Motion{{{n[1], n[2]}, n[3]}, n[4], n[5], at};
      if (now - at <= kSilentAfter) heard_at_ = now;
      if (n[4] == 0.0 && n[5] == 0.0 && at > stopped_at_) is_stopping_ = false;
    } else if (words.word == 'B' && n.size() == 2 && n[1] >= 0.0 && n[1] <= 100.0) {
      battery_ = Battery{n[1] / 100.0, 0.0, at};
    } else if (words.word == 'R' && n.size() == 1 + kSensors) {
      scan_ = scan_of(std::span(n).subspan(1), at);
    }
  }

  static Scan scan_of(std::span<const double> distances, Clock::time_point at) {
    Scan scan;
    scan.step = 2.0 * std::numbers::pi / kSensors;
    scan.nearest = kRadius;
    scan.farthest = kRadius + kReach;
    scan.at = at;
    for (const double distance : distances) {
      const bool is_told = distance >= 0.0 && (distance <= kReach || std::isinf(distance));
      scan.distances.push_back(is_told ? static_cast<float>(kRadius + distance)
                                       : std::numeric_limits<float>::quiet_NaN());
    }
    return scan;
  }

  void begin_anew() {
    lines_.begin_anew();
    clock_.forget();
    motion_.reset();
    scan_.reset();
    battery_.reset();
  }

  void say(std::string_view text, Clock::time_point now) {
    const std::string line = line_of(text);
    stream_->write(std::as_bytes(std::span(line)), now);
    told_at_ = now;
  }

  std::unique_ptr<Stream> stream_;
  const std::string name_;
  Limits limits_;
  LineReader lines_;
  TheirClock clock_;
  std::uint64_t opening_ = 0;
  std::optional<Motion> motion_;
  std::optional<Scan> scan_;
  std::optional<Battery> battery_;
  bool is_stopping_ = false;
  Clock::time_point stopped_at_;
  Command told_;
  Clock::time_point told_at_;
  Clock::time_point worked_at_;
  Clock::time_point heard_at_;
  Report report_;
};

}  // namespace
}  // namespace text_rover

std::expected<std::unique_ptr<Device>, std::string> make_text_rover_over(std::unique_ptr<Stream> stream,
                                                                         const TextRoverSettings& settings) {
  const auto is_positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!is_positive(settings.max_speed) || settings.max_speed > text_rover::kFastest)
    return std::unexpected(fmt::format("the rover's speed is {} m/s; expected is more than 0 and at most {}",
                                       settings.max_speed, text_rover::kFastest));
  if (!is_positive(settings.max_turn_rate))
    return std::unexpected(
        fmt::format("the rover's turn rate is {} rad/s; expected is more than 0", settings.max_turn_rate));
  return std::make_unique<text_rover::TextRover>(std::move(stream), settings);
}

std::expected<std::unique_ptr<Device>, std::string> make_text_rover(std::string_view address,
                                                                    const TextRoverSettings& settings) {
  const auto parsed = parse_address(address);
  if (!parsed.has_value()) return std::unexpected(parsed.error().message);
  return make_text_rover_over(make_stream(*parsed), settings);
}

}  // namespace mlab::vehicle
