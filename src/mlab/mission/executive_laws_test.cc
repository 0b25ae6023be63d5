#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mlab/base/random.h"
#include "mlab/mission/executive.h"
#include "mlab/mission/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary
using percept::Task;

// A unit command of any kind, with all that the grammar lets it have and more.
UnitCommand any_command(base::Random& random, std::uint32_t units) {
  const geom::Point goal{random.uniform(0, 1000), random.uniform(0, 1000)};
  UnitCommand c = command(static_cast<std::uint32_t>(random.below(units)),
                          static_cast<Task>(1 + random.below(7)), "P", goal);
  c.technique = static_cast<Technique>(random.below(3));
  c.formation = static_cast<percept::Formation>(random.below(percept::kFormationCount));
  for (std::uint64_t n = random.below(4); n > 0; --n)
    c.route.push_back({random.uniform(0, 1000), random.uniform(0, 1000)});
  const auto any_time = [&] {
    return MissionTime{static_cast<MissionTime::Kind>(random.below(4)), random.uniform(-100, 1000)};
  };
  if (random.below(2) == 0) c.until = any_time();
  if (random.below(2) == 0) c.on_completion = "there";
  for (std::uint64_t n = random.below(3); n > 0; --n) {
    PhaseLine& line = c.phase_lines.emplace_back();
    for (std::uint64_t k = random.below(3); k > 0; --k)
      line.points.push_back({random.uniform(0, 1000), random.uniform(0, 1000)});
    line.radius = random.uniform(0, 100);
    if (random.below(2) == 0) line.not_before = any_time();
    line.waits = random.below(2) == 0;
  }
  return c;
}

std::vector<Command> any_commands(base::Random& random, std::uint32_t units) {
  std::vector<Command> commands;
  for (std::uint64_t n = 1 + random.below(3); n > 0; --n) {
    switch (random.below(20)) {
      case 0:
        commands.emplace_back(SetBoolean{});
        break;
      case 1:
        commands.emplace_back(Print{});
        break;
      default:
        commands.emplace_back(any_command(random, units));
    }
  }
  return commands;
}

std::shared_ptr<const Mission> any_mission(base::Random& random) {
  MissionMaker m;
  const auto a = m.unit("a", 2);
  const auto b = m.unit("b", 3);
  const auto ab = m.unit("ab", {a, b});
  m.unit("c", 1);
  m.step({start(ab, {100, 100}, {10, 10})});
  for (std::uint64_t n = random.below(6); n > 0; --n)
    m.step(std::to_string(random.below(4)), any_commands(random, 4));
  return m.make();
}

// Robots as they come: most report, some are done, some speak of other orders or of nothing at all.
event::Cycle any_cycle(base::Random& random, const State& state) {
  event::Cycle cycle;
  cycle.time = state.time + (random.below(20) == 0 ? -5.0 : random.uniform(0.0, 2.0));
  for (const RobotState& robot : state.robots) {
    if (random.below(10) == 0) continue;
    RobotReport report;
    report.id = robot.id;
    report.is_running = random.below(10) != 0;
    report.sequence = random.below(5) == 0 ? robot.sequence - 1 : robot.sequence;
    report.done = random.below(3) == 0;
    report.remaining = random.below(20) == 0 ? std::nan("") : random.uniform(0.0, 100.0);
    report.pose.position = {random.uniform(0, 1000),
                            random.below(20) == 0 ? std::nan("") : random.uniform(0, 1000)};
    cycle.robots.push_back(report);
  }
  if (random.below(20) == 0) cycle.robots.emplace_back().id = {99};
  return cycle;
}

Event any_event(base::Random& random, const State& state) {
  const auto id = [&](std::uint32_t last) { return static_cast<std::uint32_t>(random.below(last + 2)); };
  switch (random.below(30)) {
    case 0:
      return event::Pause{};
    case 1:
      return event::Resume{};
    case 2:
      return event::SingleStep{};
    case 3:
      return event::Jump{id(5)};
    case 4:
      return event::Rewind{};
    case 5:
      return event::Abort{};
    case 6:
      return event::Typed{any_commands(random, 5)};
    case 7:
      return event::Edited{random.below(4) == 0 ? nullptr : any_mission(random)};
    case 8:
      return event::TeleoperationComplete{id(4)};
    case 29:
      return event::StopAfterStep{};
    case 9:
    case 10:
    case 11:
      return event::Execute{};
    case 12:
    case 13:
    case 14:
    case 15:
      return event::Answer{id(state.last_question), random.below(8) != 0};
    default:
      return any_cycle(random, state);
  }
}

// All of an effect that can be told apart.
struct Describe {
  std::string operator()(const effect::Start& e) const {
    return fmt::format("start {} {}", e.robot.value, e.pose.position.x);
  }
  std::string operator()(const effect::Order& e) const {
    std::string text = fmt::format("order {} {} {} {}:", e.order.sequence, static_cast<int>(e.order.task),
                                   e.order.goal.x, e.order.halted);
    for (const base::RobotId id : e.members) text += fmt::format(" {}", id.value);
    for (const geom::Point p : e.order.route) text += fmt::format(" {},{}", p.x, p.y);
    return text;
  }
  std::string operator()(const effect::Stop& e) const { return fmt::format("stop {}", e.robot.value); }
  std::string operator()(const effect::Set&) const { return "set"; }
  std::string operator()(const effect::Print&) const { return "print"; }
  std::string operator()(const effect::Quit&) const { return "quit"; }
  std::string operator()(const effect::PauseRobots& e) const { return fmt::format("pause {}", e.paused); }
  std::string operator()(const effect::Ask& e) const {
    return fmt::format("ask {} {} {}", e.question, e.text, e.expires.value_or(-1));
  }
  std::string operator()(const effect::LetProceed& e) const {
    return fmt::format("proceed {}", e.robot.value);
  }
  std::string operator()(const effect::Withdraw& e) const { return fmt::format("withdraw {}", e.question); }
  std::string operator()(const effect::OpenTeleoperation& e) const {
    return fmt::format("teleoperate {}", e.unit);
  }
  std::string operator()(const effect::Tell& e) const { return fmt::format("{} {}", e.step, e.text); }
};

