#include "mlab/schema/errands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mlab/base/hash.h"
#include "mlab/schema/contracts.h"
#include "mlab/schema/requests.h"
#include "mlab/schema/route.h"

namespace mlab::schema {
namespace {

using percept::Contract;
using percept::ContractState;
using percept::Percepts;
using percept::Request;
using percept::Task;

constexpr double kWait = 1.0;      // for bids [s]
constexpr double kPatience = 5.0;  // with who is silent [s]

bool may_bid(const Contract& contract, base::RobotId robot) {
  return contract.state == ContractState::kOpen && contract.reneged != robot;
}

// Of the box around them [m].
double extent_of(std::span<const geom::Point> points) {
  geom::Point low = points.empty() ? geom::Point{} : points.front();
  geom::Point high = low;
  for (const geom::Point p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return geom::distance(low, high);
}

// Of 20 random fields with 20 places and 5 robots all have ways of at most 1.14 times the shortest together,
// and take two thirds of the time that the shortest take.
constexpr double kFairness = 0.8;

}  // namespace

Errands::Errands(const Percepts& percepts) : order_(percepts.order) {
  static constexpr std::uint64_t kName = base::hash_text("errand");
  task_ = base::combine_bits(kName, order_.sequence);
  count_ = order_.task == Task::kSearch ? percept::piece_count(order_.route) : order_.route.size();
  count_ = std::min(count_, kMostErrands);
  for (const Contract& contract : percepts.contracts) {
    const std::optional<std::size_t> errand = errand_of(contract);
    if (!errand) continue;
    contracts_[*errand] = &contract;
    done_ += contract.state == ContractState::kDone ? 1 : 0;
  }
}

std::span<const geom::Point> Errands::way(std::size_t errand) const {
  if (errand >= count_) return {};
  return order_.task == Task::kSearch ? percept::piece(order_.route, errand)
                                      : order_.route.subspan(errand, 1);
}

geom::Point Errands::place(std::size_t errand) const {
  return contracts_[errand] != nullptr ? contracts_[errand]->place : way(errand).front();
}

std::optional<std::size_t> Errands::errand_of(const Contract& contract) const {
  const std::uint32_t number = contract.object.value;
  if (contract.task != task_ || number == 0 || number > count_) return std::nullopt;
  return number - 1;
}

bool Errands::has_one(base::RobotId robot) const {
  return std::any_of(contracts_.begin(), contracts_.begin() + static_cast<std::ptrdiff_t>(count_),
                     [&](const Contract* one) { return one != nullptr && is_held(*one, robot); });
}

bool Errands::are_given_up(double time) const {
  // Who would take one has announced it anew long before [s].
  constexpr double kSettled = 5.0;
  return std::all_of(
      contracts_.begin(), contracts_.begin() + static_cast<std::ptrdiff_t>(count_), [&](const Contract* one) {
        return one != nullptr && (one->state == ContractState::kDone ||
                                  (one->state == ContractState::kFailed && time - one->time > kSettled));
      });
}

bool Errands::is_share_of_another(std::size_t errand, base::RobotId robot) const {
  const std::size_t first = errand / percept::kPiecesOfAShare * percept::kPiecesOfAShare;
  for (std::size_t i = first; i < std::min(first + percept::kPiecesOfAShare, count_); ++i) {
    const Contract* contract = contracts_[i];
    if (contract != nullptr && contract->contractor.value != 0 && contract->contractor != robot) return true;
  }
  return false;
}

std::optional<std::size_t> Errands::piece_of_another(std::size_t share, base::RobotId robot) const {
  const std::size_t first = share * percept::kPiecesOfAShare;
  for (std::size_t i = first; i < std::min(first + percept::kPiecesOfAShare, count_); ++i) {
    const Contract* contract = contracts_[i];
    if (contract != nullptr && contract->contractor != robot && is_held(*contract, contract->contractor))
      return i;
  }
  return std::nullopt;
}

void LegWatch::head_for_next(double time) {
  least_ = last_ = std::numeric_limits<double>::infinity();
  nearer_at_ = time;
}

LegWatch::Verdict LegWatch::look(double left, double tolerance, double patience, double time) {
  constexpr double kNearer = 0.5;    // [m]
  constexpr double kAnother = 10.0;  // a way that is so much longer than before is another one [m]
  if (left > last_ + kAnother) least_ = left;
  last_ = left;
  if (left < least_ - kNearer) {
    least_ = left;
    nearer_at_ = time;
  }
  is_closed_ = left >= kClosedEnd;
  if (left <= tolerance) return Verdict::kThere;
  const bool is_at_end = is_closed_ && left <= kClosedEnd + tolerance;
  return is_at_end || time - nearer_at_ > patience ? Verdict::kInVain : Verdict::kUnderWay;
}

namespace {

void announce_errands(const Percepts& percepts, const Errands& errands, const ErrandSet& given_back,
                      percept::Action& action) {
  const std::size_t slices = std::max<std::size_t>(percepts.unit.size, 1);
  const auto announce = [&](std::size_t errand) {
    const Contract* contract = errands.contract(errand);
    const bool is_wanted =
        contract == nullptr || (contract->state == ContractState::kFailed && !given_back.has(errand));
    if (!is_wanted || errands.way(errand).empty()) return;
    Request request =
        announcement(errands.task(), {static_cast<std::uint32_t>(errand + 1)}, errands.way(errand).front());
    request.wait = kWait;
    request.patience = kPatience;
    action.ask(request);
  };
  for (std::size_t i = percepts.unit.rank; i < errands.count(); i += slices) announce(i);
  for (std::size_t i = 0; i < errands.count(); ++i) announce(i);
}

// What a way costs a robot that shares places: a long one more than two of half its length, so that nobody
// does most of it. `extent`: of the ground [m].
double cost_of_way(double length, double extent) {
  return length * (1.0 + kFairness * length / extent);
}

// Which of the parts that are awarded, and not begun with, is up for exchange in this cycle: for all robots
// the same.
const Contract* offered_for_exchange(const Errands& errands, double time, double cycle) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < errands.count(); ++i) {
    const Contract* contract = errands.contract(i);
    if (contract == nullptr || contract->state == ContractState::kOpen) return nullptr;  // first all of them
    count += contract->state == ContractState::kAwarded ? 1 : 0;
  }
  if (count == 0 || !(cycle > 0.0)) return nullptr;
  std::size_t number = static_cast<std::uint64_t>(std::max(0.0, std::round(time / cycle))) % count;
  for (std::size_t i = 0; i < errands.count(); ++i) {
    const Contract* contract = errands.contract(i);
    if (contract->state == ContractState::kAwarded && number-- == 0) return contract;
  }
  return nullptr;
}

void bid(const Contract& contract, double cost, percept::Action& action) {
  Request request = about_task(Request::Kind::kBid, contract);
  request.cost = cost;
  ask_once(action, request);
}

void bid_for_places(const Percepts& percepts, const Errands& errands, const ErrandSet& given_back,
                    percept::Action& action) {
  const TaskWay way(percepts);
  const double extent = std::max(1.0, extent_of(percepts.order.route));
  const double length = way.length();
  const auto cost_with = [&](double added) {
    return cost_of_way(length + added, extent) - cost_of_way(length, extent);
  };
  if (const Contract* offered = offered_for_exchange(errands, percepts.time, percepts.cycle_duration)) {
    if (is_held(*offered, percepts.id)) {
      bid(*offered, cost_of_way(length, extent) - cost_of_way(TaskWay(percepts, offered).length(), extent),
          action);
    } else if (way.size() < kMostTasks && !given_back.has(*errands.errand_of(*offered))) {
      bid(*offered, cost_with(way.added(offered->place)), action);
    }
    return;
  }
  if (way.size() == kMostTasks) return;
  const Contract* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < errands.count(); ++i) {
    const Contract* contract = errands.contract(i);
    if (contract == nullptr || !may_bid(*contract, percepts.id) || given_back.has(i)) continue;
    const double cost = cost_with(way.added(contract->place));
    if (cost >= least) continue;
    best = contract;
    least = cost;
  }
  if (best != nullptr) bid(*best, least, action);
}

