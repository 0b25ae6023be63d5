#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/formation.h"
#include "mlab/percept/site_map.h"
#include "mlab/ways/ground.h"

namespace mlab::percept {

/// Something solid nearby: a disc, or the piece of a wall that a ray hit (then with a small radius).
struct Obstacle {
  geom::Vector center;  ///< [m, robot frame]
  double radius = 0.0;  ///< [m]
  geom::Vector velocity =
      {};  ///< over the ground, whatever the robot does itself [m/s, robot frame]; 0: it stands

  constexpr bool is_moving() const { return !(velocity == geom::Vector{}); }
};

/// The kinds of things that a robot tells apart by colour. A value is a bit number of an ObjectClasses mask.
/// @source  the historic table of object classes
enum class ObjectClass : std::uint8_t {
  kMine,
  kEnemyRobot,
  kFlag,
  kBasket,
  kRock,
  kTree,
  kHomeBase,
  kUnknown,
  kHidingPlace,
  kYellowMarker,
  kFriendlyRobot
};
/// The last one, for who checks numbers from outside.
inline constexpr ObjectClass kLastObjectClass = ObjectClass::kFriendlyRobot;

/// Another robot in sight.
struct RobotReading {
  base::RobotId id;
  geom::Vector center;                                     ///< [m, robot frame]
  double heading = 0.0;                                    ///< relative to this robot's heading [rad]
  double radius = 0.2;                                     ///< of its body [m]
  bool is_unit_mate = false;                               ///< of the same outermost unit
  ObjectClass object_class = ObjectClass::kFriendlyRobot;  ///< told by its colour
};

/// What may be done with an object.
enum class ObjectStyle : std::uint8_t { kFixed, kMovable, kContainer };

/// An object (attractor, basket, flag, tree, ...) in sight; never one that somebody carries.
struct ObjectReading {
  base::ObjectId id;  ///< 0: no object
  ObjectClass object_class = ObjectClass::kUnknown;
  ObjectStyle style = ObjectStyle::kFixed;
  geom::Vector center;  ///< [m, robot frame]
  double radius = 0.0;  ///< [m]
};

/// That a robot asked to be let through.
struct AskedPassage {
  base::RobotId from;
  geom::Point to{};   ///< where it wants to go, straight on [m, world]
  double cost = 0.0;  ///< of those who meet, the one with the least goes first
  double time = 0.0;  ///< when it asked [s]
};

/// A place that another robot told, and what is there.
struct SharedPlace {
  base::RobotId from;
  base::ObjectId object;  ///< as the teller knows it; 0: just a place
  ObjectClass object_class = ObjectClass::kUnknown;
  geom::Point place{};  ///< [m, world]
  double time = 0.0;    ///< when it was told [s]
};

/// An object that a robot of the own team, perhaps this one, has claimed: the others leave it alone.
struct Claim {
  base::ObjectId object;
  base::RobotId robot;
};

/// How far a task is that robots of a team contract for.
enum class ContractState : std::uint8_t {
  kOpen,     ///< bids are wanted
  kAwarded,  ///< somebody has it
  kStarted,  ///< and works on it
  kDone,     ///< he has told that it is done
  kFailed,   ///< nobody wanted it
};

/// The last one, for who checks numbers from outside.
inline constexpr ContractState kLastContractState = ContractState::kFailed;

/// A task of the own team: who announced it, and who carries it out.
/// @source  Smith 1980, "The Contract Net Protocol", IEEE Transactions on Computers C-29(12)
struct Contract {
  std::uint64_t task = 0;  ///< base::hash_text of its name
  base::ObjectId object;   ///< what it is about, or its number among those of the same name
  geom::Point place{};     ///< [m, world]
  ContractState state = ContractState::kOpen;
  base::RobotId manager;     ///< who announced it
  base::RobotId contractor;  ///< who has it, or had it when it was done; 0: nobody
  base::RobotId reneged;     ///< who gave it back last, and may not bid for it; 0: nobody
  double time = 0.0;         ///< when it was announced or, since then, awarded or given back [s]
};

/// Where the camera looks, and how much it sees.
struct Camera {
  double pan = 0.0;                               ///< of its axis, counter-clockwise from ahead [rad]
  double field_of_view = 2.0 * std::numbers::pi;  ///< full angle [rad]
};

/// One beam of a range sensor ring. Beams come in the order of the ring's mounting.
struct RangeReading {
  float angle = 0.0F;  ///< of the beam's axis [rad, robot frame]
  float distance =
      0.0F;  ///< from the body's surface to the nearest thing; the range where nothing was hit [m]
  bool hit = false;
};

/// Another robot whose radio this one hears. It says where it is.
struct RadioContact {
  base::RobotId id;
  geom::Vector center;        ///< [m, robot frame]
  double strength = 0.0;      ///< of its signal, of that within 1 m [%], > 0
  bool is_unit_mate = false;  ///< of the same outermost unit
};

/// What the mission wants of a robot. The numbers are those of the historic command messages.
enum class Task : std::uint8_t {
  kNone = 0,
  kStart = 1,
  kMoveTo = 2,
  kTeleoperate = 3,
  kSweepTo = 4,
  kFollow = 5,
  kOccupy = 6,
  kStop = 7,
  kVisit = 8,   ///< its unit shares the points of the route among its robots
  kSearch = 9,  ///< its unit shares the pieces of the route; where a point stands twice the next piece begins
  kPatrol = 10  ///< its unit goes round the route, evenly spread
};
/// The last one, for who checks numbers from outside.
inline constexpr Task kLastTask = Task::kPatrol;
/// Whether its order has a route.
constexpr bool has_route(Task task) {
  return task == Task::kFollow || task == Task::kVisit || task == Task::kSearch || task == Task::kPatrol;
}

/// The command in force, as its robot sees it. Places are world points.
struct Order {
  std::uint32_t sequence = 0;  ///< grows with every new command; 0: no command yet
  Task task = Task::kNone;
  geom::Point goal;                    ///< [m, world]
  std::span<const geom::Point> route;  ///< of those that have one, first point first [m, world]
  Formation formation = Formation::kNone;
  FormationReference reference = FormationReference::kUnitCenter;
  double heading = 0.0;  ///< formation heading that the command fixes [rad, world], where has_heading
  bool has_heading = false;
  double speed = 0.0;   ///< cruise speed of the unit [m/s]; 0: the robot's own
  bool halted = false;  ///< hold where you are (overwatch, phase line, pause of a bound)
  double swath = 0.0;   ///< of a SEARCH: what a robot sees at once is so wide [m]; else 0
  double margin = 0.0;  ///< of a SEARCH: what its way keeps from the edges of things [m]; else 0
};

/// This robot's unit under the order in force. Comes from the unit, once per cycle, the same for all its
/// members; not from this robot's sensors.
struct UnitPercept {
  std::uint16_t size = 1;
  std::uint16_t rank = 0;          ///< of this robot among the members, 0-based
  geom::Point center;              ///< mean position of the members [m, world]
  geom::Offset center_step;        ///< how far the centre moved in the last cycle [m, world]
  geom::Pose leader;               ///< of the member of rank 0
  geom::Pose neighbor;             ///< of the member one rank before this one; its own for rank 0
  double formation_heading = 0.0;  ///< last direction in which the formation looked [rad, world]
};

/// The operator's stick.
struct Joystick {
  double x = 0.0;               ///< to the right, -1 .. 1
  double y = 0.0;               ///< up (ahead, or north), -1 .. 1
  double magnitude = 0.0;       ///< 0: nobody steers
  bool is_robot_frame = false;  ///< up is ahead; else up is north
  bool complete = false;        ///< End Teleoperation was pressed
  friend bool operator==(const Joystick&, const Joystick&) = default;
};

/// What a robot knows to stand on the ground: what its map says, and what robots of its team have sensed so
/// far, there or not any more. Discs and walls that they keep out of, and the mission area.
struct KnownGround {
  std::uint64_t revision = 0;  ///< another one: some of it is different. 0: nothing is known
  std::span<const ways::Round> discs;
  std::span<const geom::Segment> walls;  ///< [m, world]
  ways::Bounds bounds;
  /// So many of the last walls are edges of areas to keep out of: nothing stops a robot there.
  std::size_t edges = 0;
  /// Whether a wall, by its place in the list, is such an edge.
  bool is_edge(std::size_t wall) const { return wall + edges >= walls.size(); }
};

/// Everything that a robot may know in one cycle. Lists are views into a buffer of the cycle, nearest first,
/// valid until the cycle ends.
struct Percepts {
  base::RobotId id;  ///< of this robot
  geom::Pose pose;
  double time = 0.0;            ///< simulated or real time since the start of the run [s]
  double cycle_duration = 0.1;  ///< [s]
  std::span<const Obstacle> obstacles;
  std::span<const RobotReading> robots;
  std::span<const ObjectReading> objects;  ///< those in the camera's field of view
  Camera camera;
  std::span<const RangeReading> ranges;
  double range_limit = 0.0;  ///< how far the ring sees [m]
  geom::Vector touch;        ///< to the nearest thing that the body touches, of length 1; 0: nothing does
  SiteMap map;               ///< of the building around
  base::ObjectId carried;    ///< 0: hands are free
  ObjectClass carried_class = ObjectClass::kUnknown;
  Order order;
  UnitPercept unit;
  Joystick joystick;
  /// Notifications that arrived and were not taken yet, as hashes of their names (base::hash_text),
  /// ascending.
  std::span<const std::uint64_t> notifications;
  /// What every robot told last, by its id, ascending; this one's own may be among them.
  std::span<const SharedPlace> shared_places;
  /// What every robot asked for last of those in its way, by its id, ascending; this one's own may be among
  /// them.
  std::span<const AskedPassage> asked_passages;
  /// The claims that hold in this robot's team, by object, ascending. At most one for each object.
  std::span<const Claim> claims;
  /// The tasks that this robot's team contracts for, by task, then object, ascending.
  std::span<const Contract> contracts;
  KnownGround ground;                   ///< where it is wanted
  std::span<const RadioContact> radio;  ///< strongest first
};

}  // namespace mlab::percept
