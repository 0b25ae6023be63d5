#include "mlab/schema/way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mlab/schema/route.h"
#include "mlab/ways/clearances.h"
#include "mlab/ways/planner.h"
#include "mlab/ways/way_out.h"

namespace mlab::schema {
namespace {

using ways::PlannedWay;
using ways::WayEnd;

// After so much a search is given up, as Planner::effort: some hundredths of a second.
constexpr std::uint64_t kMostEffort = 4'000'000;

/// Plans on one ground at one clearance. One thread at a time.
struct Site {
  std::uint64_t revision = 0;
  ways::Ground ground;
  ways::Planner planner;
  std::mutex mutex;

  Site(const percept::KnownGround& known, double clearance)
      : revision(known.revision),
        ground{
            {known.discs.begin(), known.discs.end()}, {known.walls.begin(), known.walls.end()}, known.bounds},
        planner(ground, clearance) {}

  const ways::Clearing& clearing() const { return planner.clearing(); }
  bool is_for(const percept::KnownGround& known, double clearance) const {
    return revision == known.revision && clearing().clearance() == clearance;
  }
};

/// Those used last, for all robots of the process.
class Sites {
 public:
  /// Robots that a thread computes one after the other ask for the same few, which it holds on to: so what is
  /// returned stands until the thread has asked for others.
  const std::shared_ptr<Site>& at(const percept::KnownGround& ground, double clearance) {
    constexpr std::size_t kHeld = 4;
    thread_local std::array<std::shared_ptr<Site>, kHeld> held;
    thread_local std::size_t next = 0;
    for (const auto& one : held) {
      if (one && one->is_for(ground, clearance)) return one;
    }
    return held[next++ % kHeld] = shared(ground, clearance);
  }

 private:
  std::shared_ptr<Site> shared(const percept::KnownGround& ground, double clearance) {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::ranges::find_if(sites_, [&](const auto& one) { return one->is_for(ground, clearance); });
    if (found != sites_.end()) {
      sites_.splice(sites_.begin(), sites_, found);
    } else {
      sites_.push_front(std::make_shared<Site>(ground, clearance));
      if (sites_.size() > kMost) sites_.pop_back();
    }
    return sites_.front();
  }

