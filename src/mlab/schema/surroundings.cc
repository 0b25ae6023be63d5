#include "mlab/schema/surroundings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;
using geom::Segment;

constexpr double kLeast = 0.01;       // between surfaces, whatever else can't be kept [m]
constexpr double kStands = 0.05;      // [m/s]
constexpr double kToTheRight = 0.1;   // of what is wanted, where somebody is near
constexpr double kWallHorizon = 0.5;  // [s]
constexpr std::size_t kMostTraffic = 24;

Segment at_point(Offset place) {
  return {Point{} + place, Point{} + place};
}

Segment seen_from(Point here, const Segment& wall) {
  return {Point{} + (wall.a - here), Point{} + (wall.b - here)};
}

}  // namespace

Surroundings::Surroundings(const percept::Percepts& percepts, const Spacing& spacing,
                           const ObstacleList& obstacles, const RobotList& robots, Point before,
                           SeenRobots& seen)
    : percepts_(percepts),
      spacing_(spacing),
      obstacles_(obstacles),
      robots_(robots),
      here_(percepts.pose.position),
      before_(before),
      ahead_(geom::ahead_of(percepts.pose.heading)),
      near_(2.0 * spacing.horizon * spacing.fastest),
      step_(percepts.cycle_duration * spacing.fastest) {
  add_edges();
  if (!percepts.ground.walls.empty()) add_walls();
  if (!obstacles.empty()) add_obstacles();
  if (add_robots(seen) < 2.0 * step_) bar_robots();
  if (wall_count_ > 0) bar_ends_of_walls();
}

// The edge of the area holds who is within it.
void Surroundings::add_edges() {
  constexpr double kFar = 10.0;  // [m]
  const auto add = [&](double room, Offset outward) {
    if (room < -kLeast || room > step_) return;
    const Point line = Point{} + outward * (room + kFar);
    const Offset along = Offset{outward.y, outward.x} * (2.0 * kFar);
    bars_.add({{line - along, line + along}, kFar});
  };
  const auto& area = percepts_.ground.bounds;
  const Offset low = Point{area.x0, area.y0} - here_;
  const Offset high = Point{area.x1, area.y1} - here_;
  if (std::min({-low.x, -low.y, high.x, high.y}) > step_) return;
  add(-low.x, {-1, 0});
  add(-low.y, {0, -1});
  add(high.x, {1, 0});
  add(high.y, {0, 1});
}

// Edges of areas to keep out of are among the walls that are known: who stands within one gets out. Solid
// ones are seen besides.
void Surroundings::add_walls() {
  wall_count_ = nearest_walls(percepts_.ground, here_, 0.25 * near_, walls_);
  for (std::size_t i = 0; i < obstacles_.size() && wall_count_ > 0; ++i) {
    if (is_around(obstacles_[i])) wall_count_ = 0;
  }
  for (std::size_t i = 0; i < wall_count_; ++i) {
    const Offset place = geom::nearest_point(walls_[i], here_) - here_;
    standing_.add({place, {}, spacing_.radius + spacing_.obstacle_gap, kWallHorizon, false});
    if (length(place) < spacing_.radius + kLeast + step_)
      bars_.add({seen_from(here_, walls_[i]), spacing_.radius + kLeast});
  }
}

// Where a ray hits a wall that is known stands no more than that wall; where it is tight that decides.
bool Surroundings::is_known_wall(const percept::Obstacle& seen) const {
  constexpr double kTight = 0.25;  // from the body to a wall [m]
  constexpr double kOnIt = 0.01;   // [m]
  if (wall_count_ == 0 || length(standing_[0].place) >= spacing_.radius + kTight) return false;
  const Point hit = here_ + to_world(seen.center);
  return std::ranges::any_of(std::span(walls_).first(wall_count_), [&](const Segment& wall) {
    return distance(nearest_point(wall, hit), hit) < kOnIt;
  });
}