// Which piece of a share a robot would take that has none: the first that nobody has, since the next one
// begins where it ends. Where somebody else goes along the share it is the last one, if this robot is there
// before he has done those before it; but of who takes long the first one.
//
// @param lengths  of the pieces [m]
std::optional<std::size_t> piece_to_take(const Percepts& percepts, const Errands& errands,
                                         const ErrandSet& given_back, std::size_t share,
                                         std::span<const double> lengths) {
  constexpr double kSlow = 1.0;    // [m/s]
  constexpr double kGrace = 30.0;  // [s]
  const std::size_t begin = share * percept::kPiecesOfAShare;
  const std::size_t end = std::min(begin + percept::kPiecesOfAShare, errands.count());
  const auto is_left = [&](std::size_t i) {
    const Contract* contract = errands.contract(i);
    if (contract == nullptr) return true;
    const bool is_nobodys =
        contract->state == ContractState::kOpen || contract->state == ContractState::kFailed;
    return is_nobodys && contract->reneged != percepts.id && !given_back.has(i);
  };
  std::size_t first = begin;
  while (first < end && !is_left(first)) ++first;
  if (first == end) return std::nullopt;
  const auto under_way = errands.piece_of_another(share, percepts.id);
  if (!under_way) return first;
  const double length = lengths[*under_way];
  if (percepts.time - errands.contract(*under_way)->time > length / kSlow + kGrace) return first;
  std::size_t last = end - 1;
  while (!is_left(last)) --last;
  const double pieces_before = static_cast<double>(last) - static_cast<double>(*under_way) - 1.0;
  const double away = geom::distance(percepts.pose.position, errands.place(last));
  return away < pieces_before * length ? std::optional(last) : std::nullopt;
}

