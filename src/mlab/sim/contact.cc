#include "mlab/sim/contact.h"

#include <algorithm>
#include <cmath>

#include "mlab/binding/sweep.h"

namespace mlab::sim {
namespace {

using binding::kLeastRest;
using binding::kSkin;
using binding::kTouch;
using binding::meet;
using binding::meets_disc;
using binding::meets_edge;
using binding::meets_wall;
using binding::Mover;
using binding::slide;
using geom::Offset;
using geom::Point;

constexpr std::size_t kBodiesAtOnce = 256;
/// How often neighbours that touch tell each other how far they slide.
constexpr int kSlidePasses = 3;
/// After so many passes, bodies that would still have to stop earlier stay where they are, which ends it.
constexpr int kStopPasses = 64;
/// Pushing less than this against a thing is no contact [m a cycle].
constexpr double kLeastPush = 1e-6;

Box swept_box(const Bodies& bodies, std::uint32_t body, Offset motion, double reach) {
  const Point from = bodies.position(body);
  const Point to = from + motion;
  return Box::spanned(from.x, from.y, to.x, to.y, reach);
}

const Box& area_of(const Bodies& bodies, const ContactSolver::Surroundings& s, std::uint32_t body) {
  return bodies.held[body] ? s.area : kWholeWorld;
}

void add_static_blockers(Blockers& blockers, const Statics& statics, Point body, double radius) {
  const Box box = Box::around(body.x, body.y, radius + kSkin + kTouch);
  statics.visit_discs(box, [&](std::uint32_t index, const Disc& disc) {
    blockers.keep_off(body, disc.center, radius + disc.radius, 0.0, thing_of_disc(index));
  });
  statics.visit_walls(box, [&](std::uint32_t, const Wall& wall) {
    blockers.keep_off(body, nearest_point(wall.segment, body), radius, 0.0, thing_of_wall(wall.group));
  });
}

// Nobody has to back off: it is run over then.
void keep_off_roamer(Blockers& blockers, const ContactSolver::Passing& roamer, double gone, Point body,
                     double radius, Thing thing) {
  const Offset between = roamer.at(gone) - body;
  const double gap = length(between) - radius - roamer.radius - kSkin;
  if (gap > kTouch || length(between) <= 0.0) return;
  const Offset toward = unit(between);
  const double away = std::max(0.0, dot(roamer.step, toward)) * (1.0 - gone);
  blockers.add({toward, std::max(0.0, gap) + away, thing});
}

// When a body drives into it; never where only the roamer comes to the body.
double drives_into(const ContactSolver::Passing& roamer, double gone, Point from, Offset motion,
                   double radius) {
  const Offset step = roamer.step * (1.0 - gone);
  const double time = meets_disc(from - roamer.at(gone), motion - step, radius + roamer.radius);
  if (time > 1.0) return time;
  const Offset between = roamer.at(gone) + step * time - (from + motion * time);
  return dot(motion, between) > 0.0 ? time : binding::kNever;
}

}  // namespace

void ContactSolver::Busy::meet(Thing thing) {
  if (thing == kNoThing || std::find(met.begin(), met.begin() + met_count, thing) != met.begin() + met_count)
    return;
  if (met_count < met.size()) met[met_count++] = thing;
}

void ContactSolver::resize(std::size_t count) {
  motion_.resize(count);
  way_.resize(count);
  until_.resize(count, 1.0);
  near_count_.resize(count);
  is_busy_.resize(count);
  changed_.resize(count);
  near_.resize(count);
  clear_.resize(count);
  busy_.reserve(count);
  fast_.reserve(count);
}

void ContactSolver::move(Bodies& bodies, const Surroundings& s, Workers& workers) {
  sort_by_speed(bodies);
  run_over_.clear();
  collect_busy(bodies, s, workers);
  if (!busy_.empty()) move_busy(bodies, s, workers);
  if (!s.roamers.empty()) count_run_over(bodies, s);
}

void ContactSolver::move_busy(Bodies& bodies, const Surroundings& s, Workers& workers) {
  for (int round = 0; round < binding::kSlideRounds; ++round) {
    if (!run_round(bodies, s, workers)) break;
  }
  for (const Busy& busy : busy_) {
    const std::uint32_t i = busy.body;
    Momentum& momentum = bodies.momentum[i];
    const Offset gone = (bodies.position(i) - busy.start) * (1.0 / s.dt);
    const double square = dot(momentum.velocity, momentum.velocity);
    momentum.speed *= square > 0.0 ? std::clamp(dot(gone, momentum.velocity) / square, 0.0, 1.0) : 0.0;
    momentum.velocity = gone;
  }
  count_contacts(bodies, s);
}

/// Bodies that go far would make every question to the grid as wide as their way is long, so they are kept in
/// a list that everybody looks through.
void ContactSolver::sort_by_speed(const Bodies& bodies) {
  double widest = 0.0;
  for (std::size_t i = 0; i < bodies.count(); ++i) widest = std::max(widest, bodies.radius[i]);
  slow_limit_ = 2.0 * widest + 0.5;
  slow_way_ = longest_way_ = 0.0;
  fast_.clear();
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    way_[i] = length(motion_[i]);
    longest_way_ = std::max(longest_way_, way_[i]);
    if (way_[i] > slow_limit_) {
      fast_.push_back({i, bodies.x[i], bodies.y[i]});
    } else {
      slow_way_ = std::max(slow_way_, way_[i]);
    }
  }
}

