#include "mlab/agents/missed.h"

#include <algorithm>
#include <functional>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/topics.h"
#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

constexpr std::size_t kMostTellers = 256;
constexpr std::size_t kLongestTeller = 100;
constexpr std::size_t kLongestMachine = 64;
constexpr double kLongestSilence = 1e9;  // [s]

double silence_of(Clock::duration duration) {
  return std::max(0.0, std::chrono::duration<double>(duration).count());
}

bool is_missed(const Member& member, const StopState& holds, Clock::time_point now) {
  if (member.has_left) return false;
  if (member.state != Member::State::kThere) return member.is_held || now - member.heard < kMissedFor;
  return holds.is_engaged() && !has_confirmed(member.said.stop(), holds);
}

std::optional<Missed> missed_in(const wire::MissedAgent& said) {
  if (!is_agent_name(said.name())) return std::nullopt;
  if (!(said.silent() >= 0.0 && said.silent() <= kLongestSilence)) return std::nullopt;
  return Missed{said.name(), text::shown(said.host(), kLongestMachine), said.silent()};
}

}  // namespace

std::vector<Missed> missed_among(std::vector<Member> members, const StopState& holds, Clock::time_point now) {
  std::erase_if(members, [&](const Member& one) { return !is_missed(one, holds, now); });
  std::ranges::stable_sort(members, std::greater{},
                           [](const Member& one) { return std::pair(one.is_held, one.heard); });
  if (members.size() > kMostMissed) members.resize(kMostMissed);
  std::vector<Missed> out;
  for (const Member& one : members)
    out.push_back({one.said.name(), one.said.host(), silence_of(now - one.heard)});
  return out;
}

std::string encode(const MissedAgents& missed) {
  wire::MissedAgents out;
  out.set_by(missed.by);
  for (const Missed& one : missed.agents) {
    wire::MissedAgent& agent = *out.add_agents();
    agent.set_name(one.name);
    agent.set_host(one.machine);
    agent.set_silent(one.silent);
  }
  return out.SerializeAsString();
}

std::optional<MissedAgents> decode_missed(std::string_view message) {
  wire::MissedAgents said;
  if (!said.ParseFromArray(message.data(), static_cast<int>(message.size()))) return std::nullopt;
  MissedAgents out{said.by().empty() ? "somebody" : text::shown(said.by(), kLongestTeller), {}};
  for (const wire::MissedAgent& one : said.agents()) {
    if (out.agents.size() == kMostMissed) break;
    if (auto agent = missed_in(one)) out.agents.push_back(std::move(*agent));
  }
  return out;
}

MissedTeller::MissedTeller(dds::Participant& participant, std::string by)
    : participant_(participant), by_(std::move(by)) {
  // Tellers are told apart by it, nothing else depends on it.
  std::random_device random;
  key_ = fmt::format("{:08x}{:08x}", random(), random());
}

MissedTeller::~MissedTeller() {
  if (is_said_ && writer_) static_cast<void>(writer_->end(key_));
}

void MissedTeller::say(std::vector<Missed> agents) {
  if (agents.empty() && !is_said_) return;
  if (!writer_) {
    auto made = participant_.writer(kMissedTopic, dds::ChannelKind::kStatus);
    if (!made) return;  // the next time
    writer_.emplace(std::move(*made));
  }
  const bool is_over = agents.empty();
  // One that nobody takes is followed by the next; the last one is said until it is taken.
  const dds::Written written = writer_->write(key_, encode(MissedAgents{by_, std::move(agents)}));
  is_said_ = !is_over || written != dds::Written::kDone;
}

std::expected<std::unique_ptr<Hearsay>, std::string> Hearsay::open(dds::Participant& participant,
                                                                   dds::Waiter& waiter) {
  auto reader = participant.reader(kMissedTopic, dds::ChannelKind::kStatus, waiter);
  if (!reader) return std::unexpected(reader.error());
  return std::unique_ptr<Hearsay>(new Hearsay(std::move(*reader)));
}

void Hearsay::listen() {
  const std::scoped_lock lock(mutex_);
  for (const dds::Arrival& arrival : reader_.take()) take(arrival);
  std::erase_if(told_, [now = Clock::now()](const auto& one) { return now - one.second.when > kMissedFor; });
}

// Who is silent, or was killed, may have been right: what he said stays.
void Hearsay::take(const dds::Arrival& arrival) {
  if (arrival.kind == dds::Arrival::Kind::kEnded) told_.erase(arrival.sender);
  if (arrival.kind != dds::Arrival::Kind::kMessage) return;
  auto missed = decode_missed(arrival.body);
  if (!missed) return;
  if (missed->agents.empty()) {
    told_.erase(arrival.sender);
    return;
  }
  if (told_.size() >= kMostTellers && !told_.contains(arrival.sender)) return;
  told_[arrival.sender] = {std::move(*missed), arrival.noticed};
}

std::vector<Hearsay::Entry> Hearsay::all(Clock::time_point now) const {
  std::map<std::string, Entry> out;
  const std::scoped_lock lock(mutex_);
  for (const auto& [teller, told] : told_) {
    for (Missed one : told.missed.agents) {
      one.silent += silence_of(now - told.when);
      const auto [at, is_new] = out.try_emplace(one.name, Entry{one, told.missed.by});
      if (!is_new && one.silent < at->second.agent.silent) at->second = {std::move(one), told.missed.by};
    }
  }
  std::vector<Entry> list;
  for (auto& [name, entry] : out) list.push_back(std::move(entry));
  return list;
}

}  // namespace mlab::agents
