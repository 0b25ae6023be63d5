#include "mlab/console/session/failsafe_trials.h"

#include <algorithm>
#include <expected>
#include <string>

#include <fmt/core.h>

#include "mlab/console/published/failsafe_encoder.h"
#include "mlab/console/published/overview.h"
#include "mlab/fleet/what_if.h"

namespace mlab::console {
namespace {

std::expected<fleet::WhatIf, std::string> conditions_of(const TryFailsafes& asked) {
  fleet::WhatIf out;
  for (const TryFailsafes::Lasting& one : asked.lasting()) {
    const auto known = std::ranges::find(mission::kFailsafeConditions, one.condition(),
                                         &mission::FailsafeConditionInfo::word);
    if (known == mission::kFailsafeConditions.end())
      return std::unexpected(fmt::format("no failsafe looks for `{}`", clean(one.condition())));
    out.lasting[static_cast<std::size_t>(known->condition)] = one.seconds();
  }
  out.speed = asked.speed();
  if (asked.has_fence())
    out.fence = fleet::WhatIf::AtFence{asked.fence().row(), asked.fence().depth(), asked.fence().bearing(),
                                       asked.fence().begins_there()};
  return out;
}

// One that was not started is where START will put it.
fleet::Situation known_of(run::MissionRun& run, const fleet::FleetRobot& robot) {
  fleet::Situation out = run.fleet().situation(robot);
  if (robot.life != fleet::RobotLife::kNotStarted) return out;
  for (const run::PlannedStart& start : run.planned_starts()) {
    if (start.robot != robot.id) continue;
    out.motion.pose = start.pose;
    out.home = start.pose.position;
  }
  return out;
}

}  // namespace

Answered FailsafeTrials::try_out(const TryFailsafes& asked, Reply& reply) {
  const auto began = WorkShare::Clock::now();
  if (!share_.may_begin(began)) return "others try something at the same moment: try it again";
  Answered out = answer(asked, reply);
  share_.note(began, WorkShare::Clock::now());
  return out;
}

Answered FailsafeTrials::answer(const TryFailsafes& asked, Reply& reply) {
  if (run_.live() == nullptr) return "there is no run: the mission has errors, or none is open";
  run::MissionRun& run = run_.live()->run();
  if (run.fleet().failsafes().empty()) return "the mission has no FAILSAFE";
  const fleet::FleetRobot* robot = run.fleet().find({asked.robot()});
  if (robot == nullptr) return fmt::format("there is no robot {}", asked.robot());
  const auto conditions = conditions_of(asked);
  if (!conditions) return conditions.error();
  const auto outcome =
      fleet::what_if(run.fleet().failsafes(), known_of(run, *robot), *conditions, run.cycle_duration());
  if (!outcome) return clean(outcome.error());
  encode_trial(run.fleet().failsafes(), *outcome, asked.has_fence(), *reply.mutable_failsafes());
  return std::nullopt;
}

}  // namespace mlab::console