std::string describe(const std::vector<Effect>& effects) {
  std::string text;
  for (const Effect& effect : effects) text += std::visit(Describe{}, effect) + "\n";
  return text;
}

void expect_reasons_to_wait(const State& s) {
  if (s.mode == State::Mode::kRunning) {
    RC_ASSERT(!waits_for(s).empty());
    RC_ASSERT(s.steps.back().outcome == Outcome::kRunning);
  } else {
    RC_ASSERT(s.runs.empty());
    RC_ASSERT(s.questions.empty());
    RC_ASSERT((s.steps.empty() || s.steps.back().outcome != Outcome::kRunning));
  }
  for (const Run& run : s.runs) {
    const auto undone = std::ranges::count_if(run.needed, [&](base::RobotId id) {
      const auto robot = std::ranges::find(s.robots, id, &RobotState::id);
      return robot->run != static_cast<std::size_t>(&run - s.runs.data()) || !robot->done;
    });
    // A robot that was done before another command of the step took it stays counted as done.
    RC_ASSERT(run.missing <= static_cast<std::size_t>(undone));
    const bool asks =
        std::ranges::any_of(s.questions, [&](const Question& q) { return &s.runs[q.run] == &run; });
    RC_ASSERT((run.phase != Run::Phase::kProceed || asks));
    RC_ASSERT((run.phase != Run::Phase::kEnded || !asks));
    if (run.phase == Run::Phase::kRobots && run.missing == 0 && !s.paused) {
      RC_ASSERT(std::ranges::any_of(
          run.lines, [](const LineState& l) { return l.phase == LineState::Phase::kHolding; }));
    }
  }
}

void expect_orders_in_order(const State& s) {
  RC_ASSERT(std::ranges::is_sorted(s.groups, {}, &Group::sequence));
  std::size_t ordered = 0;
  for (const Group& group : s.groups) {
    RC_ASSERT(!group.members.empty());
    for (const base::RobotId id : group.members) {
      const auto robot = std::ranges::find(s.robots, id, &RobotState::id);
      RC_ASSERT(robot != s.robots.end());
      RC_ASSERT(robot->sequence == group.sequence);
      ++ordered;
    }
  }
  RC_ASSERT(ordered == static_cast<std::size_t>(std::ranges::count_if(
                           s.robots, [](const RobotState& r) { return r.sequence != 0; })));
}

RC_GTEST_PROP(ExecutiveLaws, AnyEventsLeaveAStateThatKnowsWhatItWaitsFor, (std::uint64_t seed)) {
  base::Random random(seed);
  State state = initial_state(any_mission(random), {.patience = 30.0, .epoch_seconds = 100.0});
  for (int i = 0; i < 200; ++i) {
    const Event event = any_event(random, state);
    state = advance(std::move(state), event).state;
    expect_reasons_to_wait(state);
    expect_orders_in_order(state);
  }
}

RC_GTEST_PROP(ExecutiveLaws, TheSameEventsGiveTheSameStatesAndEffects,
              (std::uint64_t seed, bool proceed_all)) {
  base::Random random(seed);
  const auto mission = any_mission(random);
  State state = initial_state(mission, {.proceed_all = proceed_all, .patience = 30.0});
  std::vector<Event> journal;
  std::vector<std::string> effects;
  for (int i = 0; i < 150; ++i) {
    journal.push_back(any_event(random, state));
    const State before = state;
    Advance next = advance(std::move(state), journal.back());
    const Advance again = advance(before, journal.back());
    RC_ASSERT(again.state == next.state);
    effects.push_back(describe(next.effects));
    RC_ASSERT(describe(again.effects) == effects.back());
    state = std::move(next.state);
  }
  State replayed = initial_state(mission, state.options);
  for (std::size_t i = 0; i < journal.size(); ++i) {
    Advance next = advance(std::move(replayed), journal[i]);
    RC_ASSERT(describe(next.effects) == effects[i]);
    replayed = std::move(next.state);
  }
  RC_ASSERT(replayed == state);
}

// Whatever happened before: with an operator who answers, every run comes to an end, even if no robot ever
// reports.
RC_GTEST_PROP(ExecutiveLaws, EveryRunEnds, (std::uint64_t seed, bool robots_report)) {
  base::Random random(seed);
  State state = initial_state(any_mission(random), {.patience = 30.0});
  for (int i = 0; i < 60; ++i) {
    const Event event = any_event(random, state);
    state = advance(std::move(state), event).state;
  }
  state = advance(std::move(state), event::Resume{}).state;
  for (int i = 0; i < 5000 && state.mode == State::Mode::kRunning; ++i) {
    event::Cycle cycle = any_cycle(random, state);
    cycle.time = state.time + 1.0;
    if (!robots_report) cycle.robots.clear();
    state = advance(std::move(state), cycle).state;
    const std::vector<Question> questions = state.questions;
    for (const Question& q : questions) state = advance(std::move(state), event::Answer{q.id, true}).state;
    for (std::uint32_t unit = 0; unit < 5; ++unit)
      state = advance(std::move(state), event::TeleoperationComplete{unit}).state;
  }
  RC_ASSERT(state.mode != State::Mode::kRunning);
}

}  // namespace
}  // namespace mlab::mission
