#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"

namespace mlab::console {

/// What the operator asks of the run.
class RunOrders {
 public:
  /// @param before_execute  what has to be on the disk before robots move
  RunOrders(RunControl& run, EventLog& log, std::function<void()> before_execute)
      : run_(run), log_(log), before_execute_(std::move(before_execute)) {}

  /// All but RESTART, which makes another run.
  Answered control(const Sender& sender, const Control& control);
  Answered set_speed(const Sender& sender, const SetSpeed& set);
  Answered answer(const Sender& sender, const Answer& answer);
  Answered start_teleoperation(const Sender& sender, const StartTeleoperation& start);
  Answered stick(const Stick& stick);
  Answered end_teleoperation(const Sender& sender, const EndTeleoperation& end);
  Answered set_breakpoint(const Sender& sender, const SetBreakpoint& set, Reply& reply);
  Answered remove_breakpoint(const Sender& sender, const RemoveBreakpoint& remove);
  Answered force_state(const Sender& sender, const ForceState& force);
  Answered hold_value(const Sender& sender, const HoldValue& hold);
  Answered release_value(const Sender& sender, const ReleaseValue& release);
  Answered replace_robot(const Sender& sender, const ReplaceRobot& replace);
  Answered read_said(const ReadSaid& read, Reply& reply);

 private:
  Answered why_not(const Control& control) const;
  void carry_out(const Control& control);
  void resume();
  void single_step();
  void skip_step();
  void single_cycle();
  void note_of(std::uint32_t robot, std::string what);

  RunControl& run_;
  EventLog& log_;
  const std::function<void()> before_execute_;
};

}  // namespace mlab::console
