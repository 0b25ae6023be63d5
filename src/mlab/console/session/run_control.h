#pragma once

#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/console/run/breakpoints.h"
#include "mlab/console/run/cycle_times.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/run/live_run.h"
#include "mlab/console/run/speed_meter.h"
#include "mlab/console/run/teleoperations.h"
#include "mlab/console/run/vehicle_silence.h"
#include "mlab/console/session/request.h"
#include "mlab/preflight/gate.h"
#include "mlab/run/pace.h"

namespace mlab::console {

/// The run, and its time: whether it passes and how fast, what it halts at, the emergency stop, sticks.
/// Belongs to the session's thread, but for what is marked.
class RunControl {
 public:
  /// @param log    outlives it
  /// @param speed  simulated seconds per second; 0: as fast as it goes
  /// @param stop_line  what the emergency stop is shared by; null: it is this one's own
  /// @param wake       called, by any thread, when something of it has changed; the session then looks again
  /// @param gate       before its runs' vehicles; null: they have none
  RunControl(EventLog& log, double speed, std::shared_ptr<run::StopLine> stop_line,
             std::function<void()> wake, std::shared_ptr<preflight::Gate> gate);
  RunControl(const RunControl&) = delete;
  RunControl& operator=(const RunControl&) = delete;
  ~RunControl();

  // ---- which run

  /// Null where there is none.
  LiveRun* live() { return live_.get(); }
  const LiveRun* live() const { return live_.get(); }
  double sim_time() const { return live_ ? live_->run().time() : 0.0; }
  /// One is being made, and no command can be given until `adopt`.
  void expect() {
    is_expected_ = true;
    ++state_revision_;
  }
  bool is_expected() const { return is_expected_; }
  /// Takes the place of the run before; null: there is none any more.
  /// @param recorder  as LiveRun
  void adopt(std::shared_ptr<const run::Crew> crew, std::unique_ptr<run::MissionRun> run,
             std::unique_ptr<history::Recorder> recorder = nullptr);
  /// The same with a run that was computed again: it stands, with nobody's hand on a stick.
  void adopt(std::unique_ptr<LiveRun> live);
  /// The run goes on with other robots or another plan.
  void exchange(std::shared_ptr<const run::Crew> crew);
  /// The run goes on with other programs. @errors  why it can't
  std::expected<run::Takeover, std::string> take_over(std::shared_ptr<const run::Crew> crew);
  /// The mission has ended, and begins anew: trails and alerts are of before.
  void forget_earlier_run();

  // ---- what is asked of it

  /// Why no command can be given now.
  Answered why_not_now() const;
  /// Why nothing of the run may move now, apart from that: its vehicles are not checked. May take some
  /// seconds, where they have to be looked at first.
  Answered why_not_start();
  void post(const mission::Event& event);
  void note(const std::string& who, const std::string& what);

  // ---- time

  /// Lets as much time pass as is due, but not for longer than a person would notice.
  void advance();
  /// One control cycle. False where no time passed.
  bool step_once();
  /// When the next cycle is due [s]; far away where time stands still.
  double next_cycle() const;
  /// Something was asked: the run may have something to do again.
  void look_again() { has_nothing_to_do_ = false; }
  bool time_runs() const { return time_runs_; }
  void set_speed(double speed);
  const run::Pace& pace() const { return pace_; }
  const SpeedMeter& meter() const { return meter_; }
  /// Of all cycles, whichever run's.
  const CycleTimes& cycle_times() const { return cycle_times_; }

  // ---- the emergency stop

  /// From any thread: all robots stand from the next cycle on.
  void want_stop();
  void heed_stop();
  bool is_stopped() const { return is_stopped_; }
  /// Machines that have not said that their robots stand.
  std::vector<std::string> not_known_to_stand() const;
  void release_stop(const std::string& who);

  // ---- sticks and breakpoints

  Teleoperations& teleoperations() { return teleoperations_; }
  const Teleoperations& teleoperations() const { return teleoperations_; }
  void update_teleoperations();
  BreakpointTable& breakpoints() { return breakpoints_; }
  const BreakpointTable& breakpoints() const { return breakpoints_; }
  /// At these hits; without any: at none. Whatever makes the run go on ends the halt.
  const Halted& halted();

  // ---- what has changed; each number grows where something of it does

  std::uint64_t world_version() const { return world_version_; }      ///< what a frame shows
  std::uint64_t plan_revision() const { return plan_revision_; }      ///< its mission and robots
  std::uint64_t trails_revision() const { return trails_revision_; }  ///< trails that are of before
  std::uint64_t run_number() const { return run_number_; }            ///< another run
  /// Machines that carry robots and are silent, as `look_at_machines` has found them.
  const std::vector<robot::SilentMachine>& silent_machines() const { return silent_machines_; }
  /// What vehicles have not said while the run stands.
  const VehicleSilence& vehicle_silence() const { return vehicle_silence_; }
  /// Before its runs' vehicles; null: they have none.
  const preflight::Gate* gate() const { return gate_.get(); }
  /// Where some are silent, that is news each second; and so is what vehicles say while the run stands.
  void look_at_machines();
  /// Where it stands: mode, steps, speed, what it waits for.
  std::uint64_t state_revision();
  void world_changed() { ++world_version_; }
  std::uint64_t held_revision() const { return held_revision_; }  ///< values that people hold
  void held_changed() {
    ++held_revision_;
    ++world_version_;
  }

 private:
  bool is_active() const;
  void engage_stop(const std::string& by);
  void end_stop();
  void follow_stop_line();
  void follow_exchange();
  void release_held();
  void end_run();
  void begin_run(std::unique_ptr<LiveRun> live);
  void look_at_breakpoints();
  void pause();
  void record_preflight();

  EventLog& log_;
  std::unique_ptr<LiveRun> live_;
  bool is_expected_ = false;
  run::Pace pace_;
  SpeedMeter meter_;
  CycleTimes cycle_times_;
  std::shared_ptr<preflight::Gate> gate_;     // null: there is none
  preflight::Gate::Passed passed_;            // of the run, until its recording has it
  std::shared_ptr<run::StopLine> stop_line_;  // null: there is none
  std::atomic<bool> stop_line_changed_ = true;
  std::atomic<bool> stop_wanted_ = false;
  bool is_stopped_ = false;         // emergency stop
  bool time_runs_ = false;          // cycles are being run, paced from when this began
  bool has_nothing_to_do_ = false;  // the run waits for a person; nothing but a message changes that
  Teleoperations teleoperations_;
  BreakpointTable breakpoints_;
  Halted halted_;
  std::vector<robot::SilentMachine> silent_machines_;
  VehicleSilence vehicle_silence_;
  bool is_in_cycle_ = false;         // in which nothing comes in
  double looked_at_machines_ = 0.0;  // [s]
  std::uint64_t world_version_ = 1;
  std::uint64_t plan_revision_ = 0;
  std::uint64_t trails_revision_ = 0;
  std::uint64_t run_number_ = 0;
  std::uint64_t held_revision_ = 0;
  std::uint64_t state_revision_ = 1;
};

}  // namespace mlab::console