// One at a time: the nearest, of others' shares last. For one that is not on offer just now it waits: it is
// announced again.
void bid_for_pieces(const Percepts& percepts, const Errands& errands, const ErrandSet& given_back,
                    percept::Action& action) {
  if (errands.has_one(percepts.id)) return;
  const double aside = 1.0 + route_length(percepts.order.route);  // farther than anything on it
  std::array<double, kMostErrands> lengths{};
  std::size_t number = 0;
  percept::each_piece(percepts.order.route, [&](std::span<const geom::Point> one) {
    lengths[number] = route_length(one);
    return ++number < kMostErrands;
  });
  const Contract* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t share = 0; share * percept::kPiecesOfAShare < errands.count(); ++share) {
    const auto errand = piece_to_take(percepts, errands, given_back, share, lengths);
    if (!errand) continue;
    const double cost = geom::distance(percepts.pose.position, errands.place(*errand)) +
                        (errands.is_share_of_another(*errand, percepts.id) ? aside : 0.0);
    if (cost >= least) continue;
    best = errands.contract(*errand);
    least = cost;
  }
  if (best != nullptr && may_bid(*best, percepts.id)) bid(*best, least, action);
}

/// Who has left a leg of a search comes back to it so far ahead [m], not at the next corner: so what nobody
/// knew of makes a robot leave a leg only as long as it stands beside it.
constexpr double kAheadOnLeg = 5.0;
/// Who is farther from it than so much of the swath, and than so many metres, has left it, until it is so
/// near to it again.
constexpr double kOffLeg = 0.035;
constexpr double kLeastOffLeg = 0.35;
constexpr double kOnLeg = 0.015;
constexpr double kLeastOnLeg = 0.15;

/// Where to head for on the way to a corner of a search's piece.
geom::Point on_leg(std::span<const geom::Point> way, const ErrandState& state) {
  const geom::Point corner = way[state.leg];
  if (!state.comes_back) return corner;
  const geom::Point from = way[state.leg - 1];
  return from + (corner - from) * (state.along / geom::distance(from, corner));
}

/// Who has left its leg heads for a place on it, and for a later one when it has passed half of what was
/// ahead, or can't come to that; else for the corner. No place is tried twice.
/// @return  whether it did not head for the corner before: what became of that is seen to then
bool come_back_to_leg(std::span<const geom::Point> way, const Percepts& percepts, LegWatch::Verdict verdict,
                      ErrandState& state, LegWatch& watch) {
  if (state.leg == 0 || state.leg >= way.size()) return false;
  const geom::Point here = percepts.pose.position;
  const geom::Segment leg{way[state.leg - 1], way[state.leg]};
  const geom::Point nearest = geom::nearest_point(leg, here);
  const double passed = geom::distance(leg.a, nearest);
  const bool is_under_way = verdict == LegWatch::Verdict::kUnderWay;
  const bool is_in_vain = verdict == LegWatch::Verdict::kInVain;
  const bool came_back = state.comes_back;
  const double away = geom::distance(here, nearest);
  const double swath = percepts.order.swath;
  const bool is_on_leg =
      away < (came_back ? std::max(kLeastOnLeg, kOnLeg * swath) : std::max(kLeastOffLeg, kOffLeg * swath));
  if (came_back && is_under_way && passed < state.along - 0.5 * kAheadOnLeg) return true;
  if (!came_back && (!is_under_way || is_on_leg)) return false;
  const double length = geom::distance(leg.a, leg.b);
  const double next = std::max(state.along, passed) + kAheadOnLeg;
  // Where it could come to none of two places it tries no third: it would wait at each of them.
  const bool is_stuck = is_in_vain && passed < state.along - 1.5 * kAheadOnLeg;
  const bool is_at_corner = is_stuck || next > length - 0.5 * kAheadOnLeg;
  state.comes_back = !is_at_corner && !(is_on_leg && !is_in_vain);
  if (is_at_corner) state.along = length;
  if (state.comes_back) state.along = next;
  if (came_back || state.comes_back) watch.head_for_next(percepts.time);
  return came_back;
}

