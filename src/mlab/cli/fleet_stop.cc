#include "mlab/cli/fleet_stop.h"

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/agents/agent_process.h"
#include "mlab/agents/fleet_runner.h"
#include "mlab/agents/stop_switch.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/version.h"
#include "mlab/keys/identity.h"
#include "mlab/text/age.h"

namespace mlab::cli {
namespace {

/// What may be to be said, once each time that it is something else.
class Alert {
 public:
  void tell(std::string words, std::vector<std::string>& out) {
    if (words == told_) return;
    told_ = words;
    if (!words.empty()) out.push_back(std::move(words));
  }

 private:
  std::string told_;
};

class FleetStopLine final : public run::StopLine {
 public:
  FleetStopLine(std::shared_ptr<agents::Roster> roster, std::unique_ptr<agents::StopSwitch> all,
                const std::string& identity)
      : roster_(std::move(roster)), all_(std::move(all)), withdrawals_(identity) {
    if (!identity.empty()) end_ = keys::security_in(identity).end;
  }
  State state() const override {
    const agents::StopState state = all_->state();
    return {state.is_engaged(), state.by()};
  }
  void hear() override { all_->hear_agents(); }
  void settle() override {
    const auto is_heard = [](const std::vector<agents::Member>& agents) {
      return was_interrupted() || !agents.empty();
    };
    roster_->wait(is_heard, agents::Clock::now() + kFirstHeard);
    hear();
  }
  void engage() override { all_->engage(stopping_person()); }
  void release() override { all_->release(stopping_person()); }
  std::vector<Unreached> unreached() const override {
    std::vector<Unreached> out;
    for (agents::StopSwitch::Unreached& one : all_->unreached())
      out.push_back({std::move(one.name), std::move(one.by), one.silent});
    return out;
  }
  std::vector<std::string> take_alerts() override {
    const agents::Clock::time_point now = agents::Clock::now();
    if (now < next_look_) return {};
    next_look_ = now + kBetweenLooks;
    std::vector<std::string> out;
    std::string forgetful = about_forgetful(all_->forgetful());
    forgetful_.tell(forgetful.empty() ? "" : "the emergency stop is " + std::move(forgetful), out);
    doubles_.tell(about_doubles(roster_->members()), out);
    versions_.tell(about_versions(roster_->members()), out);
    if (withdrawals_.has_changed()) out.push_back(about_withdrawal());
    own_end_.tell(about_own_end(), out);
    return out;
  }
  void tell(std::function<void()> changed) override { all_->tell(std::move(changed)); }

 private:
  // START waits for an agent in any case, and longer.
  static constexpr std::chrono::milliseconds kFirstHeard{1500};

  static constexpr std::chrono::seconds kBetweenLooks{1};

  std::string about_withdrawal() const {
    return fmt::format(
        "somebody was withdrawn from the fleet `{}`, and this run still trusts whom it trusted "
        "when it began{}. Who "
        "was withdrawn keeps the robots that it carries for it: end the run, and start it again",
        roster_->fleet(), agents_of_run());
  }

  // In time, so that somebody can do something; and when it is too late.
  std::string about_own_end() const {
    if (end_ == 0) return "";
    if (roster_->participant().has_run_out())
      return fmt::format(
          "this machine's identity in the fleet `{}` has run out: no agent hears this run any more, and "
          "their "
          "robots stand. `mlab keys` makes another identity; then start the run again",
          roster_->fleet());
    const std::string when = keys::running_out(end_);
    if (when.empty()) return "";
    return fmt::format(
        "this machine's identity in the fleet `{}` {}: no agent will hear this run from then on",
        roster_->fleet(), when);
  }

  // Certificates on the list have no names.
  std::string agents_of_run() const {
    std::string out;
    for (const agents::Member& one : roster_->members()) {
      if (one.is_held)
        out += fmt::format("{}`{}`", out.empty() ? ": its agents are " : ", ", one.said.name());
    }
    return out;
  }

  std::shared_ptr<agents::Roster> roster_;
  std::unique_ptr<agents::StopSwitch> all_;
  keys::WithdrawalWatch withdrawals_;
  std::int64_t end_ = 0;  // of the identity that it takes part with [s since 1970]; 0: there is none
  Alert forgetful_;
  Alert doubles_;
  Alert versions_;
  Alert own_end_;
  agents::Clock::time_point next_look_;
};

}  // namespace

std::string about_unreached(const std::string& by, double silent) {
  if (!by.empty()) return fmt::format(" (known by {}, last heard {} ago)", by, text::age(silent));
  return silent > 2.0 ? fmt::format(" (silent for {})", text::age(silent)) : "";
}

std::string about_forgetful(const std::vector<agents::StopSwitch::Forgetful>& agents) {
  std::string out;
  for (const agents::StopSwitch::Forgetful& one : agents)
    out += fmt::format("{}`{}` ({})", out.empty() ? "" : ", ", one.name, one.why);
  return out.empty() ? out : fmt::format("not kept by {}: started again it would forget it", out);
}

std::string about_doubles(const std::vector<agents::Member>& members) {
  std::string out;
  for (const agents::Member& one : members) {
    const auto rival = agents::rival_of(one);
    if (!rival || one.state == agents::Member::State::kGone) continue;
    out += fmt::format(
        "{}two agents call themselves `{}`, and have not found each other: that on `{}` counts, that on `{}` "
        "is left out",
        out.empty() ? "" : "; ", one.said.name(), one.said.host(), rival->host);
  }
  return out.empty() ? out : out + ": end it, or start it with another --name";
}

std::string about_versions(const std::vector<agents::Member>& members) {
  std::string out;
  int count = 0;
  for (const agents::Member& one : members) {
    if (one.state != agents::Member::State::kThere) continue;
    const std::string words = agents::other_version(one.said, kVersion);
    if (words.empty()) continue;
    out += (out.empty() ? "" : "; ") + words;
    ++count;
  }
  if (count == 0) return "";
  return out + (count == 1 ? ": it carries" : ": they carry") + " nothing for runs of this one";
}

std::string stopping_person() {
  std::string name = agents::machine_name();
  return name.empty() ? "somebody" : name;
}

std::expected<std::shared_ptr<run::StopLine>, std::string> fleet_stop_line(
    std::shared_ptr<agents::Roster> roster, std::string by, const std::string& identity) {
  auto all = agents::StopSwitch::open(roster, std::move(by));
  if (!all) return std::unexpected(all.error());
  return std::make_shared<FleetStopLine>(std::move(roster), std::move(*all), identity);
}

}  // namespace mlab::cli
