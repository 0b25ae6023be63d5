#include "mlab/fleet/messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {
namespace {

using percept::AskedPassage;
using percept::Audience;
using percept::Claim;
using percept::Request;
using percept::SharedPlace;

void take(std::vector<std::uint64_t>& inbox, std::uint64_t notification) {
  const auto at = std::ranges::lower_bound(inbox, notification);
  if (at != inbox.end() && *at == notification) inbox.erase(at);
}

// Of a robot that hears more tellers the oldest is forgotten.
constexpr std::size_t kMostHeard = 256;

// In the place of what the same robot told before.
template <class Told>
void keep(std::vector<Told>& all, const Told& told) {
  const auto at = std::ranges::lower_bound(all, told.from, {}, &Told::from);
  if (at != all.end() && at->from == told.from)
    *at = told;
  else
    all.insert(at, told);
}

template <class Told>
void hear(std::vector<Told>& all, const Told& told) {
  keep(all, told);
  if (all.size() > kMostHeard) all.erase(std::ranges::min_element(all, {}, &Told::time));
}

SharedPlace place_in(const Request& request, base::RobotId from, double time) {
  return {from, request.object, request.object_class, request.place, time};
}

AskedPassage passage_in(const Request& request, base::RobotId from, double time) {
  return {from, request.place, request.cost, time};
}

bool is_told(const Request& request) {
  if (request.kind == Request::Kind::kSharePlace || request.kind == Request::Kind::kAskPassage)
    return std::isfinite(request.place.x + request.place.y);
  return request.kind == Request::Kind::kNotify && request.audience != Audience::kSelf;
}

}  // namespace

void put_notification(std::vector<std::uint64_t>& inbox, std::uint64_t notification) {
  const auto at = std::ranges::lower_bound(inbox, notification);
  if (at == inbox.end() || *at != notification) inbox.insert(at, notification);
}

std::span<const SharedPlace> Messages::places(const FleetRobot& robot) const {
  return is_limited_ ? robot.places : places_;
}

std::span<const AskedPassage> Messages::passages(const FleetRobot& robot) const {
  return is_limited_ ? robot.passages : passages_;
}

void Messages::add_told(const FleetRobot& robot, percept::Percepts& out) const {
  out.shared_places = places(robot);
  out.asked_passages = passages(robot);
  out.claims = claims(robot.team);
  out.contracts = contracts(robot.team);
}

std::span<const Claim> Messages::claims(std::uint32_t team) const {
  const auto range = std::ranges::equal_range(claim_teams_, team);
  return {claims_.data() + (range.begin() - claim_teams_.begin()), range.size()};
}

void Messages::resolve(std::vector<FleetRobot>& robots, double time,
                       const std::function<const binding::RadioLinks*()>& radio) {
  told_.clear();
  wishes_.clear();
  for (FleetRobot& robot : robots) read(robot);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const Request& request : requests_of(robots[i])) {
      if (is_told(request)) told_.push_back({i, request});
    }
  }
  if (!told_.empty()) {
    const binding::RadioLinks* const links = radio();
    limit(robots, links != nullptr);
    if (links == nullptr)
      tell(robots, time);
    else
      tell(robots, time, *links);
  }
  settle_claims();
  contracts_.resolve(robots, time);
}

// What was known stays known.
void Messages::limit(std::vector<FleetRobot>& robots, bool is_limited) {
  if (is_limited && !is_limited_) {
    for (FleetRobot& robot : robots) {
      robot.places = places_;
      robot.passages = passages_;
    }
  }
  is_limited_ = is_limited;
}

void Messages::read(FleetRobot& robot) {
  // What is taken was heard in this cycle; what comes now is news.
  for (const Request& request : requests_of(robot)) {
    if (request.kind == Request::Kind::kTakeNotification) take(robot.notifications, request.notification);
  }
  for (const Request& request : requests_of(robot)) {
    if (request.kind == Request::Kind::kClaim && request.object.value != 0) {
      const auto held = claims(robot.team);
      const Claim claim{request.object, robot.id};
      const auto at = std::ranges::lower_bound(held, claim.object, {}, &Claim::object);
      const bool is_held = at != held.end() && at->object == claim.object && at->robot == claim.robot;
      const double cost =
          std::isfinite(request.cost) ? request.cost : std::numeric_limits<double>::infinity();
      wishes_.push_back({robot.team, claim, !is_held, cost});
    }
    if (request.kind == Request::Kind::kNotify && request.audience == Audience::kSelf)
      put_notification(robot.notifications, request.notification);
  }
}