// How far along the leg of a piece, from its beginning, the robot is [m].
double passed_on_leg(std::span<const geom::Point> way, const ErrandState& state, geom::Point here) {
  if (state.leg == 0 || state.leg >= way.size()) return 0.0;
  return geom::distance(way[state.leg - 1], geom::nearest_point({way[state.leg - 1], way[state.leg]}, here));
}

// Whether the rest of the piece comes nearer to a place than the robot is.
bool comes_nearer(std::span<const geom::Point> way, const ErrandState& state, geom::Point here,
                  geom::Point place) {
  constexpr double kNearer = 0.5;  // [m]
  const double away = geom::distance(here, place) - kNearer;
  geom::Point from = here;
  for (std::size_t i = state.leg; i < way.size(); ++i) {
    if (geom::distance(geom::nearest_point({from, way[i]}, place), place) < away) return true;
    from = way[i];
  }
  return false;
}

/// Of what lies beside the piece it goes back to what it has left unseen, where it will come no nearer to it
/// later on; to all of it before the piece is done. What it can't come to, or see from where it comes to, it
/// leaves out.
/// @return  whether it heads for that, not along the piece
bool look_back(const Percepts& percepts, std::span<const geom::Point> way, LegWatch::Verdict verdict,
               ErrandState& state, LegWatch& watch) {
  const geom::Point here = percepts.pose.position;
  const double reach = 0.5 * percepts.order.swath;
  const bool is_through = state.leg >= way.size();
  const bool looked_back = state.looks_back;
  Swept& swept = state.swept;
  if (!state.was_there) return false;
  const double passed = passed_on_leg(way, state, here);
  const bool has_looked =
      looked_back || swept.pass(percepts.ground, way, state.leg, passed, percepts.order.margin, reach);
  if (looked_back && verdict != LegWatch::Verdict::kUnderWay)
    swept.give_up(state.back_to, verdict == LegWatch::Verdict::kInVain ? reach : 0.0);
  if (looked_back && swept.misses(state.back_to)) return true;
  const bool wants_all = is_through || swept.is_nearly_full();
  const geom::Point* best = nullptr;
  for (const geom::Point& place : swept.missed()) {
    if (!wants_all && comes_nearer(way, state, here, place)) continue;
    if (best == nullptr || geom::distance(here, place) < geom::distance(here, *best)) best = &place;
  }
  state.looks_back = best != nullptr;
  if (best != nullptr) state.back_to = *best;
  if (looked_back || state.looks_back) watch.head_for_next(percepts.time);
  if (!looked_back && state.looks_back) {
    // It comes back to where it leaves the leg, or would have come to it.
    state.along = std::max((state.comes_back ? state.along : passed) - kAheadOnLeg, 0.0);
    state.comes_back = false;
  }
  return state.looks_back || (is_through && !has_looked);
}

// The leg of a piece that leads to a corner; of the first one that corner alone.
geom::Segment leg_to(std::span<const geom::Point> way, std::size_t corner) {
  return {way[corner == 0 ? 0 : corner - 1], way[corner]};
}

void head_for_corner(std::size_t corner, double time, ErrandState& state, LegWatch& watch) {
  state.leg = static_cast<std::uint32_t>(corner);
  state.along = 0.0;
  state.comes_back = false;
  watch.head_for_next(time);
}

