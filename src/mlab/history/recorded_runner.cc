#include "mlab/history/recorded_runner.h"

#include <limits>
#include <utility>

namespace mlab::history {
namespace {

constexpr const char* kKeptElsewhere = "its program is an executable, which keeps its values to itself";
constexpr const char* kSilent = "gives no answer: only what it answered in the recorded run is known";

}  // namespace

std::optional<std::string> RecordedRunner::refusal(Member member) const {
  const robot::RobotProgram& program = *members_[member].program;
  return program.is_closed() ? std::optional<std::string>(kKeptElsewhere) : std::nullopt;
}

std::optional<std::string> RecordedRunner::force(Member member, std::string_view /*sequence*/,
                                                 std::string_view /*state*/) {
  return refusal(member);
}

std::optional<std::string> RecordedRunner::hold(Member member, std::string_view /*port*/,
                                                std::string_view /*value*/) {
  return refusal(member);
}

std::optional<std::string> RecordedRunner::release(Member member, std::string_view /*port*/) {
  return refusal(member);
}

bool RecordedRunner::take_over(Member member, const robot::RobotProgram& after, bool /*is_running*/) {
  Robot& robot = members_[member];
  const robot::RobotProgram& before = *robot.program;
  const bool is_same = before.recorded ? after.recorded && after.recorded->build == before.recorded->build
                                       : !after.recorded && after.program == before.program;
  if (is_same) robot.program = &after;
  return is_same;
}

void RecordedRunner::needs(std::span<const Member> members, std::span<percept::Needs> out) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const RecordedAnswer* const answer = answers_.find(members_[members[i]].robot.value);
    out[i] = answer != nullptr ? answer->needs : percept::Needs{};
  }
}

void RecordedRunner::act(std::span<const Turn> turns) {
  for (const Turn& turn : turns) {
    const RecordedAnswer* const answer = answers_.find(members_[turn.member].robot.value);
    if (answer == nullptr) {
      *turn.action = {};
      turn.fault->clear();
      *turn.failure = kSilent;
      continue;
    }
    *turn.action = answer->failure.empty() ? answer->action : percept::Action{};
    *turn.fault = answer->fault;
    *turn.failure = answer->failure;
    if (!answer->fault.empty()) turn.action->velocity.x = std::numeric_limits<double>::quiet_NaN();
  }
}

std::expected<robot::RobotMemory, std::string> RecordedRunner::memory(Member member) const {
  robot::RobotMemory out;
  out.program = members_[member].program;
  return out;
}

// Somebody may have gone to another cycle since.
const RecordedAnswer* RecordedRunner::now(Member member) const {
  answers_.go_to(cycle_());
  return answers_.find(members_[member].robot.value);
}

double RecordedRunner::silence(Member member) const {
  const RecordedAnswer* const answer = now(member);
  return answer != nullptr ? answer->silence : 0.0;
}

double RecordedRunner::percept_age(Member member) const {
  const RecordedAnswer* const answer = now(member);
  return answer != nullptr ? answer->percept_age : 0.0;
}

}  // namespace mlab::history
