#include "mlab/mission/executive.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "mlab/mission/dispatch.h"
#include "mlab/mission/operator.h"
#include "mlab/mission/phase_line.h"
#include "mlab/mission/progress.h"
#include "mlab/mission/turn.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

struct Handle {
  Turn& turn;
  void operator()(const event::Cycle& event) const { take_cycle(turn, event); }
  template <class T>
  void operator()(const T& event) const {
    handle(turn, event);
  }
};

// Every robot that the run still waits for has asked something by itself.
bool awaits_robots_that_ask(const State& state, const Run& run) {
  if (run.missing == 0) return false;
  const std::uint32_t index = index_of(state, run);
  return std::ranges::all_of(state.robots, [&](const RobotState& robot) {
    return robot.done || robot.run != index ||
           std::ranges::find(state.questions, robot.id, &Question::robot) != state.questions.end();
  });
}

// A command that waits for orders needs what these need.
bool needs_only_an_answer(const State& state, const Run& run) {
  if (run.phase == Run::Phase::kProceed || run.phase == Run::Phase::kHeld) return true;
  if (run.ends) return false;
  if (run.phase != Run::Phase::kRobots) return false;
  if (awaits_robots_that_ask(state, run)) return true;
  for (std::size_t i = 0; i < run.lines.size(); ++i) {
    const LineState& line = run.lines[i];
    if (line.phase != LineState::Phase::kHolding) continue;
    const bool early = line.not_before && *line.not_before > state.time;
    if (!early && run.command->phase_lines[i].waits && !line.acknowledged) return true;
  }
  return false;
}

}  // namespace

State initial_state(std::shared_ptr<const Mission> mission, const ExecutiveOptions& options) {
  State state;
  state.mission = std::move(mission);
  state.options = options;
  state.robots.reserve(state.mission->robots.size());
  for (const Robot& robot : state.mission->robots) state.robots.emplace_back().id = robot.id;
  return state;
}

void hold_until(State& state, double time) {
  state.time = std::max(state.time, time);
}

Advance advance(State state, const Event& event) {
  std::vector<Effect> effects = advance_in_place(state, event);
  return {std::move(state), std::move(effects)};
}

std::vector<Effect> advance_in_place(State& state, const Event& event) {
  std::vector<Effect> effects;
  if (state.mode == State::Mode::kQuit) return effects;
  Turn turn{.state = state, .effects = effects, .elapsed = 0.0, .shrunk = {}};
  std::visit(Handle{turn}, event);
  repair_groups(turn);
  return effects;
}

bool awaits_only_operator(const State& state) {
  if (state.mode != State::Mode::kRunning || state.questions.empty()) return false;
  const auto expires = [](const Question& question) { return question.expires.has_value(); };
  if (std::ranges::any_of(state.questions, expires)) return false;
  return std::ranges::all_of(state.runs, [&](const Run& run) {
    return run.phase == Run::Phase::kEnded || needs_only_an_answer(state, run);
  });
}

std::vector<std::string> waits_for(const State& state) {
  std::vector<std::string> lines;
  for (const Run& run : state.runs) {
    if (run.phase == Run::Phase::kEnded) continue;
    lines.push_back(fmt::format("{}: {}", state.commands[run.record].text, waiting_text(state, run)));
  }
  return lines;
}

std::vector<effect::Order> standing_orders(const State& state) {
  std::vector<effect::Order> orders;
  for (const Group& group : state.groups) orders.push_back(order_of(group));
  return orders;
}

}  // namespace mlab::mission
