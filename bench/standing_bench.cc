// Robots as they stand in missions: in lines, columns, blocks and units. Each senses the robots around it,
// and drives about. Prints how fast that goes in processor time, and a sum that tells whether they ended at
// the same places.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

constexpr double kCycle = 0.1;  // [s]

struct Standing {
  const char* name;
  std::uint32_t robots;
  std::function<geom::Point(std::uint32_t)> at;
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::uint64_t mixed(std::uint64_t sum, double value) {
  return (sum ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
}

// Everybody keeps away from the nearest one, and goes ahead.
percept::Action act(const percept::Percepts& percepts) {
  percept::Action out;
  out.drives = true;
  out.velocity = {0.8, 0.0};
  if (!percepts.robots.empty()) {
    const auto& nearest = percepts.robots.front();
    const double distance = std::max(0.1, std::hypot(nearest.center.x, nearest.center.y));
    out.velocity.x -= nearest.center.x / (distance * distance);
    out.velocity.y -= nearest.center.y / (distance * distance);
  }
  return out;
}

void run(const Standing& standing, double reach, int cycles) {
  Simulator simulator(World{});
  for (std::uint32_t i = 0; i < standing.robots; ++i) {
    const geom::Point at = standing.at(i);
    simulator.add_body({.spec = {}, .pose = {at, 0.1 * (i % 60)}, .robot = {i + 1}});
  }
  std::vector<percept::Action> actions(standing.robots);
  SenseBuffer buffer;
  const double began = processor_seconds();
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (std::uint32_t i = 0; i < standing.robots; ++i) {
      percept::Percepts percepts;
      simulator.sense({i}, {{percept::Sensor::kRobots, reach}}, buffer, percepts);
      actions[i] = act(percepts);
    }
    simulator.step(actions, kCycle);
  }
  const double seconds = processor_seconds() - began;
  std::uint64_t sum = 0xcbf29ce484222325;
  for (std::uint32_t i = 0; i < standing.robots; ++i) {
    const geom::Pose pose = simulator.pose({i});
    sum = mixed(mixed(mixed(sum, pose.position.x), pose.position.y), pose.heading);
  }
  fmt::print("{:<28} {:>6} robots {:>5.0f} m {:>12.0f} robot-cycles/s   {:016x}\n", standing.name,
             standing.robots, reach, standing.robots * static_cast<double>(cycles) / seconds, sum);
}

}  // namespace
}  // namespace mlab::sim

int main() {
  using mlab::geom::Point;
  const std::vector<mlab::sim::Standing> all = {
      {"line", 10'000, [](auto i) { return Point{2.0 * i, 50.0}; }},
      {"column", 10'000, [](auto i) { return Point{50.0, 2.0 * i}; }},
      {"hundred columns", 10'000, [](auto i) { return Point{20.0 * (i % 100), 2.0 * (i / 100)}; }},
      {"block", 10'000, [](auto i) { return Point{2.0 * (i % 100), 2.0 * (i / 100)}; }},
      {"250 units of four", 1'000, [](auto i) { return Point{0.0, 25.0 * (i / 4) + 1.5 * (i % 4)}; }},
      {"250 units in a square", 1'000,
       [](auto i) { return Point{40.0 * (i / 4 % 16) + 1.5 * (i % 4), 40.0 * (i / 64)}; }},
      {"spread evenly, askew", 10'000,
       [](auto i) { return Point{3.1 * (i % 100) + 0.37 * (i % 7), 3.3 * (i / 100) + 0.29 * (i % 11)}; }},
  };
  for (const auto& standing : all) {
    for (const double reach : {3.0, 30.0}) mlab::sim::run(standing, reach, standing.robots > 5000 ? 10 : 100);
  }
}
