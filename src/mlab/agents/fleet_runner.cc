#include "mlab/agents/fleet_runner.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/agents/dds_link.h"
#include "mlab/robot/remote/live_runner.h"
#include "mlab/robot/remote/remote_runner.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

constexpr std::chrono::seconds kJoiningPatience(5);  // for an agent that somebody wants and that is not there

bool fits(const wire::AgentPresence& agent, const std::string& version) {
  return agent.protocol() == robot_remote::kAgentProtocol && agent.version() == version &&
         agent.layout() == robot_wire::shared_layout();
}

/// Agents of a fleet, each of which is given out once.
class Recruits {
 public:
  Recruits(std::shared_ptr<Roster> roster, std::uint64_t seed, std::string version, double period,
           StartHints hints)
      : roster_(std::move(roster)),
        seed_(seed),
        version_(std::move(version)),
        period_(period),
        hints_(std::move(hints)) {}

  /// Where no such agent was ever there, the first call waits a while.
  robot_remote::RemoteRunner::Newcomers find(const std::string& host, const std::vector<std::string>& lost) {
    for (const std::string& name : lost) known_.erase(name);
    const auto is_wanted = [&](const std::vector<Member>& members) {
      return std::ranges::any_of(members, [&](const Member& one) {
        return (host.empty() || one.said.name() == host) && one.state == Member::State::kThere &&
               fits(one.said, version_);
      });
    };
    if (waited_for_.insert(host).second) roster_->wait(is_wanted, Clock::now() + kJoiningPatience);
    robot_remote::RemoteRunner::Newcomers out;
    out.why_none =
        host.empty() ? fmt::format("none has joined the fleet `{0}`: `mlab agent --fleet {0}{1}` starts one",
                                   roster_->fleet(), hints_.here)
                     : fmt::format(
                           "none of the name `{1}` has joined the fleet `{0}`: there, `mlab agent "
                           "--fleet {0} --name {1}{2}` starts one",
                           roster_->fleet(), text::shown(host), hints_.elsewhere);
    for (const Member& one : roster_->members()) {
      if (one.state != Member::State::kThere || is_known(one)) continue;
      if (!fits(one.said, version_)) {
        out.why_none = misfit(one.said);
        continue;
      }
      auto link = DdsLink::open(roster_, one, period_ > 0.0);
      if (!link) {  // it is asked again when somebody is wanted again
        out.why_none = fmt::format("the agent on `{}` {}", one.said.name(), link.error());
        continue;
      }
      known_[one.said.name()] = one.guid;
      roster_->hold(one.said.name());
      auto agent = std::make_unique<robot_remote::Agent>(one.said.name(), std::move(*link));
      if (auto problem = agent->open(seed_, version_, period_))
        out.why_none = std::move(*problem);
      else
        out.agents.push_back(std::move(agent));
    }
    return out;
  }

 private:
  bool is_known(const Member& member) const {
    const auto at = known_.find(member.said.name());
    return at != known_.end() && at->second == member.guid;
  }
  std::string misfit(const wire::AgentPresence& agent) const {
    return fmt::format("the agent on `{}` is missionlab {} (protocol {}), and this is {} (protocol {})",
                       agent.name(), agent.version(), agent.protocol(), version_,
                       robot_remote::kAgentProtocol);
  }

  std::shared_ptr<Roster> roster_;
  std::uint64_t seed_;
  std::string version_;
  double period_;  // [s]; 0: in lock-step
  StartHints hints_;
  std::map<std::string, dds::Guid> known_;  // by name: who was given out last
  std::set<std::string> waited_for_;
};

}  // namespace

std::unique_ptr<robot::ProgramRunner> make_fleet_runner(std::shared_ptr<Roster> roster, std::uint64_t seed,
                                                        const std::string& version, double period,
                                                        StartHints hints) {
  auto recruits = std::make_shared<Recruits>(std::move(roster), seed, version, period, std::move(hints));
  auto recruit = [recruits](const std::string& host, const std::vector<std::string>& lost) {
    return recruits->find(host, lost);
  };
  if (period > 0.0) return std::make_unique<robot_remote::LiveRunner>(std::move(recruit), period);
  return std::make_unique<robot_remote::RemoteRunner>(std::move(recruit));
}

}  // namespace mlab::agents
