#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/mission/failsafe.h"
#include "mlab/mission/tasks.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/formation.h"
#include "mlab/text/source.h"

namespace mlab::mission {

/// A NEW-ROBOT parameter. Numbers keep the text that was written, so that 0.3 stays 0.3.
struct RobotParameter {
  std::string key;               ///< case-sensitive
  std::string value;             ///< without quotes; booleans as `1` and `0`
  text::Place place;             ///< of the key
  text::Place value_place;       ///< of the value
  bool is_from_outside = false;  ///< it stands in no NEW-ROBOT: whoever loads the mission set it
};

/// What NEW-ROBOT defines, or the predefined ROBOT.
struct RobotType {
  std::string name;                        ///< compared without regard to letter case
  std::string program;                     ///< as written: `robot`, `mine.cnl`, `./forager`
  std::string color = "blue";              ///< an X11 colour name
  std::string host;                        ///< empty: here
  std::vector<RobotParameter> parameters;  ///< in file order; of equal keys the last counts
  text::Place place;                       ///< of the program's name; nowhere for ROBOT
};

/// A robot type that stands for several robots: NEW-ROBOT with a society of a configuration as its program.
struct Society {
  /// Robots of one type.
  struct Part {
    std::uint32_t type = 0;  ///< index into Mission::types: `f#Scout`
    int count = 1;
  };
  std::string name;         ///< compared without regard to letter case: `f`
  std::vector<Part> parts;  ///< in rank order
  text::Place place;        ///< of its name
};

struct Robot {
  base::RobotId id;
  std::uint32_t type = 0;  ///< index into Mission::types
  text::Place place;
};

/// A named group of robots. Recursive: the parts are the groups written directly inside, named or not.
struct Unit {
  std::string name;                    ///< empty for an unnamed group
  std::vector<base::RobotId> members;  ///< all robots below, depth first in file order
  std::vector<std::uint32_t> parts;    ///< indices into Mission::units; empty for a flat unit
  text::Place place;
};

enum class Technique : std::uint8_t { kTraveling, kTravelingOverwatch, kBoundingOverwatch };

/// A point in mission time.
struct MissionTime {
  enum class Kind : std::uint8_t {
    kSinceReached,  ///< seconds after the unit is in place (UNTIL TIMEOUT)
    kSinceStart,    ///< seconds after the mission clock's start (`+...`)
    kOfDay,         ///< seconds after midnight of the day on which the mission clock starts
    kAbsolute,      ///< seconds since 1970-01-01 00:00, in the mission clock's own time zone
  };
  Kind kind = Kind::kSinceReached;
  double seconds = 0.0;

  friend constexpr bool operator==(MissionTime, MissionTime) = default;
};

struct PhaseLine {
  std::string name;                 ///< as written
  std::vector<geom::Point> points;  ///< of the feature, at least one [m, world]
  double radius = 0.0;              ///< of a feature with a single point: half its size [m]
  std::optional<MissionTime> not_before;
  std::string acknowledge;  ///< text that the operator acknowledges; empty: none
  bool waits = false;       ///< hold at the line until it is acknowledged

  friend bool operator==(const PhaseLine&, const PhaseLine&) = default;
};

/// In place of a unit's index where a command names robots.
inline constexpr std::uint32_t kNoUnit = std::numeric_limits<std::uint32_t>::max();

/// `UNIT u ...`, `ROBOTS 2 5 7 ...`
struct UnitCommand {
  /// A place as it is written: `PP-A`, `310 205`.
  struct Written {
    std::string name;
    text::Place place;
  };