  static constexpr std::size_t kMost = 16;
  std::mutex mutex_;
  std::list<std::shared_ptr<Site>> sites_;
};

Sites& sites() {
  static Sites all;
  return all;
}

// Where a body may leave a place, or come to it, that things are nearer to than it keeps: so many clearances
// from there, or from the nearest place to it where it can be at all.
std::optional<geom::Point> free_beside(const ways::Clearing& tight, const ways::Clearing& wide,
                                       geom::Point place, double most) {
  if (wide.is_free(place)) return place;
  const auto out = wide.nearest_free(place);
  const auto least = tight.nearest_free(place);
  if (!out || !least || distance(*out, *least) > most * wide.clearance()) return std::nullopt;
  // Not through a wall.
  return *least != place || tight.is_free(geom::Segment{place, *out}) ? out : std::nullopt;
}

// Where the way of a body begins that stands at a place, from which it has to get out first, maybe.
std::optional<geom::Point> free_before(const Site& tight, const ways::Clearing& wide, geom::Point place,
                                       std::optional<geom::Point> out, double radius) {
  const auto beside = free_beside(tight.clearing(), wide, place, 4.0);
  if (!out || (beside && ways::leads_straight(tight.ground, {place, *beside}, radius))) return beside;
  return wide.is_free(*out) ? out : std::nullopt;
}

PlannedWay put_together(const Site& tight, geom::Point from, const ways::Way& way, geom::Point goal,
                        WayEnd end) {
  PlannedWay out;
  out.clearance = way.clearance;
  out.end = end;
  out.append(from);
  for (const geom::Point corner : way.corners) out.append(corner);
  if (end != WayEnd::kGoal) return out;
  if (tight.clearing().is_free(goal))
    out.append(goal);
  else
    out.set_whole_end(WayEnd::kBesideGoal);
  return out;
}

// Where somebody is as near to a goal as who can't stand there may be, about.
bool is_beside(const ways::Clearing& tight, geom::Point place, geom::Point goal) {
  constexpr double kOnTheOtherSide = 20.0;  // of what stands there [m]
  const auto nearest = tight.nearest_free(goal);
  return nearest && distance(place, goal) <= 2.0 * distance(*nearest, goal) + kOnTheOtherSide;
}

// Where no way leads to the goal: to the nearest place to it that one leads to.
std::optional<PlannedWay> way_near(Site& tight, geom::Point from, geom::Point begin, geom::Point goal) {
  constexpr std::size_t kMostPlaces = 24;
  constexpr std::uint64_t kEffortOfAll = kMostEffort / 2;
  const std::uint64_t before = tight.planner.effort();
  for (const geom::Point place : tight.clearing().free_places(goal, kMostPlaces)) {
    const std::uint64_t spent = tight.planner.effort() - before;
    if (spent >= kEffortOfAll) break;
    // Back from there: what is closed off is small, mostly.
    auto back = tight.planner.find(place, begin, kEffortOfAll - spent);
    if (!back) continue;
    std::ranges::reverse(back->corners);
    const bool is_there = !tight.clearing().is_free(goal) && is_beside(tight.clearing(), place, goal);
    return put_together(tight, from, *back, goal, is_there ? WayEnd::kBesideGoal : WayEnd::kClosedOff);
  }
  return std::nullopt;
}

// With a last piece straight to the goal, as far as nothing is in front of it.
PlannedWay up_to_the_goal(const ways::Clearing& clearing, PlannedWay way, geom::Point goal) {
  if (way.count == 0) return way;
  const geom::Point last = way.whole_last();
  double open = 0.0;  // share of that piece
  double closed = 1.0;
  constexpr double kExact = 0.1;  // [m]
  while ((closed - open) * distance(last, goal) > kExact) {
    const double middle = 0.5 * (open + closed);
    (clearing.is_free(geom::Segment{last, last + (goal - last) * middle}) ? open : closed) = middle;
  }
  way.append(last + (goal - last) * open);
  return way;
}

// Where a way leads at its ends. The last metres may only lead up to a goal that something stands near to.
constexpr double kEnd = 20.0;  // [m]
geom::Offset begin_direction(const PlannedWay& way) {
  return unit(point_on(way, kEnd) - way.corners.front());
}
geom::Offset end_direction(const PlannedWay& way) {
  return unit(way.points().back() - point_on(way, way_length(way) - kEnd));
}

constexpr double kFar =
    1e100;  // the square of what is farther is no number, and nothing is nearest to it [m]

/// Most ways are one straight piece, whose length is known; nothing is rounded otherwise for that.
bool is_straight(const PlannedWay& way) {
  return way.count == 2 && way.length > 0.0 && way.length < kFar;
}

/// And it is as long as it says, so that all stations beside it are in line.
bool goes_straight(const PlannedWay& way) {
  return is_straight(way) && way.length == distance(way.corners[0], way.corners[1]);
}

/// Whether all that lies between two points is beyond one edge of the area.
bool is_beyond(const ways::Bounds& area, geom::Point a, geom::Point b) {
  constexpr double kRounded = 1e-3;  // more than any of this [m]
  return std::max(a.x, b.x) < area.x0 - kRounded || std::min(a.x, b.x) > area.x1 + kRounded ||
         std::max(a.y, b.y) < area.y0 - kRounded || std::min(a.y, b.y) > area.y1 + kRounded;
}

// Without a call, since most of what follows a way looks at several places of it in each cycle.
[[gnu::always_inline]] inline geom::Point point_along(const PlannedWay& way, double at) {
  if (!is_straight(way)) return route_point(way.points(), at);
  const geom::Point from = way.corners[0];
  if (!(at > 0.0)) return from;
  return at < way.length ? from + (way.corners[1] - from) * (at / way.length) : way.corners[1];
}

[[gnu::always_inline]] inline double nearest_along(const PlannedWay& way, geom::Point p, double from,
                                                   double to) {
  if (!is_straight(way)) return nearest_way(way.points(), p, from, to);
  const geom::Offset away = p - way.corners[0];
  const double projected = dot(away, way.corners[1] - way.corners[0]) / way.length;
  if (!(std::abs(away.x) < kFar && std::abs(away.y) < kFar)) return nearest_way(way.points(), p, from, to);
  if (!(0.0 <= to && way.length >= from)) return from;
  const double low = std::max(0.0, from);
  return std::clamp(projected, low, std::max(low, std::min(way.length, to)));
}

/// Whether nothing is in front of the goal: most often so, and all that plan_way looks at comes to the same
/// then.
bool is_straight_free(const ways::Clearing& wide, geom::Point from, geom::Point goal) {
  return wide.is_free(from) && wide.is_free(goal) && wide.is_free(geom::Segment{from, goal});
}

void lead_straight(geom::Point from, geom::Point goal, double clearance, PlannedWay& out) {
  out.append(from);
  out.append(goal);
  out.clearance = clearance;
  out.end = WayEnd::kGoal;
}

/// As plan_way, where more than one piece may be needed, and but for the way's length.
PlannedWay find_way(const percept::KnownGround& ground, geom::Point from, geom::Point goal, double radius,
                    double margin) {
  PlannedWay out;
  const ways::Clearances clearances(radius, margin);
  const double least = clearances.least();
  const auto tight = sites().at(ground, least);
  const auto out_at = ways::way_out(tight->ground, tight->clearing(), from, radius);
  for (const double clearance : clearances.all()) {
    const auto site = sites().at(ground, clearance);
    const std::lock_guard lock(site->mutex);
    const auto begin = free_before(*tight, site->clearing(), from, out_at, radius);
    const auto end = free_beside(tight->clearing(), site->clearing(), goal, 2.0);
    if (!begin || !end) continue;
    const auto way = site->planner.find(*begin, *end, kMostEffort);
    if (way) return put_together(*tight, from, *way, goal, WayEnd::kGoal);
    if (clearance > least) continue;
    if (auto near = way_near(*site, from, *begin, goal)) return *near;
    const auto part = site->planner.find(*begin, way.error().nearest, kMostEffort);
    if (part)
      return up_to_the_goal(site->clearing(), put_together(*tight, from, *part, goal, WayEnd::kClosedOff),
                            goal);
  }
  return out;
}

/// What a way depends on.
struct Question {
  std::uint64_t revision = 0;  // of the ground
  geom::Point from;
  geom::Point goal;
  double radius = 0.0;
  double margin = 0.0;

