#include "mlab/schema/turns.h"

#include <algorithm>
#include <cmath>

#include "mlab/schema/narrow.h"
#include "mlab/schema/requests.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;
using percept::Percepts;

constexpr double kWantsMore = 0.1;   // [m/s]
constexpr double kStandsFor = 5.0;   // [s]
constexpr double kGivesUp = 25.0;    // who stands asks for so long, and then pauses for as long [s]
constexpr double kTells = 0.5;       // [s]
constexpr double kHolds = 1.5;       // what was told so long ago still counts [s]
constexpr double kAfter = 2.0;       // so long after nobody was in front any more one still asks [s]
constexpr double kHears = 8.0;       // [m]
constexpr double kAsksAhead = 4.0;   // so far ahead one asks for way [m]
constexpr double kThere = 0.1;       // [m]
constexpr double kSameWay = 0.5;     // cosine of the angle
constexpr double kLooksAgain = 1.5;  // [s]
constexpr double kBeside = 2.0;      // who has made way waits so near to whom he made it for [m]
constexpr double kCodes = 1U << 24;  // of priorities

}  // namespace

percept::Request tell_wish(const PassageWish& wish) {
  return ask_passage(wish.to, wish.priority.code());
}

std::optional<PassageWish> wish_in(const percept::AskedPassage& asked) {
  if (!(asked.cost >= 0.0 && asked.cost < kCodes)) return std::nullopt;
  return PassageWish{asked.to, Priority::of_code(static_cast<std::uint32_t>(asked.cost))};
}

std::optional<PassageWish> wish_of(const Percepts& percepts, base::RobotId robot) {
  const auto& told = percepts.asked_passages;
  const auto at = std::ranges::lower_bound(told, robot, {}, &percept::AskedPassage::from);
  if (at == told.end() || at->from != robot || percepts.time - at->time > kHolds) return std::nullopt;
  return wish_in(*at);
}

bool is_waiting(const PassageWish& wish, Point here) {
  return distance(here, wish.to) < 2.0 * kThere;
}

bool hears_wish(const Percepts& percepts, const flow::ListView<percept::RobotReading>& robots) {
  for (const percept::RobotReading& robot : robots) {
    if (length(robot.center) > kHears) break;
    if (wish_of(percepts, robot.id)) return true;
  }
  return false;
}

/// What it knows in this cycle.
struct TurnTaker::Situation {
  const Percepts& percepts;
  const RobotList& robots;
  Offset wanted;
  Offset along;  // of length 1, where it wants something
  double radius;
  double gap;
  double speed;
  bool wants;  // something that it is not at yet
  Priority priority;

  Point here() const { return percepts.pose.position; }
  double time() const { return percepts.time; }
  /// So far from what somebody goes along one is not in his way [m].
  double keeps(double other) const { return radius + other + kLeastGap * gap + 0.1; }
  /// Whether somebody is in front, so far away at most [m].
  bool is_met(Offset towards, double farthest) const {
    for (const percept::RobotReading& robot : robots) {
      const Offset place = percepts.pose.point_at(robot.center) - here();
      const double bodies = radius + robot.radius;
      if (length(place) > farthest + bodies) break;
      const double ahead = dot(place, towards);
      if (ahead > 0.0 && std::abs(cross(place, towards)) < bodies + gap) return true;
    }
    return false;
  }
};

Turn TurnTaker::take(const Percepts& percepts, const RobotList& robots, Offset wanted, double left,
                     double radius, double gap, double speed, percept::Action& action) {
  constexpr double kRoom = 0.5;  // [m]
  const double time = percepts.time;
  has_arrived_ = left <= 0.0 || (has_arrived_ && sequence_ == percepts.order.sequence);
  sequence_ = percepts.order.sequence;
  const bool wants = !has_arrived_ && dot(wanted, wanted) > kWantsMore * kWantsMore;
  const Offset went = percepts.pose.position - at_;
  const bool is_elsewhere = dot(went, went) > kRoom * kRoom;
  // Who is carried along by others has come nowhere.
  if (since_ > time || !wants || (is_elsewhere && dot(went, wanted) > 0.0)) since_ = time;
  if (since_ == time || is_elsewhere) at_ = percepts.pose.position;
  const bool is_free = time >= gives_until_ && time >= asks_until_ && time - since_ <= kStandsFor;
  if (robots.empty() || (is_free && percepts.asked_passages.empty())) return {wanted, false};
  Situation now{percepts, robots, wanted, unit(wanted), radius, gap, speed, wants, {}};
  if (wants) now.priority = Priority(percepts.id);
  if (wants && time < cornered_until_) now.priority = std::min(now.priority, cornered_);
  if (time < gives_until_ && next_ < count_) now.priority = std::min(now.priority, for_);
  if (gives_way(now, hear(now))) return step_aside(now, action);
  if (!asks(now)) return {wanted, false};
  tell(now, now.along, kAsksAhead, now.priority, action);
  return {wanted, true};
}

TurnTaker::Wishes TurnTaker::hear(const Situation& now) const {
  Wishes out;
  if (now.percepts.asked_passages.empty()) return out;
  for (const percept::RobotReading& robot : now.robots) {
    if (length(robot.center) > kHears) break;
    const auto wish = wish_of(now.percepts, robot.id);
    const Point from = now.percepts.pose.point_at(robot.center);
    // Who is where it wants to be only says whom it waits for.
    if (!wish || !(wish->priority < now.priority) || is_waiting(*wish, from)) continue;
    out.add({{{from, wish->to}, now.keeps(robot.radius)}, wish->priority, from});
  }
  return out;
}

