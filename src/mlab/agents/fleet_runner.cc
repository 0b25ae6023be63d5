#include "mlab/agents/fleet_runner.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/agents/dds_link.h"
#include "mlab/robot/remote/live_runner.h"
#include "mlab/robot/remote/remote_runner.h"
#include "mlab/robot/wire/arithmetic.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/age.h"
#include "mlab/text/shell_word.h"
#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

constexpr std::size_t kWholeName = 255;  // characters, of a file

bool is_of(const wire::AgentPresence& agent, const std::string& version) {
  return agent.protocol() == robot_remote::kAgentProtocol && agent.version() == version &&
         agent.layout() == robot_wire::shared_layout();
}

std::optional<robot::ExecutableOrigin> offered_by(const wire::AgentPresence& agent) {
  if (!agent.has_offered()) return std::nullopt;
  return robot::ExecutableOrigin{agent.offered().name(), agent.offered().source()};
}

// Robots of that program may be carried there, if the name is right.
bool offers(const wire::AgentPresence& agent, const robot::RobotProgram& program) {
  return !agent.has_vehicle() &&
         agent.offered().source() == (program.executable ? program.executable->source : 0);
}

bool is_other_version(const wire::AgentPresence& agent, const robot::RobotProgram& program) {
  return program.executable && agent.offered().name() == program.executable->name && !offers(agent, program);
}

/// Agents of a fleet, each of which is given out once.
class Recruits {
 public:
  Recruits(std::shared_ptr<Roster> roster, std::uint64_t seed, std::string version, double period,
           StartHints hints, Clock::duration patience)
      : roster_(std::move(roster)),
        seed_(seed),
        version_(std::move(version)),
        period_(period),
        hints_(std::move(hints)),
        patience_(patience) {}

