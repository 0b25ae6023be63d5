#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The sticks of all units that are under teleoperation, each with its dead-man's switch: nobody holds the
/// stick for kDeadMan, and the robots stand.
///
/// `wall` is in seconds of any clock that does not go back: a person's hand knows no simulated time.
class Teleoperations {
 public:
  static constexpr double kDeadMan = 0.5;  ///< [s]

  /// Finds out which units are under teleoperation now; sticks of others are let go. True where that has
  /// changed.
  bool update(run::MissionRun& run);
  /// @errors  a sentence: the unit is not under teleoperation, a value is no number
  std::optional<std::string> push(run::MissionRun& run, const Stick& stick, double wall);
  /// Lets go of the sticks that nobody has held for too long. True where there were some.
  bool relax(run::MissionRun& run, double wall);
  /// All at once.
  void let_go(run::MissionRun& run);
  /// When some stick is to be let go; nothing: none is held.
  std::optional<double> next_release() const;

  bool is_open(const std::string& unit) const;
  /// Names of the units, in the order in which they came.
  std::vector<std::string> units() const;
  /// All of their robots, ascending.
  const std::vector<base::RobotId>& robots() const { return robots_; }
  void encode(Status& out) const;

 private:
  struct Unit {
    std::string name;
    std::vector<base::RobotId> robots;
    double held_at = 0.0;
    bool is_held = false;
  };
  static void let_go(run::MissionRun& run, Unit& unit);

  std::vector<Unit> units_;
  std::vector<base::RobotId> robots_;
};

}  // namespace mlab::console
