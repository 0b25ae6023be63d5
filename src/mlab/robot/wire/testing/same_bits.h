#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

/// Equality bit for bit: -0 is not 0, and a NaN equals itself.
namespace mlab::robot_wire::testing {

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
inline bool same(geom::Vector a, geom::Vector b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
inline bool same(geom::Point a, geom::Point b) {
  return same(a.x, b.x) && same(a.y, b.y);
}
inline bool same(geom::Pose a, geom::Pose b) {
  return same(a.position, b.position) && same(a.heading, b.heading);
}
inline bool same(const percept::Obstacle& a, const percept::Obstacle& b) {
  return same(a.center, b.center) && same(a.radius, b.radius);
}
inline bool same(const percept::RobotReading& a, const percept::RobotReading& b) {
  return a.id == b.id && same(a.center, b.center) && same(a.heading, b.heading) && same(a.radius, b.radius) &&
         a.is_unit_mate == b.is_unit_mate && a.object_class == b.object_class;
}
inline bool same(const percept::ObjectReading& a, const percept::ObjectReading& b) {
  return a.id == b.id && a.object_class == b.object_class && a.style == b.style && same(a.center, b.center) &&
         same(a.radius, b.radius);
}
inline bool same(const percept::RangeReading& a, const percept::RangeReading& b) {
  return same(a.angle, b.angle) && same(a.distance, b.distance) && a.hit == b.hit;
}
inline bool same(const percept::Order& a, const percept::Order& b) {
  return a.sequence == b.sequence && a.task == b.task && same(a.goal, b.goal) &&
         std::ranges::equal(a.route, b.route, [](geom::Point p, geom::Point q) { return same(p, q); }) &&
         a.formation == b.formation && a.reference == b.reference && same(a.heading, b.heading) &&
         a.has_heading == b.has_heading && same(a.speed, b.speed) && a.halted == b.halted;
}
inline bool same(const percept::UnitPercept& a, const percept::UnitPercept& b) {
  return a.size == b.size && a.rank == b.rank && same(a.center, b.center) &&
         same(a.center_step.x, b.center_step.x) && same(a.center_step.y, b.center_step.y) &&
         same(a.leader, b.leader) && same(a.neighbor, b.neighbor) &&
         same(a.formation_heading, b.formation_heading);
}
inline bool same(const percept::Joystick& a, const percept::Joystick& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.magnitude, b.magnitude) &&
         a.is_robot_frame == b.is_robot_frame && a.complete == b.complete;
}

inline bool same(const percept::Camera& a, const percept::Camera& b) {
  return same(a.pan, b.pan) && same(a.field_of_view, b.field_of_view);
}
inline bool same(const percept::SharedPlace& a, const percept::SharedPlace& b) {
  return a.from == b.from && a.object == b.object && a.object_class == b.object_class &&
         same(a.place, b.place) && same(a.time, b.time);
}
inline bool same(const percept::Claim& a, const percept::Claim& b) {
  return a.object == b.object && a.robot == b.robot;
}

inline bool same(const percept::SiteMap& a, const percept::SiteMap& b) {
  const auto same_points = [](geom::Point p, geom::Point q) { return same(p, q); };
  return std::ranges::equal(a.doors, b.doors,
                            [](const percept::Door& p, const percept::Door& q) {
                              return same(p.a, q.a) && same(p.b, q.b) && p.is_marked == q.is_marked;
                            }) &&
         std::ranges::equal(a.rooms, b.rooms,
                            [&](const percept::Room& p, const percept::Room& q) {
                              return std::ranges::equal(p.outline, q.outline, same_points);
                            }) &&
         std::ranges::equal(a.hallways, b.hallways, [](const percept::Hallway& p, const percept::Hallway& q) {
           return same(p.start, q.start) && same(p.end, q.end) && same(p.width, q.width);
         });
}

inline bool same(const percept::Percepts& a, const percept::Percepts& b) {
  const auto alike = [](const auto& p, const auto& q) {
    return std::ranges::equal(p, q, [](const auto& x, const auto& y) { return same(x, y); });
  };
  return same(a.map, b.map) && a.id == b.id && same(a.camera, b.camera) &&
         alike(a.shared_places, b.shared_places) && alike(a.claims, b.claims) && same(a.pose, b.pose) &&
         same(a.time, b.time) && same(a.cycle_duration, b.cycle_duration) &&
         alike(a.obstacles, b.obstacles) && alike(a.robots, b.robots) && alike(a.objects, b.objects) &&
         alike(a.ranges, b.ranges) && same(a.range_limit, b.range_limit) && a.carried == b.carried &&
         a.carried_class == b.carried_class && same(a.order, b.order) && same(a.unit, b.unit) &&
         same(a.joystick, b.joystick) && std::ranges::equal(a.notifications, b.notifications);
}

inline bool same(const percept::Request& a, const percept::Request& b) {
  return a.kind == b.kind && a.object == b.object && same(a.reach, b.reach) &&
         a.notification == b.notification && a.audience == b.audience && a.object_class == b.object_class &&
         same(a.cost, b.cost) && same(a.place, b.place) && same(a.heading, b.heading);
}
inline bool same(const percept::Action& a, const percept::Action& b) {
  return a.alert == b.alert && same(a.pan, b.pan) && a.looks == b.looks && same(a.velocity, b.velocity) &&
         same(a.spin, b.spin) && a.drives == b.drives && a.spins == b.spins &&
         a.status.sequence == b.status.sequence && a.status.done == b.status.done &&
         same(a.status.remaining, b.status.remaining) &&
         std::equal(a.requests.begin(), a.requests.begin() + a.request_count, b.requests.begin(),
                    b.requests.begin() + b.request_count,
                    [](const auto& x, const auto& y) { return same(x, y); });
}

}  // namespace mlab::robot_wire::testing
