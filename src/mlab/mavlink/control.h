#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "mlab/mavlink/ardupilot.h"
#include "mlab/mavlink/line.h"
#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// After this long, a rover that was told to stop and still moves is disarmed by force.
inline constexpr std::chrono::milliseconds kHardStopAfter{2000};
/// Slower than this it stands [m/s, rad/s].
inline constexpr double kStandsBelow = 0.1;
/// What filters make of standing still is slower than this: it is not disarmed for less [m/s, rad/s].
inline constexpr double kRunsAwayFrom = 0.3;

/// What a rover's heartbeats say.
struct Heard {
  std::uint8_t system = 0;
  Mode mode = Mode::kInitialising;
  bool is_armed = false;
  State state = State::kUninitialised;
  vehicle::Clock::time_point at;  ///< of the last one
};

/// Brings a rover into GUIDED mode and arms it, streams set-points, stops it; and keeps its hands off where
/// somebody else has taken it.
///
/// Whoever changes its mode while it is driven, or disarms what this has armed, has taken it: its own
/// failsafes, a pilot, another ground station. What we asked for ourselves is nobody's: a mode that shows is
/// ours as long as not all that was asked for is answered, or not yet seen. It is not fought about: nothing
/// is sent until `engage` and then `drive` are called, but for an emergency. A pilot who steers an armed
/// rover by hand keeps it also then, but for an emergency.
class Control {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param command_lasts  a command that is older is not carried out any more
  explicit Control(vehicle::Clock::duration command_lasts) : command_lasts_(command_lasts) {}

  void drive(const vehicle::Command& command, Time now);
  /// @param is_emergency  also where somebody has taken it
  void stop(bool is_emergency, Time now);
  /// What was taken from us may be taken back.
  void engage();
  /// It was silent, or has begun again: it stands until the next `drive`. Meanwhile its failsafe may have put
  /// it into HOLD, which is nobody's word.
  void let_go(Time now);
  void take(const CommandAck& message, Time now);
  /// Sends what is due.
  /// @param may_drive  nothing else is against it
  /// @param motion     how it moves; null: it is not known
  void work(const Heard& heard, bool may_drive, const vehicle::Motion* motion, Line& line, Time now);
  /// As the last thing: it is to stand, without waiting for an answer.
  void leave(const Heard& heard, Line& line, Time now);

  /// Why somebody else has it, as a sentence without its subject; empty: nobody has.
  std::string taken_by(const Heard& heard) const;
  /// Why the vehicle refuses what it was last told; empty: it does not.
  const std::string& refusal() const { return refusal_; }

 private:
  enum class Wish : std::uint8_t { kNone, kDrive, kStop };

  // A command that is sent until what it asks for is seen.
  struct Request {
    std::uint16_t command = 0;
    float first = 0.0F;
    float second = 0.0F;
    std::uint8_t sent = 0;
    std::optional<Time> not_before;
  };

  void work_drive(const Heard& heard, Line& line, Time now);
  void work_stop(const Heard& heard, const vehicle::Motion* motion, Line& line, Time now);
  void ask(Request& request, const Heard& heard, Line& line, Time now);
  void send_set_point(const vehicle::Command& command, const Heard& heard, Line& line, Time now);
  void note_asking(const Request& request, Time now);
  void note_answer(const CommandAck& message, Time now);
  /// All modes that were asked for are answered, and it has told its mode since.
  bool is_answered(const Heard& heard) const;
  bool may_be_our_hold(const Heard& heard, Time now);
  void notice_taking(const Heard& heard, Time now);
  void begin_stopping(Time now);

  vehicle::Clock::duration command_lasts_;
  vehicle::Command command_;
  Time commanded_at_;
  Time stop_asked_at_;
  Time stopping_since_;
  Wish wish_ = Wish::kNone;
  bool is_emergency_ = false;  // what it is to stop for
  bool has_stopped_ = false;
  bool is_engaged_ = false;
  bool has_it_armed_ = false;     // it was engaged, and nothing of ours has disarmed it since
  bool is_hold_seen_ = false;     // since HOLD was asked for last
  bool is_guided_asked_ = false;  // GUIDED is the mode that was asked for last
  bool has_granted_ = false;      // the last answer: that is accepted
  bool is_reclaimed_ = false;
  int unanswered_ = 0;                 // modes that were asked for
  std::optional<Time> held_at_;        // when HOLD was asked for last, and may show itself yet
  std::optional<Time> mode_asked_at_;  // last
  std::optional<Time> answered_at_;    // the last of them
  std::optional<Time> stand_until_;
  std::optional<Time> let_go_at_;
  std::string taken_;
  std::string refusal_;
  std::optional<Time> set_point_at_;
  Request guided_{kDoSetMode, 1.0F, static_cast<float>(Mode::kGuided), 0, {}};
  Request hold_{kDoSetMode, 1.0F, static_cast<float>(Mode::kHold), 0, {}};
  Request arm_{kArmDisarm, 1.0F, 0.0F, 0, {}};
  Request disarm_{kArmDisarm, 0.0F, kForced, 0, {}};
};

}  // namespace mlab::mavlink