template <class Visit>
void ContactSolver::search_near(const Bodies& bodies, const Surroundings& s, std::uint32_t body, Point start,
                                Visit&& visit) const {
  // No body can do more in all rounds together than the length of its motion, so who is farther away than
  // both lengths can't be met.
  const double own = way_[body] + bodies.radius[body] + kSkin + kTouch;
  const auto consider = [&](double x, double y, std::uint32_t other, double way) {
    const double reach = own + bodies.radius[other] + way;
    const double dx = x - start.x;
    const double dy = y - start.y;
    if (dx * dx + dy * dy <= reach * reach && other != body) visit(other);
  };
  const double widest = own + slow_way_ + s.grid.max_radius();
  s.grid.visit(Box::around(start.x, start.y, widest), [&](const PointGrid::Item& item) {
    const double dx = item.x - start.x;
    const double dy = item.y - start.y;
    if (dx * dx + dy * dy > widest * widest || way_[item.id] > slow_limit_) return;
    consider(item.x, item.y, item.id, way_[item.id]);
  });
  for (const Fast& fast : fast_) consider(fast.x, fast.y, fast.body, way_[fast.body]);
}

template <class Visit>
void ContactSolver::for_each_near(const Bodies& bodies, const Surroundings& s, const Busy& busy,
                                  Visit&& visit) const {
  const std::uint8_t count = near_count_[busy.body];
  if (count == kTooMany) {
    search_near(bodies, s, busy.body, busy.start, visit);
    return;
  }
  for (std::uint8_t k = 0; k < count; ++k) visit(near_[busy.body].body[k]);
}

/// True where a body may meet a disc or a wall on its way.
bool ContactSolver::may_meet_standing(const Bodies& bodies, const Surroundings& s, std::uint32_t body) {
  constexpr double kCycles = 16.0;  // that it looks ahead
  const Point start = bodies.position(body);
  const double reach = way_[body] + bodies.radius[body] + kSkin + kTouch;
  if (clear_[body].covers(s.statics, start, reach)) return false;
  bool is_near = false;
  const Box box = swept_box(bodies, body, motion_[body], bodies.radius[body] + kSkin + kTouch);
  s.statics.visit_discs(box, [&](std::uint32_t, const Disc& disc) {
    is_near = is_near || distance(disc.center, start) <= reach + disc.radius;
  });
  s.statics.visit_walls(box, [&](std::uint32_t, const Wall& wall) {
    is_near = is_near || distance(nearest_point(wall.segment, start), start) <= reach;
  });
  if (is_near) return true;
  clear_[body] = ClearPlace::look(s.statics, start, reach + kCycles * way_[body]);
  return false;
}

