#include "mlab/vehicles/fleet_facts.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"
#include "mlab/vehicle/messages.h"
#include "mlab/vehicles/vehicle_line.h"

namespace mlab::vehicles {
namespace {

using agents::Member;
using preflight::VehicleFacts;
using vehicle::Clock;

constexpr std::chrono::seconds kFindingPatience(4);     // for who has only just joined to find all
constexpr std::chrono::seconds kHearingPatience(3);     // for a vehicle to say how it is
constexpr std::chrono::seconds kListenedFor(60);        // after it was asked for last
constexpr std::chrono::milliseconds kFirstEchoes(20);   // between questions to one that is new
constexpr std::chrono::milliseconds kLastAnswers(250);  // for what is on its way, before a loss is told
constexpr std::chrono::milliseconds kLaterEchoes(500);  // likewise, to others
constexpr std::chrono::milliseconds kOldReport(1000);   // one that is older is waited for
// So many questions that the first ones, asked before both have found each other, count no more.
constexpr int kEnoughEchoes = agents::LinkHistory::kKept + 3;
constexpr std::size_t kLongestText = 100;  // characters

std::string why_not_there(const Member& member, Clock::time_point now) {
  if (member.state == Member::State::kGone) return "has left the fleet";
  return fmt::format("has been silent for {:.0f} s", vehicle::seconds_between(member.heard, now));
}

}  // namespace

FleetFacts::FleetFacts(std::shared_ptr<agents::Roster> roster)
    : roster_(std::move(roster)), waiter_(dds::Waiter::make().value()) {}

FleetFacts::~FleetFacts() {
  thread_.request_stop();
  waiter_.wake();
}

// ---- listening

void FleetFacts::want(const std::vector<std::string>& names) {
  const std::scoped_lock lock(mutex_);
  asked_ = Clock::now();
  for (const std::string& name : names) {
    const auto member = roster_->find(name);
    if (!member || !member->said.has_vehicle() || watched_.contains(name)) continue;
    auto& participant = roster_->participant();
    auto reports = participant.reader(reports_topic(name), dds::ChannelKind::kLivePercepts, waiter_);
    auto checks = participant.reader(checks_topic(name), dds::ChannelKind::kLivePercepts, waiter_);
    if (reports && checks) watched_.emplace(name, Watched{std::move(*reports), std::move(*checks)});
  }
  if (!watched_.empty() && !thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
  waiter_.wake();
  changed_.notify_all();
}

void FleetFacts::expect(const std::vector<std::string>& names) {
  want(names);
}

void FleetFacts::listen(const std::stop_token& stop) {
  const auto links = agents::EchoProbe::open(roster_);
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      if (Clock::now() - asked_ > kListenedFor) watched_.clear();
      changed_.wait(lock, stop, [this] { return !watched_.empty(); });
      if (stop.stop_requested()) return;
    }
    if (links)
      measure(**links);
    else
      waiter_.wait(kFirstEchoes);
    take_news();
  }
}

void FleetFacts::measure(agents::EchoProbe& links) {
  int least = kEnoughEchoes + 1;
  {
    const std::scoped_lock lock(mutex_);
    for (const auto& [name, one] : watched_) least = std::min(least, one.echoes);
  }
  links.measure(least < kEnoughEchoes ? kFirstEchoes : least == kEnoughEchoes ? kLastAnswers : kLaterEchoes);
  const std::scoped_lock lock(mutex_);
  for (auto& [name, one] : watched_) {
    one.link = links.quality(name);
    ++one.echoes;
  }
}

void FleetFacts::take_news() {
  const std::scoped_lock lock(mutex_);
  for (auto& [name, one] : watched_) take(name, one);
  changed_.notify_all();
}

