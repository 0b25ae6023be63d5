#include "mlab/mission/step.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "mlab/mission/dispatch.h"
#include "mlab/mission/phase_line.h"
#include "mlab/mission/question.h"

namespace mlab::mission {
namespace {

using Kind = effect::Tell::Kind;

void begin_record(Turn& turn, std::string label, std::uint32_t step) {
  State& s = turn.state;
  StepRecord record;
  record.label = std::move(label);
  record.step = step;
  record.start = record.end = s.time;
  record.first_command = static_cast<std::uint32_t>(s.commands.size());
  s.steps.push_back(std::move(record));
}

// `step 3`, `typed commands`
std::string step_text(const State& state) {
  if (state.typed) return "typed commands";
  return fmt::format("step {}", state.steps.back().label);
}

// The runs are over, however they ended.
void close_step(Turn& turn, Outcome outcome) {
  State& s = turn.state;
  s.steps.back().outcome = outcome;
  s.steps.back().end = s.time;
  for (std::size_t i = s.questions.size(); i-- > 0;) {
    if (s.questions[i].robot.value == 0) withdraw(turn, i);
  }
  for (const Run& run : s.runs) {
    for (const base::RobotId id : run.needed) {
      if (RobotState* robot = find_robot(s, id)) robot->run = kNoRun;
    }
  }
  s.runs.clear();
  tell(turn, Kind::kStepEnded, fmt::format("{} {}", step_text(s), name(outcome)));
}

void end_mission_done(Turn& turn) {
  end_mission(turn, Outcome::kDone, "mission done");
}

// After a step or typed commands that were done.
void begin_next(Turn& turn) {
  State& s = turn.state;
  const bool was_typed = std::exchange(s.typed, false);
  if (was_typed && !s.goes_on) {
    s.mode = State::Mode::kIdle;
    return;
  }
  s.goes_on = false;
  if (!was_typed) ++s.step;
  if (s.step >= s.mission->steps.size()) {
    end_mission_done(turn);
    return;
  }
  if (std::exchange(s.single, false))
    s.mode = State::Mode::kIdle;
  else
    begin_step(turn, s.step);
}

// Ends the run, or asks for clearance, where its robots are done.
void settle(Turn& turn, Run& run) {
  const bool robots_done = run.missing == 0;
  if (run.phase == Run::Phase::kTeleoperation && (robots_done || turn.state.options.proceed_all)) {
    if (!robots_done)
      message(turn,
              fmt::format("{}: nobody steers, taken as complete", turn.state.commands[run.record].text));
    complete(turn, run);
    return;
  }
  if (run.phase != Run::Phase::kRobots || !robots_done || holds_at_line(run)) return;
  if (run.command->task == percept::Task::kOccupy)
    ask_to_proceed(turn, run);
  else
    complete(turn, run);
}

// The other commands of a step that ends before they are done.
void end_others(Turn& turn) {
  for (Run& run : turn.state.runs) {
    if (run.phase == Run::Phase::kEnded) continue;
    run.phase = Run::Phase::kEnded;
    end_command(turn, run.record, Outcome::kAborted, {});
  }
}

bool shares_robots(const Run& run, const std::vector<base::RobotId>& sorted) {
  return std::ranges::any_of(run.needed,
                             [&](base::RobotId id) { return std::ranges::binary_search(sorted, id); });
}

}  // namespace

void begin_step(Turn& turn, std::uint32_t step) {
  State& s = turn.state;
  s.mode = State::Mode::kRunning;
  s.typed = s.goes_on = false;
  s.step = step;
  const Step& planned = s.mission->steps[step];
  begin_record(turn, planned.label, step);
  tell(turn, Kind::kStepStarted, step_text(s));
  begin_commands(turn, planned.commands, s.mission);
}

void begin_typed(Turn& turn, const std::vector<Command>& commands) {
  State& s = turn.state;
  s.mode = State::Mode::kRunning;
  s.typed = true;
  begin_record(turn, {}, kNoStep);
  tell(turn, Kind::kStepStarted, step_text(s));
  const auto kept = std::make_shared<const std::vector<Command>>(commands);
  begin_commands(turn, *kept, kept);
}

void go_on(Turn& turn) {
  State& s = turn.state;
  while (s.mode == State::Mode::kRunning) {
    for (Run& run : s.runs) settle(turn, run);
    if (!std::ranges::all_of(s.runs, [](const Run& run) { return run.phase == Run::Phase::kEnded; })) return;
    close_step(turn, Outcome::kDone);
    begin_next(turn);
  }
}

void end_command(Turn& turn, std::uint32_t record, Outcome outcome, const std::string& why) {
  CommandRecord& c = turn.state.commands[record];
  c.outcome = outcome;
  c.end = turn.state.time;
  c.message = why;
  std::string text = fmt::format("{}{} {}", step_prefix(turn.state), c.text, name(outcome));
  if (!why.empty()) text += ": " + why;
  tell(turn, Kind::kCommandEnded, std::move(text), record);
}

void complete(Turn& turn, Run& run) {
  run.phase = Run::Phase::kEnded;
  end_command(turn, run.record, Outcome::kDone, {});
  if (!run.command->on_completion.empty()) {
    message(turn, fmt::format("{}: {}", turn.state.commands[run.record].unit, run.command->on_completion));
  }
}

void fail(Turn& turn, Run& run, const std::string& why) {
  State& s = turn.state;
  run.phase = Run::Phase::kEnded;
  end_command(turn, run.record, Outcome::kFailed, why);
  end_others(turn);
  const std::string text = step_text(s);
  close_step(turn, Outcome::kFailed);
  const bool in_mission = !s.typed || s.goes_on;
  s.typed = s.goes_on = s.single = false;
  if (in_mission) {
    const std::uint32_t step = s.step;
    end_mission(turn, Outcome::kFailed, fmt::format("mission failed at {}", text));
    s.step = std::min(step, static_cast<std::uint32_t>(s.mission->steps.size()));
  } else {
    s.mode = State::Mode::kIdle;
  }
}

void abandon_step(Turn& turn, Outcome outcome, const std::vector<base::RobotId>& taken) {
  State& s = turn.state;
  if (s.mode != State::Mode::kRunning) return;
  for (Run& run : s.runs) {
    if (run.phase == Run::Phase::kEnded) continue;
    run.phase = Run::Phase::kEnded;
    const bool replaced = outcome != Outcome::kReplaced || shares_robots(run, taken);
    end_command(turn, run.record, replaced ? outcome : Outcome::kSkipped, {});
  }
  close_step(turn, outcome);
  s.typed = false;
}

void abort_mission(Turn& turn) {
  State& s = turn.state;
  if (std::exchange(s.paused, false)) emit(turn, effect::PauseRobots{false});
  abandon_step(turn, Outcome::kAborted);
  for (RobotState& robot : s.robots) stop_robot(turn, robot);
  end_mission(turn, Outcome::kAborted, "mission aborted");
}

void quit(Turn& turn) {
  State& s = turn.state;
  if (s.mode == State::Mode::kRunning) {
    end_others(turn);
    close_step(turn, Outcome::kDone);
  }
  end_mission(turn, Outcome::kDone, "mission done: QUIT");
  s.mode = State::Mode::kQuit;
  emit(turn, effect::Quit{});
}

void end_mission(Turn& turn, Outcome outcome, const std::string& text) {
  State& s = turn.state;
  tell(turn, Kind::kMissionEnded, text);
  s.mode = State::Mode::kIdle;
  s.outcome = outcome;
  s.step = 0;
  s.single = s.typed = s.goes_on = false;
}

}  // namespace mlab::mission