/// True where its eyes have told that all others are farther away than any that it looks for.
bool ContactSolver::is_apart(const Bodies& bodies, const Surroundings& s, std::uint32_t body) const {
  if (s.apart.empty() || s.apart[body].build != s.grid.builds()) return false;
  const double widest =
      way_[body] + bodies.radius[body] + kSkin + kTouch + s.grid.max_radius() + longest_way_;
  constexpr double kRounding = 1e-6;  // more than any of this [m]
  return s.apart[body].away > widest + kRounding;
}

/// True where a body may meet anything on its way, or the edge of the area. Fills its list of near bodies.
bool ContactSolver::has_company(const Bodies& bodies, const Surroundings& s, std::uint32_t body) {
  const Point start = bodies.position(body);
  std::uint8_t& count = near_count_[body];
  count = 0;
  const auto list = [&](std::uint32_t other) {
    if (count == kTooMany) return;
    if (count == kNear) {
      count = kTooMany;
    } else {
      near_[body].body[count++] = other;
    }
  };
  if (!is_apart(bodies, s, body)) search_near(bodies, s, body, start, list);
  const Point end = start + motion_[body];
  if (!is_inside(area_of(bodies, s, body), end)) return true;
  bool is_near = count > 0;
  if (!is_near) is_near = may_meet_standing(bodies, s, body);
  const double reach = way_[body] + bodies.radius[body] + kSkin + kTouch;
  for (const Passing& roamer : s.roamers)
    is_near = is_near || distance(roamer.from, start) <= reach + roamer.radius + length(roamer.step);
  return is_near;
}

/// Bodies that nothing is near to move at once; the others are collected. Who moves here is in nobody's list,
/// and others are looked for where they stood at the beginning, so the order makes no difference.
void ContactSolver::collect_busy(Bodies& bodies, const Surroundings& s, Workers& workers) {
  workers.run(bodies.count(), kBodiesAtOnce, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      is_busy_[i] = 0;
      if (way_[i] <= 0.0) continue;
      if (has_company(bodies, s, static_cast<std::uint32_t>(i))) {
        is_busy_[i] = 1;
        continue;
      }
      bodies.x[i] += motion_[i].x;
      bodies.y[i] += motion_[i].y;
      bodies.distance[i] += way_[i];
    }
  });
  busy_.clear();
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    if (!is_busy_[i]) continue;
    Busy& busy = busy_.emplace_back();
    busy.body = i;
    busy.start = bodies.position(i);
    busy.wanted = motion_[i];
  }
}

/// @return true where something is left for another round
bool ContactSolver::run_round(Bodies& bodies, const Surroundings& s, Workers& workers) {
  slide_all(bodies, s, workers);
  workers.run(busy_.size(), kBodiesAtOnce, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t k = begin; k < end; ++k) stop_at_statics(bodies, s, busy_[k]);
  });
  for (const Busy& busy : busy_) until_[busy.body] = busy.until;
  stop_at_bodies(bodies, s, workers);
  bool is_unfinished = false;
  for (Busy& busy : busy_) is_unfinished = advance(bodies, s, busy) || is_unfinished;
  return is_unfinished;
}

void ContactSolver::slide_all(const Bodies& bodies, const Surroundings& s, Workers& workers) {
  for (int pass = 0; pass < kSlidePasses; ++pass) {
    const bool is_first = pass == 0;
    workers.run(busy_.size(), kBodiesAtOnce, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t k = begin; k < end; ++k) {
        Busy& busy = busy_[k];
        if (busy.is_moving && (is_first || busy.touches_bodies)) slide_one(bodies, s, busy, is_first);
      }
    });
    bool is_settled = true;
    for (const Busy& busy : busy_) {
      if (!busy.is_moving) continue;
      is_settled = is_settled && (!busy.touches_bodies || motion_[busy.body] == busy.slid);
      motion_[busy.body] = busy.slid;
    }
    if (is_settled) return;
  }
}

