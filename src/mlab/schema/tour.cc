#include "mlab/schema/tour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mlab/schema/requests.h"
#include "mlab/schema/route.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using percept::Percepts;
using percept::Request;

constexpr std::uint32_t kLegBits = 8;
constexpr std::uint32_t kFlagBits = 3;

// From the tour's first place [m]; the leg ends at its place.
double way_round(std::span<const geom::Point> tour, std::size_t leg, geom::Point p) {
  const geom::Point from = tour[(leg + tour.size() - 1) % tour.size()];
  const geom::Point at = geom::nearest_point({from, tour[leg]}, p);
  double out = geom::distance(from, at);
  for (std::size_t i = 1; i <= (leg + tour.size() - 1) % tour.size(); ++i)
    out += geom::distance(tour[i - 1], tour[i]);
  return out;
}

double length_round(std::span<const geom::Point> tour) {
  return route_length(tour) + geom::distance(tour.back(), tour.front());
}

// As it told it last.
TourPlace own_tour_place(const Percepts& percepts) {
  for (const percept::SharedPlace& shared : percepts.shared_places) {
    const auto place = tour_place(percepts.order, shared);
    if (place && shared.from == percepts.id) return *place;
  }
  return {};
}

// Where no way led to any place of the round when these were last tried, one after the other.
bool comes_to_none(const TourState& state, std::size_t places) {
  return state.in_vain >= places;
}

// Where a robot is that goes round and counts: not who has told nothing for `patience` [s], or comes to no
// place.
std::optional<TourPlace> place_on_round(const Percepts& percepts, const percept::SharedPlace& shared,
                                        double patience) {
  const auto place = tour_place(percepts.order, shared);
  if (!place || place->comes_to_none || percepts.time - shared.time > patience) return std::nullopt;
  return place;
}

/// A robot on the round.
struct OnRound {
  base::RobotId robot;
  std::size_t leg = 0;  // it heads for that place
  double along = 0.0;   // that leg [m]
};

using Polyline = std::vector<geom::Point>;

// The legs of a round, which end at its places. Who shows a round asks many times for the same one.
const std::vector<Polyline>& legs_of(const Percepts& percepts, double radius, double margin) {
  struct Legs {
    std::uint64_t revision = 0;  // of the ground
    std::vector<geom::Point> tour;
    double radius = 0.0;
    double margin = 0.0;
    std::vector<Polyline> all;
  };
  thread_local Legs known;
  const std::span<const geom::Point> tour = percepts.order.route;
  if (known.revision == percepts.ground.revision && known.radius == radius && known.margin == margin &&
      std::ranges::equal(known.tour, tour))
    return known.all;
  known = {percepts.ground.revision, {tour.begin(), tour.end()}, radius, margin, {}};
  geom::Point from = tour.empty() ? geom::Point{} : tour.back();
  for (const geom::Point& place : tour) {
    const ways::PlannedWay way = plan_way(percepts.ground, from, place, radius, margin);
    const auto points = way.points();
    known.all.push_back(way.is_closed_off() ? Polyline{from, place} : Polyline(points.begin(), points.end()));
    if (way.end == ways::WayEnd::kFull) known.all.back().push_back(way.whole_last());
    from = known.all.back().back();
  }
  return known.all;
}

// Adds what of a leg lies behind one place on it, up to another one or to its end; without the first one.
void add_piece(const Polyline& leg, double from, std::optional<double> to, Polyline& out) {
  const double end = to.value_or(std::numeric_limits<double>::infinity());
  double at = 0.0;
  for (std::size_t i = 1; i + 1 < leg.size(); ++i) {
    at += geom::distance(leg[i - 1], leg[i]);
    if (at > from && at < end) out.push_back(leg[i]);
  }
  out.push_back(to ? route_point(leg, *to) : leg.back());
}

}  // namespace

geom::Point next_tour_place(const Percepts& percepts, LegWatch::Verdict verdict, TourState& state,
                            LegWatch& watch, percept::Action& action) {
  const std::span<const geom::Point> tour = percepts.order.route;
  const geom::Point here = percepts.pose.position;
  if (tour.empty()) return here;
  if (verdict != LegWatch::Verdict::kUnderWay) {
    state.at.leg = (state.at.leg + 1) % tour.size();
    state.in_vain = verdict == LegWatch::Verdict::kThere ? 0 : state.in_vain + 1;
    state.passed = comes_to_none(state, tour.size()) ? 0 : state.passed + 1;
    watch.head_for_next(percepts.time);
  }
  state.at.has_gone_round = state.at.has_gone_round || state.passed > tour.size();
  state.at.is_shut_in = verdict != LegWatch::Verdict::kThere && own_tour_place(percepts).is_shut_in;
  state.at.comes_to_none = state.at.is_shut_in || comes_to_none(state, tour.size());
  Request told = share_place(here);
  told.object = tour_code(percepts.order, state.at);
  action.ask(told);
  return tour[state.at.leg % tour.size()];
}

