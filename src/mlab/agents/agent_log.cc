#include "mlab/agents/agent_log.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/dds_link.h"
#include "mlab/robot/remote/agent.h"

namespace mlab::agents {

void AgentLog::add(const std::string& line) {
  if (tell_) tell_(line);
  const std::scoped_lock lock(mutex_);
  told_.push_back({Clock::now(), line});
  if (told_.size() > kMost) told_.pop_front();
}

std::vector<robot::LogLine> AgentLog::lines() const {
  const std::scoped_lock lock(mutex_);
  const Clock::time_point now = Clock::now();
  std::vector<robot::LogLine> out;
  for (const Told& one : told_) out.push_back({robot_remote::in_seconds(now - one.when), one.text});
  return out;
}

std::expected<std::vector<robot::LogLine>, std::string> read_log(const std::shared_ptr<Roster>& roster,
                                                                 const std::string& agent) {
  const auto member = roster->find(agent);
  if (!member || member->state == Member::State::kGone)
    return std::unexpected(fmt::format("no agent `{}` is heard in the fleet `{}`", agent, roster->fleet()));
  if (member->said.protocol() != robot_remote::kAgentProtocol)
    return std::unexpected(fmt::format("the agent on `{}` is missionlab {}, which has another protocol",
                                       agent, member->said.version()));
  auto link = DdsLink::open(roster, *member, false);
  if (!link) return std::unexpected(fmt::format("the agent on `{}` {}", agent, link.error()));
  auto said = robot_remote::Agent(agent, std::move(*link)).said(robot_remote::Agent::kNoMember);
  if (!said) return std::unexpected(said.error());
  return std::move(said->machine);
}

}  // namespace mlab::agents