void Surroundings::add_obstacles() {
  for (const percept::Obstacle& obstacle : obstacles_) {
    if (standing_.is_full()) break;
    if (is_known_wall(obstacle)) continue;
    const double reach = obstacle.radius + spacing_.radius;
    if (obstacle.is_moving() || length(obstacle.center) - obstacle.radius > 0.5 * near_) continue;
    const Offset place = to_world(obstacle.center);
    standing_.add({place, {}, reach + spacing_.obstacle_gap, kWallHorizon, false});
    if (length(place) < reach + kLeast + step_) bars_.add({at_point(place), reach + kLeast});
  }
  for (const percept::Obstacle& obstacle : obstacles_) {
    if (passing_.is_full()) break;
    const double away = length(obstacle.center) - obstacle.radius;
    if (!obstacle.is_moving() || away > near_ + spacing_.horizon * length(obstacle.velocity)) continue;
    passing_.add({to_world(obstacle.center), to_world(obstacle.velocity),
                  obstacle.radius + spacing_.radius + spacing_.gap, spacing_.horizon, false, true});
  }
}

double Surroundings::add_robots(SeenRobots& seen) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Offset place = to_world(robots_[i].center);
    others_.add({place, seen.velocity(robots_[i].id, here_ + place, percepts_.cycle_duration, i),
                 length(robots_[i].center)});
    least = std::min(least, room_to(i));
  }
  seen.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) seen.add(robots_[i].id, here_ + others_[i].place);
  return least;
}

double Surroundings::room_to(std::size_t robot) const {
  const double bodies = robots_[robot].radius + spacing_.radius;
  return std::max(0.0, others_[robot].away - bodies - kLeast);
}

// Half of what is between them, so that they can't touch. More of it where the other one went away from it,
// which takes as much from its own half: so each takes less where it was itself that did.
void Surroundings::bar_robots() {
  for (std::size_t i = 0; i < robots_.size() && !bars_.is_full(); ++i) {
    const double room = room_to(i);
    if (room >= 2.0 * step_) continue;
    const Offset place = others_[i].place;
    const double gone = percepts_.cycle_duration * dot(others_[i].velocity, unit(place));
    const double went = dot(before_ - here_, unit(place));
    const double share = 0.5 * (room + std::clamp(gone, 0.0, room) - std::clamp(went, 0.0, room));
    bars_.add({at_point(place), robots_[i].radius + spacing_.radius, share});
  }
}

bool Surroundings::hides_somebody(std::size_t which, Point end) const {
  constexpr double kSame = 0.01;         // [m]
  constexpr double kStraightOn = -0.99;  // cosine of the angle
  const Segment& wall = walls_[which];
  const Offset along = unit(wall.a == end ? wall.b - end : wall.a - end);
  int others = 0;
  for (std::size_t i = 0; i < wall_count_; ++i) {
    if (i == which || distance(nearest_point(walls_[i], end), end) > kSame) continue;
    ++others;
    for (const Point far : {walls_[i].a, walls_[i].b}) {
      if (distance(far, end) > kSame && dot(unit(far - end), along) < kStraightOn) return false;
    }
  }
  return others < 2;
}

// Who goes among others may meet one whom it does not see yet, at the end of a wall: neither drives more than
// half of what is between them at least.
void Surroundings::bar_ends_of_walls() {
  constexpr double kCrowd = 3.0;  // [m]
  if (std::ranges::none_of(others_.all(), [](const Other& other) { return other.away < kCrowd; })) return;
  for (std::size_t i = 0; i < wall_count_; ++i) {
    for (const Point end : {walls_[i].a, walls_[i].b}) {
      const double share = 0.5 * std::max(0.0, distance(end, here_) - spacing_.radius);
      if (share < step_ && hides_somebody(i, end)) bars_.add({at_point(end - here_), 0.0, share});
    }
  }
}

