#include "mlab/console/session/run_orders.h"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/console/published/status_encoder.h"
#include "mlab/console/run/held_values.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"

namespace mlab::console {
namespace {

namespace event = mission::event;

std::string name_of(Control::Action action) {
  std::string name = Control::Action_Name(action);
  std::ranges::replace(name, '_', ' ');
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

bool is_running(const mission::State& state) {
  return state.mode == mission::State::Mode::kRunning;
}

// Where they are is where the stick takes over.
void teleoperate(const run::MissionRun& run, mission::UnitCommand& command) {
  command.task = mission::Task::kTeleoperate;
  const auto& members = mission::members_of(run.mission(), command);
  const fleet::FleetRobot* leader = members.empty() ? nullptr : run.fleet().find(members.front());
  if (leader != nullptr) command.goal = run.fleet().pose(*leader).position;
}

// Of what is not started anything may move then.
bool moves_robots(const Control& control) {
  switch (control.action()) {
    case Control::EXECUTE:
    case Control::RESUME:
    case Control::SINGLE_STEP:
    case Control::SKIP_STEP:
    case Control::SINGLE_CYCLE:
    case Control::JUMP:
      return true;
    default:
      return false;
  }
}

bool has_running_robot(const run::MissionRun& run, const mission::UnitCommand& command) {
  return std::ranges::any_of(mission::members_of(run.mission(), command), [&](base::RobotId id) {
    const fleet::FleetRobot* robot = run.fleet().find(id);
    return robot != nullptr && robot->life == fleet::RobotLife::kRunning;
  });
}

}  // namespace

// ---- what it does next

Answered RunOrders::why_not(const Control& control) const {
  if (auto refused = run_.why_not_now()) return refused;
  const run::MissionRun& run = run_.live()->run();
  const mission::State& state = run.state();
  const std::size_t steps = state.mission->steps.size();
  switch (control.action()) {
    case Control::JUMP:
      if (control.step() >= steps) return fmt::format("there is no step {} in this mission", control.step());
      if (mode_of(run) == Status::ENDED) return "the mission has ended: restart it first";
      return std::nullopt;
    case Control::PAUSE:
      if (!is_running(state)) return "nothing runs";
      return std::nullopt;
    case Control::SKIP_STEP:
      if (!state.in_step && state.step + 1 >= steps) return "there is no step after this one";
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

Answered RunOrders::control(const Sender& sender, const Control& control) {
  const std::string& who = sender.client.name;
  if (!Control::Action_IsValid(control.action())) return "this control is not known here";
  if (control.action() == Control::RELEASE_STOP) {
    if (!run_.is_stopped()) return "there is no emergency stop";
    run_.release_stop(who);
    return std::nullopt;
  }
  if (auto refused = why_not(control)) return refused;
  if (moves_robots(control)) {
    if (auto refused = run_.why_not_start()) return refused;
  }
  const run::MissionRun& run = run_.live()->run();
  const bool has_ended = mode_of(run) == Status::ENDED;
  if (has_ended && control.action() != Control::ABORT) run_.forget_earlier_run();
  run_.note(who, control.action() == Control::JUMP
                     ? fmt::format("jump to step {}", clean(run.state().mission->steps[control.step()].label))
                     : name_of(control.action()));
  carry_out(control);
  return std::nullopt;
}

void RunOrders::carry_out(const Control& control) {
  switch (control.action()) {
    case Control::EXECUTE:
      before_execute_();
      run_.post(event::Execute{});
      break;
    case Control::PAUSE:
      run_.post(event::Pause{});
      break;
    case Control::RESUME:
      resume();
      break;
    case Control::SINGLE_STEP:
      single_step();
      break;
    case Control::SKIP_STEP:
      skip_step();
      break;
    case Control::SINGLE_CYCLE:
      single_cycle();
      break;
    case Control::JUMP:
      run_.post(event::Jump{control.step()});
      break;
    case Control::REWIND:
      run_.post(event::Rewind{});
      break;
    case Control::ABORT:
      run_.post(event::Abort{});
      break;
    default:
      break;
  }
}

void RunOrders::resume() {
  if (is_running(run_.live()->run().state()))
    run_.post(event::Resume{});
  else
    run_.post(event::Execute{});
}

// What runs is finished, and then nothing goes on by itself.
void RunOrders::single_step() {
  const mission::State& state = run_.live()->run().state();
  if (!state.in_step) {
    run_.post(event::SingleStep{});
    return;
  }
  run_.post(event::StopAfterStep{});
  if (state.paused) run_.post(event::Resume{});
}

void RunOrders::skip_step() {
  const mission::State& state = run_.live()->run().state();
  if (!state.in_step)
    run_.post(event::Jump{state.step + 1});
  else
    run_.post(event::SingleStep{});
}

// One cycle, whatever the run was doing before; afterwards it is paused.
void RunOrders::single_cycle() {
  const mission::State& state = run_.live()->run().state();
  if (!is_running(state))
    run_.post(event::Execute{});
  else if (state.paused)
    run_.post(event::Resume{});
  run_.step_once();
  if (is_running(state) && !state.paused) run_.post(event::Pause{});
  run_.world_changed();
}

Answered RunOrders::set_speed(const Sender& sender, const SetSpeed& set) {
  if (run_.live() != nullptr && run_.live()->run().is_in_real_time())
    return "the robots are not waited for: time passes as on the clock, no faster and no slower";
  const double speed = set.speed();
  const bool is_allowed = speed == 0.0 || (speed >= run::Pace::kSlowest && speed <= run::Pace::kFastest);
  if (!is_allowed)
    return fmt::format("the speed is a number from {} to {}, or 0 for as fast as it goes",
                       run::Pace::kSlowest, run::Pace::kFastest);
  run_.set_speed(speed);
  run_.note(sender.client.name, speed == 0.0 ? "speed max" : fmt::format("speed {}", speed));
  return std::nullopt;
}

Answered RunOrders::answer(const Sender& sender, const Answer& answer) {
  const LiveRun* live = run_.live();
  if (live == nullptr || run_.is_stopped()) return run_.why_not_now();
  const auto& questions = live->run().state().questions;
  const auto open = std::ranges::find(questions, answer.question(), &mission::Question::id);
  if (open == questions.end()) return "this question is no longer open";
  const auto text = live->notes().question_texts().find(answer.question());
  log_.add(run_.sim_time(),
           {Log::ANSWER,
            fmt::format("{}: {} to `{}`", sender.client.name, answer.proceed() ? "yes" : "no",
                        text == live->notes().question_texts().end() ? "" : text->second),
            0,
            "",
            {},
            false});
  run_.post(event::Answer{answer.question(), answer.proceed()});
  return std::nullopt;
}

// ---- sticks

Answered RunOrders::start_teleoperation(const Sender& sender, const StartTeleoperation& start) {
  if (auto refused = run_.why_not_now()) return refused;
  const run::MissionRun& run = run_.live()->run();
  mission::UnitCommand command;
  if (start.robot() != 0) {
    if (run.fleet().find({start.robot()}) == nullptr)
      return fmt::format("there is no robot {}", start.robot());
    command.unit = mission::kNoUnit;
    command.robots = {{start.robot()}};
  } else {
    const auto& units = run.mission().units;
    const auto at = std::ranges::find(units, start.unit(), &mission::Unit::name);
    if (start.unit().empty() || at == units.end())
      return fmt::format("there is no unit `{}`", clean(start.unit()));
    command.unit = static_cast<std::uint32_t>(at - units.begin());
  }
  const std::string name = mission::addressee(run.mission(), command);
  if (run_.teleoperations().is_open(name)) return std::nullopt;
  if (!has_running_robot(run, command)) return fmt::format("no robot of {} runs", clean(name));
  teleoperate(run, command);
  run_.note(sender.client.name, fmt::format("teleoperate {}", clean(name)));
  run_.post(event::Typed{{std::move(command)}});
  if (run.state().paused) run_.post(event::Resume{});
  run_.update_teleoperations();
  return std::nullopt;
}

Answered RunOrders::stick(const Stick& stick) {
  if (run_.live() == nullptr || run_.is_stopped()) return "nothing can be steered now";
  return run_.teleoperations().push(run_.live()->run(), stick, wall_time());
}

Answered RunOrders::end_teleoperation(const Sender& sender, const EndTeleoperation& end) {
  if (run_.live() == nullptr) return run_.why_not_now();
  const mission::State& state = run_.live()->run().state();
  for (const mission::Run& command : state.runs) {
    if (command.phase != mission::Run::Phase::kTeleoperation) continue;
    if (state.commands[command.record].unit != end.unit()) continue;
    run_.note(sender.client.name, fmt::format("end the teleoperation of {}", clean(end.unit())));
    run_.post(event::TeleoperationComplete{command.record});
    run_.update_teleoperations();
    return std::nullopt;
  }
  return fmt::format("{} is not under teleoperation", clean(end.unit()));
}

// ---- breakpoints

Answered RunOrders::set_breakpoint(const Sender& sender, const SetBreakpoint& set, Reply& reply) {
  std::string error;
  const std::uint32_t id = run_.breakpoints().set(set.breakpoint(), error);
  if (id == 0) return error;
  reply.set_breakpoint(id);
  if (set.breakpoint().id() == 0) run_.note(sender.client.name, fmt::format("breakpoint {}", id));
  return std::nullopt;
}

Answered RunOrders::remove_breakpoint(const Sender& sender, const RemoveBreakpoint& remove) {
  if (!run_.breakpoints().remove(remove.id())) return fmt::format("there is no breakpoint {}", remove.id());
  run_.note(sender.client.name,
            remove.id() == 0 ? "remove all breakpoints" : fmt::format("remove breakpoint {}", remove.id()));
  return std::nullopt;
}

// ---- what programs are made to do

void RunOrders::note_of(std::uint32_t robot, std::string what) {
  log_.add(run_.sim_time(), {Log::OPERATOR, std::move(what), robot, "", {}, false});
}

Answered RunOrders::force_state(const Sender& sender, const ForceState& force) {
  if (auto refused = run_.why_not_now()) return refused;
  if (auto error = run_.live()->run().force_state({force.robot()}, force.sequence(), force.state()))
    return clean(*error);
  run_.world_changed();
  note_of(force.robot(), fmt::format("{}: robot {} is forced: {} goes to {}", sender.client.name,
                                     force.robot(), clean(force.sequence()), clean(force.state())));
  return std::nullopt;
}

Answered RunOrders::hold_value(const Sender& sender, const HoldValue& hold) {
  if (run_.live() == nullptr || run_.is_expected()) return run_.why_not_now();
  if (auto error = run_.live()->run().hold_value({hold.robot()}, hold.port(), hold.value()))
    return clean(*error);
  run_.held_changed();
  note_of(hold.robot(), fmt::format("{}: hold {} of robot {} at {}", sender.client.name, clean(hold.port()),
                                    hold.robot(), clean(hold.value())));
  return std::nullopt;
}

Answered RunOrders::release_value(const Sender& sender, const ReleaseValue& release) {
  if (run_.live() == nullptr || run_.is_expected()) return run_.why_not_now();
  const auto let_go = [&](std::uint32_t robot) -> Answered {
    if (auto error = run_.live()->run().release_value({robot}, release.port())) return clean(*error);
    const std::string what = release.port().empty() ? "all values" : clean(release.port());
    note_of(robot, fmt::format("{}: release {} of robot {}", sender.client.name, what, robot));
    return std::nullopt;
  };
  std::vector<std::uint32_t> robots = {release.robot()};
  if (release.robot() == 0) robots = robots_that_hold(run_.live()->run(), release.port());
  Answered error;
  for (const std::uint32_t robot : robots) {
    if (auto refused = let_go(robot)) error = std::move(refused);
  }
  run_.held_changed();
  return error;
}

Answered RunOrders::replace_robot(const Sender& sender, const ReplaceRobot& replace) {
  if (auto refused = run_.why_not_now()) return refused;
  const base::RobotId robot{replace.robot()};
  if (auto error = run_.live()->run().replace_robot(robot)) return clean(*error);
  run_.world_changed();
  const fleet::FleetRobot& replaced = *run_.live()->run().fleet().find(robot);
  const std::string machine = clean(replaced.runner->machine(replaced.member));
  note_of(robot.value,
          fmt::format("{}: robot {} is replaced by another {}{}: its program begins anew", sender.client.name,
                      robot.value, clean(replaced.type), machine.empty() ? "" : ", on " + machine));
  return std::nullopt;
}

Answered RunOrders::read_said(const ReadSaid& read, Reply& reply) {
  if (run_.live() == nullptr) return "there is no run";
  const fleet::FleetRobot* const robot = run_.live()->run().fleet().find(base::RobotId{read.robot()});
  if (robot == nullptr) return fmt::format("there is no robot {}", read.robot());
  if (robot->runner == nullptr) return "no program runs for it";
  const auto known = robot->runner->said(robot->member);
  if (!known) return clean(known.error());
  Said& out = *reply.mutable_said();
  for (const robot::LogLine& line : known->machine) {
    Said::Line& told = *out.add_machine();
    told.set_age(line.age);
    told.set_text(clean(line.text));
  }
  out.set_program(clean(known->program));
  return std::nullopt;
}

}  // namespace mlab::console