  friend bool operator==(const Question&, const Question&) = default;
};

/// As plan_way, where more than one piece may be needed. The robots of a unit ask for its way one after the
/// other.
PlannedWay remembered_way(const Question& asked, const percept::KnownGround& ground) {
  struct Answer {
    Question question;  // of revision 0: none
    PlannedWay way;
  };
  constexpr std::size_t kHeld = 4;
  thread_local std::array<Answer, kHeld> held;
  thread_local std::size_t next = 0;
  const auto known = std::ranges::find(held, asked, &Answer::question);
  if (known != held.end()) return known->way;
  Answer& fresh = held[next++ % kHeld];
  fresh.way = find_way(ground, asked.from, asked.goal, asked.radius, asked.margin);
  fresh.way.length = route_length(fresh.way.points());
  fresh.question = asked;
  return fresh.way;
}

}  // namespace

geom::Point place_outside(const percept::Percepts& percepts, double keep) {
  const auto around = std::ranges::find_if(percepts.obstacles, is_around);
  if (around == percepts.obstacles.end()) return percepts.pose.position;
  const double farther = (around->radius + keep) / around->radius;
  return percepts.pose.position + percepts.pose.to_world(around->center * -farther);
}

PlannedWay plan_way(const percept::KnownGround& ground, geom::Point from, geom::Point goal, double radius,
                    double margin) {
  PlannedWay out;
  if (ground.revision == 0 || !is_finite(from) || !is_finite(goal)) {
    lead_straight(from, goal, radius + margin, out);
  } else if (const double wide = ways::Clearances(radius, margin).widest();
             is_straight_free(sites().at(ground, wide)->clearing(), from, goal)) {
    lead_straight(from, goal, wide, out);
  } else {
    return remembered_way({ground.revision, from, goal, radius, margin}, ground);
  }
  out.length = route_length(out.points());
  return out;
}

namespace {

// Whether nobody can be where a way ends, on other ground than it was planned on.
bool is_end_taken(const percept::KnownGround& ground, const PlannedWay& way) {
  return way.count > 0 && std::ranges::any_of(ground.discs, [&](const ways::Round& disc) {
           return distance(disc.center, way.points().back()) < disc.radius;
         });
}

}  // namespace

bool leads_on(const percept::KnownGround& ground, bool is_same_ground, const PlannedWay& way,
              geom::Point from, double stray, bool is_body, const OnRoute* on_route, double& off) {
  off = std::numeric_limits<double>::infinity();
  if (!is_same_ground &&
      (way.whole_end() == WayEnd::kClosedOff || !is_open(ground, way) || is_end_taken(ground, way)))
    return false;
  const double length = way_length(way);
  const double at = nearest_on(way, from, on_route == nullptr ? 0.0 : on_route->at, length);
  const double away = distance(point_on(way, at), from);
  // Those who are farther ahead than the middle of a unit see where a route leads on, too.
  const bool is_near_its_end = on_route == nullptr
                                   ? at >= 0.7 * length
                                   : on_route->at - on_route->since >= 0.5 * (length - on_route->since);
  if (away > stray || (way.end == WayEnd::kFull && is_near_its_end)) return false;
  if (way.end != WayEnd::kFull) off = away;
  if (!is_body || away <= way.clearance) return true;
  const geom::Segment ahead{from, carrot_on(way, from, at, away, kLookahead)};
  return std::ranges::none_of(ground.walls,
                              [&](const geom::Segment& wall) { return intersects(ahead, wall); }) &&
         std::ranges::none_of(ground.discs, [&](const ways::Round& disc) {
           return distance(nearest_point(ahead, disc.center), disc.center) < disc.radius;
         });
}

bool is_open(const percept::KnownGround& ground, const PlannedWay& way) {
  // Corners lie a little outside of the arcs that they stand for, never inside.
  const double clearance = way.clearance - 1e-3;
  const auto points = way.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const geom::Segment piece{points[i - 1], points[i]};
    for (const ways::Round& disc : ground.discs) {
      const geom::Point nearest = nearest_point(piece, disc.center);
      // Where it is nearest at an end of the way, it only leaves the thing, or comes to it.
      if (distance(nearest, disc.center) < disc.radius + clearance && nearest != points.front() &&
          nearest != points.back())
        return false;
    }
    for (const geom::Segment& wall : ground.walls) {
      if (intersects(piece, wall)) return false;
    }
  }
  return true;
}

