#include "mlab/agents/dds_link.h"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/agents/dds_live_line.h"

namespace mlab::agents {
namespace {

constexpr std::chrono::milliseconds kGlance(100);  // between two looks at how the agent is

// Conversations of one agent are told apart by it, nothing else depends on it.
std::string any_key() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

bool has(const std::vector<dds::Guid>& all, const dds::Guid& one) {
  return std::ranges::find(all, one) != all.end();
}

}  // namespace

std::expected<std::unique_ptr<DdsLink>, std::string> DdsLink::open(std::shared_ptr<Roster> roster,
                                                                   const Member& agent, bool is_live) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  const std::string& name = agent.said.name();
  const std::string key = any_key();
  auto answers =
      roster->participant().reader(answers_topic(name, key), dds::ChannelKind::kLockStepPercepts, *waiter);
  if (!answers) return std::unexpected(answers.error());
  auto requests = roster->participant().writer(requests_topic(name, agent.guid),
                                               dds::ChannelKind::kLockStepPercepts, &*waiter);
  if (!requests) return std::unexpected(requests.error());
  std::shared_ptr<robot_remote::LiveLine> live;
  if (is_live) {
    auto opened = open_live_line_of_run(roster->participant(), name, key, agent.guid);
    if (!opened) return std::unexpected(opened.error());
    live = std::move(*opened);
  }
  std::unique_ptr<DdsLink> out(new DdsLink(std::move(roster), agent, key, std::move(*waiter),
                                           std::move(*answers), std::move(*requests)));
  out->live_ = std::move(live);
  // What is written before the agent hears it would be lost. It waits in turn until it is heard.
  const Clock::time_point last = Clock::now() + kMeetingPatience;
  while (!out->is_met()) {
    if (Clock::now() >= last) return std::unexpected("is there, but can't be talked to");
    out->waiter_.wait(kGlance);
  }
  return out;
}

DdsLink::DdsLink(std::shared_ptr<Roster> roster, const Member& agent, std::string key, dds::Waiter waiter,
                 dds::Reader answers, dds::Writer requests)
    : roster_(std::move(roster)),
      agent_(agent.said.name()),
      guid_(agent.guid),
      key_(std::move(key)),
      waiter_(std::move(waiter)),
      answers_(std::move(answers)),
      requests_(std::move(requests)) {}

bool DdsLink::is_met() const {
  return has(requests_.readers(), guid_);
}

void DdsLink::fail(std::string why) {
  if (failure_.empty()) failure_ = std::move(why);
}

// Whoever stood still himself, or is not let in any more, hears of the others as if they had gone.
std::string DdsLink::why_lost(std::string otherwise) const {
  if (roster_->participant().has_run_out())
    return "hears nothing of this run any more: this machine's identity in the secured fleet has run out";
  constexpr std::chrono::seconds kRecently(10);
  const auto own = roster_->standstill();
  if (!own || own->seconds < patience_with_silence() || Clock::now() - own->ended > kRecently)
    return otherwise;
  return fmt::format("gave this run up, which itself stood still for {:.0f} s", own->seconds);
}

bool DdsLink::is_cut() {
  return live_ && failure_.empty() && (!is_met() || silence() > 0.0);
}

double DdsLink::silence() const {
  const auto agent = roster_->sight(agent_);
  if (!agent || agent->guid != guid_ || agent->state == Member::State::kThere) return 0.0;
  return std::chrono::duration<double>(Clock::now() - agent->heard).count();
}

double DdsLink::patience_with_silence() const {
  return live_ ? robot_remote::kLivePatience : std::chrono::duration<double>(kSilencePatience).count();
}

void DdsLink::send(std::string_view message) {
  if (!failure_.empty()) return;
  const auto agent_stands = [this] {
    look_after_agent();
    return failure_.empty();
  };
  if (!write_in_parts(requests_, key_, message, agent_stands)) fail("can't be written to");
}

std::optional<std::string_view> DdsLink::receive(robot_remote::Clock::time_point deadline) {
  for (;;) {
    if (!came_.empty()) {
      last_ = std::move(came_.front());
      came_.pop_front();
      return last_;
    }
    if (!failure_.empty()) return std::nullopt;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - robot_remote::Clock::now());
    if (left.count() <= 0) return std::nullopt;
    waiter_.wait(std::min(left, kGlance));
    take_arrivals();
    look_after_agent();
  }
}

void DdsLink::take_arrivals() {
  for (dds::Arrival& arrival : answers_.take()) {
    if (arrival.kind == dds::Arrival::Kind::kLost) fail("has said more than could be kept");
    if (arrival.kind != dds::Arrival::Kind::kMessage || arrival.key != key_ || arrival.sender != guid_)
      continue;
    const Assembly::Outcome outcome = assembly_.add(arrival.body);
    if (outcome == Assembly::Outcome::kWhole) came_.push_back(assembly_.message());
    if (outcome == Assembly::Outcome::kNonsense) fail("answers what is no message of the agents' protocol");
  }
}

void DdsLink::look_after_agent() {
  const auto agent = roster_->sight(agent_);
  if (!agent || agent->guid != guid_)
    fail("was started anew, and knows nothing of this run");
  else if (agent->state == Member::State::kGone) {
    const Clock::duration silence = Clock::now() - agent->heard;
    if (agent->has_left)
      fail("has left the fleet");
    else if (!live_ && silence < kSilencePatience)
      fail(why_lost("has left the fleet"));
    else if (!live_ || silence >= robot_remote::from_seconds(robot_remote::kLivePatience))
      fail(why_lost(
          fmt::format("was silent for {} s", std::chrono::floor<std::chrono::seconds>(silence).count())));
  }
}

}  // namespace mlab::agents
