#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "mlab/base/up_to.h"
#include "mlab/flow/lists.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/schema/clearance.h"
#include "mlab/schema/narrow.h"
#include "mlab/schema/reciprocal.h"

namespace mlab::schema {

/// What a body keeps from others, and how far ahead it looks for them.
struct Spacing {
  double radius = 0.2;        ///< of the body [m]
  double gap = 0.6;           ///< between two bodies [m]
  double obstacle_gap = 0.2;  ///< between the body and what is solid [m]
  double horizon = 3.0;       ///< [s], > 0
  double fastest = 7.0;       ///< that it may ever want to go [m/s], > 0
};

/// What is round a body that goes among others: what it keeps clear of, and what it must not touch in the
/// cycle that comes. For one cycle, as seen from the body, turned as the world is.
class Surroundings {
 public:
  using ObstacleList = flow::ListView<percept::Obstacle>;
  using RobotList = flow::ListView<percept::RobotReading>;

  /// @param percepts  outlive this, like the lists
  /// @param before    where the body was in the cycle before [m, world]
  /// @param seen      where robots were then; knows from now on where they are
  Surroundings(const percept::Percepts& percepts, const Spacing& spacing, const ObstacleList& obstacles,
               const RobotList& robots, geom::Point before, SeenRobots& seen);

  geom::Offset to_world(geom::Vector v) const {
    return {ahead_.x * v.x - ahead_.y * v.y, ahead_.y * v.x + ahead_.x * v.y};
  }
  /// In the plane.
  geom::Vector to_robot(geom::Offset v) const {
    return {ahead_.x * v.x + ahead_.y * v.y, ahead_.x * v.y - ahead_.y * v.x, 0.0};
  }

  /// What a body wants that lets those pass whom it meets in a narrow place.
  /// @param wanted  [m/s]
  WayMade give_way(geom::Offset wanted) const;

  /// The velocity nearest to the wanted one with which it meets nobody and drives into nothing.
  geom::Offset clear_velocity(const WayMade& made, double fastest) const;

 private:
  struct Other {
    geom::Offset place;
    geom::Offset velocity;
    double away = 0.0;
  };

  void add_edges();
  void add_walls();
  bool is_known_wall(const percept::Obstacle& seen) const;
  void add_obstacles();
  /// @return  the least room that it has to any of them [m]
  double add_robots(SeenRobots& seen);
  double room_to(std::size_t robot) const;
  void bar_robots();
  void bar_ends_of_walls();
  /// Whether somebody may stand unseen behind that end of a wall: nothing goes straight on from it.
  bool hides_somebody(std::size_t wall, geom::Point end) const;
  WayMade give_way_at(geom::Offset wanted, const SideRoom& room) const;
  bool is_clear(geom::Offset wanted, geom::Offset now, double gap) const;
  geom::Offset least_change(geom::Offset wanted, geom::Offset now, double gap, double fastest) const;

  const percept::Percepts& percepts_;
  Spacing spacing_;
  const ObstacleList& obstacles_;
  const RobotList& robots_;
  geom::Point here_;
  geom::Point before_;
  geom::Offset ahead_;  // of length 1, where it looks [world]
  double near_;         // who is farther away is not looked at [m]
  double step_;         // that it comes at most in a cycle [m]
  std::size_t wall_count_ = 0;
  std::array<geom::Segment, 6> walls_;
  base::UpTo<Traffic, 12> standing_;  // the walls first
  base::UpTo<Traffic, 6> passing_;
  base::UpTo<Bar, 48> bars_;
  base::UpTo<Other, flow::Robots::kCapacity> others_;  // by place in the list of robots
};

}  // namespace mlab::schema