void ContactSolver::slide_one(const Bodies& bodies, const Surroundings& s, Busy& busy, bool is_first) {
  const std::uint32_t i = busy.body;
  const Point here = bodies.position(i);
  Blockers blockers;
  add_static_blockers(blockers, s.statics, here, bodies.radius[i]);
  for (std::uint32_t k = 0; k < s.roamers.size(); ++k)
    keep_off_roamer(blockers, s.roamers[k], busy.gone, here, bodies.radius[i], thing_of_roamer(k));
  const Box& area = area_of(bodies, s, i);
  blockers.keep_within({area.x0, area.y0}, {area.x1, area.y1}, here, length(busy.wanted), kNoThing);
  busy.touches_bodies = false;
  for_each_near(bodies, s, busy, [&](std::uint32_t other) {
    const Offset between = bodies.position(other) - here;
    const double gap = length(between) - bodies.radius[i] - bodies.radius[other] - kSkin;
    if (gap > kTouch || length(between) <= 0.0) return;
    busy.touches_bodies = true;
    const double away = std::max(0.0, dot(motion_[other], between) / length(between));
    blockers.keep_off(here, bodies.position(other), bodies.radius[i] + bodies.radius[other], away,
                      thing_of_body(other));
  });
  busy.slid = slide(busy.wanted, blockers);
  if (!is_first) return;
  for (const Blocker& blocker : blockers) {
    if (dot(busy.wanted, blocker.toward) - blocker.gap > kLeastPush) busy.meet(blocker.thing);
  }
}

void ContactSolver::stop_at_statics(const Bodies& bodies, const Surroundings& s, Busy& busy) {
  busy.until = 1.0;
  busy.stopped_by = kNoThing;
  if (!busy.is_moving) return;
  const std::uint32_t i = busy.body;
  const Offset motion = motion_[i];
  const Point from = bodies.position(i);
  const double radius = bodies.radius[i] + kSkin;
  const auto stop = [&](double time, Thing thing) {
    if (time > busy.until || time > 1.0 || (time == busy.until && thing >= busy.stopped_by)) return;
    busy.until = time;
    busy.stopped_by = thing;
  };
  const Box box = swept_box(bodies, i, motion, radius + kTouch);
  s.statics.visit_discs(box, [&](std::uint32_t index, const Disc& disc) {
    stop(meets_disc(from - disc.center, motion, disc.radius + radius), thing_of_disc(index));
  });
  s.statics.visit_walls(box, [&](std::uint32_t, const Wall& wall) {
    stop(meets_wall(wall.segment, from, motion, radius), thing_of_wall(wall.group));
  });
  for (std::uint32_t k = 0; k < s.roamers.size(); ++k)
    stop(drives_into(s.roamers[k], busy.gone, from, motion, radius), thing_of_roamer(k));
  const Box& area = area_of(bodies, s, i);
  stop(meets_edge({area.x0, area.y0}, {area.x1, area.y1}, from, motion), kNoThing);
}

/// Passes over all busy bodies, each against where the pass before made its neighbours stop, until none has
/// to stop earlier. Then no two of them meet before both stand.
void ContactSolver::stop_at_bodies(const Bodies& bodies, const Surroundings& s, Workers& workers) {
  for (const Busy& busy : busy_) changed_[busy.body] = 1;
  for (int pass = 0;; ++pass) {
    const bool gives_up = pass >= kStopPasses;
    workers.run(busy_.size(), kBodiesAtOnce, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t k = begin; k < end; ++k) {
        if (busy_[k].is_moving && near_count_[busy_[k].body] > 0) stop_one(bodies, s, busy_[k], gives_up);
      }
    });
    bool is_settled = true;
    for (const Busy& busy : busy_) {
      changed_[busy.body] = busy.until < until_[busy.body] ? 1 : 0;
      is_settled = is_settled && !changed_[busy.body];
      until_[busy.body] = busy.until;
    }
    if (is_settled) return;
  }
}