  /// Where no such agent was ever there, the first call waits a while.
  robot_remote::RemoteRunner::Newcomers find(const robot::RobotProgram& program,
                                             const std::vector<std::string>& lost) {
    for (const std::string& name : lost) known_.erase(name);
    const auto is_wanted = [&](const std::vector<Member>& members) {
      return std::ranges::any_of(members, [&](const Member& one) {
        return (program.host.empty() || one.said.name() == program.host) && offers(one.said, program) &&
               one.state == Member::State::kThere && fits(one.said);
      });
    };
    const std::uint64_t source = program.executable ? program.executable->source : 0;
    if (waited_for_.emplace(program.host, source).second) roster_->wait(is_wanted, joined_until());
    robot_remote::RemoteRunner::Newcomers out;
    out.why_none = why_none(program);
    for (const Member& one : roster_->members()) {
      if (one.state != Member::State::kThere || one.said.has_vehicle()) continue;
      const bool may_be_meant = program.host.empty() || one.said.name() == program.host;
      if (may_be_meant && is_other_version(one.said, program))
        out.why_none = fmt::format("`{}` offers another version of `{}`: copy yours to it, and start it anew",
                                   one.said.name(), program.executable->name);
      if (is_known(one)) continue;
      if (!fits(one.said)) {
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
      auto agent = std::make_unique<robot_remote::Agent>(one.said.name(), std::move(*link),
                                                         robot_remote::Patience{}, offered_by(one.said));
      if (auto problem = agent->open(seed_, version_, period_))
        out.why_none = std::move(*problem);
      else
        out.agents.push_back(std::move(agent));
    }
    return out;
  }

 private:
  // Whoever is there is found in that time: robots that are taken in one after the other don't wait one after
  // the other for as many agents as are missing.
  Clock::time_point joined_until() {
    const Clock::time_point now = Clock::now();
    if (now > joined_until_ + patience_) joined_until_ = now + patience_;
    return joined_until_;
  }
  std::string why_none(const robot::RobotProgram& program) const {
    const std::string& fleet = roster_->fleet();
    const std::string host = text::shown(program.host);
    const std::string who = host.empty() ? "none" : fmt::format("none of the name `{}`", host);
    const std::string words =
        host.empty() ? hints_.here : fmt::format(" --name {}{}", text::shell_word(host), hints_.elsewhere);
    if (const auto named = host.empty() ? std::nullopt : roster_->find(program.host);
        named && named->state == Member::State::kThere && !offers(named->said, program))
      return fmt::format(
          "`{}` {}", host,
          named->said.has_vehicle()
              ? (period_ > 0.0 ? "is a vehicle, which has joined after the run began: start the run anew"
                               : "is a vehicle, which --real-time drives")
          : named->said.has_offered() ? fmt::format("carries robots of the executable `{}`, and no others",
                                                    named->said.offered().name())
                                      : "carries robots that are built from text, and no executables");
    if (program.executable)
      return fmt::format("{} in the fleet `{}` offers `{}`: there, `{} --fleet {}{}` does", who, fleet,
                         text::shown(program.executable->name),
                         text::shell_word("./" + text::shown(program.executable->name, kWholeName)), fleet,
                         host.empty() ? hints_.elsewhere : words);
    if (const std::string others = those_with_executables(); host.empty() && !others.empty())
      return fmt::format(
          "nobody in the fleet `{0}` builds robots from text, {1}: `mlab agent --fleet {0}{2}` starts one "
          "that "
          "does",
          fleet, others, words);
    if (const auto gone = who_has_gone(program.host))
      return about_gone(*gone, host.empty()) +
             (gone->said.has_vehicle() ? ": start it again there"
                                       : fmt::format(": {}`mlab agent --fleet {}{}` starts one",
                                                     host.empty() ? "" : "there, ", fleet, words));
    return fmt::format("{0} has joined the fleet `{1}`: {2}`mlab agent --fleet {1}{3}` starts one{4}", who,
                       fleet, host.empty() ? "" : "there, ", words, hints_.unseen);
  }
  // Of those who had joined, and may have been meant, the one that was heard last. Nothing: nobody had, or
  // somebody is there still.
  std::optional<Member> who_has_gone(const std::string& host) const {
    std::optional<Member> last;
    for (Member& one : roster_->members()) {
      if (host.empty() ? one.said.has_vehicle() : one.said.name() != host) continue;
      if (one.state == Member::State::kThere) return std::nullopt;
      if (!last || one.heard > last->heard) last = std::move(one);
    }
    return last;
  }
  // `north`, on `n1`, left the fleet `alpha` 14 s ago.
  std::string about_gone(const Member& gone, bool was_last) const {
    const std::string since = text::age(robot_remote::in_seconds(Clock::now() - gone.heard));
    const std::string name = fmt::format("`{}`, on `{}`,", gone.said.name(), gone.said.host());
    return (was_last ? "nobody is left: " : "") +
           (gone.has_left ? fmt::format("{} left the fleet `{}` {} ago", name, roster_->fleet(), since)
                          : fmt::format("nothing has been heard of {} in the fleet `{}` for {}", name,
                                        roster_->fleet(), since));
  }
  // Members that carry robots of one executable each, and nothing else: "`f1` carries those of `walker`
  // only".
  std::string those_with_executables() const {
    constexpr std::size_t kMostNamed = 3;
    std::vector<std::string> out;
    std::size_t more = 0;
    for (const Member& one : roster_->members()) {
      if (one.state != Member::State::kThere || !one.said.has_offered()) continue;
      if (out.size() == kMostNamed)
        ++more;
      else
        out.push_back(fmt::format("`{}` carries those of the executable `{}` only", one.said.name(),
                                  one.said.offered().name()));
    }
    if (more > 0) out.push_back(fmt::format("{} more are of that sort", more));
    return fmt::format("{}", fmt::join(out, ", "));
  }
  bool is_known(const Member& member) const {
    const auto at = known_.find(member.said.name());
    return at != known_.end() && at->second == member.guid;
  }
  // In real time nobody expects the report of an embedded run.
  bool fits(const wire::AgentPresence& agent) const {
    return is_of(agent, version_) && (period_ > 0.0 || agent.arithmetic() == robot_wire::arithmetic());
  }
  std::string misfit(const wire::AgentPresence& agent) const {
    if (is_of(agent, version_))
      return fmt::format(
          "the agent on `{}` computes sines and the like otherwise than this machine does, in the last digit "
          "(another C library, or one of the processors has no FMA), so its robots would not do the same; "
          "--real-time "
          "takes it",
          agent.name());
    return other_version(agent, version_);
  }

  std::shared_ptr<Roster> roster_;
  std::uint64_t seed_;
  std::string version_;
  double period_;  // [s]; 0: in lock-step
  StartHints hints_;
  Clock::duration patience_;
  Clock::time_point joined_until_;
  std::map<std::string, dds::Guid> known_;                      // by name: who was given out last
  std::set<std::pair<std::string, std::uint64_t>> waited_for_;  // host, and source of the executable
};

}  // namespace

std::string other_version(const wire::AgentPresence& agent, const std::string& version) {
  if (agent.has_vehicle() || is_of(agent, version)) return "";
  const bool is_same_name = agent.version() == version && agent.protocol() == robot_remote::kAgentProtocol;
  return fmt::format("the agent on `{}` is missionlab {} (protocol {}), and this is {}", agent.name(),
                     agent.version(), agent.protocol(),
                     is_same_name ? "another build of that, which lays out robots' memory otherwise"
                                  : fmt::format("{} (protocol {})", version, robot_remote::kAgentProtocol));
}

std::unique_ptr<robot::ProgramRunner> make_fleet_runner(std::shared_ptr<Roster> roster, std::uint64_t seed,
                                                        const std::string& version, double period,
                                                        StartHints hints, Clock::duration patience) {
  auto recruits =
      std::make_shared<Recruits>(std::move(roster), seed, version, period, std::move(hints), patience);
  auto recruit = [recruits](const robot::RobotProgram& program, const std::vector<std::string>& lost) {
    return recruits->find(program, lost);
  };
  if (period > 0.0) return std::make_unique<robot_remote::LiveRunner>(std::move(recruit), period);
  return std::make_unique<robot_remote::RemoteRunner>(std::move(recruit));
}

}  // namespace mlab::agents
