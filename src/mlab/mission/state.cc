#include "mlab/mission/state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace mlab::mission {
namespace {

auto fields(const UnitCommand& c) {
  return std::tie(c.unit, c.robots, c.task, c.place_name, c.goal, c.route, c.swath, c.margin, c.start_step,
                  c.formation, c.has_formation, c.technique, c.speed, c.heading, c.phase_lines,
                  c.on_completion, c.until);
}

template <class Robots>
auto find_robot_in(Robots& robots, base::RobotId id) -> decltype(robots.data()) {
  // Ids are dense from 1 in every mission that was not edited: try that first.
  const std::size_t guess = std::size_t{id.value} - 1;
  if (guess < robots.size() && robots[guess].id == id) return &robots[guess];
  const auto at = std::ranges::lower_bound(robots, id, {}, &RobotState::id);
  return at != robots.end() && at->id == id ? &*at : nullptr;
}

}  // namespace

std::string_view name(Outcome outcome) {
  constexpr std::array<std::string_view, 7> kNames = {"pending", "running",  "done",   "failed",
                                                      "aborted", "replaced", "skipped"};
  const auto index = static_cast<std::size_t>(outcome);
  return index < kNames.size() ? kNames[index] : "";
}

std::string_view name(Failure failure) {
  constexpr std::array<std::string_view, 6> kNames = {"",
                                                      "robots did not start",
                                                      "no progress",
                                                      "no progress, and robots that it waits for do not run",
                                                      "none of its robots runs",
                                                      "no way leads there"};
  const auto index = static_cast<std::size_t>(failure);
  return index < kNames.size() ? kNames[index] : "";
}

bool operator==(const CommandRef& a, const CommandRef& b) {
  if (a.value == b.value) return true;
  return a.value != nullptr && b.value != nullptr && fields(*a.value) == fields(*b.value);
}

RobotState* find_robot(State& state, base::RobotId id) {
  return find_robot_in(state.robots, id);
}
const RobotState* find_robot(const State& state, base::RobotId id) {
  return find_robot_in(state.robots, id);
}

}  // namespace mlab::mission
