#include "mlab/mission/step.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "mlab/mission/clock.h"
#include "mlab/mission/dispatch.h"
#include "mlab/mission/owner.h"
#include "mlab/mission/phase_line.h"
#include "mlab/mission/question.h"

namespace mlab::mission {
namespace {

using Kind = effect::Tell::Kind;

// After a step that was done.
void begin_next(Turn& turn) {
  State& s = turn.state;
  ++s.step;
  if (s.step >= s.mission->steps.size())
    end_plan(turn);
  else if (!std::exchange(s.single, false))
    begin_step(turn, s.step);
}

// UNTIL ends a command that takes time. Who is not there yet holds where he is.
void end_in_time(Turn& turn, Run& run) {
  message(turn,
          fmt::format("{}: it is {}, done by UNTIL", turn.state.commands[run.record].text,
                      clock_text(turn.state.time, turn.state.options)),
          run.owner);
  halt(turn, run);
  complete(turn, run);
}

// Ends the run, or asks for clearance, where its robots are done. @return whether it ended
bool settle(Turn& turn, Run& run) {
  const State& s = turn.state;
  const Task task = run.command->task;
  // A PATROL goes on until its time comes.
  const bool robots_done = run.missing == 0 && !(task == Task::kPatrol && run.ends);
  const bool steers = run.phase == Run::Phase::kTeleoperation;
  if (!steers && run.phase != Run::Phase::kRobots) return false;
  if (steers && (robots_done || s.options.proceed_all)) {
    if (!robots_done)
      message(turn, fmt::format("{}: nobody steers, taken as complete", s.commands[run.record].text),
              run.owner);
    complete(turn, run);
  } else if (!steers && robots_done && !holds_at_line(run)) {
    if (task == Task::kOccupy || task == Task::kPatrol)
      ask_to_proceed(turn, run);
    else
      complete(turn, run);
  } else if (run.ends && *run.ends <= s.time) {
    end_in_time(turn, run);
  }
  return run.phase == Run::Phase::kEnded;
}

// Closes orders and the step whose commands have all ended. @return whether one was
bool close_finished(Turn& turn) {
  State& s = turn.state;
  bool any = false;
  for (std::size_t i = 0; i < s.runs.size();) {
    const std::uint32_t owner = s.runs[i].owner;
    const std::span<const Run> runs = runs_of(s, owner);
    const bool is_over = std::ranges::all_of(runs, has_ended);
    if (is_over && !is_step(s, owner)) {
      close_owner(turn, owner, outcome_of_order(s, owner));
      any = true;
    } else {
      i += runs.size();
    }
  }
  if (s.in_step && std::ranges::all_of(runs_of(s, s.step_record), has_ended)) {
    close_owner(turn, s.step_record, Outcome::kDone);
    begin_next(turn);
    any = true;
  } else if (s.is_ending && s.runs.empty()) {
    end_plan(turn);
    any = true;
  }
  if (any) rest(turn);
  return any;
}

// Commands of a step or an order that ends before they are done.
void end_runs_of(Turn& turn, std::uint32_t owner, Outcome outcome) {
  for (Run& run : turn.state.runs) {
    if (run.owner == owner && run.phase != Run::Phase::kEnded) end_run(turn, run, outcome);
  }
}

void abort_orders(Turn& turn) {
  State& s = turn.state;
  while (!s.runs.empty()) {
    const std::uint32_t owner = s.runs.back().owner;
    end_runs_of(turn, owner, Outcome::kAborted);
    close_owner(turn, owner, Outcome::kAborted);
  }
}

}  // namespace

void begin_step(Turn& turn, std::uint32_t step) {
  State& s = turn.state;
  s.mode = State::Mode::kRunning;
  s.is_ending = false;
  s.step = step;
  const Step& planned = s.mission->steps[step];
  s.step_record = open_owner(turn, planned.label, step);
  s.in_step = true;
  tell(turn, Kind::kStepStarted, owner_text(s, s.step_record), s.step_record);
  begin_commands(turn, planned.commands, s.mission, s.step_record);
}

void begin_order(Turn& turn, const std::vector<Command>& commands) {
  State& s = turn.state;
  s.mode = State::Mode::kRunning;
  const std::uint32_t owner = open_owner(turn, {}, kNoStep);
  tell(turn, Kind::kStepStarted, owner_text(s, owner), owner);
  const auto kept = std::make_shared<const std::vector<Command>>(commands);
  begin_commands(turn, *kept, kept, owner);
}

void go_on(Turn& turn) {
  State& s = turn.state;
  bool has_changed = true;
  while (has_changed && s.mode == State::Mode::kRunning) {
    has_changed = begin_held(turn);
    for (Run& run : s.runs) has_changed |= settle(turn, run);
    has_changed |= close_finished(turn);
  }
}

void end_command(Turn& turn, std::uint32_t owner, std::uint32_t record, Outcome outcome,
                 const std::string& why, Failure failure) {
  CommandRecord& c = turn.state.commands[record];
  c.outcome = outcome;
  c.failure = failure;
  c.end = turn.state.time;
  c.message = why;
  std::string text = fmt::format("{}{} {}", owner_prefix(turn.state, owner), c.text, name(outcome));
  if (!why.empty()) text += ": " + why;
  tell(turn, Kind::kCommandEnded, std::move(text), owner, record);
}

void end_run(Turn& turn, Run& run, Outcome outcome, const std::string& why, Failure failure) {
  run.phase = Run::Phase::kEnded;
  withdraw_of(turn, run);
  end_command(turn, run.owner, run.record, outcome, why, failure);
}

void complete(Turn& turn, Run& run) {
  end_run(turn, run, Outcome::kDone);
  if (!run.command->on_completion.empty()) {
    message(turn, fmt::format("{}: {}", turn.state.commands[run.record].unit, run.command->on_completion),
            run.owner);
  }
}

void fail(Turn& turn, Run& run, Failure failure, const std::string& why) {
  State& s = turn.state;
  const std::uint32_t owner = run.owner;
  end_run(turn, run, Outcome::kFailed, why, failure);
  if (!is_step(s, owner)) return;
  end_runs_of(turn, owner, Outcome::kAborted);
  const std::string text = owner_text(s, owner);
  close_owner(turn, owner, Outcome::kFailed);
  const std::uint32_t step = s.step;
  end_mission(turn, Outcome::kFailed, fmt::format("mission failed at {}", text));
  s.step = std::min(step, static_cast<std::uint32_t>(s.mission->steps.size()));
}

void abandon_step(Turn& turn, Outcome outcome) {
  State& s = turn.state;
  if (!s.in_step) return;
  end_runs_of(turn, s.step_record, outcome);
  close_owner(turn, s.step_record, outcome);
  rest(turn);
}

void end_plan(Turn& turn) {
  State& s = turn.state;
  if (s.runs.empty()) {
    end_mission(turn, Outcome::kDone, "mission done");
    return;
  }
  if (!std::exchange(s.is_ending, true))
    message(turn, "no step is left; the mission is done when the orders under way are");
  s.single = false;
}

void abort_mission(Turn& turn) {
  State& s = turn.state;
  if (std::exchange(s.paused, false)) emit(turn, effect::PauseRobots{false});
  abandon_step(turn, Outcome::kAborted);
  abort_orders(turn);
  for (RobotState& robot : s.robots) stop_robot(turn, robot);
  end_mission(turn, Outcome::kAborted, "mission aborted");
}

void quit(Turn& turn) {
  State& s = turn.state;
  if (s.in_step) {
    end_runs_of(turn, s.step_record, Outcome::kAborted);
    close_owner(turn, s.step_record, Outcome::kDone);
  }
  abort_orders(turn);
  end_mission(turn, Outcome::kDone, "mission done: QUIT");
  s.mode = State::Mode::kQuit;
  emit(turn, effect::Quit{});
}

void end_mission(Turn& turn, Outcome outcome, const std::string& text) {
  State& s = turn.state;
  tell(turn, Kind::kMissionEnded, text);
  s.outcome = outcome;
  s.step = 0;
  s.in_step = s.single = s.is_ending = false;
  rest(turn);
}

void rest(Turn& turn) {
  State& s = turn.state;
  if (s.mode == State::Mode::kQuit) return;
  const bool runs = s.in_step || s.is_ending || !s.runs.empty();
  s.mode = runs ? State::Mode::kRunning : State::Mode::kIdle;
}

}  // namespace mlab::mission