namespace {

constexpr double kHalf = 10.0;  // of a piece of a way that says where it leads [m]

/// Its beginning, its middle, its end.
using Piece = std::array<geom::Point, 3>;

// What is so far to the left of its middle.
geom::Point beside(const Piece& piece, double left) {
  const geom::Offset along = unit(piece[2] - piece[0]);
  return piece[1] + geom::Offset{-along.y, along.x} * left;
}

/// Around a place on a way.
/// @param way_at  as way_point has it on this way
template <class WayAt>
Piece piece_around(const PlannedWay& way, double length, const WayAt& way_at, double at) {
  const bool is_beyond_an_end = at - kHalf < 0.0 || at + kHalf > length;
  if (is_straight(way) || is_beyond_an_end) return {way_at(at - kHalf), way_at(at), way_at(at + kHalf)};
  return route_points(way.points(), {at - kHalf, at, at + kHalf});
}

}  // namespace

PlaceAhead place_on_way(const percept::KnownGround& ground, const PlannedWay& way, geom::Vector station,
                        const std::function<double()>& in_file, double at, geom::Point here, double away,
                        double most) {
  constexpr double kStep = 2.0;         // [m]
  constexpr int kMostPlaces = 100'000;  // that are looked at: a way may come from anybody, and say any length
  const auto points = way.points();
  if (points.empty()) return {here, at};
  const double length = way_length(way);
  // Where it goes on all go to its end, and see from there.
  const double end = way.end == WayEnd::kFull ? length : length + station.x;
  const auto is_apart = [&](geom::Point a, geom::Point b) {
    return std::ranges::any_of(ground.walls,
                               [&](const geom::Segment& wall) { return intersects({a, b}, wall); });
  };
  // Most of it is as point_along has it on a straight way, without a call.
  const bool is_one_piece = is_straight(way);
  const geom::Offset whole = points.back() - points.front();
  const auto way_at = [&](double there) {
    return is_one_piece && there > 0.0 && there < length ? points.front() + whole * (there / length)
                                                         : way_point(way, there);
  };
  const auto place_at = [&](double there) {
    const Piece piece = piece_around(way, length, way_at, there);
    const geom::Point middle = piece[1];
    const geom::Point place = beside(piece, station.y);
    if (ground.walls.empty()) return place;
    const geom::Point nearest = way_at(std::clamp(there, 0.0, length));
    if (!is_apart(nearest, middle) && !is_apart(middle, place)) return place;
    return there < end ? nearest : way_at(std::max(0.0, length - in_file()));
  };
  if (ground.revision == 0 || way.count < 2) return {place_at(std::min(at, end)), std::min(at, end)};
  const ways::Clearing& clearing = sites().at(ground, way.clearance)->clearing();
  const auto on_the_way = [&](double farthest) {
    double there = at;
    while (there + kStep < farthest && distance(way_at(there), here) < away) there += kStep;
    return PlaceAhead{way_at(there), there};
  };
  for (int step = 0; step < kMostPlaces && at + kStep * step < end; ++step) {
    const double there = at + kStep * step;
    if (there - at > most) return on_the_way(there);
    const geom::Point place = place_at(there);
    if (distance(place, here) >= away && clearing.is_free(place)) return {place, there};
    // Where the first and the last of places in line are beyond the same edge, none of them is free.
    if (step == 0 && is_beyond(ground.bounds, place, place) && goes_straight(way) && ground.walls.empty() &&
        is_beyond(ground.bounds, place, place_at(std::min(end, at + kStep * kMostPlaces))))
      break;
  }
  // The way leads there, though it may be nearer to something than the way keeps.
  const bool is_goal = way.end == WayEnd::kGoal && station.x == 0.0 && station.y == 0.0;
  if (is_goal) return {points.back(), end};
  const auto last = clearing.nearest_free(place_at(end));
  const bool is_there = last && !is_apart(way_at(std::clamp(end, 0.0, length)), *last);
  return {is_there ? *last : way_at(std::max(0.0, length - in_file())), end};
}

