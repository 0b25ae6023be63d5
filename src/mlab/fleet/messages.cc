#include "mlab/fleet/messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {
namespace {

using percept::Audience;
using percept::Claim;
using percept::Request;
using percept::SharedPlace;

void put(std::vector<std::uint64_t>& inbox, std::uint64_t notification) {
  const auto at = std::ranges::lower_bound(inbox, notification);
  if (at == inbox.end() || *at != notification) inbox.insert(at, notification);
}

void take(std::vector<std::uint64_t>& inbox, std::uint64_t notification) {
  const auto at = std::ranges::lower_bound(inbox, notification);
  if (at != inbox.end() && *at == notification) inbox.erase(at);
}

}  // namespace

std::span<const Claim> Messages::claims(std::uint32_t team) const {
  const auto range = std::ranges::equal_range(claim_teams_, team);
  return {claims_.data() + (range.begin() - claim_teams_.begin()), range.size()};
}

void Messages::resolve(std::vector<FleetRobot>& robots, double time) {
  to_all_.clear();
  to_teams_.clear();
  wishes_.clear();
  for (FleetRobot& robot : robots) read(robot, time);
  deliver(robots);
  settle_claims();
  contracts_.resolve(robots, time);
}

void Messages::read(FleetRobot& robot, double time) {
  // What is taken was heard in this cycle; what comes now is news.
  for (const Request& request : requests_of(robot)) {
    if (request.kind == Request::Kind::kTakeNotification) take(robot.notifications, request.notification);
  }
  for (const Request& request : requests_of(robot)) {
    if (request.kind == Request::Kind::kSharePlace) share(robot.id, request, time);
    if (request.kind == Request::Kind::kClaim && request.object.value != 0) {
      const auto held = claims(robot.team);
      const Claim claim{request.object, robot.id};
      const auto at = std::ranges::lower_bound(held, claim.object, {}, &Claim::object);
      const bool is_held = at != held.end() && at->object == claim.object && at->robot == claim.robot;
      const double cost =
          std::isfinite(request.cost) ? request.cost : std::numeric_limits<double>::infinity();
      wishes_.push_back({robot.team, claim, !is_held, cost});
    }
    if (request.kind != Request::Kind::kNotify) continue;
    if (request.audience == Audience::kAll) to_all_.push_back(request.notification);
    if (request.audience == Audience::kTeam) to_teams_.push_back({robot.team, request.notification});
    if (request.audience == Audience::kSelf) put(robot.notifications, request.notification);
  }
}

void Messages::share(base::RobotId from, const Request& request, double time) {
  if (!std::isfinite(request.place.x + request.place.y)) return;
  const SharedPlace place{from, request.object, request.object_class, request.place, time};
  const auto at = std::ranges::lower_bound(places_, from, {}, &SharedPlace::from);
  if (at != places_.end() && at->from == from)
    *at = place;
  else
    places_.insert(at, place);
}

void Messages::deliver(std::vector<FleetRobot>& robots) {
  if (to_all_.empty() && to_teams_.empty()) return;
  std::ranges::sort(to_all_);
  to_all_.erase(std::ranges::unique(to_all_).begin(), to_all_.end());
  std::ranges::sort(to_teams_);
  to_teams_.erase(std::ranges::unique(to_teams_).begin(), to_teams_.end());
  for (FleetRobot& robot : robots) {
    for (const std::uint64_t notification : to_all_) put(robot.notifications, notification);
    for (const Letter& letter : std::ranges::equal_range(to_teams_, robot.team, {}, &Letter::team))
      put(robot.notifications, letter.notification);
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