base::ObjectId tour_code(const percept::Order& order, TourPlace place) {
  const std::uint32_t flags =
      (place.has_gone_round ? 1U : 0U) | (place.comes_to_none ? 2U : 0U) | (place.is_shut_in ? 4U : 0U);
  const auto leg = static_cast<std::uint32_t>(place.leg);
  return {order.sequence << (kLegBits + kFlagBits) | flags << kLegBits | (leg & ((1U << kLegBits) - 1))};
}

std::optional<TourPlace> tour_place(const percept::Order& order, const percept::SharedPlace& shared) {
  const std::uint32_t code = shared.object.value;
  const TourPlace out{code & ((1U << kLegBits) - 1), (code >> kLegBits & 1U) != 0,
                      (code >> (kLegBits + 1) & 1U) != 0, (code >> (kLegBits + 2) & 1U) != 0};
  if (out.leg >= order.route.size() || tour_code(order, out) != shared.object) return std::nullopt;
  return out;
}

std::size_t nearest_leg(std::span<const geom::Point> tour, geom::Point p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const geom::Point from = tour[(i + tour.size() - 1) % tour.size()];
    const double away = geom::distance(geom::nearest_point({from, tour[i]}, p), p);
    if (away < least) {
      least = away;
      best = i;
    }
  }
  return best;
}

double patrol_pace(const Percepts& percepts, double patience, double slowest) {
  const std::span<const geom::Point> tour = percepts.order.route;
  if (tour.empty()) return 1.0;
  const double round = length_round(tour);
  std::optional<double> own;
  for (const percept::SharedPlace& shared : percepts.shared_places) {
    const auto place = tour_place(percepts.order, shared);
    if (place && shared.from == percepts.id) own = way_round(tour, place->leg, shared.place);
  }
  if (!own || !(round > 0.0)) return 1.0;
  double ahead = round;
  int robots = 1;
  for (const percept::SharedPlace& shared : percepts.shared_places) {
    const auto place = place_on_round(percepts, shared, patience);
    if (!place || shared.from == percepts.id) continue;
    ++robots;
    double gap = std::fmod(way_round(tour, place->leg, shared.place) - *own + round, round);
    // Side by side: who has the lower number is ahead.
    if (gap <= 0.0 && shared.from.value > percepts.id.value) gap = round;
    ahead = std::min(ahead, gap);
  }
  const double share = round / robots;
  constexpr double kGain = 2.0;
  return std::clamp(1.0 + kGain * (ahead - share) / share, slowest, 1.0);
}

std::vector<Stretch> stretches(const Percepts& percepts, double patience, double radius, double margin) {
  const std::vector<Polyline>& legs = legs_of(percepts, radius, margin);
  std::vector<OnRound> all;
  for (const percept::SharedPlace& shared : percepts.shared_places) {
    const auto place = place_on_round(percepts, shared, patience);
    if (!place) continue;
    const Polyline& leg = legs[place->leg];
    all.push_back({shared.from, place->leg, nearest_way(leg, shared.place, 0.0, route_length(leg))});
  }
  // Side by side who has the lower number is ahead, as for their pace.
  std::ranges::sort(all, [](const OnRound& a, const OnRound& b) {
    if (a.leg != b.leg) return a.leg < b.leg;
    return a.along != b.along ? a.along < b.along : a.robot.value > b.robot.value;
  });
  std::vector<Stretch> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const OnRound& from = all[i];
    const OnRound& to = all[(i + 1) % all.size()];
    Polyline& way = out.emplace_back(from.robot, Polyline{route_point(legs[from.leg], from.along)}).way;
    if (from.leg == to.leg && i + 1 < all.size()) {
      add_piece(legs[to.leg], from.along, to.along, way);
      continue;
    }
    add_piece(legs[from.leg], from.along, std::nullopt, way);
    for (std::size_t leg = (from.leg + 1) % legs.size(); leg != to.leg; leg = (leg + 1) % legs.size())
      add_piece(legs[leg], 0.0, std::nullopt, way);
    add_piece(legs[to.leg], 0.0, to.along, way);
  }
  return out;
}

}  // namespace mlab::schema
