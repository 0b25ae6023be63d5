#include "mlab/fleet/contracts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "mlab/fleet/fleet_robot.h"

namespace mlab::fleet {

using percept::Contract;
using percept::ContractState;
using percept::Request;

namespace {

bool is_held(const Contract& contract) {
  return contract.state == ContractState::kAwarded || contract.state == ContractState::kStarted;
}

bool is_wanted(const Contract& contract) {
  return contract.state == ContractState::kOpen || is_held(contract);
}

// A number that is none counts as the longest time.
double duration(double seconds) {
  return std::isnan(seconds) ? HUGE_VAL : std::max(seconds, 0.0);
}

}  // namespace

std::span<const Contract> Contracts::of(std::uint32_t team) const {
  const auto range = std::ranges::equal_range(terms_, team, {}, &Terms::team);
  return {contracts_.data() + (range.begin() - terms_.begin()), range.size()};
}

void Contracts::resolve(std::span<const FleetRobot> robots, double time) {
  bids_.clear();
  own_bids_.clear();
  for (const FleetRobot& robot : robots) {
    for (const Request& request : requests_of(robot)) {
      if (request.kind == Request::Kind::kAnnounceTask) announce(robot, request, time);
    }
  }
  if (contracts_.empty()) return;
  for (const FleetRobot& robot : robots) {
    for (const Request& request : requests_of(robot)) hear(robot, request, time);
  }
  for (std::size_t i = 0; i < contracts_.size(); ++i) {
    if (is_held(contracts_[i]) && time - terms_[i].heard > terms_[i].patience) offer(i, time);
  }
  award(time);
  give_up(time);
}

// Where it stands, or would stand.
std::size_t Contracts::place_of(std::uint32_t team, const Request& request) const {
  const auto range = std::ranges::equal_range(terms_, team, {}, &Terms::team);
  const auto begin = contracts_.begin() + (range.begin() - terms_.begin());
  const auto end = contracts_.begin() + (range.end() - terms_.begin());
  const auto at = std::lower_bound(begin, end, request, [](const Contract& a, const Request& b) {
    return std::tie(a.task, a.object) < std::tie(b.notification, b.object);
  });
  return static_cast<std::size_t>(at - contracts_.begin());
}

bool Contracts::is_at(std::size_t place, std::uint32_t team, const Request& request) const {
  return place < contracts_.size() && terms_[place].team == team &&
         contracts_[place].task == request.notification && contracts_[place].object == request.object;
}

void Contracts::announce(const FleetRobot& robot, const Request& request, double time) {
  if (!std::isfinite(request.place.x + request.place.y)) return;
  std::size_t at = place_of(robot.team, request);
  if (!is_at(at, robot.team, request)) {
    if (of(robot.team).size() >= kMostOfATeam && !forget_oldest(robot.team)) return;
    at = place_of(robot.team, request);
    const auto offset = static_cast<std::ptrdiff_t>(at);
    contracts_.insert(contracts_.begin() + offset, Contract{});
    terms_.insert(terms_.begin() + offset, Terms{});
  } else if (is_wanted(contracts_[at])) {
    return;
  }
  Contract& contract = contracts_[at];
  contract = {};
  contract.task = request.notification;
  contract.object = request.object;
  contract.place = request.place;
  contract.manager = robot.id;
  terms_[at] = {.team = robot.team,
                .wait = duration(request.wait),
                .patience = duration(request.patience),
                .deadline = 0.0,
                .heard = time};
  offer(at, time);
}

// Of a team that has as many as it may: one that is over. @return whether there was one
bool Contracts::forget_oldest(std::uint32_t team) {
  std::optional<std::size_t> oldest;
  for (std::size_t i = 0; i < contracts_.size(); ++i) {
    if (terms_[i].team != team || is_wanted(contracts_[i])) continue;
    if (!oldest || contracts_[i].time < contracts_[*oldest].time) oldest = i;
  }
  if (!oldest) return false;
  contracts_.erase(contracts_.begin() + static_cast<std::ptrdiff_t>(*oldest));
  terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(*oldest));
  return true;
}

