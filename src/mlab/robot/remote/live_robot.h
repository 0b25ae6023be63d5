#pragma once

#include <cstdint>
#include <deque>

#include "mlab/agent.pb.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/remote/live_line.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::robot_remote {

/// A robot in real time, as its agent knows it: the newest percepts, and what it asked for that the run may
/// not know of yet. It knows nothing of its program.
class LiveRobot {
 public:
  /// Takes what has come.
  /// @return  false: nonsense, or older than what is there; nothing has changed
  bool hear(const wire::LivePercepts& message, Clock::time_point arrived);
  bool has_percepts() const { return cycle_ > 0; }
  /// Something newer has come than it acted on.
  bool is_fresh() const { return cycle_ > acted_on_; }
  bool wants_state() const { return wants_state_; }
  /// Of the percepts [s].
  double age(Clock::time_point now) const { return transit_ + in_seconds(now - arrived_); }
  Clock::time_point acted_at() const { return acted_at_; }

  /// What it perceives now: the time has gone on.
  percept::Percepts percepts(Clock::time_point now) const;
  /// It acts, now.
  /// @param out  everything but its action is filled in
  void answer(Clock::time_point now, wire::LiveAction& out);
  /// Keeps what was asked for once until the run has taken it.
  void keep_requests(const wire::LiveAction& done);

 private:
  std::uint64_t cycle_ = 0;
  std::uint64_t acted_on_ = 0;
  std::int64_t sent_ = 0;
  double transit_ = 0.0;  // [s]
  bool wants_state_ = false;
  Clock::time_point arrived_;
  Clock::time_point acted_at_;
  robot_wire::DecodedPercepts percepts_;
  std::uint64_t number_ = 0;  // of its last action
  std::deque<wire::EarlierRequests> earlier_;
};

}  // namespace mlab::robot_remote
