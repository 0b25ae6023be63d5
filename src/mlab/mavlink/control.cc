#include "mlab/mavlink/control.h"

#include <cmath>

#include <fmt/format.h>

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

// `work` comes every 50 ms: ten set-points a second and some more.
constexpr milliseconds kBetweenSetPoints{80};
constexpr milliseconds kBetweenRequests{400};
constexpr milliseconds kBetweenStops{200};
constexpr milliseconds kAfterRefusal{2000};
// So long after HOLD was sent, what shows it may be that, and nobody else's doing; where nothing tells
// better.
constexpr milliseconds kHoldIsOurs{4000};
// Answers and heartbeats are not on their way for longer.
constexpr milliseconds kShowsWithin{1000};
// A `stop` after such a pause is a new one.
constexpr milliseconds kSameStop{1000};
// After a silence set-points say so long that it is to stand.
constexpr milliseconds kStandAfterSilence{1000};
// It may still have been alone when it was heard again: its failsafe then acts only now.
constexpr milliseconds kFailsafeFollows{1000};

bool moves(const vehicle::Motion& motion, double from) {
  return std::abs(motion.speed) > from || std::abs(motion.turn_rate) > from;
}

std::string_view word_of(std::uint8_t result) {
  switch (static_cast<Result>(result)) {
    case Result::kTemporarilyRejected:
      return "not now";
    case Result::kDenied:
      return "denied";
    case Result::kUnsupported:
      return "it does not know that command";
    default:
      return "it failed";
  }
}

}  // namespace

void Control::drive(const vehicle::Command& command, Time now) {
  if (wish_ != Wish::kDrive) {
    refusal_.clear();
    guided_.sent = arm_.sent = 0;
    guided_.not_before.reset();
    arm_.not_before.reset();
  }
  wish_ = Wish::kDrive;
  command_ = command;
  commanded_at_ = now;
  stand_until_.reset();
}

void Control::stop(bool is_emergency, Time now) {
  const bool is_new =
      wish_ != Wish::kStop || now - stop_asked_at_ > kSameStop || is_emergency != is_emergency_;
  stop_asked_at_ = now;
  if (!is_new) return;
  wish_ = Wish::kStop;
  is_emergency_ = is_emergency;
  if (is_emergency) taken_.clear();
  begin_stopping(now);
}

void Control::begin_stopping(Time now) {
  stopping_since_ = now;
  has_stopped_ = false;
  is_engaged_ = has_granted_ = false;
  refusal_.clear();
  hold_.sent = disarm_.sent = 0;
  hold_.not_before.reset();
  disarm_.not_before.reset();
}

void Control::engage() {
  is_reclaimed_ = !taken_.empty();
  taken_.clear();
  has_it_armed_ = false;
  refusal_.clear();
}

void Control::let_go(Time now) {
  // What it was told last may still be on its way.
  if (is_engaged_) stand_until_ = now + kStandAfterSilence;
  let_go_at_ = now;
  is_engaged_ = has_granted_ = has_it_armed_ = false;
  if (wish_ == Wish::kDrive) wish_ = Wish::kNone;
  taken_.clear();
  is_reclaimed_ = false;
  refusal_.clear();
}

// Each is answered, in order; the answer does not say which mode it is about.
void Control::note_asking(const Request& request, Time now) {
  if (request.command != kDoSetMode) return;
  if (mode_asked_at_ && now - *mode_asked_at_ > kShowsWithin) unanswered_ = 0;  // the others got lost
  mode_asked_at_ = now;
  ++unanswered_;
  has_granted_ = false;
  is_guided_asked_ = &request == &guided_;
  if (&request != &hold_) return;
  held_at_ = now;
  is_hold_seen_ = false;
}

void Control::note_answer(const CommandAck& message, Time now) {
  if (message.command != kDoSetMode || unanswered_ == 0) return;
  --unanswered_;
  if (unanswered_ > 0) return;
  answered_at_ = now;
  has_granted_ = is_guided_asked_ && static_cast<Result>(message.result) == Result::kAccepted;
}

bool Control::is_answered(const Heard& heard) const {
  return unanswered_ == 0 && answered_at_ && heard.at > *answered_at_;
}

void Control::take(const CommandAck& message, Time now) {
  note_answer(message, now);
  for (Request* const one : {&guided_, &hold_, &arm_, &disarm_}) {
    if (one->command != message.command || one->sent == 0) continue;
    const auto result = static_cast<Result>(message.result);
    if (result == Result::kAccepted || result == Result::kInProgress) continue;
    // Of two that are the same command, only the one that is being asked has something to be refused.
    const bool is_of_driving = one == &guided_ || one == &arm_;
    if (is_of_driving != (wish_ == Wish::kDrive)) continue;
    if (is_of_driving) {
      refusal_ = fmt::format("refuses {}: {}", one == &arm_ ? "to be armed" : "mode GUIDED",
                             word_of(message.result));
      one->not_before = now + kAfterRefusal;
    }
  }
}

void Control::ask(Request& request, const Heard& heard, Line& line, Time now) {
  if (request.not_before && now < *request.not_before) return;
  const bool is_stop = &request == &hold_ || &request == &disarm_;
  request.not_before = now + (is_stop ? kBetweenStops : kBetweenRequests);
  CommandLong message;
  message.command = request.command;
  message.params[0] = request.first;
  message.params[1] = request.second;
  message.confirmation = request.sent;
  if (request.sent < 255) ++request.sent;
  note_asking(request, now);
  if (&request == &disarm_) has_it_armed_ = false;
  line.send_to(heard.system, message, now);
}