// Who goes the same way is not.
bool TurnTaker::crosses(const Situation& now, const Heard& heard) {
  return !now.wants || dot(now.along, unit(heard.lane.piece.b - heard.lane.piece.a)) <= kSameWay;
}

// Nor is who is beyond a wall.
bool TurnTaker::is_in_way(const Situation& now, const Heard& heard) {
  const Offset lane = heard.lane.piece.b - heard.lane.piece.a;
  if (!heard.lane.holds(now.here()) || dot(now.here() - heard.from, lane) <= 0.0) return false;
  const geom::Segment between{now.here(), nearest_point(heard.lane.piece, now.here())};
  return crosses(now, heard) &&
         std::ranges::none_of(now.percepts.ground.walls,
                              [&](const geom::Segment& wall) { return intersects(between, wall); });
}

bool TurnTaker::gives_way(const Situation& now, const Wishes& wishes) {
  const Heard* first = nullptr;
  bool waits = false;  // for whom it has made way
  for (const Heard& heard : wishes) {
    const double away = distance(nearest_point(heard.lane.piece, now.here()), now.here());
    waits = waits || (heard.priority == for_ && away < heard.lane.reach + kBeside && crosses(now, heard));
    if (is_in_way(now, heard) && (first == nullptr || heard.priority < first->priority)) first = &heard;
  }
  const bool gave = now.time() < gives_until_;
  if (first != nullptr && !gave) next_ = count_ = 0;
  if (first != nullptr) for_ = first->priority;
  if (first != nullptr || (waits && gave)) gives_until_ = now.time() + kHolds;
  if (now.time() >= gives_until_) return false;
  if (first != nullptr && needs_place(now, wishes)) look_for_place(now, wishes);
  // Who is cornered goes where it wanted to, and asks for that.
  return !(now.wants && now.time() < cornered_until_);
}

bool TurnTaker::needs_place(const Situation& now, const Wishes& wishes) const {
  const bool is_good = count_ > 0 && std::ranges::none_of(wishes, [&](const Heard& heard) {
                         return heard.lane.holds(corners_[count_ - 1]);
                       });
  const bool is_there = next_ == count_;
  return now.time() - looked_ >= kLooksAgain ? !is_good || !is_there : count_ == 0;
}

void TurnTaker::look_for_place(const Situation& now, const Wishes& wishes) {
  constexpr double kCornered = 5.0;  // [s]
  looked_ = now.time();
  base::UpTo<Lane, 8> lanes;
  base::UpTo<Lane, 8> askers;
  base::UpTo<Lane, 16> others;
  // Who makes way for the same one itself gets out of the way.
  for (const Heard& heard : wishes) {
    const bool comes = is_in_way(now, heard);
    if (comes || heard.priority != for_) lanes.add(heard.lane);
    if (comes) askers.add({{heard.from, heard.from}, heard.lane.reach});
  }
  for (const percept::RobotReading& robot : now.robots) {
    const Point place = now.percepts.pose.point_at(robot.center);
    others.add({{place, place}, now.radius + robot.radius + 0.1});
  }
  auto way =
      way_aside(now.percepts.ground, now.here(), now.radius, {lanes.all(), askers.all(), others.all()});
  if (!way) {
    cornered_until_ = now.time() + kCornered;
    cornered_ = for_ = for_.of_cornered();
    if (!now.wants)
      way = way_aside(now.percepts.ground, now.here(), now.radius, {lanes.all(), {}, others.all()});
  }
  next_ = count_ = 0;
  if (!way) return;
  for (const Point corner : way->points().subspan(1)) {
    if (count_ < kMostCorners) corners_[count_++] = corner;
  }
}

Turn TurnTaker::step_aside(const Situation& now, percept::Action& action) {
  while (next_ < count_ && distance(now.here(), corners_[next_]) < kThere) ++next_;
  if (next_ == count_) {
    tell(now, {}, 0.0, for_, action);
    return {{}, true};
  }
  const Offset left = corners_[next_] - now.here();
  tell(now, unit(left), length(left), for_, action);
  return {unit(left) * std::min(now.speed, 2.0 * length(left)), true};
}

bool TurnTaker::asks(const Situation& now) {
  if (!now.wants) return false;
  const double stood = now.time() - since_;
  if (std::fmod(stood, 2.0 * kGivesUp) > kGivesUp) return false;
  const bool is_blocked = stood > kStandsFor && now.is_met(now.along, now.gap + 0.5);
  const bool goes_on = now.time() < asks_until_ && now.is_met(now.along, 2.0);
  const bool is_cornered = now.time() < cornered_until_;
  if (is_blocked || goes_on || is_cornered) asks_until_ = now.time() + kAfter;
  if (is_cornered && goes_on) cornered_until_ = std::max(cornered_until_, now.time() + kAfter);
  return now.time() < asks_until_;
}

// As far as nothing solid stands.
void TurnTaker::tell(const Situation& now, Offset along, double farthest, Priority priority,
                     percept::Action& action) {
  if (now.time() - told_ < kTells) return;
  geom::Segment lane{now.here(), now.here() + along * farthest};
  for (int i = 0; i < 4; ++i) {
    const bool is_open = std::ranges::none_of(
        now.percepts.ground.walls, [&](const geom::Segment& wall) { return intersects(lane, wall); });
    if (is_open) break;
    lane.b = lane.a + (lane.b - lane.a) * 0.5;
  }
  if (action.ask(tell_wish({lane.b, priority}))) told_ = now.time();
}

}  // namespace mlab::schema
