#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "mlab/console/run/event_log.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Watches the robots of a run for what a person should know of: contacts, no progress, silence, changes of
/// state. Enters it into the log, not more than a person can read, and keeps what each robot's place on the
/// map shows.
class Alarms {
 public:
  static constexpr double kStuckAfter = 30.0;     ///< so long no nearer to done [s]
  static constexpr double kProgress = 0.5;        ///< what counts as nearer [m]
  static constexpr double kContactsApart = 5.0;   ///< of one robot, in the log [s]
  static constexpr std::size_t kMostAtOnce = 10;  ///< entries of one kind in one cycle; the rest is counted
  static constexpr std::size_t kMostRobots =
      200;  ///< with more, states are told only of robots that are watched

  struct Robot {
    std::uint32_t id = 0;
    std::uint32_t contacts = 0;
    std::uint32_t sequence = 0;                             ///< of the order whose progress is watched
    double best = std::numeric_limits<double>::infinity();  ///< least that remained [m]
    double since = 0.0;                                     ///< when it was that near for the first time [s]
    double contact_told = -kContactsApart;
    std::uint64_t states = 0;
    fleet::RobotLife life = fleet::RobotLife::kNotStarted;
    bool knows_states = false;
    bool is_stuck = false;
    bool is_lost = false;
    bool is_watched = false;
  };

  /// Once per cycle.
  void look(const run::MissionRun& run, EventLog& log);
  /// By place in the fleet.
  const std::vector<Robot>& robots() const { return robots_; }
  /// Whose states are told in any case, by id.
  void watch_states(std::vector<std::uint32_t> robots) { watched_ = std::move(robots); }

 private:
  void match(const std::vector<fleet::FleetRobot>& fleet);
  void look_at(const run::MissionRun& run, const fleet::FleetRobot& robot, Robot& known, EventLog& log);
  void look_for_contact(const run::MissionRun& run, const fleet::FleetRobot& robot, Robot& known,
                        EventLog& log);
  void look_for_progress(const run::MissionRun& run, const fleet::FleetRobot& robot, Robot& known,
                         EventLog& log);
  void look_for_silence(const run::MissionRun& run, const fleet::FleetRobot& robot, Robot& known,
                        EventLog& log);
  void look_for_states(const run::MissionRun& run, const fleet::FleetRobot& robot, Robot& known,
                       EventLog& log);

  std::vector<Robot> robots_;
  std::vector<std::uint32_t> watched_;
  std::size_t contacts_now_ = 0;
  std::size_t stuck_now_ = 0;
  std::size_t states_now_ = 0;
};

}  // namespace mlab::console
