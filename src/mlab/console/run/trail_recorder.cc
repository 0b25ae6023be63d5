#include "mlab/console/run/trail_recorder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace mlab::console {

using fleet::FleetRobot;

void TrailRecorder::match(const std::vector<FleetRobot>& fleet) {
  const bool matches =
      std::equal(trails_.begin(), trails_.end(), fleet.begin(), fleet.end(),
                 [](const Trail& trail, const FleetRobot& robot) { return trail.robot == robot.id.value; });
  if (matches) return;
  std::map<std::uint32_t, Trail> before;
  for (Trail& trail : trails_) before[trail.robot] = std::move(trail);
  trails_.clear();
  count_ = 0;
  for (const FleetRobot& robot : fleet) {
    Trail& trail = trails_.emplace_back(std::move(before[robot.id.value]));
    trail.robot = robot.id.value;
    count_ += trail.points.size();
  }
}

void TrailRecorder::thin(Trail& trail) {
  const std::size_t before = trail.points.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < before; i += 2) trail.points[kept++] = trail.points[i];
  trail.points.resize(kept);
  trail.step *= 2.0;
  count_ -= before - kept;
}

void TrailRecorder::look(const run::MissionRun& run) {
  const std::vector<FleetRobot>& fleet = run.fleet().robots();
  match(fleet);
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    if (fleet[i].life == fleet::RobotLife::kNotStarted) continue;
    Trail& trail = trails_[i];
    const geom::Point at = run.fleet().pose(fleet[i]).position;
    if (!trail.points.empty() && geom::distance(at, trail.last) < trail.step) continue;
    trail.last = at;
    trail.points.push_back(
        {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(run.time())});
    ++count_;
    if (trail.points.size() > kMostOfOne) thin(trail);
  }
  while (count_ > kMostPoints && count_ > trails_.size()) {
    for (Trail& trail : trails_) thin(trail);
  }
}

void TrailRecorder::clear() {
  trails_.clear();
  count_ = 0;
}

void TrailRecorder::encode(Trails& out, double until) const {
  for (const Trail& trail : trails_) {
    const auto end = std::ranges::upper_bound(trail.points, static_cast<float>(until), {}, &Point::time);
    const auto count = static_cast<std::size_t>(end - trail.points.begin());
    if (count == 0) continue;
    Trails::Trail& told = *out.add_trails();
    told.set_robot(trail.robot);
    told.set_points(reinterpret_cast<const char*>(trail.points.data()), count * sizeof(Point));
  }
}

}  // namespace mlab::console
