#include "mlab/console/session/run_control.h"

#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/run/held_values.h"

namespace mlab::console {
namespace {

// Cycles are run for so long before the session looks around again [s].
constexpr double kSlice = 0.008;

}  // namespace

RunControl::RunControl(EventLog& log, double speed, std::shared_ptr<run::StopLine> stop_line,
                       std::function<void()> wake, std::shared_ptr<preflight::Gate> gate)
    : log_(log), pace_(speed), gate_(std::move(gate)), stop_line_(std::move(stop_line)) {
  if (!stop_line_) return;
  stop_line_->tell([this, wake = std::move(wake)] {
    stop_line_changed_ = true;
    wake();
  });
}

RunControl::~RunControl() {
  if (stop_line_) stop_line_->tell({});
}

// ---- which run

void RunControl::adopt(std::shared_ptr<const run::Crew> crew, std::unique_ptr<run::MissionRun> run,
                       std::unique_ptr<history::Recorder> recorder) {
  end_run();
  begin_run(run ? std::make_unique<LiveRun>(std::move(crew), std::move(run), log_, std::move(recorder))
                : nullptr);
}

void RunControl::adopt(std::unique_ptr<LiveRun> live) {
  end_run();
  is_stopped_ = is_stopped_ || live->run().is_stopped();
  begin_run(std::move(live));
  run::MissionRun& run = live_->run();
  for (const fleet::FleetRobot& robot : run.fleet().robots()) run.let_go_of_stick(robot.id);
  pause();
}

void RunControl::end_run() {
  is_expected_ = false;
  breakpoints_.begin(nullptr);
  if (live_) release_held();
  live_.reset();
}

void RunControl::begin_run(std::unique_ptr<LiveRun> live) {
  live_ = std::move(live);
  if (live_) {
    if (live_->run().is_in_real_time()) pace_.set_speed(1.0, wall_time(), sim_time());
    live_->run().set_stands_still_for_operator(pace_.speed() == 0.0);
    live_->run().set_emergency_stop(is_stopped_);
  }
  breakpoints_.begin(live_ ? &live_->run() : nullptr);
  halted_.Clear();
  has_nothing_to_do_ = time_runs_ = false;
  passed_ = {};
  teleoperations_ = {};
  ++run_number_;
  ++plan_revision_;
  ++trails_revision_;
  ++world_version_;
  ++held_revision_;
  ++state_revision_;
}

// With the run that ends; who held them is told.
void RunControl::release_held() {
  HeldValues held;
  encode_held(live_->run(), held);
  if (held.values().empty()) return;
  log_.add(sim_time(), {Log::OPERATOR,
                        fmt::format("{} held value{} released: the run has ended", held.values_size(),
                                    held.values_size() == 1 ? " is" : "s are"),
                        0,
                        "",
                        {},
                        false});
  ++held_revision_;
}

void RunControl::exchange(std::shared_ptr<const run::Crew> crew) {
  live_->edit(std::move(crew));
  follow_exchange();
}

std::expected<run::Takeover, std::string> RunControl::take_over(std::shared_ptr<const run::Crew> crew) {
  auto out = live_->take_over(std::move(crew));
  if (out) follow_exchange();
  return out;
}

void RunControl::follow_exchange() {
  breakpoints_.change(&live_->run());
  ++held_revision_;  // of a robot that went
  has_nothing_to_do_ = false;
  ++plan_revision_;
  ++world_version_;
  ++state_revision_;
}

void RunControl::forget_earlier_run() {
  log_.begin_run();
  live_->notes().trails().clear();
  ++trails_revision_;
}

// ---- what is asked of it

Answered RunControl::why_not_now() const {
  if (is_expected_) return "the mission is still being made ready";
  if (!live_) return "there is no mission that could run";
  if (is_stopped_) return "an emergency stop holds all robots: release it first";
  if (live_->run().state().mode == mission::State::Mode::kQuit) return "the mission has quit: restart it";
  return std::nullopt;
}

Answered RunControl::why_not_start() {
  if (!gate_ || !live_) return std::nullopt;
  const std::string before = gate_->passed().said;
  if (std::string why = gate_->why_not_start(*live_->crew()); !why.empty()) return why;
  preflight::Gate::Passed passed = gate_->passed();
  if (passed.said == before) return std::nullopt;
  const Log::Kind kind = passed.is_unchecked ? Log::WARNING : Log::MESSAGE;
  log_.add(sim_time(), {kind, passed.said, 0, "", {}, passed.is_unchecked});
  passed_ = std::move(passed);
  return std::nullopt;
}

// Its recording begins when it is started.
void RunControl::record_preflight() {
  history::Recorder* const recorder = live_->recorder();
  if (passed_.said.empty() || recorder == nullptr) return;
  if (recorder->put_metadata({"preflight", {{"said", passed_.said}, {"checklist", passed_.checklist}}}))
    passed_ = {};
}

void RunControl::post(const mission::Event& event) {
  live_->run().post(event);
  record_preflight();
  has_nothing_to_do_ = false;
  ++state_revision_;
  ++world_version_;
}

void RunControl::note(const std::string& who, const std::string& what) {
  log_.add(sim_time(), {Log::OPERATOR, fmt::format("{}: {}", who, what), 0, "", {}, false});
}

void RunControl::pause() {
  const mission::State& state = live_->run().state();
  if (state.mode == mission::State::Mode::kRunning && !state.paused) post(mission::event::Pause{});
}

// ---- time

bool RunControl::is_active() const {
  if (!live_ || is_expected_) return false;
  const mission::State& state = live_->run().state();
  return is_stopped_ || (state.mode == mission::State::Mode::kRunning && !state.paused);
}

double RunControl::next_cycle() const {
  if (!is_active() || has_nothing_to_do_) return std::numeric_limits<double>::infinity();
  return pace_.due(sim_time());
}

void RunControl::advance() {
  if (!is_active() || has_nothing_to_do_) {
    time_runs_ = false;
    return;
  }
  const double began = wall_time();
  if (!std::exchange(time_runs_, true)) pace_.start(began, sim_time());
  // Robots that nobody waits for could not follow cycles that are made up for.
  if (live_->run().is_in_real_time()) pace_.forgive_all(began, sim_time(), live_->run().cycle_duration());
  double wall = began;
  while (wall - began < kSlice && pace_.due(sim_time()) <= wall) {
    heed_stop();
    if (!step_once()) {
      has_nothing_to_do_ = true;
      if (is_stopped_) ++state_revision_;  // all stand
      break;
    }
    wall = wall_time();
    if (!is_active()) break;
  }
  meter_.note(wall, sim_time());
  pace_.forgive(wall, sim_time());
}

bool RunControl::step_once() {
  halted_.Clear();
  const CycleTimes::Watch watch(cycle_times_);
  is_in_cycle_ = true;
  const run::MissionRun::Progress progress = live_->step();
  is_in_cycle_ = false;
  if (progress != run::MissionRun::Progress::kStepped) return false;
  watch.note(cycle_times_);
  ++world_version_;
  if (breakpoints_.are_on()) look_at_breakpoints();
  return true;
}

void RunControl::set_speed(double speed) {
  pace_.set_speed(speed, wall_time(), sim_time());
  if (live_) live_->run().set_stands_still_for_operator(speed == 0.0);
  ++state_revision_;
}

// ---- the emergency stop

void RunControl::want_stop() {
  // Not by way of the session's thread, which may be waiting for something.
  if (stop_line_) stop_line_->engage();
  stop_wanted_ = true;
}

void RunControl::heed_stop() {
  if (stop_wanted_.exchange(false)) engage_stop("");
  if (stop_line_changed_.exchange(false) && stop_line_) follow_stop_line();
}

// Somebody else may have pulled or released it.
void RunControl::follow_stop_line() {
  ++state_revision_;
  const run::StopLine::State state = stop_line_->state();
  if (state.is_engaged) {
    engage_stop(state.by);
  } else if (is_stopped_) {
    note(state.by, "release the emergency stop");
    end_stop();
  }
}

std::vector<std::string> RunControl::not_known_to_stand() const {
  std::vector<std::string> out;
  if (!stop_line_ || !is_stopped_) return out;
  for (const run::StopLine::Unreached& one : stop_line_->unreached())
    out.push_back(one.by.empty() ? one.name : fmt::format("{} (known by {})", one.name, one.by));
  return out;
}

void RunControl::engage_stop(const std::string& by) {
  if (is_stopped_) return;
  is_stopped_ = true;
  if (live_) {
    live_->run().set_emergency_stop(true);
    teleoperations_.let_go(live_->run());
  }
  has_nothing_to_do_ = false;
  time_runs_ = false;
  log_.add(sim_time(), {Log::OPERATOR,
                        by.empty() ? "emergency stop: all robots stand"
                                   : fmt::format("emergency stop by {}: all robots stand", by),
                        0,
                        "",
                        {},
                        true});
  ++state_revision_;
  ++world_version_;
}

void RunControl::release_stop(const std::string& who) {
  if (stop_line_) stop_line_->release();
  note(who, "release the emergency stop");
  end_stop();
}

void RunControl::end_stop() {
  is_stopped_ = false;
  ++state_revision_;
  if (!live_) return;
  pause();
  live_->run().set_emergency_stop(false);
}

void RunControl::look_at_machines() {
  constexpr double kApart = 0.5;  // between two looks [s]
  if (const double wall = wall_time(); wall >= looked_at_machines_ + kApart)
    looked_at_machines_ = wall;
  else
    return;
  if (stop_line_) {
    for (std::string& alert : stop_line_->take_alerts())
      log_.add(sim_time(), {Log::WARNING, std::move(alert), 0, "", {}, true});
  }
  if (!live_ || time_runs_ || is_in_cycle_)
    vehicle_silence_.forget();
  else if (vehicle_silence_.look(live_->run(), wall_time()))
    ++state_revision_;
  std::vector<robot::SilentMachine> silent;
  if (live_) silent = live_->run().fleet().silent_machines();
  if (!silent.empty() || !silent_machines_.empty()) ++state_revision_;
  silent_machines_ = std::move(silent);
}

// ---- sticks and breakpoints

void RunControl::update_teleoperations() {
  if (!live_) return;
  const bool has_changed = teleoperations_.update(live_->run());
  if (teleoperations_.relax(live_->run(), wall_time()) || has_changed) ++world_version_;
  if (has_changed) ++state_revision_;
}

void RunControl::look_at_breakpoints() {
  breakpoints_.look(live_->run(), halted_);
  if (halted_.hits().empty()) return;
  for (const Halted::Hit& hit : halted_.hits())
    log_.add(sim_time(), {Log::BREAKPOINT, hit.text(), hit.robot(), "", {}, false});
  pause();
}

const Halted& RunControl::halted() {
  const bool stands = live_ && live_->run().state().paused;
  if (!stands) halted_.Clear();
  return halted_;
}

std::uint64_t RunControl::state_revision() {
  if (live_ && live_->notes().take_news()) ++state_revision_;
  return state_revision_;
}

}  // namespace mlab::console
