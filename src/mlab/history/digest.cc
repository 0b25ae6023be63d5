#include "mlab/history/digest.h"

#include <bit>

#include "mlab/base/hash.h"

namespace mlab::history {

std::uint64_t digest_of(const run::MissionRun& run) {
  std::uint64_t out = base::combine_bits(run.cycle(), run.state().step);
  const auto add = [&](std::uint64_t bits) { out = base::combine_bits(out, bits); };
  add(std::bit_cast<std::uint64_t>(run.time()));
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    add(robot.id.value);
    add(static_cast<std::uint64_t>(robot.life));
    if (robot.life == fleet::RobotLife::kNotStarted) continue;
    const geom::Pose& pose = run.fleet().pose(robot);
    add(std::bit_cast<std::uint64_t>(pose.position.x));
    add(std::bit_cast<std::uint64_t>(pose.position.y));
    add(std::bit_cast<std::uint64_t>(pose.heading));
  }
  return out;
}

}  // namespace mlab::history
