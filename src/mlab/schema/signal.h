#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// Whose signals count.
enum class Heard : std::uint8_t { kAnybody, kMates, kOthers };

/// Of the robot that is heard best, in percent of what it is within 1 m; 0: nobody is heard.
double signal_strength(const percept::Percepts& percepts, Heard heard);

/// The ways in which a robot can care for its radio. The numbers are those of the historic library.
enum class SignalMethod : std::uint8_t { kRecovery, kPreservation, kPlan, kAverage, kGreedy };

/// What a robot remembers of its radio, and what that advises. One for each node that asks.
/// @source  Ulam and Arkin 2004, "When Good Communication Go Bad: Communications Recovery for Multi-Robot
///          Teams", ICRA (going back along the own way, then to a teammate); Powers and Balch 2004,
///          "Value-Based Communication Preservation for Mobile Robots", DARS (signals as part of the
///          choice of a motion);
///          Wagner and Arkin 2004, "Multi-Robot Communication-Sensitive Reconnaissance", ICRA (plans agreed
///          on beforehand)
class SignalMemory {
 public:
  struct Advice {
    geom::Vector direction{};  ///< of length 1 at most [robot frame]
    double confidence = 0.0;   ///< how much is to be thought of it, 0 .. 1
  };

  /// Once for each cycle.
  /// @param wanted  strength from which on all is well [%], > 0
  void note(const percept::Percepts& percepts, double wanted, Heard heard);

  /// Of a method, as things stood when they were noted last. With a strong signal: to stay, for sure.
  Advice advice(const geom::Pose& here, SignalMethod method, double wanted) const;

 private:
  static constexpr std::size_t kMostCrumbs = 64;

  void follow(geom::Point here);
  Advice recovery(const geom::Pose& here) const;
  Advice preservation(double wanted) const;
  Advice plan(const geom::Pose& here) const;

  std::array<geom::Point, kMostCrumbs> crumbs_{};  // the way since the signal was at its strongest, of
                                                   // which what was gone back is taken off [m, world]
  std::size_t count_ = 0;                          // of crumbs_
  double at_its_begin_ = 0.0;                      // how strong the signal was where that way began [%]
  double step_ = 0.0;                              // between two of them [m]
  double nearest_ = 0.0;                           // that it came to the last one since that was the last [m]
  bool was_left_ = false;                          // it was away from the last one meanwhile
  geom::Point meeting_{};                          // where it began [m, world]
  geom::Point heard_at_{};                         // where the last one was that it heard [m, world]
  geom::Vector toward_{};                          // to who is heard best, of length 1 [robot frame]
  double strength_ = 0.0;                          // of him [%]
  bool has_heard_ = false;
  bool has_begun_ = false;
};

}  // namespace mlab::schema