void ContactSolver::stop_one(const Bodies& bodies, const Surroundings& s, Busy& busy, bool gives_up) const {
  const std::uint32_t i = busy.body;
  const Mover self{bodies.position(i), motion_[i], until_[i]};
  for_each_near(bodies, s, busy, [&](std::uint32_t other) {
    if (!changed_[i] && !changed_[other]) return;
    const Mover neighbor{bodies.position(other), motion_[other], until_[other]};
    const double time = meet(self, neighbor, bodies.radius[i] + bodies.radius[other] + kSkin);
    if (time >= self.until || (time == busy.until && thing_of_body(other) >= busy.stopped_by)) return;
    if (time > busy.until) return;
    // Who is only run into from behind goes on; it gets no nearer by that.
    const Offset between =
        neighbor.from + neighbor.motion * std::min(time, neighbor.until) - (self.from + self.motion * time);
    if (dot(self.motion, between) <= 0.0) return;
    busy.until = gives_up ? 0.0 : time;
    busy.stopped_by = thing_of_body(other);
  });
}

/// @return true where something of the motion is left for the next round
bool ContactSolver::advance(Bodies& bodies, const Surroundings& s, Busy& busy) {
  const std::uint32_t i = busy.body;
  if (!busy.is_moving) return false;
  const Offset step = motion_[i] * busy.until;
  if (!s.roamers.empty()) {
    const double until = busy.gone + (1.0 - busy.gone) * busy.until;
    note_run_over(s, i, bodies.radius[i], bodies.position(i), step, busy.gone, until);
    busy.gone = until;
  }
  bodies.x[i] += step.x;
  bodies.y[i] += step.y;
  bodies.distance[i] += length(step);
  const Box& area = area_of(bodies, s, i);
  bodies.x[i] = std::clamp(bodies.x[i], area.x0, area.x1);
  bodies.y[i] = std::clamp(bodies.y[i], area.y0, area.y1);
  if (busy.until < 1.0) busy.meet(busy.stopped_by);
  busy.wanted = busy.wanted * (1.0 - busy.until);
  busy.is_moving = busy.until < 1.0 && length(busy.wanted) > kLeastRest;
  motion_[i] = busy.is_moving ? busy.wanted : Offset{};
  until_[i] = 1.0;
  changed_[i] = 0;
  return busy.is_moving;
}

void ContactSolver::count_contacts(Bodies& bodies, const Surroundings& s) {
  const auto count = [&](std::uint32_t body, Thing thing) {
    if (bodies.touched[body].meet(thing, s.time)) ++bodies.contacts[body];
  };
  for (const Busy& busy : busy_) {
    for (std::uint8_t k = 0; k < busy.met_count; ++k) {
      count(busy.body, busy.met[k]);
      if (is_body(busy.met[k])) count(busy.met[k], thing_of_body(busy.body));
    }
  }
}

/// Notes the roamers that come nearer than both radii to a body which moves straight during a share of the
/// cycle.
void ContactSolver::note_run_over(const Surroundings& s, std::uint32_t body, double radius, Point from,
                                  Offset motion, double gone, double until) {
  for (std::uint32_t k = 0; k < s.roamers.size(); ++k) {
    const Passing& roamer = s.roamers[k];
    const Point start = from - (roamer.at(gone) - Point{});
    const geom::Segment way{start, start + (motion - roamer.step * (until - gone))};
    if (length(nearest_point(way, {}) - Point{}) < radius + roamer.radius)
      run_over_.emplace_back(body, thing_of_roamer(k));
  }
}

/// Who drove into a roamer has a contact with it, which goes on while it is in it.
void ContactSolver::count_run_over(Bodies& bodies, const Surroundings& s) {
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    if (bodies.present[i] && way_[i] <= 0.0)
      note_run_over(s, i, bodies.radius[i], bodies.position(i), {}, 0.0, 1.0);
  }
  for (const Busy& busy : busy_)
    note_run_over(s, busy.body, bodies.radius[busy.body], bodies.position(busy.body), {}, busy.gone, 1.0);
  for (const auto& [body, roamer] : run_over_) {
    if (bodies.touched[body].meet(roamer, s.time)) ++bodies.run_over[body];
  }
}

}  // namespace mlab::sim