  std::uint32_t unit = 0;             ///< index into Mission::units; kNoUnit: `robots` are meant
  std::vector<base::RobotId> robots;  ///< a unit without a name as long as the command lasts, in rank order
  Task task = Task::kMoveTo;
  std::string place_name;          ///< as written; `310 205` for coordinates; empty for STOP
  geom::Point goal;                ///< [m, world]
  double radius = 0.0;             ///< RALLY: who is so near to the goal has arrived [m]
  std::vector<geom::Point> route;  ///< FOLLOW; VISIT and PATROL: the places; SEARCH: the outline [m, world]
  std::vector<Written> written;    ///< VISIT and PATROL: for each point of the route
  double swath = 0.0;              ///< SEARCH: what a robot sees at once is so wide [m]
  double margin = 0.0;             ///< SEARCH: what its planned way keeps from the edges of things [m]
  geom::Offset start_step;         ///< START: from one robot to the next [m]
  percept::Formation formation = percept::Formation::kNone;
  bool has_formation = false;  ///< a FORMATION clause was written
  Technique technique = Technique::kTraveling;
  double speed = 0.0;             ///< [m/s]; 0: the robot's own
  std::optional<double> heading;  ///< HEADING of the formation [rad, world]
  std::vector<PhaseLine> phase_lines;
  std::string on_completion;         ///< message; empty: none
  std::optional<MissionTime> until;  ///< OCCUPY: proceeds by itself then; others: are done then
  text::Place place;                 ///< in the text, of the unit's name or the robots' numbers
  text::Place goal_place;            ///< in the text, of `place_name`
};

/// What SET switches on and off.
enum class BooleanOption : std::uint8_t {
  kUseMilitaryStyle,
  kShowTrails,
  kHighlightRepellingObstacles,
  kShowMovementVectors,
  kShowColormap,
  kDebugRobots,
  kDebugSimulator,
  kDebugScheduler,
  kScaleRobots,
  kPlanWays,
  kAssignStations
};
/// What SET gives a number.
enum class NumberOption : std::uint8_t {
  kSeed,
  kRobotLength,
  kObstacleCoverage,
  kMinObstacleRadius,
  kMaxObstacleRadius,
  kZoomFactor,
  kCycleDuration,
  kFailingRobots,
  kFailuresWithin,
  kCohesion
};
/// `SET option ON`
struct SetBoolean {
  BooleanOption option = BooleanOption::kShowTrails;
  bool value = true;
};
/// `SET option number`
struct SetNumber {
  NumberOption option = NumberOption::kSeed;
  double value = 0.0;
};
struct Print {
  bool robot_info = false;  ///< else the console database
};
struct Quit {};

using Command = std::variant<UnitCommand, SetBoolean, SetNumber, Print, Quit>;

/// Commands that start together. The step is done when all of them are.
struct Step {
  std::string label;  ///< without the point: `2a`
  std::vector<Command> commands;
  text::Place place;
};

/// All SET options, with the historic defaults.
struct Options {
  std::optional<double> seed;         ///< for CREATE-OBSTACLES, rounded to a 32-bit float as historically
  double robot_length = 0.0;          ///< drawing only; 0: default
  double obstacle_coverage = 3.0;     ///< [per cent of the area]
  double min_obstacle_radius = 2.0;   ///< [m]
  double max_obstacle_radius = 10.0;  ///< [m]
  double zoom_percent = 100.0;
  std::optional<double> cycle_duration;  ///< [s]
  double failing_robots = 0.0;           ///< in simulation: of each run, a whole number
  double failures_within = 100.0;        ///< they fail so soon after their start, at the latest [s]
  bool use_military_style = true;
  bool show_trails = false;
  bool highlight_repelling_obstacles = false;
  bool show_movement_vectors = false;
  bool show_colormap = false;
  bool debug_robots = false;
  bool debug_simulator = false;
  bool debug_scheduler = false;
  bool scale_robots = true;
  std::optional<bool>
      plans_ways;  ///< of robots whose types don't say; as their programs have it where not set
  std::optional<bool>
      assigns_stations;            ///< else by rank; assigned to robots that plan their ways where not set
  std::optional<double> cohesion;  ///< so far ahead of its station a robot waits [m]; 0: nobody waits
};

/// A mission, checked: every name is resolved. Immutable once loaded.
struct Mission {
  std::string name;
  std::string scenario;
  overlay::Overlay overlay;  ///< all overlays that it names, its own area, obstacles and start points added
  std::vector<RobotType> types;  ///< [0] is ROBOT
  std::vector<Society> societies;
  std::vector<Robot> robots;  ///< by id, ascending
  std::vector<Unit> units;
  Options options;
  std::vector<Failsafe> failsafes;  ///< of all robots, the highest rank first
  std::vector<Print> prints;        ///< of the preamble: to be printed once when the mission is loaded
  std::vector<Step> steps;
  text::SourcePtr source;
  std::string folder;                  ///< where names of files in it begin
  std::vector<text::SourcePtr> texts;  ///< what else was read for it: overlays, and what these name
  std::vector<std::pair<std::string, std::string>> set;  ///< names and values in place of what its text says
  std::vector<std::string> typed;                        ///< lines typed since that changed it, in order
  bool has_obstacles_by_seed = false;  ///< CREATE-OBSTACLES without SET SEED: others for another seed
};

}  // namespace mlab::mission
