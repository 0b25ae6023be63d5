#include "mlab/simulated/breakdowns.h"

#include <algorithm>
#include <tuple>

#include "mlab/base/hash.h"
#include "mlab/base/random.h"

namespace mlab::simulated {
namespace {

base::Random draw(std::uint64_t seed, base::RobotId robot) {
  return base::Random::of(seed, robot.value, base::hash_text("FAILING-ROBOTS"), 0);
}

}  // namespace

std::vector<Breakdown> breakdowns_of(const mission::Mission& mission, std::uint64_t seed) {
  struct Drawn {
    double rank = 0.0;  // the lowest fail
    Breakdown breakdown;
  };
  const auto wanted = static_cast<std::size_t>(mission.options.failing_robots);
  if (wanted == 0) return {};
  std::vector<Drawn> drawn;
  for (const mission::Robot& robot : mission.robots) {
    base::Random random = draw(seed, robot.id);
    const double rank = random.uniform();
    drawn.push_back({rank, {robot.id, random.uniform() * mission.options.failures_within}});
  }
  std::ranges::sort(drawn, {}, [](const Drawn& one) { return std::tuple(one.rank, one.breakdown.robot); });
  std::vector<Breakdown> out;
  for (std::size_t i = 0; i < std::min(wanted, drawn.size()); ++i) out.push_back(drawn[i].breakdown);
  return out;
}

}  // namespace mlab::simulated
