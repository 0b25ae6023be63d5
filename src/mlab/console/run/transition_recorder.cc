#include "mlab/console/run/transition_recorder.h"

#include <algorithm>
#include <utility>

#include "mlab/console/published/overview.h"

namespace mlab::console {

void TransitionRecorder::watch(std::span<const std::uint32_t> robots) {
  std::erase_if(robots_,
                [&](const auto& known) { return std::ranges::find(robots, known.first) == robots.end(); });
  for (const std::uint32_t id : robots) robots_.try_emplace(id);
}

// An address tells whose it is as long as both exist, and the new ones were made beside the old.
void TransitionRecorder::change(const run::MissionRun& run) {
  for (auto& [id, watched] : robots_) {
    const fleet::FleetRobot* const robot = run.fleet().find({id});
    if (robot == nullptr || robot->workings().program != watched.program) watched = {};
  }
}

void TransitionRecorder::look(const run::MissionRun& run) {
  for (auto& [id, watched] : robots_) {
    const fleet::FleetRobot* robot = run.fleet().find({id});
    const bool runs =
        robot != nullptr && robot->life == fleet::RobotLife::kRunning && robot->workings().program;
    if (!runs) continue;
    const flow::Program& program = *robot->workings().program;
    const std::byte* const frame = robot->workings().frame;
    const bool begins = flow::Program::cycle(frame) <= 1;
    const bool is_known = std::exchange(watched.program, &program) == &program && !watched.now.empty();
    if (!is_known || begins) watched.last.clear();
    std::swap(watched.before, watched.now);
    program.sequence_states(frame, watched.now);
    if (begins) watched.before.clear();  // nothing was before
    if (!is_known && !begins) {
      watched.before = watched.now;
      continue;
    }
    for (const flow::Program::Transit& transit :
         program.transits(frame, watched.before, robot->workings().interventions))
      watched.last[transit.sequence] = {transit, run.time(), run.cycle()};
  }
}

void TransitionRecorder::encode(std::uint32_t robot, RobotDetail& out) const {
  const auto found = robots_.find(robot);
  if (found == robots_.end() || found->second.program == nullptr) return;
  const flow::Program& program = *found->second.program;
  for (const auto& [sequence, made] : found->second.last) {
    RobotDetail::Transition& told = *out.add_transitions();
    const std::vector<std::string>& names = program.state_names(sequence);
    told.set_sequence(clean(program.sequence_name(sequence)));
    told.set_from(clean(names[made.transit.from]));
    told.set_index(made.transit.way);
    told.set_to(clean(names[made.transit.to]));
    told.set_time(made.time);
    told.set_cycle(made.cycle);
    told.set_is_forced(made.transit.is_forced);
  }
}

std::span<const flow::Program::SequenceState> TransitionRecorder::before(std::uint32_t robot) const {
  const auto found = robots_.find(robot);
  if (found == robots_.end()) return {};
  return found->second.before;
}

}  // namespace mlab::console
