#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "mlab/comparison/comparison.h"
#include "mlab/comparison/program_pair.h"
#include "mlab/run/mission_run.h"

namespace mlab::comparison {

/// Looks after each cycle whether two runs are still the same: every value of every robot, states, actions,
/// bodies, the plan.
class PartingFinder {
 public:
  /// Both have run the same number of cycles.
  /// @param comparison  what is known of their beginnings and inputs, for the causes
  std::optional<Parting> look(const Both<const run::MissionRun*>& runs, const Comparison& comparison);

 private:
  using Robots = Both<const fleet::FleetRobot*>;

  const ProgramPair& pair_of(const Both<const run::MissionRun*>& runs,
                             const Both<const flow::Program*>& programs);
  std::optional<Parting> look_at(const Both<const run::MissionRun*>& runs, const Robots& robots);
  std::optional<Parting> look_into(const Both<const run::MissionRun*>& runs, const Robots& robots);

  // Programs are told by where they lie, so those of an older crew may not be mistaken for those of a newer.
  Both<std::shared_ptr<const run::Crew>> crews_;
  std::map<std::pair<const flow::Program*, const flow::Program*>, std::unique_ptr<ProgramPair>> pairs_;
};

}  // namespace mlab::comparison
