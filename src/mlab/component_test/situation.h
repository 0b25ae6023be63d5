#pragma once

#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/percept/percepts.h"

namespace mlab::component_test {

/// What a test says that its robot senses, from one `given` to the next.
class Situation {
 public:
  /// @param steps  all of the test: what has no number of its own gets one that none of them says
  explicit Situation(const std::vector<cdl::LoweredStep>& steps);

  /// `given ...`, `given no ...`
  void take(const cdl::LoweredStep& step);
  /// Valid until something else is called.
  ///
  /// @param cycle  from 1
  const percept::Percepts& in_cycle(std::uint64_t cycle);

 private:
  struct Obstacle {
    geom::Point at;
    double radius = 0.0;
  };
  struct Robot {
    geom::Point at;
    double heading = 0.0;
    percept::RobotReading reading;
  };
  struct Object {
    geom::Point at;
    percept::ObjectReading reading;
  };
  struct Contact {
    geom::Point at;
    percept::RadioContact contact;
  };
  /// Numbers of things of a kind.
  struct Ids {
    std::set<std::uint32_t> said;
    std::uint32_t next = 1;  ///< that may be free
  };

  void forget(cdl::TestPercept what);
  static std::uint32_t id_of(const cdl::LoweredStep& step, Ids& ids);
  void take_order(const cdl::LoweredStep& step);
  void take_unit(const cdl::LoweredStep& step);
  void take_robot(const cdl::LoweredStep& step);
  void take_object(const cdl::LoweredStep& step);
  void take_stick(const cdl::LoweredStep& step);
  void sense();
  void sense_around();
  void sense_unit();

  percept::Percepts percepts_;
  std::vector<Obstacle> obstacles_;
  std::vector<Robot> robots_;
  std::vector<Object> objects_;
  std::vector<percept::RangeReading> beams_;
  std::vector<geom::Point> route_;
  std::vector<std::uint64_t> messages_;
  std::vector<percept::SharedPlace> shared_places_;
  std::vector<percept::AskedPassage> asked_passages_;
  std::vector<percept::Claim> claims_;
  std::vector<Contact> contacts_;
  std::vector<percept::Door> doors_;
  std::vector<percept::Hallway> hallways_;
  bool is_sensed_ = false;    // the lists below are those of what was given
  std::uint32_t orders_ = 0;  // that there were, and ends of them
  bool has_center_ = false;
  bool has_leader_ = false;
  bool has_neighbor_ = false;
  Ids robot_ids_ = {{1}, 2};  // the tested one is 1
  Ids object_ids_;

  // Of the cycle, nearest first.
  std::vector<percept::Obstacle> seen_obstacles_;
  std::vector<percept::RobotReading> seen_robots_;
  std::vector<percept::ObjectReading> seen_objects_;
  std::vector<percept::RadioContact> heard_;  // strongest first
};

}  // namespace mlab::component_test
