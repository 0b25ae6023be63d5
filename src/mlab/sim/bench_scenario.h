#pragma once

#include <cstdint>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/sim/body.h"
#include "mlab/sim/world.h"
#include "mlab/text/diagnostic.h"

namespace mlab::sim {

/// A square arena full of discs and robots, the same as other simulators were measured on: 10 m^2 for each
/// robot, walls all round, static discs over 5 per cent of the area, robots anywhere with any heading.
struct BenchScenario {
  double side = 0.0;  ///< of the arena, which is centred at (0, 0) [m]
  std::vector<Disc> discs;
  std::vector<geom::Pose> robots;
};

/// @param robots  >= 1
/// @param seed    of the positions. With 1, a thousand robots under the diffusion control measure what is
/// usual for the
///                scenario; other draws differ by some per cent in hits and their distance
BenchScenario make_bench_scenario(std::uint32_t robots, std::uint64_t seed = 1);

/// Reads positions as CSV: a line `# side_m,SIDE`, lines `obstacle,X,Y,RADIUS` and `robot,X,Y,HEADING` in
/// metres and radians.
/// @errors  `bad-positions` at the first line that is none of these, or where there is no side or no robot
[[nodiscard]] text::Result<BenchScenario> read_bench_scenario(const text::SourcePtr& source);

/// Discs and the four walls; no edge of a mission area.
World bench_world(const BenchScenario& scenario);
/// The scenario's robot: differential drive, 24 rays.
/// @param range  of the rays [m]
BodySpec bench_body(double range);

/// Goals are drawn in the inner 90 per cent of the arena.
inline constexpr double kShareOfArena = 0.9;
inline constexpr double kBenchCruise = 0.2;       ///< [m/s]
inline constexpr double kBenchTurnRate = 1.4286;  ///< [rad/s]

}  // namespace mlab::sim
