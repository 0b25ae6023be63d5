#include "mlab/mission/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "mlab/mission/step.h"
#include "mlab/mission/tasks.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

// Those robots of the run for which the predicate holds leave it. @return  them
template <class Predicate>
std::vector<base::RobotId> let_go(Run& run, const Predicate& leaves) {
  std::vector<base::RobotId> gone;
  std::erase_if(run.needed, [&](base::RobotId id) {
    if (!leaves(id)) return false;
    gone.push_back(id);
    return true;
  });
  return gone;
}

bool runs_already(const RobotState& robot) {
  return robot.is_running && robot.life != RobotState::Life::kStopped;
}

bool can_follow(const RobotState& robot) {
  return robot.life == RobotState::Life::kStarted && (robot.seen == 0 || robot.is_running);
}

// It ran once, and does not now: another one may take its place, but it does not come by itself.
bool is_lost(const RobotState& robot) {
  return robot.life == RobotState::Life::kStarted && robot.seen != 0 && !robot.is_running;
}

void warn_of_left_out(Turn& turn, const Run& run, const std::vector<base::RobotId>& out) {
  const bool is_one = out.size() == 1;
  warn(turn,
       fmt::format("{}{} {} not run and {} left out of `{}`", owner_prefix(turn.state, run.owner),
                   robots_text(out), is_one ? "does" : "do", is_one ? "is" : "are",
                   turn.state.commands[run.record].text),
       run.owner);
}

// Of a step: who was lost before, if others are left. A step waits for robots that were never started, since
// they may still come; and where robots share something nobody waits for who is lost.
void leave_out_lost(Turn& turn, Run& run) {
  if (info(run.command->task).is_shared) return;
  const auto lost = [&](base::RobotId id) { return is_lost(*find_robot(turn.state, id)); };
  if (std::ranges::all_of(run.needed, lost)) return;
  run.left_out = let_go(run, lost);
  if (!run.left_out.empty()) warn_of_left_out(turn, run, run.left_out);
}

// Who is not in the plan any more, who runs already, and who does not run.
bool leave_out(Turn& turn, Run& run) {
  const State& s = turn.state;
  const Task task = run.command->task;
  let_go(run, [&](base::RobotId id) { return find_robot(s, id) == nullptr; });
  std::vector<base::RobotId> out;
  if (task == Task::kStart) {
    out = let_go(run, [&](base::RobotId id) { return runs_already(*find_robot(s, id)); });
    const std::string prefix = owner_prefix(s, run.owner);
    if (!out.empty())
      warn(turn,
           fmt::format("{}{} {} already and can't be started again", prefix, robots_text(out),
                       out.size() == 1 ? "runs" : "run"),
           run.owner);
  } else if (task != Task::kStop && is_step(s, run.owner)) {
    leave_out_lost(turn, run);
  } else if (task != Task::kStop) {
    out = let_go(run, [&](base::RobotId id) { return !can_follow(*find_robot(s, id)); });
    if (!out.empty() && !run.needed.empty()) warn_of_left_out(turn, run, out);
  }
  run.missing = static_cast<std::uint32_t>(run.needed.size());
  if (!run.needed.empty() || out.empty() || task == Task::kStart) return true;
  end_run(turn, run, Outcome::kFailed,
          fmt::format("{} {} not run", robots_text(out), out.size() == 1 ? "does" : "do"),
          Failure::kNobodyLeft);
  return false;
}

// A command that another one takes robots from goes on with the others. @return  the robots
std::vector<base::RobotId> take(Turn& turn, const Run& taker, Run& other,
                                const std::vector<base::RobotId>& sorted) {
  State& s = turn.state;
  std::vector<base::RobotId> gone = let_go(other, [&](base::RobotId id) {
    if (!std::ranges::binary_search(sorted, id)) return false;
    if (!find_robot(s, id)->done) --other.missing;
    return true;
  });
  if (gone.empty()) return gone;
  other.stalled = 0.0;
  const std::string by = s.commands[taker.record].text;
  if (other.needed.empty())
    end_run(turn, other, Outcome::kReplaced, fmt::format("by `{}`", by));
  else
    message(turn,
            fmt::format("{}{} goes on without {}: `{}`", owner_prefix(s, other.owner),
                        s.commands[other.record].text, robots_text(gone), by),
            other.owner);
  return gone;
}

// Who names robots knows that he takes them out of their unit.
void warn_of_twice(Turn& turn, const Run& run, const std::vector<base::RobotId>& twice) {
  if (twice.empty() || run.unit == kNoUnit) return;
  warn(turn,
       fmt::format("{}{} {} in two commands of this step; the last one, `{}`, has {}",
                   owner_prefix(turn.state, run.owner), robots_text(twice), twice.size() == 1 ? "is" : "are",
                   turn.state.commands[run.record].text, twice.size() == 1 ? "it" : "them"),
       run.owner);
}

// Of two commands of one step the last one has the robot, also where the first one had to wait.
// @return  whether somebody is left
bool leave_to_later(const State& s, Run& run) {
  const bool was_empty = run.needed.empty();
  for (std::size_t i = index_of(s, run) + 1; i < s.runs.size() && s.runs[i].owner == run.owner; ++i) {
    const auto& later = s.runs[i].needed;
    let_go(run, [&](base::RobotId id) { return std::ranges::find(later, id) != later.end(); });
  }
  return was_empty || !run.needed.empty();
}

}  // namespace

bool is_free(const State& state, const Run& run) {
  if (!is_step(state, run.owner)) return true;
  return std::ranges::none_of(run.needed,
                              [&](base::RobotId id) { return order_of_robot(state, id) != nullptr; });
}

bool claim(Turn& turn, Run& run) {
  State& s = turn.state;
  if (!leave_to_later(s, run)) {
    end_run(turn, run, Outcome::kReplaced, "by a later command of its step");
    return false;
  }
  if (!leave_out(turn, run)) return false;
  std::vector<base::RobotId> sorted = run.needed;
  std::ranges::sort(sorted);
  std::vector<base::RobotId> twice;
  for (Run& other : s.runs) {
    if (&other == &run || other.phase == Run::Phase::kEnded || other.phase == Run::Phase::kHeld) continue;
    const std::vector<base::RobotId> gone = take(turn, run, other, sorted);
    if (other.owner == run.owner) twice.insert(twice.end(), gone.begin(), gone.end());
  }
  for (const base::RobotId id : run.needed) {
    RobotState& robot = *find_robot(s, id);
    robot.run = index_of(s, run);
    robot.done = robot.warned = robot.has_given_up = false;
    robot.remaining = robot.best = std::numeric_limits<double>::infinity();
  }
  warn_of_twice(turn, run, twice);
  return true;
}

}  // namespace mlab::mission