void Contracts::offer(std::size_t contract, double time) {
  contracts_[contract].state = ContractState::kOpen;
  contracts_[contract].contractor = {};
  contracts_[contract].time = time;
  terms_[contract].deadline = time + terms_[contract].wait;
}

void Contracts::hear(const FleetRobot& robot, const Request& request, double time) {
  using Kind = Request::Kind;
  if (request.kind == Kind::kBid) bid(robot, request);
  if (request.kind == Kind::kKeepTasks) keep(robot, time);
  if (request.kind != Kind::kStartTask && request.kind != Kind::kFinishTask &&
      request.kind != Kind::kRenegeTask)
    return;
  const std::size_t at = place_of(robot.team, request);
  if (!is_at(at, robot.team, request)) return;
  Contract& contract = contracts_[at];
  if (!is_held(contract) || contract.contractor != robot.id) return;
  terms_[at].heard = time;
  if (request.kind == Kind::kStartTask) contract.state = ContractState::kStarted;
  if (request.kind == Kind::kFinishTask) contract.state = ContractState::kDone;
  if (request.kind == Kind::kRenegeTask) {
    offer(at, time);
    contract.reneged = robot.id;
  }
}

void Contracts::keep(const FleetRobot& robot, double time) {
  const std::size_t begin = static_cast<std::size_t>(
      std::ranges::lower_bound(terms_, robot.team, {}, &Terms::team) - terms_.begin());
  for (std::size_t i = begin; i < terms_.size() && terms_[i].team == robot.team; ++i) {
    if (is_held(contracts_[i]) && contracts_[i].contractor == robot.id) terms_[i].heard = time;
  }
}

void Contracts::bid(const FleetRobot& robot, const Request& request) {
  const std::size_t at = place_of(robot.team, request);
  if (!is_at(at, robot.team, request) || !std::isfinite(request.cost)) return;
  const Contract& contract = contracts_[at];
  if (contract.state == ContractState::kAwarded && contract.contractor == robot.id)
    own_bids_.push_back({robot.team, at, request.cost, robot.id});
  else if (contract.reneged != robot.id)
    bids_.push_back({robot.team, at, request.cost, robot.id});
}

// Only what is on offer can be had, or costs somebody else less than who has it and offers it himself.
void Contracts::drop_bids_in_vain() {
  constexpr double kLess = 0.1;  // [m]
  std::erase_if(bids_, [&](const Bid& bid) {
    const Contract& contract = contracts_[bid.contract];
    if (contract.state == ContractState::kOpen) return false;
    if (contract.state != ContractState::kAwarded || contract.contractor == bid.robot) return true;
    const auto offer =
        std::ranges::find_if(own_bids_, [&](const Bid& own) { return own.contract == bid.contract; });
    return offer == own_bids_.end() || bid.cost >= offer->cost - kLess;
  });
}

// One for each team: what another task costs a robot depends on those that it has.
void Contracts::award(double time) {
  drop_bids_in_vain();
  std::ranges::sort(bids_, [](const Bid& a, const Bid& b) {
    return std::tie(a.team, a.cost, a.robot, a.contract) < std::tie(b.team, b.cost, b.robot, b.contract);
  });
  const Bid* last = nullptr;
  for (const Bid& bid : bids_) {
    if (last != nullptr && last->team == bid.team) continue;
    if (time < terms_[bid.contract].deadline) continue;
    last = &bid;
    Contract& contract = contracts_[bid.contract];
    contract.state = ContractState::kAwarded;
    contract.contractor = bid.robot;
    contract.time = time;
    terms_[bid.contract].heard = time;
  }
}

// Where nobody of the team bids any more. Nobody can have known of what was announced in this cycle.
void Contracts::give_up(double time) {
  for (std::size_t i = 0; i < contracts_.size(); ++i) {
    if (contracts_[i].state != ContractState::kOpen) continue;
    if (time < terms_[i].deadline || time <= contracts_[i].time) continue;
    const bool is_bidding = std::ranges::binary_search(bids_, terms_[i].team, {}, &Bid::team);
    if (!is_bidding) contracts_[i].state = ContractState::kFailed;
  }
}

}  // namespace mlab::fleet
