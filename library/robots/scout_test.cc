// The standard robot of missions, to the bit: what it did when it was a network of nodes written by hand.

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/hash.h"
#include "mlab/base/random.h"
#include "mlab/robot/program/configuration_file.h"

#include "../testing/network.h"

namespace mlab::library_test {
namespace {

// Something that a robot may meet in a cycle: a random order, obstacles, robots, sticks, units.
class AnyCycle {
 public:
  explicit AnyCycle(std::uint64_t seed) : random_(seed) {}

  void next(percept::Percepts& p) {
    obstacles_.clear();
    robots_.clear();
    route_.clear();
    for (std::uint64_t n = random_.below(5); n > 0; --n)
      obstacles_.push_back({vector(), random_.uniform(0.0, 5.0)});
    for (std::uint64_t n = random_.below(4); n > 0; --n)
      robots_.push_back({.id = {static_cast<std::uint32_t>(n)}, .center = vector()});
    for (std::uint64_t n = random_.below(5); n > 0; --n) route_.push_back(point());
    if (random_.below(5) == 0) order(p.order);
    p.order.route = route_;
    p.obstacles = obstacles_;
    p.robots = robots_;
    p.pose = {point(), random_.uniform(-3.0, 3.0)};
    p.joystick = {
        .x = random_.uniform(-1.0, 1.0), .y = random_.uniform(-1.0, 1.0), .magnitude = random_.uniform()};
    if (random_.below(2) == 0) p.joystick = {};
    p.unit = {.size = 4,
              .rank = static_cast<std::uint16_t>(random_.below(4)),
              .center = point(),
              .center_step = {random_.uniform(), random_.uniform()},
              .leader = {point(), 0.3},
              .neighbor = {point(), 0.4},
              .formation_heading = random_.uniform()};
    p.time += 0.1;
  }

 private:
  geom::Vector vector() { return {random_.uniform(-40.0, 40.0), random_.uniform(-40.0, 40.0), 0.0}; }
  geom::Point point() { return {random_.uniform(0.0, 200.0), random_.uniform(0.0, 200.0)}; }
  void order(percept::Order& order) {
    order.sequence += 1;
    order.task = static_cast<percept::Task>(random_.below(8));
    order.goal = point();
    order.formation = static_cast<percept::Formation>(random_.below(10));
    order.reference = static_cast<percept::FormationReference>(random_.below(3));
    order.heading = random_.uniform();
    order.has_heading = random_.below(2) == 0;
    order.speed = random_.below(2) == 0 ? 0.0 : random_.uniform(1.0, 6.0);
    order.halted = random_.below(8) == 0;
  }

  base::Random random_;
  std::vector<percept::Obstacle> obstacles_;
  std::vector<percept::RobotReading> robots_;
  std::vector<geom::Point> route_;
};

// All that the program does in so many cycles, as one number, bit for bit.
std::uint64_t deeds(const flow::Program& program,
                    const std::vector<std::pair<const char*, const char*>>& parameters) {
  std::uint64_t hash = 1;
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = base::combine_bits(hash, bits);
  };
  flow::Frame frame = program.make_frame();
  for (const auto& [name, value] : parameters) {
    const flow::Port* port = program.find(name);
    EXPECT_NE(port, nullptr) << name;
    if (port == nullptr) continue;
    EXPECT_EQ(program.set(frame.data(), *port, value).value_or(""), "");
  }
  AnyCycle any(7);
  percept::Percepts percepts;
  for (int cycle = 0; cycle < 5000; ++cycle) {
    any.next(percepts);
    percept::Action action;
    program.step(frame.data(), percepts, action, 3, 5);
    add(action.velocity.x);
    add(action.velocity.y);
    add(action.spin);
    add(action.status.remaining);
    hash = base::combine_bits(hash, action.status.sequence * 8U + (action.drives ? 4U : 0U) +
                                        (action.spins ? 2U : 0U) + (action.status.done ? 1U : 0U));
    const percept::Needs needs = program.needs(frame.data());
    add(needs[percept::Sensor::kObstacles]);
    add(needs[percept::Sensor::kRobots]);
  }
  return hash;
}

const flow::Program& scout() {
  static const auto kRobot = [] {
    text::Diagnostics sink;
    auto robot = robot::library_robot("Scout", {}, {}, sink);
    EXPECT_TRUE(robot) << text::render(sink);
    return robot;
  }();
  return *kRobot->built.program;
}

TEST(Scout, DoesWhatItDidAsANetworkWrittenByHand) {
  EXPECT_EQ(deeds(scout(), {{"plans_ways", "0"}}), 8341195207322162590ULL);
  EXPECT_EQ(deeds(scout(), {{"plans_ways", "0"},
                            {"navigation_swirl_gain", "1"},
                            {"navigation_move_to_concealment_gain", "0.5"},
                            {"formation_reference", "leader"},
                            {"cautious_mode", "true"},
                            {"swirl_sphere", "20"}}),
            12023803421817601044ULL);
}

}  // namespace
}  // namespace mlab::library_test