// Of a piece it leaves out the next legs, as far as nobody sees anything of them.
void leave_out_covered(const Percepts& percepts, std::span<const geom::Point> way, ErrandState& state,
                       LegWatch& watch) {
  if (percepts.order.task != Task::kSearch) return;  // a place under something is come to beside that
  const double reach = 0.5 * percepts.order.swath;
  std::size_t corner = state.leg;
  while (corner < way.size() && is_covered(percepts.ground, leg_to(way, corner), reach)) ++corner;
  if (corner != state.leg) head_for_corner(corner, percepts.time, state, watch);
}

// What comes of the part that this robot has next. @return where it is to go for that
geom::Point go_on_with(const Percepts& percepts, const Errands& errands, std::size_t errand,
                       const Contract& contract, LegWatch::Verdict verdict, ErrandState& state,
                       LegWatch& watch, percept::Action& action) {
  const geom::Point here = percepts.pose.position;
  const double time = percepts.time;
  const std::span<const geom::Point> way = errands.way(errand);
  if (state.current != static_cast<std::int32_t>(errand)) {
    state.current = static_cast<std::int32_t>(errand);
    state.was_there = false;
    state.looks_back = false;
    state.swept.begin();
    head_for_corner(0, time, state, watch);
    leave_out_covered(percepts, way, state, watch);
    verdict = LegWatch::Verdict::kUnderWay;
  }
  if (percepts.order.swath > 0.0) {
    const bool looked_back = state.looks_back;
    if (look_back(percepts, way, verdict, state, watch)) return state.looks_back ? state.back_to : here;
    if (looked_back) verdict = LegWatch::Verdict::kUnderWay;
  }
  if (state.leg < way.size() && verdict == LegWatch::Verdict::kThere) {
    // Beside a thing that stands there nothing of it may be seen.
    const double away = geom::distance(geom::nearest_point(leg_to(way, state.leg), here), here);
    if (percepts.order.task != Task::kSearch || away <= 0.5 * percepts.order.swath) state.was_there = true;
  }
  if (come_back_to_leg(way, percepts, verdict, state, watch)) verdict = LegWatch::Verdict::kUnderWay;
  // What it can't come to it leaves out.
  if (state.leg < way.size() && verdict != LegWatch::Verdict::kUnderWay) {
    head_for_corner(state.leg + 1, time, state, watch);
    leave_out_covered(percepts, way, state, watch);
  }
  const bool is_through = state.leg >= way.size();
  const bool is_lost = is_through && !state.was_there;
  const bool is_given_back = is_lost && !is_nothing_to_see(percepts, errands, errand);
  if (is_lost && !state.given_back.has(errand) && !watch.is_closed())
    tell_of_lost(percepts, errands, errand, is_given_back ? "gives back" : "leaves out", action);
  if (is_given_back) {
    state.given_back.add(errand);
    ask_once(action, about_task(Request::Kind::kRenegeTask, contract));
    return way.back();
  }
  if (is_through) {
    ask_once(action, about_task(Request::Kind::kFinishTask, contract));
  } else if (contract.state == ContractState::kAwarded) {
    ask_once(action, about_task(Request::Kind::kStartTask, contract));
  }
  return is_through ? here : on_leg(way, state);
}

}  // namespace

geom::Point next_errand(const Percepts& percepts, LegWatch::Verdict verdict, ErrandState& state,
                        LegWatch& watch, percept::Action& action) {
  const Errands errands(percepts);
  keep_tasks(percepts, action);
  geom::Point out = percepts.pose.position;
  if (percepts.order.swath > 0.0) state.swept.look(percepts.ground, out, 0.5 * percepts.order.swath);
  // What it set out for it keeps: of two ways of nearly the same length now one is shorter, now the other
  // one.
  const Contract* next =
      state.current < 0 ? nullptr : errands.contract(static_cast<std::size_t>(state.current));
  if (next == nullptr || !is_held(*next, percepts.id)) next = next_task(percepts, errands.task());
  const auto errand = next == nullptr ? std::nullopt : errands.errand_of(*next);
  if (errand)
    out = go_on_with(percepts, errands, *errand, *next, verdict, state, watch, action);
  else
    state.current = -1;
  if (percepts.order.task == Task::kSearch)
    bid_for_pieces(percepts, errands, state.given_back, action);
  else
    bid_for_places(percepts, errands, state.given_back, action);
  announce_errands(percepts, errands, state.given_back, action);  // what there is room for
  return out;
}

}  // namespace mlab::schema
