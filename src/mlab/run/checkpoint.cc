#include "mlab/run/checkpoint.h"

#include <utility>

#include "mlab/run/mission_run.h"

namespace mlab::run {
namespace {

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

std::size_t bytes_of(const mission::State& state) {
  std::size_t out = bytes_of(state.robots) + bytes_of(state.groups) + bytes_of(state.runs) +
                    bytes_of(state.questions) + bytes_of(state.steps) + bytes_of(state.commands);
  for (const mission::Group& group : state.groups) out += bytes_of(group.members);
  for (const mission::Run& run : state.runs)
    out += bytes_of(run.needed) + bytes_of(run.left_out) + bytes_of(run.lines) + bytes_of(run.parts);
  for (const mission::CommandRecord& command : state.commands)
    out += command.text.size() + command.unit.size() + command.task.size() + command.place.size() +
           command.formation.size() + command.message.size();
  return out;
}

std::size_t bytes_of(const RunState& state) {
  std::size_t out = sizeof state + bytes_of(state.executive) + bytes_of(state.crews) +
                    bytes_of(state.metrics) + bytes_of(state.answers) + bytes_of(state.interventions) +
                    bytes_of(state.takeovers) + bytes_of(state.deliveries) + bytes_of(state.failsafes) +
                    bytes_of(state.carriers) + bytes_of(state.milestones);
  for (const UnitMetrics& metrics : state.metrics) out += bytes_of(metrics.legs);
  for (const Takeover& takeover : state.takeovers) out += bytes_of(takeover.robots);
  for (const FailsafeRecord& record : state.failsafes) out += record.what.size();
  return out;
}

std::size_t bytes_of(const fleet::FleetCheckpoint& checkpoint) {
  const fleet::FleetState& state = checkpoint.state;
  std::size_t out = bytes_of(state.robots) + bytes_of(state.poses) + bytes_of(state.seen) +
                    bytes_of(state.groups) + state.messages.bytes();
  for (const fleet::FleetRobot& robot : state.robots)
    out += bytes_of(robot.notifications) + bytes_of(robot.places) + bytes_of(robot.passages);
  for (const fleet::SeenByFailsafes& seen : state.seen)
    out += bytes_of(seen.obstacles) + bytes_of(seen.others);
  for (const fleet::Group& group : state.groups) out += bytes_of(group.members);
  for (const robot::RobotMemory& memory : checkpoint.memories) out += memory.bytes();
  return out;
}

}  // namespace

Checkpoint::Checkpoint(std::shared_ptr<const All> all) : all_(std::move(all)) {
  bytes_ = sizeof(All) + bytes_of(all_->run) + bytes_of(all_->fleet) + all_->bodies->bytes();
}

std::expected<Checkpoint, std::string> MissionRun::save() const {
  auto bodies = binding_->save();
  if (!bodies) return std::unexpected(std::move(bodies.error()));
  auto fleet = fleet_->save();
  if (!fleet) return std::unexpected(std::move(fleet.error()));
  return Checkpoint(
      std::make_shared<const Checkpoint::All>(now_, std::move(*fleet), std::move(*bodies), settings_.seed));
}

std::optional<std::string> MissionRun::restore(const Checkpoint& checkpoint) {
  const Checkpoint::All& all = *checkpoint.all_;
  if (all.seed != settings_.seed) return "it is of a run with another seed";
  if (settings_.robots_elsewhere) return "robots that are carried elsewhere can't be put back";
  if (!binding_->restore(*all.bodies)) return "it is of a run with bodies of another kind";
  const RunState before = std::exchange(now_, all.run);  // robots point into its crews until they go
  fleet_->restore(all.fleet);
  return std::nullopt;
}

}  // namespace mlab::run
