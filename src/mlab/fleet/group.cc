#include "mlab/fleet/group.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mlab::fleet {

void update_group(Group& group, const std::vector<geom::Pose>& poses) {
  if (group.members.empty()) return;
  geom::Offset sum;
  for (const std::uint32_t member : group.members) sum = sum + (poses[member].position - geom::Point{});
  const geom::Point center = geom::Point{} + sum * (1.0 / static_cast<double>(group.members.size()));
  group.center_step = group.has_center ? center - group.center : geom::Offset{};
  group.center = center;
  group.has_center = true;
  const geom::Offset to_goal = group.order.goal - center;
  if (group.order.has_heading) {
    group.formation_heading = group.order.heading;
  } else if (group.order.task != percept::Task::kFollow && geom::length(to_goal) >= group.heading_trigger) {
    group.formation_heading = geom::direction(to_goal);
  }
}

percept::UnitPercept unit_percept(const Group& group, std::size_t rank,
                                  const std::vector<geom::Pose>& poses) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint16_t>::max();
  percept::UnitPercept out;
  out.size = static_cast<std::uint16_t>(std::min(group.members.size(), kMost));
  out.rank = static_cast<std::uint16_t>(std::min(rank, kMost - 1));
  out.center = group.center;
  out.center_step = group.center_step;
  out.leader = poses[group.members.front()];
  out.neighbor = poses[group.members[rank == 0 ? 0 : rank - 1]];
  out.formation_heading = group.formation_heading;
  return out;
}

namespace {

// Where stations are measured from, and the station of who stands there.
struct Origin {
  geom::Pose pose;
  geom::Vector station;
};

Origin origin_of(const Group& group, std::size_t rank, const std::vector<geom::Pose>& poses) {
  using percept::FormationReference;
  if (group.reference == FormationReference::kUnitCenter)
    return {{group.center, group.formation_heading}, {}};
  const std::size_t other = group.reference == FormationReference::kLeader ? 0 : rank - 1;
  return {{poses[group.members[other]].position, group.formation_heading},
          percept::station(group.order.formation, static_cast<int>(other),
                           static_cast<int>(group.members.size()), group.spacing)};
}

// From the origin to the station, in the formation's frame.
geom::Vector station_from(const Group& group, std::size_t rank, const Origin& origin) {
  return percept::station(group.order.formation, static_cast<int>(rank),
                          static_cast<int>(group.members.size()), group.spacing) -
         origin.station;
}

}  // namespace

bool has_station(const Group& group, std::size_t rank) {
  return group.order.formation != percept::Formation::kNone && group.members.size() > 1 &&
         (rank > 0 || group.reference == percept::FormationReference::kUnitCenter);
}

std::optional<geom::Point> station_place(const Group& group, std::size_t rank,
                                         const std::vector<geom::Pose>& poses) {
  if (!has_station(group, rank)) return std::nullopt;
  const Origin origin = origin_of(group, rank, poses);
  if (group.order.formation == percept::Formation::kSweep) {
    const geom::Vector at = origin.pose.to_robot(poses[group.members[rank]].position);
    return origin.pose.point_at({0.0, at.y, 0.0});
  }
  return origin.pose.point_at(station_from(group, rank, origin));
}

double station_error(const Group& group, std::size_t rank, const std::vector<geom::Pose>& poses) {
  if (!has_station(group, rank)) return 0.0;
  const Origin origin = origin_of(group, rank, poses);
  const geom::Vector at = origin.pose.to_robot(poses[group.members[rank]].position);
  if (group.order.formation == percept::Formation::kSweep) return std::abs(at.x);
  return geom::length(at - station_from(group, rank, origin));
}

}  // namespace mlab::fleet
