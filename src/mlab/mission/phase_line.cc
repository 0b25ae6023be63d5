#include "mlab/mission/phase_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "mlab/geom/pose.h"
#include "mlab/mission/clock.h"
#include "mlab/mission/question.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

// At least so many cycles of the robot's present motion are looked ahead.
constexpr double kMinCycles = 3.0;

bool meets(const geom::Segment& path, const PhaseLine& line, double body_radius) {
  if (line.points.size() == 1) {
    const geom::Point point = line.points.front();
    return geom::distance(geom::nearest_point(path, point), point) <= std::max(line.radius, body_radius);
  }
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    if (geom::intersects(path, {line.points[i - 1], line.points[i]})) return true;
  }
  return false;
}

// The robot crosses the line now or is about to. A robot at rest crosses nothing.
bool crosses(const Turn& turn, const RobotState& robot, const PhaseLine& line) {
  if (!in_sight(turn.state, robot) || geom::length(robot.step) <= 0.0) return false;
  const double cycles = turn.elapsed > 0.0
                            ? std::max(kMinCycles, turn.state.options.phase_line_ahead / turn.elapsed)
                            : kMinCycles;
  const geom::Point now = robot.pose.position;
  return meets({now - robot.step, now + robot.step * cycles}, line, robot.radius);
}

bool is_reached(const Turn& turn, const Run& run, const PhaseLine& line) {
  const std::uint32_t run_index = index_of(turn.state, run);
  return std::ranges::any_of(run.needed, [&](base::RobotId id) {
    const RobotState* robot = find_robot(turn.state, id);
    return robot != nullptr && robot->run == run_index && crosses(turn, *robot, line);
  });
}

bool may_pass(const State& state, const PhaseLine& said, const LineState& line) {
  return (!line.not_before || *line.not_before <= state.time) && (!said.waits || line.acknowledged);
}

void reach(Turn& turn, Run& run, std::uint32_t index) {
  const State& s = turn.state;
  const PhaseLine& said = run.command->phase_lines[index];
  if (said.not_before) run.lines[index].not_before = run_time_of(*said.not_before, s.options, s.time);
  std::string text =
      fmt::format("{} {} at phase line {}", addressee(s, run), is_one(run) ? "is" : "are", said.name);
  if (!said.acknowledge.empty()) text += ": " + said.acknowledge;
  message(turn, std::move(text), run.owner);
  if (said.waits) ask_to_acknowledge(turn, run, index);
  if (may_pass(s, said, run.lines[index])) {
    run.lines[index].phase = LineState::Phase::kPassed;
    return;
  }
  run.lines[index].phase = LineState::Phase::kHolding;
  message(turn,
          fmt::format("{} {}, waiting for {}", addressee(s, run), is_one(run) ? "holds" : "hold",
                      waiting_text(s, run)),
          run.owner);
}

void release(Turn& turn, Run& run, std::uint32_t index) {
  run.lines[index].phase = LineState::Phase::kPassed;
  run.stalled = 0.0;
  message(turn,
          fmt::format("{} {} on across phase line {}", addressee(turn.state, run),
                      is_one(run) ? "goes" : "go", run.command->phase_lines[index].name),
          run.owner);
}

}  // namespace

bool holds_at_line(const Run& run) {
  return std::ranges::any_of(run.lines,
                             [](const LineState& line) { return line.phase == LineState::Phase::kHolding; });
}

void watch_phase_lines(Turn& turn) {
  for (Run& run : turn.state.runs) {
    if (run.phase != Run::Phase::kRobots) continue;
    for (std::uint32_t i = 0; i < run.lines.size(); ++i) {
      const PhaseLine& said = run.command->phase_lines[i];
      const LineState& line = run.lines[i];
      if (line.phase == LineState::Phase::kAhead && is_reached(turn, run, said))
        reach(turn, run, i);
      else if (line.phase == LineState::Phase::kHolding && may_pass(turn.state, said, line))
        release(turn, run, i);
    }
  }
}

}  // namespace mlab::mission
