#include "mlab/ways/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <ranges>
#include <tuple>
#include <utility>

#include "mlab/ways/turn.h"

namespace mlab::ways {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// A line round a circle leads so far outside of it at its corners: the larger of a share of the radius, and
// of a length [m].
constexpr double kOutside = 0.009;
constexpr double kLeastOutside = 0.03;
// Looking at so many rounds is as dear as a tangent.
constexpr std::uint64_t kRoundsOfATangent = 20;
constexpr double kSlack = 1e-9;  // a share: the last digits of what is computed in two ways

}  // namespace

struct Planner::Search {
  geom::Point from;
  geom::Point to;
  std::vector<Step> steps;
  using Open = std::pair<double, std::int32_t>;  // the least that a way through this step has, and the step
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  /// The least that a way by this round has, and the round: those that no step leads to from where it begins
  /// so far.
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>,
                      std::greater<>>
      rounds;
  /// The least that a way by farther rings of a step's circle has, the step, and the first of the rings.
  using Farther = std::tuple<double, std::int32_t, std::uint32_t>;
  std::priority_queue<Farther, std::vector<Farther>, std::greater<>> farther;

  void add(const Step& step) {
    open.emplace(step.cost + distance(step.piece.tangent.piece.b, to),
                 static_cast<std::int32_t>(steps.size()));
    steps.push_back(step);
  }
  static constexpr std::uint32_t kGoal = UINT32_MAX;  // in place of a circle
};

const std::vector<Arc>& Planner::arcs(std::uint32_t round) {
  auto& out = arcs_[round];
  if (!out) out = clearing_.free_arcs(round);
  return *out;
}

/// Whether nothing stands in the way from an angle on, by so much in the circle's sense [rad].
bool Planner::is_open(std::uint32_t circle, double angle, double by) {
  const double slack = 1e-9 + 2.0 * Clearing::kTolerance / std::max(round(circle).radius, 1e-3);
  const double begin = sense(circle) == Sense::kCounterClockwise ? angle : angle - by;
  return std::ranges::any_of(arcs(circle / 2), [&](const Arc& arc) {
    const double from = in_turn(begin - arc.begin + slack);
    return arc.end - arc.begin >= kTurn || from + by <= arc.end - arc.begin + 2.0 * slack;
  });
}

/// Where things are few the first ring holds all: what that saves costs as much. Else some of the nearest.
double Planner::first_reach(std::span<const Round> rounds) {
  constexpr std::size_t kFew = 512;
  constexpr double kSpacings = 2.0;  // between neighbours, if all stood evenly
  if (rounds.size() <= kFew) return kNever;
  const auto [x0, x1] =
      std::ranges::minmax(rounds | std::views::transform([](const Round& r) { return r.center.x; }));
  const auto [y0, y1] =
      std::ranges::minmax(rounds | std::views::transform([](const Round& r) { return r.center.y; }));
  const auto count = static_cast<double>(rounds.size());
  const double spacing =
      std::max(std::sqrt((x1 - x0) * (y1 - y0) / count), std::max(x1 - x0, y1 - y0) / count);
  return spacing > 0.0 ? kSpacings * spacing : kNever;
}

const Planner::Ring& Planner::known(std::uint32_t circle, std::uint32_t ring) {
  while (circles_[circle].rings.size() <= ring) circles_[circle].rings.push_back(next_ring(circle));
  return circles_[circle].rings[ring];
}