void Messages::tell(std::vector<FleetRobot>& robots, double time) {
  to_all_.clear();
  to_teams_.clear();
  for (const auto& [teller, request] : told_) {
    if (request.kind == Request::Kind::kSharePlace)
      keep(places_, place_in(request, robots[teller].id, time));
    else if (request.kind == Request::Kind::kAskPassage)
      keep(passages_, passage_in(request, robots[teller].id, time));
    else if (request.audience == Audience::kAll)
      to_all_.push_back(request.notification);
    else
      to_teams_.push_back({robots[teller].team, request.notification});
  }
  deliver(robots);
}

// Who tells something knows it himself. Who has no body hears nobody, and nobody hears him.
void Messages::tell(std::vector<FleetRobot>& robots, double time, const binding::RadioLinks& radio) {
  nets_.clear();
  for (const FleetRobot& robot : robots)
    nets_.push_back(robot.body == binding::kNoBody ? binding::kNoBody.value : radio.net_of(robot.body));
  broadcasts_.clear();
  for (const auto& [from, request] : told_) {
    const FleetRobot& teller = robots[from];
    if (teller.body == binding::kNoBody) continue;
    const bool is_news = request.kind == Request::Kind::kNotify;
    const bool is_passage = request.kind == Request::Kind::kAskPassage;
    const bool is_to_all = request.audience == Audience::kAll;
    const SharedPlace place = place_in(request, teller.id, time);
    const AskedPassage passage = passage_in(request, teller.id, time);
    if (is_passage)
      keep(passages_, passage);
    else if (!is_news)
      keep(places_, place);
    if (is_news && !radio.loses(teller.body)) {
      broadcasts_.push_back({nets_[from], is_to_all, is_to_all ? 0 : teller.team, request.notification});
      continue;
    }
    for (std::size_t i = 0; i < robots.size(); ++i) {
      FleetRobot& robot = robots[i];
      if (nets_[i] != nets_[from] || (is_news && !is_to_all && robot.team != teller.team)) continue;
      if (i != from && !(robot.body != binding::kNoBody && radio.arrives(teller.body, robot.body))) continue;
      if (is_news)
        put_notification(robot.notifications, request.notification);
      else if (is_passage)
        hear(robot.passages, passage);
      else
        hear(robot.places, place);
    }
  }
  std::ranges::sort(broadcasts_);
  broadcasts_.erase(std::ranges::unique(broadcasts_).begin(), broadcasts_.end());
  if (broadcasts_.empty()) return;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const Broadcast& one : std::ranges::equal_range(broadcasts_, nets_[i], {}, &Broadcast::net)) {
      if (one.is_to_all || one.team == robots[i].team)
        put_notification(robots[i].notifications, one.notification);
    }
  }
}

void Messages::deliver(std::vector<FleetRobot>& robots) {
  if (to_all_.empty() && to_teams_.empty()) return;
  std::ranges::sort(to_all_);
  to_all_.erase(std::ranges::unique(to_all_).begin(), to_all_.end());
  std::ranges::sort(to_teams_);
  to_teams_.erase(std::ranges::unique(to_teams_).begin(), to_teams_.end());
  for (FleetRobot& robot : robots) {
    for (const std::uint64_t notification : to_all_) put_notification(robot.notifications, notification);
    for (const Letter& letter : std::ranges::equal_range(to_teams_, robot.team, {}, &Letter::team))
      put_notification(robot.notifications, letter.notification);
  }
}

void Messages::settle_claims() {
  std::ranges::sort(wishes_, [](const Wish& a, const Wish& b) {
    return std::tie(a.team, a.claim.object, a.is_new, a.cost, a.claim.robot) <
           std::tie(b.team, b.claim.object, b.is_new, b.cost, b.claim.robot);
  });
  claims_.clear();
  claim_teams_.clear();
  for (const Wish& wish : wishes_) {
    if (!claims_.empty() && claims_.back().object == wish.claim.object && claim_teams_.back() == wish.team)
      continue;
    claims_.push_back(wish.claim);
    claim_teams_.push_back(wish.team);
  }
}

}  // namespace mlab::fleet
