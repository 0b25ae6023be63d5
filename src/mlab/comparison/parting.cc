#include "mlab/comparison/parting.h"

#include <algorithm>
#include <bit>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/comparison/causes.h"
#include "mlab/comparison/in_world.h"
#include "mlab/comparison/wire_walk.h"

namespace mlab::comparison {
namespace {

using Runs = Both<const run::MissionRun*>;
using Robots = Both<const fleet::FleetRobot*>;

bool is_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool is_same_place(const geom::Pose& a, const geom::Pose& b) {
  return is_same_bits(a.position.x, b.position.x) && is_same_bits(a.position.y, b.position.y) &&
         is_same_bits(a.heading, b.heading);
}

std::string text_of(const geom::Pose& pose) {
  return fmt::format("({}, {}) heading {}", pose.position.x, pose.position.y, base::degrees(pose.heading));
}

std::string text_of(const percept::Action& action) {
  if (!action.drives) return action.spins ? fmt::format("turns at {} rad/s", action.spin) : "stands";
  return fmt::format("({}, {}) m/s{}", action.velocity.x, action.velocity.y,
                     action.spins ? fmt::format(", {} rad/s", action.spin) : "");
}

bool is_same(const percept::Action& a, const percept::Action& b) {
  return is_same_bits(a.velocity.x, b.velocity.x) && is_same_bits(a.velocity.y, b.velocity.y) &&
         is_same_bits(a.spin, b.spin) && a.drives == b.drives && a.spins == b.spins;
}

// How far the plan is, in words; empty where the same.
std::optional<Value> plan_difference(const Runs& runs) {
  const auto words = [](const run::MissionRun& run) {
    const mission::State& state = run.state();
    const std::string step = state.in_step ? "in" : state.paused ? "paused before" : "before";
    return fmt::format("{} step {}, {} of {} steps done, {} commands so far, {} questions open", step,
                       state.step + 1, run.steps_done(), run.mission().steps.size(), state.commands.size(),
                       state.questions.size());
  };
  Value out{"the plan", {words(*runs[0]), words(*runs[1])}};
  if (out.values[0] == out.values[1]) return std::nullopt;
  return out;
}

std::string life_of(const run::MissionRun& run, base::RobotId id) {
  const fleet::FleetRobot* const robot = run.fleet().find(id);
  if (robot == nullptr) return "there is none";
  return std::string(fleet::name(robot->life));
}

std::vector<base::RobotId> ids_of(const Runs& runs) {
  std::vector<base::RobotId> out;
  // Nearly always both have the same.
  const std::vector<fleet::FleetRobot>& a = runs[0]->fleet().robots();
  const bool is_equal =
      std::ranges::equal(a, runs[1]->fleet().robots(), {}, &fleet::FleetRobot::id, &fleet::FleetRobot::id);
  for (const run::MissionRun* const run : std::span(runs).first(is_equal ? 1 : 2)) {
    for (const fleet::FleetRobot& robot : run->fleet().robots()) out.push_back(robot.id);
  }
  std::ranges::sort(out);
  const auto doubles = std::ranges::unique(out);
  out.erase(doubles.begin(), doubles.end());
  return out;
}

}  // namespace

const ProgramPair& PartingFinder::pair_of(const Runs& runs, const Both<const flow::Program*>& programs) {
  if (crews_[0] != runs[0]->crew() || crews_[1] != runs[1]->crew()) {
    pairs_.clear();
    crews_ = {runs[0]->crew(), runs[1]->crew()};
  }
  std::unique_ptr<ProgramPair>& pair = pairs_[{programs[0], programs[1]}];
  if (!pair) pair = std::make_unique<ProgramPair>(programs);
  return *pair;
}

// What its program computed.
std::optional<Parting> PartingFinder::look_into(const Runs& runs, const Robots& robots) {
  const Both<robot::Workings> workings = {robots[0]->workings(), robots[1]->workings()};
  if (!workings[0] || !workings[1]) return std::nullopt;
  const ProgramPair& programs = pair_of(runs, {workings[0].program, workings[1].program});
  const ProgramPair::Frames frames = {workings[0].frame, workings[1].frame};
  if (programs.are_equal_bytes(frames)) return std::nullopt;
  Parting out;
  if (const ProgramPair::PortPair* const first = programs.first_difference(frames)) {
    out.value = value_of(*first, frames);
    WireWalk walk = walk_wires(programs, frames, *first);
    out.consequences = std::move(walk.consequences);
    out.values = walk.values;
    out.causes = causes_at(walk, workings, *first);
    return out;
  }
  if (auto state = programs.state_difference(frames)) {
    out.what = Parting::What::kState;
    out.value = std::move(*state);
    out.values = 1;
    return out;
  }
  return std::nullopt;
}

std::optional<Parting> PartingFinder::look_at(const Runs& runs, const Robots& robots) {
  if (auto inside = look_into(runs, robots)) return inside;
  Parting out;
  out.values = 1;
  if (!is_same(robots[0]->action, robots[1]->action)) {
    out.what = Parting::What::kAction;
    out.value = {"what its program wants", {text_of(robots[0]->action), text_of(robots[1]->action)}};
    return out;
  }
  const Both<geom::Pose> poses = {runs[0]->fleet().pose(*robots[0]), runs[1]->fleet().pose(*robots[1])};
  if (is_same_place(poses[0], poses[1])) return std::nullopt;
  out.what = Parting::What::kPlace;
  out.value = {"where it is", {text_of(poses[0]), text_of(poses[1])}};
  return out;
}

std::optional<Parting> PartingFinder::look(const Runs& runs, const Comparison& comparison) {
  std::optional<Parting> out;
  std::vector<std::uint32_t> parted;
  Robots first{};
  for (const base::RobotId id : ids_of(runs)) {
    const Robots robots = {in_world(*runs[0], id), in_world(*runs[1], id)};
    std::optional<Parting> one;
    if (robots[0] != nullptr && robots[1] != nullptr && robots[0]->life == robots[1]->life) {
      // Of all that part in this cycle only the first is told in full.
      one = look_at(runs, robots);
    } else if (life_of(*runs[0], id) != life_of(*runs[1], id) &&
               (robots[0] != nullptr || robots[1] != nullptr)) {
      one.emplace();
      one->what = Parting::What::kRobots;
      one->value = {"what became of it", {life_of(*runs[0], id), life_of(*runs[1], id)}};
      one->values = 1;
    }
    if (!one) continue;
    parted.push_back(id.value);
    if (out) continue;
    out = std::move(one);
    out->robot = id.value;
    first = robots;
  }
  const std::optional<Value> plan = plan_difference(runs);
  if (!out && !plan) return std::nullopt;
  if (!out) {
    out.emplace();
    out->what = Parting::What::kMission;
    out->value = *plan;
    out->values = 1;
  }
  out->cycle = runs[0]->cycle();
  out->time = runs[0]->time();
  out->robots = std::move(parted);
  add_causes(runs, first, comparison, *out);
  return out;
}

}  // namespace mlab::comparison