/// The first ring that is not known, twice as far out as the one before. Beyond the ground's other end there
/// is nothing.
Planner::Ring Planner::next_ring(std::uint32_t circle) {
  const std::vector<Ring>& before = circles_[circle].rings;
  const double inner = before.empty() ? -1.0 : before.back().reach;
  Ring out{before.empty() ? first_reach_ : 2.0 * inner, pieces_, {}};
  double farthest = 0.0;
  effort_ += 2;
  if (out.reach < kNever) effort_ += clearing_.rounds().size() / kRoundsOfATangent;
  for (std::uint32_t other = 0; other < circles_.size(); ++other) {
    if (other / 2 == circle / 2) continue;
    const double gap = std::max(
        distance(round(circle).center, round(other).center) - round(circle).radius - round(other).radius,
        0.0);
    farthest = std::max(farthest, gap);
    if (gap < inner || gap >= out.reach) continue;
    ++effort_;
    const auto one = tangent(round(circle), sense(circle), round(other), sense(other));
    if (one && clearing_.is_free(one->piece))
      out.pieces.push_back({*one, other, angle(circle, one->piece.a), angle(other, one->piece.b)});
  }
  if (farthest < out.reach) out.reach = kNever;
  pieces_ += static_cast<std::uint32_t>(out.pieces.size());
  best_.resize(pieces_, kNever);
  return out;
}

void Planner::begin(Search& search) {
  effort_ += clearing_.rounds().size() / kRoundsOfATangent;
  std::vector<std::pair<double, std::uint32_t>> rounds;
  for (std::uint32_t i = 0; i < clearing_.rounds().size(); ++i) {
    const auto& [center, radius] = clearing_.rounds()[i];
    const double least = std::max(distance(search.from, center) - radius, 0.0) +
                         std::max(distance(search.to, center) - radius, 0.0);
    rounds.emplace_back(least * (1.0 - kSlack), i);
  }
  search.rounds = decltype(search.rounds)(std::greater<>(), std::move(rounds));
}

/// The steps from where the search begins to both sides of a round.
void Planner::begin_by(std::uint32_t round_number, Search& search) {
  effort_ += 2;
  for (const std::uint32_t circle : {2 * round_number, 2 * round_number + 1}) {
    const auto one = tangent({search.from, 0.0}, Sense::kCounterClockwise, round(circle), sense(circle));
    if (one) search.add({{*one, circle, 0.0, angle(circle, one->piece.b)}, one->length, -1});
  }
}

/// Makes the next step the one by which the shortest way may lead, and one that can be gone. False: there is
/// none.
bool Planner::has_next(Search& search) {
  while (true) {
    const double next = search.open.empty() ? kNever : search.open.top().first;
    if (!search.rounds.empty() && search.rounds.top().first <= next) {
      begin_by(search.rounds.top().second, search);
      search.rounds.pop();
    } else if (!search.farther.empty() && std::get<0>(search.farther.top()) <= next) {
      const auto [least, step, ring] = search.farther.top();
      search.farther.pop();
      go_on_by(ring, step, search);
    } else if (search.open.empty()) {
      return false;
    } else if (is_blocked(search.steps[static_cast<std::size_t>(search.open.top().second)])) {
      search.open.pop();
    } else {
      return true;
    }
  }
}

/// First steps are looked at only where a search comes to them, since there is one to each.
bool Planner::is_blocked(const Step& step) const {
  return step.before < 0 && !clearing_.is_free(step.piece.tangent.piece);
}

/// Of a way that comes to a circle by a step and leaves it at an angle, up to there.
double Planner::cost_round(const Step& arrived, double leaving) {
  const std::uint32_t here = arrived.piece.to;
  const double by = turned(arrived.piece.to_angle, leaving, sense(here));
  // Straight on, but for the last digit.
  const double rest = by > kTurn - 1e-9 ? 0.0 : by;
  return is_open(here, arrived.piece.to_angle, rest) ? arrived.cost + round(here).radius * rest : kNever;
}

void Planner::go_on(Search& search, std::int32_t step) {
  const Step arrived = search.steps[static_cast<std::size_t>(step)];
  const std::uint32_t here = arrived.piece.to;
  if (const auto last = tangent(round(here), sense(here), {search.to, 0.0}, Sense::kCounterClockwise)) {
    const double leaving = angle(here, last->piece.a);
    const double cost = cost_round(arrived, leaving) + last->length;
    if (cost < kNever && clearing_.is_free(last->piece))
      search.add({{*last, Search::kGoal, leaving, 0.0}, cost, step});
  }
  go_on_by(0, step, search);
}