void FleetFacts::take(const std::string& name, Watched& one) {
  const auto is_its = [&](const dds::Arrival& arrival) {
    const auto member = roster_->sight(name);
    if (arrival.kind != dds::Arrival::Kind::kMessage || arrival.key != name || !member ||
        arrival.sender != member->guid)
      return false;
    // Of a process that was started anew nothing is known that the one before said.
    if (std::exchange(one.from, arrival.sender) == arrival.sender) return true;
    one.report.clear();
    one.said.reset();
    return true;
  };
  for (dds::Arrival& arrival : one.reports.take()) {
    if (!is_its(arrival)) continue;
    one.report = std::move(arrival.body);
    one.arrived = arrival.noticed;
  }
  for (const dds::Arrival& arrival : one.checks.take()) {
    if (!is_its(arrival)) continue;
    auto said = vehicle::decode_checks(arrival.body);
    if (!said) continue;
    one.said = std::move(*said);
    one.said_at = arrival.noticed;
  }
}

// ---- being asked

bool FleetFacts::is_known(const std::string& name, Clock::time_point now) const {
  const auto member = roster_->find(name);
  if (!member || member->state != Member::State::kThere) return now - joined_ > kFindingPatience;
  if (!member->said.has_vehicle()) return true;
  const auto at = watched_.find(name);
  return at != watched_.end() && at->second.from == member->guid && at->second.said &&
         at->second.echoes > kEnoughEchoes && !at->second.report.empty() &&
         now - at->second.arrived < kOldReport;
}

std::vector<VehicleFacts> FleetFacts::look(const std::vector<std::string>& names) {
  const auto are_there = [&](const std::vector<Member>& members) {
    return std::ranges::all_of(names, [&](const std::string& name) {
      return std::ranges::any_of(members, [&](const Member& one) {
        return one.said.name() == name && one.state == Member::State::kThere;
      });
    });
  };
  roster_->wait(are_there, joined_ + kFindingPatience);
  want(names);
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kHearingPatience, [&] {
    return std::ranges::all_of(names, [&](const auto& name) { return is_known(name, Clock::now()); });
  });
  std::vector<VehicleFacts> out;
  for (const std::string& name : names) {
    const auto member = roster_->find(name);
    if (!member) {
      out.push_back({.name = name, .why_not_there = "has not joined the fleet"});
    } else if (member->said.has_vehicle()) {
      out.push_back(facts(*member, Clock::now()));
    }
  }
  return out;
}

std::vector<VehicleFacts> FleetFacts::glance(const std::vector<std::string>& names) const {
  const std::scoped_lock lock(mutex_);
  std::vector<VehicleFacts> out;
  for (const std::string& name : names) {
    const auto member = roster_->find(name);
    if (member && member->said.has_vehicle()) out.push_back(facts(*member, Clock::now()));
  }
  return out;
}

VehicleFacts FleetFacts::facts(const Member& member, Clock::time_point now) const {
  const wire::OfferedVehicle& said = member.said.vehicle();
  VehicleFacts out = {.name = member.said.name(),
                      .is_there = member.state == Member::State::kThere,
                      .kind = text::shown(said.kind(), kLongestText),
                      .version = text::shown(member.said.version(), kLongestText),
                      .machine = text::shown(member.said.host(), kLongestText),
                      .is_simulated = said.is_simulated()};
  if (!out.is_there) {
    out.why_not_there = why_not_there(member, now);
    return out;
  }
  out.session = member.guid.text();
  if (const auto limits = vehicle::limits_of(said))
    out.limits = *limits;
  else
    out.limits_refusal = limits.error();
  const auto at = watched_.find(out.name);
  if (at == watched_.end() || at->second.from != member.guid) return out;
  const Watched& one = at->second;
  if (one.link) out.link = {one.link->round_trip, one.link->lost, one.link->clock_offset};
  // What it said longer ago is said of a process that may have ended since.
  if (one.said && now - one.said_at < 2 * kHearingPatience) out.checks = one.said;
  wire::VehicleReport message;
  if (one.report.empty() || !message.ParseFromString(one.report)) return out;
  if (const auto report = vehicle::decode(message, one.arrived)) out.report = *report;
  out.arrived = one.arrived;
  out.report_age = vehicle::seconds_between(one.arrived, now);
  out.is_driven = message.held_by() != 0;
  out.is_stopped = message.is_stopped();
  return out;
}

}  // namespace mlab::vehicles
