#include "mlab/console/published/status_encoder.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/console/published/vehicle_encoder.h"
#include "mlab/mission/wording.h"
#include "mlab/schema/contracts.h"
#include "mlab/schema/errands.h"
#include "mlab/schema/tour.h"

namespace mlab::console {
namespace {

using mission::State;

constexpr double kSilence = 3.0;          // who has told nothing for so long counts for no `ErrandPace` [s]
constexpr std::size_t kMostParts = 1000;  // in one status: of more the map would be a tangle

// The enumerations count alike.
Status::Outcome outcome_of(mission::Outcome outcome) {
  static_assert(static_cast<int>(mission::Outcome::kSkipped) == Status::SKIPPED);
  static_assert(static_cast<int>(mission::Outcome::kDone) == Status::DONE);
  return static_cast<Status::Outcome>(outcome);
}

// Only where the unit's name does not say it.
void encode_followers(const State& state, const mission::Run& run, Status::Command& out) {
  const bool is_whole = run.unit < state.mission->units.size() &&
                        state.mission->units[run.unit].members.size() == run.needed.size();
  if (is_whole) return;
  for (const base::RobotId id : run.needed) out.add_followers(id.value);
}

void encode_way(std::span<const geom::Point> way, Status::Command::Part& out) {
  for (const geom::Point p : way) {
    out.add_way(static_cast<float>(p.x));
    out.add_way(static_cast<float>(p.y));
  }
}

void encode_part(const schema::Errands& errands, std::size_t errand, Status::Command::Part& out) {
  encode_way(errands.way(errand), out);
  const percept::Contract* contract = errands.contract(errand);
  if (contract == nullptr) return;
  const bool is_done = contract->state == percept::ContractState::kDone;
  if (is_done || schema::is_held(*contract, contract->contractor)) out.set_robot(contract->contractor.value);
  out.set_is_done(is_done);
}

// What each of them has before it on its round, as one of them knows it.
void encode_round(const fleet::FleetRobot& robot, const percept::Percepts& percepts, std::size_t& room,
                  Status::Command& out) {
  const std::vector<schema::Stretch> all = schema::stretches(
      percepts, kSilence, robot.program->number("robot_radius").value_or(robot.capabilities.radius),
      robot.program->number("avoid_obstacle_safety_margin").value_or(0.0));
  if (all.size() > room) return;
  room -= all.size();
  for (const schema::Stretch& one : all) {
    Status::Command::Part& part = *out.add_shared();
    encode_way(one.way, part);
    part.set_robot(one.robot.value);
  }
}

// How far a command is that its robots share, as one of them knows it.
// @param room  for so many parts there is room, of all commands together; of one with more no part is told
void encode_parts(const run::MissionRun& run, const mission::Run& command, std::size_t& room,
                  Status::Command& out) {
  if (!mission::info(command.command->task).is_shared) return;
  out.set_is_shared(true);
  for (const base::RobotId id : command.needed) {
    const fleet::FleetRobot* robot = run.fleet().find(id);
    if (robot == nullptr || robot->life != fleet::RobotLife::kRunning) continue;
    const bool goes_round = command.command->task == mission::Task::kPatrol;
    percept::Needs needs;
    if (goes_round && robot->program->number("plans_ways").value_or(0.0) != 0.0)
      needs.want(percept::Sensor::kGround);
    const percept::Percepts percepts = run.fleet().perceive_at(*robot, run.fleet().pose(*robot), needs, 0.0);
    if (goes_round) {
      encode_round(*robot, percepts, room, out);
      return;
    }
    const schema::Errands errands(percepts);
    if (errands.count() == 0) return;
    out.set_parts(static_cast<std::uint32_t>(errands.count()));
    out.set_parts_done(static_cast<std::uint32_t>(errands.done()));
    out.set_progress(static_cast<double>(errands.done()) / static_cast<double>(errands.count()));
    out.set_swath(percepts.order.swath);
    if (errands.count() > room) return;
    room -= errands.count();
    for (std::size_t i = 0; i < errands.count(); ++i) encode_part(errands, i, *out.add_shared());
    return;
  }
}

void encode_command(const run::MissionRun& mission_run, std::uint32_t record, const Estimates& estimates,
                    std::size_t& room, Status::Command& out) {
  const State& state = mission_run.state();
  const mission::CommandRecord& command = state.commands[record];
  out.set_text(clean(command.text));
  out.set_unit(clean(command.unit));
  out.set_outcome(outcome_of(command.outcome));
  out.set_start(command.start);
  if (command.outcome != mission::Outcome::kRunning) out.set_end(command.end);
  out.set_message(clean(command.message));
  out.set_remaining(-1.0);
  out.set_arrival(-1.0);
  if (command.outcome == mission::Outcome::kDone) out.set_progress(1.0);
  const auto run = std::ranges::find(state.runs, record, &mission::Run::record);
  if (run == state.runs.end()) return;
  const Estimates::Estimate estimate = estimates.of(state, *run);
  out.set_robots(estimate.robots);
  out.set_robots_done(estimate.robots_done);
  if (command.outcome != mission::Outcome::kRunning) return;
  encode_followers(state, *run, out);
  out.set_waits_for(clean(mission::waiting_text(state, *run)));
  out.set_is_held(run->phase == mission::Run::Phase::kHeld);
  out.set_remaining(estimate.remaining);
  out.set_arrival(estimate.arrival);
  out.set_progress(estimate.progress);
  if (run->phase == mission::Run::Phase::kRobots) encode_parts(mission_run, *run, room, out);
}

}  // namespace

Status::Mode mode_of(const run::MissionRun& run) {
  const State& state = run.state();
  if (run.is_stopped()) return Status::STOPPED;
  if (state.mode == State::Mode::kQuit) return Status::ENDED;
  if (state.mode == State::Mode::kRunning) {
    if (state.paused) return Status::PAUSED;
    return mission::awaits_only_operator(state) ? Status::WAITING : Status::RUNNING;
  }
  switch (state.outcome) {
    case mission::Outcome::kPending:
      return state.steps.empty() ? Status::READY : Status::PAUSED;
    case mission::Outcome::kRunning:
      return Status::PAUSED;
    default:
      return Status::ENDED;
  }
}

std::string clock_time(const mission::ExecutiveOptions& options, double run_time) {
  const auto seconds =
      static_cast<std::time_t>(std::floor(options.epoch_seconds + options.zone_offset + run_time));
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1,
                     parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

void encode_run(const run::MissionRun& run, const Estimates& estimates, Status& out) {
  const State& state = run.state();
  out.set_mode(mode_of(run));
  out.set_time(run.time());
  out.set_cycle(run.cycle());
  out.set_cycle_duration(run.cycle_duration());
  out.set_current_step(state.step);
  out.set_outcome(outcome_of(state.outcome));
  out.set_stops_after_step(state.mode == State::Mode::kRunning && state.single);
  out.set_seed(run.seed());
  if (const robot::Punctuality* const robots = run.fleet().punctuality()) {
    out.mutable_real_time()->set_robot_cycles(robots->asked);
    out.mutable_real_time()->set_late(robots->late);
    out.mutable_real_time()->set_stood(robots->stood);
    out.mutable_real_time()->set_worst_age(robots->worst_age);
  }
  out.set_mission_clock(clock_time(state.options, run.time()));
  std::size_t room = kMostParts;
  const std::size_t first = state.steps.size() - std::min(state.steps.size(), kMostSteps);
  for (std::size_t i = 0; i < state.steps.size(); ++i) {
    const mission::StepRecord& step = state.steps[i];
    if (i < first && step.outcome != mission::Outcome::kRunning) continue;
    Status::Step& told = *out.add_steps();
    told.set_label(clean(step.label));
    told.set_step(step.step);
    told.set_outcome(outcome_of(step.outcome));
    told.set_start(step.start);
    if (step.outcome != mission::Outcome::kRunning) told.set_end(step.end);
    for (std::uint32_t c = 0; c < step.command_count; ++c)
      encode_command(run, step.first_command + c, estimates, room, *told.add_commands());
  }
  for (const std::string& line : mission::waits_for(state)) out.add_waits_for(clean(line));
  encode_vehicles(run, out);
}

void encode_questions(const State& state, const std::map<std::uint32_t, double>& asked,
                      const std::map<std::uint32_t, std::string>& texts, Questions& out) {
  for (const mission::Question& question : state.questions) {
    Questions::Question& told = *out.add_questions();
    told.set_id(question.id);
    if (const auto text = texts.find(question.id); text != texts.end()) told.set_text(clean(text->second));
    told.set_robot(question.robot.value);
    if (question.robot.value == 0 && question.run < state.runs.size()) {
      const mission::CommandRecord& record = state.commands[state.runs[question.run].record];
      told.set_unit(clean(record.unit));
      told.set_command(clean(record.text));
    }
    if (question.expires) told.set_expires(*question.expires);
    if (const auto time = asked.find(question.id); time != asked.end()) told.set_asked(time->second);
  }
}

}  // namespace mlab::console