/// By the pieces of one ring; those of the next one wait until the shortest way may lead by them.
void Planner::go_on_by(std::uint32_t ring_number, std::int32_t step, Search& search) {
  const Step arrived = search.steps[static_cast<std::size_t>(step)];
  const std::uint32_t here = arrived.piece.to;
  const Ring& ring = known(here, ring_number);
  effort_ += ring.pieces.size();
  for (std::size_t i = 0; i < ring.pieces.size(); ++i) {
    const Piece& piece = ring.pieces[i];
    const double cost = cost_round(arrived, piece.from_angle) + piece.tangent.length;
    const std::uint32_t number = ring.first_piece + static_cast<std::uint32_t>(i);
    if (cost >= best_[number]) continue;
    best_[number] = cost;
    improved_.push_back(number);
    search.add({piece, cost, step});
  }
  if (ring.reach == kNever) return;
  // Who goes farther than the goal has to come back.
  const double back = ring.reach - distance(round(here).center, search.to) - round(here).radius;
  const double least = arrived.cost + ring.reach + std::max(back, 0.0);
  search.farther.emplace(least * (1.0 - kSlack), step, ring_number + 1);
}

std::expected<Way, Planner::NoWay> Planner::find(geom::Point from, geom::Point to,
                                                 std::uint64_t most_effort) {
  const std::uint64_t effort_before = effort_;
  if (clearing_.is_free(geom::Segment{from, to}))
    return Way{{from, to}, distance(from, to), clearing_.clearance()};
  for (const std::uint32_t piece : improved_) best_[piece] = kNever;
  improved_.clear();
  Search search{from, to, {}, {}, {}, {}};
  begin(search);
  while (has_next(search) && effort_ - effort_before < most_effort) {
    const std::int32_t step = search.open.top().second;
    search.open.pop();
    if (search.steps[static_cast<std::size_t>(step)].piece.to == Search::kGoal) return way_of(search, step);
    go_on(search, step);
  }
  NoWay out{search.open.empty(), from};
  for (const Step& step : search.steps) {
    const geom::Point reached = step.piece.tangent.piece.b;
    if (distance(reached, to) < distance(out.nearest, to) && !is_blocked(step)) out.nearest = reached;
  }
  return std::unexpected(out);
}

Way Planner::way_of(const Search& search, std::int32_t last) const {
  std::vector<const Step*> steps;
  for (std::int32_t at = last; at >= 0; at = search.steps[static_cast<std::size_t>(at)].before)
    steps.push_back(&search.steps[static_cast<std::size_t>(at)]);
  std::ranges::reverse(steps);
  Way out;
  out.length = steps.back()->cost;
  out.clearance = clearing_.clearance();
  out.corners.push_back(search.from);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const std::uint32_t circle = steps[i]->piece.to;
    const Round& one = round(circle);
    const double begin = steps[i]->piece.to_angle;
    const auto side = static_cast<double>(sense(circle));
    const double by = turned(begin, steps[i + 1]->piece.from_angle, sense(circle));
    if (by > kTurn - 1e-9 || by * one.radius < 1e-6) continue;
    const double outside = std::max(kOutside * one.radius, kLeastOutside);
    const int pieces = static_cast<int>(std::ceil(0.5 * by / std::acos(one.radius / (one.radius + outside))));
    const double half = 0.5 * by / pieces;
    for (int k = 0; k < pieces; ++k) {
      const double angle = begin + side * (2 * k + 1) * half;
      const double far = one.radius / std::cos(half);
      out.corners.push_back(one.center + geom::Offset{far * std::cos(angle), far * std::sin(angle)});
    }
  }
  out.corners.push_back(search.to);
  return out;
}

}  // namespace mlab::ways