geom::Point point_on(const PlannedWay& way, double at) {
  return point_along(way, at);
}

double nearest_on(const PlannedWay& way, geom::Point p, double from, double to) {
  return nearest_along(way, p, from, to);
}

geom::Point way_point(const PlannedWay& way, double at) {
  const auto points = way.points();
  if (points.size() < 2) return points.empty() ? geom::Point{} : points.front();
  const double length = way_length(way);
  if (at < 0.0) return points.front() + begin_direction(way) * at;
  if (at > length) return points.back() + end_direction(way) * (at - length);
  return point_along(way, at);
}

std::size_t nearest_walls(const percept::KnownGround& ground, geom::Point here, double reach,
                          std::span<geom::Segment> out) {
  std::size_t count = 0;
  const auto away = [&](const geom::Segment& wall) { return distance(nearest_point(wall, here), here); };
  for (const geom::Segment& wall : ground.walls) {
    const double far = away(wall);
    if (far > reach || (count == out.size() && far >= away(out.back()))) continue;
    if (count < out.size()) ++count;
    std::size_t at = count - 1;
    for (; at > 0 && far < away(out[at - 1]); --at) out[at] = out[at - 1];
    out[at] = wall;
  }
  return count;
}

geom::Point carrot_on(const PlannedWay& way, geom::Point here, double at, double off, double lookahead) {
  const auto points = way.points();
  const double length = way_length(way);
  // So much nearer than the clearance one may come to what the way leads round.
  const auto cut = [&] { return std::clamp(0.2 * way.clearance, 0.05, 0.5) + off; };
  for (double ahead = lookahead;; ahead *= 0.5) {
    const double there = std::min(at + ahead, length);
    const geom::Point carrot = point_on(way, there);
    double corner = 0.0;
    bool is_near = true;
    for (std::size_t i = 1; i < points.size() && corner < there && is_near; ++i) {
      corner += distance(points[i - 1], points[i]);
      is_near = corner <= at || corner >= there ||
                distance(nearest_point({here, carrot}, points[i]), points[i]) <= cut();
    }
    if (is_near || ahead < 0.05) return carrot;
  }
}

double way_progress(const PlannedWay& way, geom::Point p, double from, double to) {
  const auto points = way.points();
  if (points.size() < 2) return 0.0;
  const double length = way_length(way);
  const double at = nearest_along(way, p, std::clamp(from, 0.0, length), std::clamp(to, 0.0, length));
  if (at <= 0.0) return std::min(std::max(dot(p - points.front(), begin_direction(way)), from), 0.0);
  if (at >= length) {
    const double beyond = dot(p - points.back(), end_direction(way));
    return length + std::max(0.0, std::min(beyond, to - length));
  }
  return at;
}

geom::Point beside_way(const PlannedWay& way, double at, double left) {
  const auto way_at = [&](double there) { return way_point(way, there); };
  return beside(piece_around(way, way_length(way), way_at, at), left);
}

double station_progress(const PlannedWay& way, double left, geom::Point p, double from, double to) {
  constexpr double kStep = 2.0;  // [m]
  constexpr int kMost = 1'000;   // that are looked at: a way may come from anybody, and say any length
  double best = from;
  double least = distance(beside_way(way, from, left), p);
  for (int i = 1; i < kMost && from + kStep * i <= to; ++i) {
    const double away = distance(beside_way(way, from + kStep * i, left), p);
    if (away >= least) continue;
    least = away;
    best = from + kStep * i;
  }
  constexpr int kHalvings = 4;
  double step = kStep;
  for (int i = 0; i < kHalvings; ++i) {
    step *= 0.5;
    for (const double at : {best - step, best + step}) {
      const double away = distance(beside_way(way, at, left), p);
      if (at < from || at > to || away >= least) continue;
      least = away;
      best = at;
    }
  }
  return best;
}

}  // namespace mlab::schema
