#include "mlab/mission/operator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "mlab/mission/question.h"
#include "mlab/mission/step.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

void set_paused(Turn& turn, bool paused) {
  if (turn.state.paused == paused) return;
  turn.state.paused = paused;
  emit(turn, effect::PauseRobots{paused});
}

// Starts the step, or ends the mission where there is none.
void start_at(Turn& turn, std::size_t step) {
  State& s = turn.state;
  s.outcome = Outcome::kRunning;
  s.step = static_cast<std::uint32_t>(std::min(step, s.mission->steps.size()));
  if (s.step == s.mission->steps.size())
    end_plan(turn);
  else
    begin_step(turn, s.step);
  go_on(turn);  // robots may have got done in a pause that this ends
}

bool moves_units(const std::vector<Command>& commands) {
  return std::ranges::any_of(commands,
                             [](const Command& c) { return std::holds_alternative<UnitCommand>(c); });
}

bool knows_units(const Mission& mission, const std::vector<Command>& commands) {
  return std::ranges::all_of(commands, [&](const Command& command) {
    const auto* c = std::get_if<UnitCommand>(&command);
    return c == nullptr || c->unit == kNoUnit || c->unit < mission.units.size();
  });
}

// A typed command that needs no robots, beside whatever runs.
void act_now(Turn& turn, const Command& command) {
  if (std::holds_alternative<Quit>(command)) {
    quit(turn);
    return;
  }
  message(turn, "typed: " + command_text(*turn.state.mission, command));
  if (const auto* boolean = std::get_if<SetBoolean>(&command))
    emit(turn, effect::Set{*boolean});
  else if (const auto* number = std::get_if<SetNumber>(&command))
    emit(turn, effect::Set{*number});
  else if (const auto* print = std::get_if<Print>(&command))
    emit(turn, effect::Print{print->robot_info});
}

// The robots of the edited plan; those that it no longer has stay known as long as they are under an order.
std::vector<RobotState> merge_robots(const State& state, const Mission& edited) {
  std::vector<RobotState> robots;
  for (const RobotState& robot : state.robots) {
    const bool stays = std::ranges::binary_search(edited.robots, robot.id, {}, &Robot::id);
    if (stays || robot.life != RobotState::Life::kNotStarted || robot.run != kNoRun || robot.seen != 0)
      robots.push_back(robot);
  }
  for (const Robot& robot : edited.robots) {
    if (find_robot(state, robot.id) != nullptr) continue;
    RobotState added;
    added.id = robot.id;
    robots.push_back(added);
  }
  std::ranges::sort(robots, {}, &RobotState::id);
  return robots;
}

// The step of that label in the edited plan, the one at the old place before others; none: past the end.
std::size_t step_labelled(const Mission& mission, const std::string& label, std::size_t old_place) {
  if (old_place < mission.steps.size() && mission.steps[old_place].label == label) return old_place;
  const auto at = std::ranges::find(mission.steps, label, &Step::label);
  return static_cast<std::size_t>(at - mission.steps.begin());
}

// Units keep their meaning for commands that run, by name.
void rename_units(State& state, const Mission& edited) {
  for (Run& run : state.runs) {
    if (run.unit == kNoUnit) continue;
    const std::string& wanted = state.commands[run.record].unit;
    std::uint32_t unit = 0;
    while (unit < edited.units.size() && unit_name(edited, unit) != wanted) ++unit;
    run.unit = unit;
  }
}

}  // namespace

void handle(Turn& turn, const event::Execute&) {
  State& s = turn.state;
  set_paused(turn, false);
  if (!s.in_step && !s.is_ending) {
    start_at(turn, s.step);
    return;
  }
  s.single = false;
  go_on(turn);
}

void handle(Turn& turn, const event::Pause&) {
  set_paused(turn, true);
}
void handle(Turn& turn, const event::Resume&) {
  set_paused(turn, false);
  go_on(turn);  // robots may have got done in the meantime
}

void handle(Turn& turn, const event::SingleStep&) {
  State& s = turn.state;
  const bool in_step = s.in_step;
  abandon_step(turn, Outcome::kSkipped);
  if (!in_step) s.single = true;
  start_at(turn, in_step ? s.step + 1 : s.step);
}

void handle(Turn& turn, const event::StopAfterStep&) {
  if (turn.state.in_step) turn.state.single = true;
}

void handle(Turn& turn, const event::Jump& event) {
  State& s = turn.state;
  if (event.step >= s.mission->steps.size()) {
    warn(turn, "there is no such step to go to");
    return;
  }
  if (!s.in_step && !s.is_ending) {
    s.step = event.step;
    return;
  }
  abandon_step(turn, Outcome::kSkipped);
  start_at(turn, event.step);
}

void handle(Turn& turn, const event::Rewind&) {
  State& s = turn.state;
  abandon_step(turn, Outcome::kSkipped);
  s.single = s.is_ending = false;
  s.step = 0;
  rest(turn);
}

void handle(Turn& turn, const event::Abort&) {
  abort_mission(turn);
}

void handle(Turn& turn, const event::Answer& event) {
  answer(turn, event.question, event.proceed);
  go_on(turn);
}

void handle(Turn& turn, const event::RobotAsks& event) {
  ask_for_robot(turn, event.robot);
}

void handle(Turn& turn, const event::Typed& event) {
  State& s = turn.state;
  if (!knows_units(*s.mission, event.commands)) {
    warn(turn, "typed: no such unit");
    return;
  }
  if (!moves_units(event.commands)) {
    for (const Command& command : event.commands) {
      if (s.mode != State::Mode::kQuit) act_now(turn, command);
    }
    return;
  }
  begin_order(turn, event.commands);
  go_on(turn);
}

void handle(Turn& turn, const event::Edited& event) {
  State& s = turn.state;
  if (event.mission == nullptr || event.mission == s.mission) return;
  const bool in_step = s.in_step;
  std::string label;
  if (s.step < s.mission->steps.size()) label = s.mission->steps[s.step].label;
  const std::size_t step = step_labelled(*event.mission, label, s.step);
  const bool gone = step >= event.mission->steps.size();
  if (in_step && gone) {
    abandon_step(turn, Outcome::kSkipped);
    s.single = false;
    warn(turn, fmt::format("step {} is no longer in the plan; execution stops", label));
  }
  rename_units(s, *event.mission);
  s.robots = merge_robots(s, *event.mission);
  s.mission = event.mission;
  s.step = gone ? std::min(s.step, static_cast<std::uint32_t>(s.mission->steps.size()))
                : static_cast<std::uint32_t>(step);
}

void handle(Turn& turn, const event::TeleoperationComplete& event) {
  for (Run& run : turn.state.runs) {
    if (run.phase == Run::Phase::kTeleoperation && run.record == event.command) complete(turn, run);
  }
  go_on(turn);
}

}  // namespace mlab::mission
