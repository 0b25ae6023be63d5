#pragma once

#include <cstdint>
#include <functional>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/sim/bench_scenario.h"

namespace mlab::sim {

/// What one robot does in one cycle. Called from several threads, never for the same robot at a time.
/// @param robot  index in BenchScenario::robots
/// @param out    a fresh action; the scenario's controls set velocity.x to the speed and spin to the turn
/// rate
using BenchControl = std::function<void(std::uint32_t robot, const percept::Percepts&, percept::Action& out)>;

/// The scenario's control without memory: straight on, away from what is ahead.
void diffusion_control(std::uint32_t robot, const percept::Percepts& percepts, percept::Action& out);

struct BenchOptions {
  int threads = 1;
  double range = 1.0;           ///< of the rays [m]
  double cycle_duration = 0.1;  ///< [s]
  int warm_up = 5;              ///< cycles that aren't timed
  int cycles = 0;               ///< timed; 0: as many as the scenario says for so many robots
  std::uint64_t seed = 1;
};

struct BenchResult {
  int cycles = 0;        ///< timed ones
  double seconds = 0.0;  ///< of wall clock for all timed cycles
  double sense = 0.0;    ///< of these for sensing, and so on [s]
  double behave = 0.0;
  double move = 0.0;
  double contact = 0.0;
  double robot_cycles_per_second = 0.0;
  double bytes_per_robot = 0.0;    ///< what the process grew by while the simulator was filled and run
  double hit_share = 0.0;          ///< of all rays in the first 100 cycles (20 for more than 20,000 robots)
  double mean_hit_distance = 0.0;  ///< in the same [m]
  double mean_displacement = 0.0;  ///< from before to after the timed cycles [m]
  std::uint64_t contacts = 0;      ///< in all cycles, of all robots
};

/// Runs the scenario twice: timed, and again to count hits.
BenchResult run_bench(const BenchScenario& scenario, const BenchOptions& options,
                      const BenchControl& control);

}  // namespace mlab::sim
