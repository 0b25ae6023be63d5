#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <rapidcheck.h>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

/// Percepts and actions with anything in them, for tests: numbers of any bits, and often the odd ones.
namespace mlab::robot_wire::testing {

inline double any_double() {
  constexpr std::array<std::uint64_t, 6> kOdd = {0x8000000000000000ULL,   // -0
                                                 0x7ff0000000000000ULL,   // infinity
                                                 0x7ff8000000000000ULL,   // a NaN
                                                 0xfff4000000012345ULL,   // a signalling NaN with a payload
                                                 0x0000000000000001ULL,   // the smallest number
                                                 0x3ff0000000000000ULL};  // 1
  const auto bits = *rc::gen::weightedOneOf<std::uint64_t>(
      {{3, rc::gen::arbitrary<std::uint64_t>()}, {1, rc::gen::elementOf(kOdd)}});
  return std::bit_cast<double>(bits);
}
inline float any_float() {
  return std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>());
}
inline bool any_bool() {
  return *rc::gen::arbitrary<bool>();
}
inline std::uint32_t any_id() {
  return *rc::gen::arbitrary<std::uint32_t>();
}
template <class Enum>
Enum any_of(Enum last) {
  return static_cast<Enum>(*rc::gen::inRange(0, static_cast<int>(last) + 1));
}
inline geom::Vector any_vector() {
  return {any_double(), any_double(), any_double()};
}
inline geom::Point any_point() {
  return {any_double(), any_double()};
}
inline geom::Pose any_pose() {
  return {any_point(), any_double()};
}

/// Percepts with the lists that they are views of.
struct AnyPercepts {
  std::vector<percept::Obstacle> obstacles;
  std::vector<percept::RobotReading> robots;
  std::vector<percept::ObjectReading> objects;
  std::vector<percept::RangeReading> ranges;
  std::vector<geom::Point> route;
  std::vector<std::uint64_t> notifications;
  std::vector<percept::SharedPlace> shared_places;
  std::vector<percept::Claim> claims;
  std::vector<percept::Door> doors;
  std::vector<std::vector<geom::Point>> outlines;
  std::vector<percept::Room> rooms;
  std::vector<percept::Hallway> hallways;
  percept::Percepts percepts;

  AnyPercepts() {
    const auto count = [] { return *rc::gen::inRange(0, 5); };
    for (int n = count(); n > 0; --n) obstacles.push_back({any_vector(), any_double()});
    for (int n = count(); n > 0; --n)
      robots.push_back({{any_id()},
                        any_vector(),
                        any_double(),
                        any_double(),
                        any_bool(),
                        any_of(percept::kLastObjectClass)});
    for (int n = count(); n > 0; --n) {
      objects.push_back({{any_id()},
                         any_of(percept::ObjectClass::kFriendlyRobot),
                         any_of(percept::ObjectStyle::kContainer),
                         any_vector(),
                         any_double()});
    }
    for (int n = count(); n > 0; --n) ranges.push_back({any_float(), any_float(), any_bool()});
    for (int n = count(); n > 0; --n) route.push_back(any_point());
    for (int n = count(); n > 0; --n) notifications.push_back(*rc::gen::arbitrary<std::uint64_t>());
    for (int n = count(); n > 0; --n) {
      shared_places.push_back(
          {{any_id()}, {any_id()}, any_of(percept::ObjectClass::kFriendlyRobot), any_point(), any_double()});
    }
    for (int n = count(); n > 0; --n) claims.push_back({{any_id()}, {any_id()}});
    for (int n = count(); n > 0; --n) doors.push_back({any_point(), any_point(), any_bool()});
    for (int n = count(); n > 0; --n) hallways.push_back({any_point(), any_point(), any_double()});
    for (int n = count(); n > 0; --n) {
      std::vector<geom::Point>& outline = outlines.emplace_back();
      for (int m = count(); m > 0; --m) outline.push_back(any_point());
    }
    for (const auto& outline : outlines) rooms.push_back({outline});
    percepts.map = {doors, rooms, hallways};
    percepts.id = {any_id()};
    percepts.camera = {any_double(), any_double()};
    percepts.pose = any_pose();
    percepts.time = any_double();
    percepts.cycle_duration = any_double();
    percepts.range_limit = any_double();
    percepts.carried = {any_id()};
    percepts.carried_class = any_of(percept::ObjectClass::kFriendlyRobot);
    percepts.order = {any_id(),
                      any_of(percept::Task::kStop),
                      any_point(),
                      route,
                      any_of(percept::Formation::kSweep),
                      any_of(percept::FormationReference::kNeighbor),
                      any_double(),
                      any_bool(),
                      any_double(),
                      any_bool()};
    percepts.unit = {*rc::gen::arbitrary<std::uint16_t>(),
                     *rc::gen::arbitrary<std::uint16_t>(),
                     any_point(),
                     {any_double(), any_double()},
                     any_pose(),
                     any_pose(),
                     any_double()};
    percepts.joystick = {any_double(), any_double(), any_double(), any_bool(), any_bool()};
    percepts.obstacles = obstacles;
    percepts.robots = robots;
    percepts.objects = objects;
    percepts.ranges = ranges;
    percepts.notifications = notifications;
    percepts.shared_places = shared_places;
    percepts.claims = claims;
  }
  AnyPercepts(const AnyPercepts&) = delete;
  AnyPercepts& operator=(const AnyPercepts&) = delete;
};

inline percept::Action any_action() {
  percept::Action action;
  action.velocity = any_vector();
  action.spin = any_double();
  action.drives = any_bool();
  action.spins = any_bool();
  action.pan = any_double();
  action.looks = any_bool();
  action.status = {any_id(), any_bool(), any_double()};
  for (int n = *rc::gen::inRange(0, percept::Action::kMaxRequests + 1); n > 0; --n) {
    action.ask({any_of(percept::Request::Kind::kEndMission),
                any_of(percept::Audience::kSelf),
                any_of(percept::ObjectClass::kFriendlyRobot),
                {any_id()},
                any_double(),
                any_double(),
                *rc::gen::arbitrary<std::uint64_t>(),
                any_point(),
                any_double()});
  }
  for (int n = *rc::gen::inRange(0, 127); n > 0; --n) action.alert[static_cast<std::size_t>(n - 1)] = 'a';
  return action;
}

}  // namespace mlab::robot_wire::testing
