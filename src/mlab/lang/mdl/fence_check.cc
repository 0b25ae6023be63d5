#include "mlab/lang/mdl/fence_check.h"

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/lang/mdl/quoted.h"

namespace mlab::mdl {
namespace {

// Sides of fences looked at over the whole mission: some tenths of a second.
constexpr std::uint64_t kMaxSideVisits = 20'000'000;

// Whether a ray to the east crosses the closed line an odd number of times.
bool is_within(std::span<const geom::Point> corners, geom::Point place) {
  bool out = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const geom::Point a = corners[i];
    const geom::Point b = corners[(i + 1) % corners.size()];
    const bool crosses = (a.y > place.y) != (b.y > place.y);
    if (crosses && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) out = !out;
  }
  return out;
}

}  // namespace

void FenceCheck::check(const mission::UnitCommand& start, std::span<const mission::Robot* const> robots) {
  for (const mission::Failsafe& one : mission_.failsafes) {
    if (one.fence.size() >= 3) check(start, robots, one);
  }
}

void FenceCheck::check(const mission::UnitCommand& start, std::span<const mission::Robot* const> robots,
                       const mission::Failsafe& failsafe) {
  std::size_t outside = 0;
  base::RobotId first;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    if (!failsafe.is_of(mission_.types[robots[k]->type].name)) continue;
    visits_ += failsafe.fence.size();
    if (visits_ > kMaxSideVisits) return;
    if (is_within(failsafe.fence, start.goal + start.start_step * static_cast<double>(k))) continue;
    if (outside++ == 0) first = robots[k]->id;
  }
  if (outside == 0) return;
  auto& warning = diagnostics_.warning(
      "start-outside-fence", start.goal_place,
      fmt::format("{} of {} outside of the fence {}, first robot {}: beyond it robots only drive back",
                  outside,
                  base::counted(robots.size(), "robot") + (robots.size() == 1 ? " starts" : " start"),
                  in_backticks(failsafe.fence_name), first.value));
  warning.notes.push_back({"its fence is this", failsafe.place});
}

}  // namespace mlab::mdl
