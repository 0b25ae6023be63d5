#include "mlab/mission/technique.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "mlab/geom/pose.h"
#include "mlab/mission/command.h"
#include "mlab/mission/dispatch.h"
#include "mlab/mission/parts.h"
#include "mlab/mission/passage.h"
#include "mlab/mission/phase_line.h"

namespace mlab::mission {
namespace {

constexpr double kRestSpeed = 0.05;  ///< slower is at rest [m/s]
constexpr double kMaxSettling =
    5.0;  ///< after so long a halted part counts as at rest, whatever it reports [s]
constexpr double kFollowSlack =
    1.1;  ///< a trailing part that closed up waits until it is so much farther behind
constexpr double kShortestBound =
    0.25;  ///< of a bound's length: what would be left of the leg is done with the bound before
constexpr double kClosedUp = 0.1;  ///< in file: so much of a bound's length behind is no distance
constexpr double kTurnIn =
    2.0;  ///< FOLLOW: so many times its distance from the goal before it, a part makes for its own place

// What is left of the route, as the members that run tell it [m].
double reported_remaining(const State& state, const Group& group) {
  double sum = 0.0;
  double count = 0.0;
  for (const base::RobotId id : group.members) {
    const RobotState& robot = *find_robot(state, id);
    if (!in_sight(state, robot) || !robot.is_running || robot.reported != group.sequence ||
        !std::isfinite(robot.remaining))
      continue;
    sum += robot.remaining;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::infinity();
}

// Who does not run moves no more: the others of the part go on without it.
void measure(const State& state, const Run& run, Part& part) {
  const Group* group = find_group(state, part.sequence);
  if (group == nullptr) {
    part.done = true;  // all its robots went to other orders
    return;
  }
  const std::uint32_t run_index = index_of(state, run);
  part.done = std::ranges::all_of(group->members, [&](base::RobotId id) {
    const RobotState& robot = *find_robot(state, id);
    return robot.done || robot.run != run_index || !robot.is_running;
  });
  if (group->task == percept::Task::kFollow) {
    part.behind = reported_remaining(state, *group);
    part.remaining = part.behind + part.ahead;
  } else if (const auto at = centre(state, group->members, Whose::kRunning)) {
    part.remaining = geom::distance(*at, part.goal);
    part.behind = geom::distance(*at, goal_of(*run.command));
  }
}

// The end of a route belongs to all parts: shortly before it each of them makes for its own place.
void turn_in(Turn& turn, Part& part) {
  const Group* group = find_group(turn.state, part.sequence);
  if (group == nullptr || group->task != percept::Task::kFollow || part.done) return;
  const double aside = geom::distance(part.goal, goal_of(*group->command));
  if (aside <= 0.0 || part.behind > kTurnIn * aside) return;
  const auto done = [&](base::RobotId id) { return find_robot(turn.state, id)->done; };
  if (std::ranges::any_of(group->members, done)) return;
  Group next = *group;
  next.task = percept::Task::kMoveTo;
  next.goal = part.goal;
  part.sequence = give_order(turn, std::move(next));
}

bool is_at_rest(const Turn& turn, const Part& part) {
  const Group* group = find_group(turn.state, part.sequence);
  if (group == nullptr) return true;
  return std::ranges::all_of(group->members, [&](base::RobotId id) {
    const RobotState& robot = *find_robot(turn.state, id);
    return !in_sight(turn.state, robot) || geom::length(robot.step) <= kRestSpeed * turn.elapsed;
  });
}

// The part that bounds next: the first part first, then always the one that is farthest back. In file the
// first part leads as long as the others have closed up.
std::uint32_t next_mover(const Run& run) {
  const double slack = run.in_file ? kClosedUp * run.distance : 0.0;
  std::uint32_t farthest = kNoPart;
  for (std::uint32_t i = 0; i < run.parts.size(); ++i) {
    if (run.parts[i].done) continue;
    if (run.bounds == 0) return i;
    if (farthest == kNoPart || run.parts[i].remaining > run.parts[farthest].remaining + slack) farthest = i;
  }
  return farthest;
}

// A bound goes past the foremost other part; in file only the first part passes, the others close up to it.
void begin_bound(Run& run, std::uint32_t mover) {
  double foremost = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < run.parts.size(); ++i) {
    if (i != mover) foremost = std::min(foremost, run.parts[i].done ? 0.0 : run.parts[i].remaining);
  }
  run.target = foremost - (run.in_file && mover != 0 ? 0.0 : run.distance);
  if (!(run.target > kShortestBound * run.distance) || !std::isfinite(run.target)) run.target = 0.0;
  run.mover = mover;
  run.parts[mover].halted = false;
  ++run.bounds;
}

// Whether somebody of a part would be in the way of the others if it halted now.
bool is_in_the_way(const Turn& turn, const Part& part) {
  const Group* group = find_group(turn.state, part.sequence);
  return group != nullptr && std::ranges::any_of(group->members, [&](base::RobotId id) {
           const RobotState& robot = *find_robot(turn.state, id);
           return in_sight(turn.state, robot) &&
                  is_in_passage(turn.state.mission->overlay, robot.pose.position);
         });
}

void bound(Turn& turn, Run& run) {
  if (run.mover != kNoPart) {
    Part& mover = run.parts[run.mover];
    if (!mover.done && (run.target <= 0.0 || mover.remaining > run.target || is_in_the_way(turn, mover)))
      return;
    mover.halted = true;
    run.mover = kNoPart;
    run.settled = 0.0;
    run.stalled = 0.0;
    return;
  }
  run.settled += turn.elapsed;
  const bool at_rest =
      std::ranges::all_of(run.parts, [&](const Part& part) { return is_at_rest(turn, part); });
  if (!at_rest && run.settled < kMaxSettling) return;
  const std::uint32_t mover = next_mover(run);
  if (mover != kNoPart) begin_bound(run, mover);
}

// Each part keeps its distance to the one before it.
void trail(Run& run) {
  for (std::size_t i = 1; i < run.parts.size(); ++i) {
    const Part& ahead = run.parts[i - 1];
    Part& part = run.parts[i];
    const double gap = part.behind - ahead.behind;
    if (ahead.done || !std::isfinite(gap))
      part.halted = !ahead.done;
    else
      part.halted = gap < run.distance * (part.halted ? kFollowSlack : 1.0);
  }
}

}  // namespace

void steer_parts(Turn& turn, Run& run) {
  if (run.technique == Technique::kTraveling) return;
  for (Part& part : run.parts) {
    measure(turn.state, run, part);
    turn_in(turn, part);
  }
  if (run.technique == Technique::kBoundingOverwatch)
    bound(turn, run);
  else
    trail(run);
}

void apply_halts(Turn& turn, const Run& run) {
  const bool holds = holds_at_line(run);
  for (const Part& part : run.parts) {
    if (Group* group = find_group(turn.state, part.sequence)) set_halted(turn, *group, holds || part.halted);
  }
}

}  // namespace mlab::mission
