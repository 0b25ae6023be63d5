#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mlab/base/random.h"
#include "mlab/mission/command.h"
#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary
// Some robots, in any order; few of them, robot 7 among them, may not exist.
void name_robots(base::Random& random, UnitCommand& c) {
  c.unit = kNoUnit;
  for (std::uint32_t id = 1; id <= 7; ++id) {
    if (random.below(3) == 0)
      c.robots.insert(c.robots.begin() + static_cast<std::ptrdiff_t>(random.below(c.robots.size() + 1)),
                      {id});
  }
}

// A unit command of any kind, with all that the grammar lets it have and more.
UnitCommand any_command(base::Random& random, std::uint32_t units) {
  const geom::Point goal{random.uniform(0, 1000), random.uniform(0, 1000)};
  UnitCommand c = command(static_cast<std::uint32_t>(random.below(units)),
                          static_cast<Task>(random.below(kTasks.size())), "P", goal);
  if (random.below(4) == 0) name_robots(random, c);
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
      return event::TeleoperationComplete{id(static_cast<std::uint32_t>(state.commands.size()))};
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
    return fmt::format("teleoperate {}", e.command);
  }
  std::string operator()(const effect::Tell& e) const { return fmt::format("{} {}", e.step, e.text); }
};

std::string describe(const std::vector<Effect>& effects) {
  std::string text;
  for (const Effect& effect : effects) text += std::visit(Describe{}, effect) + "\n";
  return text;
}

// What runs has a record that runs and something to wait for; what doesn't run has neither.
void expect_reasons_to_wait(const State& s) {
  const bool runs = s.mode == State::Mode::kRunning;
  RC_ASSERT(runs != waits_for(s).empty());
  RC_ASSERT((runs || s.runs.empty()));
  RC_ASSERT((s.in_step || s.is_ending || !s.runs.empty()) == runs);
  for (std::uint32_t i = 0; i < s.steps.size(); ++i) {
    const bool has_command = std::ranges::any_of(
        s.runs, [&](const Run& run) { return run.owner == i && run.phase != Run::Phase::kEnded; });
    RC_ASSERT((s.steps[i].outcome == Outcome::kRunning) == has_command);
    const bool is_the_step = s.in_step && i == s.step_record;
    RC_ASSERT((!has_command || is_the_step || s.steps[i].step == kNoStep));
  }
  RC_ASSERT(std::ranges::is_sorted(s.runs, {}, [](const Run& run) { return run.owner; }));
}

bool is_under(const State& s, const Run& run, base::RobotId id) {
  const auto robot = std::ranges::find(s.robots, id, &RobotState::id);
  return robot != s.robots.end() && robot->run == static_cast<std::size_t>(&run - s.runs.data());
}

void expect_exact_counts(const State& s) {
  for (const Run& run : s.runs) {
    const bool asks = std::ranges::any_of(
        s.questions, [&](const Question& q) { return q.robot.value == 0 && &s.runs.at(q.run) == &run; });
    RC_ASSERT((run.phase != Run::Phase::kProceed || asks));
    RC_ASSERT((run.phase != Run::Phase::kEnded || !asks));
    if (run.phase == Run::Phase::kEnded) continue;
    const auto undone = std::ranges::count_if(run.needed, [&](base::RobotId id) {
      return !is_under(s, run, id) || !std::ranges::find(s.robots, id, &RobotState::id)->done;
    });
    RC_ASSERT(run.missing == static_cast<std::size_t>(undone));
    const bool waits_for_time = run.command->task == Task::kPatrol && run.ends;
    if (run.phase == Run::Phase::kRobots && run.missing == 0 && !s.paused && !waits_for_time) {
      RC_ASSERT(std::ranges::any_of(
          run.lines, [](const LineState& l) { return l.phase == LineState::Phase::kHolding; }));
    }
  }
}

// Commands of different owners that are under way never want the same robot; those of the plan wait for
// orders.
void expect_one_owner_for_each_robot(const State& s) {
  for (const Run& run : s.runs) {
    if (run.phase == Run::Phase::kEnded) continue;
    bool is_held_up = false;
    for (const Run& other : s.runs) {
      if (&other == &run || other.phase == Run::Phase::kEnded || other.phase == Run::Phase::kHeld) continue;
      const bool shares = std::ranges::any_of(run.needed, [&](base::RobotId id) {
        return std::ranges::find(other.needed, id) != other.needed.end();
      });
      RC_ASSERT((!shares || run.phase == Run::Phase::kHeld));
      is_held_up |= shares;
    }
    if (run.phase != Run::Phase::kHeld) continue;
    RC_ASSERT((s.in_step && run.owner == s.step_record));
    RC_ASSERT((is_held_up || s.paused));
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
    expect_exact_counts(state);
    expect_one_owner_for_each_robot(state);
    expect_orders_in_order(state);
  }
}

// An order changes nothing of commands whose robots it does not name.
RC_GTEST_PROP(ExecutiveLaws, AnOrderEndsOnlyWhatItsOwnRobotsDo, (std::uint64_t seed)) {
  base::Random random(seed);
  State state = initial_state(any_mission(random), {.patience = 30.0});
  for (int i = 0; i < 100; ++i) {
    const Event event = any_event(random, state);
    if (std::holds_alternative<event::Edited>(event)) continue;
    const auto* typed = std::get_if<event::Typed>(&event);
    const State before = state;
    state = advance(std::move(state), event).state;
    if (typed == nullptr) continue;
    for (const Run& run : before.runs) {
      if (run.phase == Run::Phase::kHeld) continue;
      const bool is_touched = std::ranges::any_of(typed->commands, [&](const Command& c) {
        const auto* command = std::get_if<UnitCommand>(&c);
        if (command == nullptr) return false;
        const auto& named = members_of(*before.mission, *command);
        return std::ranges::any_of(
            run.needed, [&](base::RobotId id) { return std::ranges::find(named, id) != named.end(); });
      });
      const auto now = std::ranges::find(state.runs, run.record, &Run::record);
      if (is_touched || now == state.runs.end()) continue;
      RC_ASSERT(now->needed == run.needed);
      RC_ASSERT(now->parts == run.parts);
      RC_ASSERT((now->phase != Run::Phase::kEnded ||
                 state.commands[run.record].outcome != Outcome::kReplaced ||
                 run.phase == Run::Phase::kEnded));
    }
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
    const auto commands = static_cast<std::uint32_t>(state.commands.size());
    for (std::uint32_t command = commands - std::min(commands, 20U); command < commands; ++command)
      state = advance(std::move(state), event::TeleoperationComplete{command}).state;
  }
  RC_ASSERT(state.mode != State::Mode::kRunning);
}

}  // namespace
}  // namespace mlab::mission
