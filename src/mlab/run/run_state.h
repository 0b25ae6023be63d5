#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/mission/state.h"
#include "mlab/run/crew.h"
#include "mlab/run/intervention.h"
#include "mlab/run/records.h"

namespace mlab::run {

/// How far a robot had driven by some cycle.
struct Milestone {
  std::uint64_t cycle = 0;
  double driven = 0.0;  ///< [m]
};

/// All that a mission run keeps from one cycle to the next, but for its fleet and bodies. It is copied whole:
/// what is to be known after a cycle stands here, or follows from it.
struct RunState {
  mission::State executive;
  std::vector<std::shared_ptr<const Crew>> crews;  ///< robots point into them; the last one is in force
  bool stands_still_for_operator = true;           ///< as RunSettings has it, until somebody says otherwise
  double dt = 0.1;                                 ///< cycle duration [s],
  double start_of_duration = 0.0;                  ///< in force since this time [s]
  std::uint64_t first_of_duration = 0;             ///< and this cycle
  std::uint64_t cycle = 0;
  std::uint64_t robot_cycles = 0;
  std::size_t moved_at_start = 0;  ///< by the effects in hand
  bool is_full = false;            ///< the environment had no room once, which was told
  std::vector<UnitMetrics> metrics;
  std::vector<Milestone> milestones;  ///< by robot; empty as long as no unit has had a formation
  std::vector<AnswerRecord> answers;
  std::vector<InterventionRecord> interventions;
  std::vector<Takeover> takeovers;
  std::vector<base::RobotId> forced;  ///< in the coming cycle, ascending
  std::vector<Delivery> deliveries;
  std::vector<FailsafeRecord> failsafes;
  std::vector<base::RobotId> carriers;  ///< by object id: who carries it; none as well once it was delivered
  bool is_stopped = false;
  bool has_braked = false;  ///< for at least one cycle of this stop
  bool has_looked = false;  ///< since the last cycle, or since something came in

  /// Simulated [s]. Counted in cycles, so that it does not drift.
  double time() const { return start_of_duration + static_cast<double>(cycle - first_of_duration) * dt; }
};

}  // namespace mlab::run
