#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "mlab/run/mission_run.h"

namespace mlab::run {

std::string_view name(InterventionRecord::Kind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"force", "hold", "release", "replace"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<std::string> MissionRun::force_state(base::RobotId robot, const std::string& sequence,
                                                   const std::string& state) {
  note(input::Intervened{robot, InterventionRecord::Kind::kForce, sequence, state});
  if (auto problem = fleet_->force(robot, sequence, state)) return problem;
  now_.interventions.push_back({now_.cycle, robot, InterventionRecord::Kind::kForce, sequence, state});
  const auto at = std::ranges::lower_bound(now_.forced, robot);
  if (at == now_.forced.end() || *at != robot) now_.forced.insert(at, robot);
  return std::nullopt;
}

std::optional<std::string> MissionRun::hold_value(base::RobotId robot, const std::string& port,
                                                  const std::string& value) {
  note(input::Intervened{robot, InterventionRecord::Kind::kHold, port, value});
  if (auto problem = fleet_->hold(robot, port, value)) return problem;
  now_.interventions.push_back({now_.cycle, robot, InterventionRecord::Kind::kHold, port, value});
  return std::nullopt;
}

std::optional<std::string> MissionRun::release_value(base::RobotId robot, const std::string& port) {
  note(input::Intervened{robot, InterventionRecord::Kind::kRelease, port, ""});
  const fleet::FleetRobot* const known = fleet_->find(robot);
  const flow::Interventions* const before = known == nullptr ? nullptr : known->workings().interventions;
  const bool holds_something = before != nullptr && !before->held().empty();
  if (auto problem = fleet_->release(robot, port)) return problem;
  if (!holds_something) return std::nullopt;
  now_.interventions.push_back({now_.cycle, robot, InterventionRecord::Kind::kRelease, port, ""});
  return std::nullopt;
}

std::optional<std::string> MissionRun::replace_robot(base::RobotId robot) {
  note(input::Intervened{robot, InterventionRecord::Kind::kReplace, "", ""});
  if (auto problem = fleet_->replace(robot)) return problem;
  now_.interventions.push_back({now_.cycle, robot, InterventionRecord::Kind::kReplace, "", ""});
  return std::nullopt;
}

// What the sequence is part of may have come to an end in the same cycle.
void MissionRun::tell_not_forced() {
  for (const base::RobotId id : std::exchange(now_.forced, {})) {
    const fleet::FleetRobot* const robot = fleet_->find(id);
    const robot::Workings with = robot != nullptr ? robot->workings() : robot::Workings{};
    if (!with || with.interventions == nullptr) continue;
    for (const flow::Interventions::Forced& one : with.interventions->forced()) {
      if (one.was_done) continue;
      tell(mission::effect::Tell::Kind::kWarning,
           fmt::format("robot {}: {} did not go to {}: it did not run any more", id.value,
                       with.program->sequence_name(one.sequence),
                       with.program->state_names(one.sequence)[one.state]));
    }
  }
}

}  // namespace mlab::run