WayMade Surroundings::give_way(Offset wanted) const {
  if (robots_.empty()) return {wanted, spacing_.gap};
  base::UpTo<Segment, 6> beside;
  base::UpTo<RoundThing, 12> rounds;
  const double reach = narrow_reach(spacing_.radius, spacing_.gap);
  for (std::size_t i = 0; i < wall_count_; ++i) {
    if (length(standing_[i].place) < reach) beside.add(seen_from(here_, walls_[i]));
  }
  for (const percept::Obstacle& obstacle : obstacles_) {
    if (rounds.is_full() || length(obstacle.center) - obstacle.radius > reach) break;
    if (!obstacle.is_moving()) rounds.add({to_world(obstacle.center), obstacle.radius});
  }
  if (beside.size() + rounds.size() == 0) return {wanted, spacing_.gap};
  return give_way_at(wanted, side_room(unit(wanted), beside.all(), rounds.all()));
}

WayMade Surroundings::give_way_at(Offset wanted, const SideRoom& room) const {
  if (!room.is_narrow(spacing_.radius, spacing_.gap)) return {wanted, spacing_.gap};
  base::UpTo<Neighbour, flow::Robots::kCapacity> met;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const percept::RobotReading& robot = robots_[i];
    met.add({others_[i].place, others_[i].velocity, robot.radius, robot.is_unit_mate,
             robot.id.value < percepts_.id.value});
  }
  return make_way(wanted, spacing_.radius, spacing_.gap, room, met.all());
}

bool Surroundings::is_clear(Offset wanted, Offset now, double gap) const {
  for (const auto& list : {standing_.all(), passing_.all()}) {
    for (const Traffic& one : list) {
      if (!is_clear_of(one, wanted, now)) return false;
    }
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const auto& [place, velocity, away] = others_[i];
    if (away > near_) continue;
    const double reach = robots_[i].radius + spacing_.radius + gap;
    if (!is_clear_of({place, velocity, reach, spacing_.horizon, true}, wanted, now)) return false;
  }
  return true;
}

Offset Surroundings::least_change(Offset wanted, Offset now, double gap, double fastest) const {
  base::UpTo<Traffic, kMostTraffic> traffic;
  for (const Traffic& one : standing_) traffic.add(one);
  for (const bool shares : {false, true}) {
    const std::size_t room = kMostTraffic - (shares ? 0 : passing_.size());
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const auto& [place, velocity, away] = others_[i];
      if (traffic.size() >= room || away > near_) continue;
      if ((length(velocity) > kStands) != shares) continue;
      const double bodies = robots_[i].radius + spacing_.radius;
      const double apart = std::clamp(length(place), bodies + kLeastGap * spacing_.gap, bodies + gap);
      traffic.add({place, velocity, apart, spacing_.horizon, shares});
    }
    for (std::size_t i = 0; i < passing_.size() && !shares; ++i) traffic.add(passing_[i]);
  }
  return reciprocal_velocity(wanted, now, traffic.all(), percepts_.cycle_duration, fastest);
}

Offset Surroundings::clear_velocity(const WayMade& made, double fastest) const {
  const double most = std::max(fastest, kStands);
  const double dt = percepts_.cycle_duration;
  const Offset now = dt > 0.0 ? (here_ - before_) * (1.0 / dt) : Offset{};
  const bool is_alone =
      std::ranges::none_of(others_.all(), [&](const Other& other) { return other.away <= 0.5 * near_; });
  Offset wanted = made.wanted;
  if (!is_alone) wanted = wanted + Offset{wanted.y, -wanted.x} * kToTheRight;
  const bool is_free = length(wanted) <= most && is_clear(wanted, now, made.gap);
  const Offset chosen = is_free ? wanted : least_change(wanted, now, made.gap, most);
  if (bars_.size() == 0) return chosen;
  const Offset motion = chosen * dt;
  const Offset clear = clear_motion(motion, bars_.all());
  return clear == motion ? chosen : clear * (1.0 / dt);
}

}  // namespace mlab::schema