void Control::send_set_point(const vehicle::Command& command, const Heard& heard, Line& line, Time now) {
  if (set_point_at_ && now - *set_point_at_ < kBetweenSetPoints) return;
  set_point_at_ = now;
  SetPositionTargetLocalNed message;
  message.time_boot_ms =
      static_cast<std::uint32_t>(std::chrono::duration_cast<milliseconds>(now.time_since_epoch()).count());
  message.vx = static_cast<float>(command.speed);
  // Theirs is clockwise.
  message.yaw_rate = static_cast<float>(-command.turn_rate);
  message.type_mask = kVelocityAndTurnRate;
  message.coordinate_frame = kFrameBodyNed;
  line.send_to(heard.system, message, now);
}

bool Control::may_be_our_hold(const Heard& heard, Time now) {
  if (!held_at_) return false;
  is_hold_seen_ = is_hold_seen_ || (heard.mode == Mode::kHold && heard.at > *held_at_);
  const auto since = now - *held_at_;
  // GUIDED came behind it.
  const bool is_over =
      heard.mode == Mode::kGuided && (is_answered(heard) || (is_hold_seen_ && since > kShowsWithin));
  if (is_over || since >= kHoldIsOurs) held_at_.reset();
  return held_at_.has_value();
}

void Control::notice_taking(const Heard& heard, Time now) {
  const bool is_ours = may_be_our_hold(heard, now);
  const bool is_in_guided = heard.mode == Mode::kGuided;
  // It has said that it takes GUIDED, and is in another mode since.
  const bool is_changed = has_granted_ && is_answered(heard) && heard.is_armed && !is_in_guided;
  const bool is_disarmed = has_it_armed_ && !heard.is_armed;
  if (!is_changed && !is_disarmed && (!is_engaged_ || is_in_guided)) return;
  is_engaged_ = has_granted_ = false;
  const bool is_failsafes = let_go_at_ && now - *let_go_at_ < kFailsafeFollows;
  if (heard.mode == Mode::kHold && heard.is_armed && ((is_ours && !is_changed) || is_failsafes)) return;
  has_it_armed_ = false;
  if (!heard.is_armed)
    taken_ = "was disarmed by itself or by somebody else; Replace in the console has it armed again";
  else
    taken_ = fmt::format(
        "was put into mode {} by itself or by somebody else; Replace in the console takes it back",
        name_of(heard.mode));
}

void Control::work(const Heard& heard, bool may_drive, const vehicle::Motion* motion, Line& line, Time now) {
  notice_taking(heard, now);
  if (stand_until_ && now < *stand_until_ && heard.mode == Mode::kGuided && heard.is_armed)
    send_set_point({}, heard, line, now);
  if (wish_ == Wish::kStop) {
    work_stop(heard, motion, line, now);
  } else if (wish_ == Wish::kDrive && taken_by(heard).empty()) {
    // A heartbeat from before a silence does not tell what became of it meanwhile.
    if (let_go_at_ && heard.at <= *let_go_at_) return;
    if (may_drive)
      work_drive(heard, line, now);
    else if (is_engaged_)
      send_set_point({}, heard, line, now);
  }
}

void Control::work_drive(const Heard& heard, Line& line, Time now) {
  const bool is_fresh = now - commanded_at_ <= command_lasts_;
  if (is_engaged_) {
    send_set_point(is_fresh ? command_ : vehicle::Command{}, heard, line, now);
  } else if (!is_fresh) {
    // Nobody asks any more.
  } else if (heard.mode != Mode::kGuided) {
    ask(guided_, heard, line, now);
  } else if (!heard.is_armed) {
    ask(arm_, heard, line, now);
  } else {
    is_engaged_ = has_it_armed_ = true;
    is_reclaimed_ = false;
    refusal_.clear();
    send_set_point(command_, heard, line, now);
  }
}

void Control::work_stop(const Heard& heard, const vehicle::Motion* motion, Line& line, Time now) {
  const bool is_moving = motion != nullptr && moves(*motion, kStandsBelow);
  const bool is_held = heard.mode == Mode::kHold || !heard.is_armed;
  // An emergency lasts as long as this is called: nobody gets it away from there meanwhile.
  const bool lasts = is_emergency_ && now - stop_asked_at_ <= kSameStop;
  if (has_stopped_ && lasts && !is_held) begin_stopping(now);
  if (has_stopped_ || (!is_emergency_ && !taken_by(heard).empty())) return;
  // A heartbeat from before says nothing of what came after.
  const bool is_seen = heard.at > stopping_since_;
  if (is_seen && is_held && !is_moving) {
    has_stopped_ = true;
    return;
  }
  send_set_point({}, heard, line, now);
  ask(hold_, heard, line, now);
  const bool runs_away = motion != nullptr && moves(*motion, kRunsAwayFrom);
  if (runs_away && heard.is_armed && now - stopping_since_ >= kHardStopAfter) ask(disarm_, heard, line, now);
}

void Control::leave(const Heard& heard, Line& line, Time now) {
  if ((wish_ != Wish::kDrive && !is_engaged_) || !taken_by(heard).empty()) return;
  set_point_at_.reset();
  send_set_point({}, heard, line, now);
  hold_.not_before.reset();
  ask(hold_, heard, line, now);
}

std::string Control::taken_by(const Heard& heard) const {
  if (!taken_.empty()) return taken_;
  if (!heard.is_armed || heard.mode == Mode::kHold || heard.mode == Mode::kGuided || is_engaged_) return {};
  if (is_reclaimed_ && !is_pilots(heard.mode)) return {};
  return fmt::format(
      "is armed and in mode {}: {}", name_of(heard.mode),
      is_pilots(heard.mode) ? "a pilot steers it" : "somebody else, or its own failsafe, drives it");
}

}  // namespace mlab::mavlink
