#include "mlab/sim/sensors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "mlab/base/angle.h"
#include "mlab/base/random.h"
#include "mlab/geom/outline.h"
#include "mlab/sim/camera.h"
#include "mlab/sim/radio.h"

namespace mlab::sim {
namespace {

using geom::Point;
using geom::Vector;

/// Walls are told to behaviors by what these rays hit.
/// @source  the historic simulator: 16 rays, each hit an obstacle of 0.1 m
constexpr int kWallRays = 16;
constexpr double kWallHitRadius = 0.1;
/// From here on the ids of roamers among obstacles: behind those of all else.
constexpr std::uint32_t kRoamerId = 1U << 31;

const RingBeams& wall_rays() {
  static const RingBeams kRays({.count = kWallRays, .range = 1.0}, 0.0);
  return kRays;
}

// As seen by who looks ahead.
Vector turned(geom::Offset o, geom::Offset ahead) {
  return {ahead.x * o.x + ahead.y * o.y, ahead.x * o.y - ahead.y * o.x, 0.0};
}

double square_distance(Point a, Point b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// What a robot notices of an area that only it itself keeps it out of.
struct AreaSeen {
  double distance;  ///< [m]; 0 inside
  Point
      center;  ///< the nearest point of the edge; from inside a disc opposite to it, which touches the robot
  double radius;  ///< [m]
};

AreaSeen area_seen(std::span<const Wall> edge, Point here) {
  Point nearest = edge.front().segment.a;
  bool is_inside = false;
  for (const Wall& wall : edge) {
    const Point at = geom::nearest_point(wall.segment, here);
    if (square_distance(at, here) < square_distance(nearest, here)) nearest = at;
    is_inside ^= geom::is_crossed(wall.segment, here);
  }
  const double distance = std::sqrt(square_distance(nearest, here));
  return is_inside ? AreaSeen{0.0, here + (here - nearest), distance} : AreaSeen{distance, nearest, 0.0};
}

/// Calls visit(seen) for each area that robots keep out of.
template <class Visit>
void visit_areas(std::span<const Wall> walls, Point here, Visit&& visit) {
  const auto first =
      std::find_if(walls.rbegin(), walls.rend(), [](const Wall& wall) { return wall.is_solid; }).base();
  for (auto at = first; at != walls.end();) {
    const auto next =
        std::find_if(at, walls.end(), [&](const Wall& wall) { return wall.group != at->group; });
    visit(area_seen({at, next}, here));
    at = next;
  }
}

// The middle of the nearest thing that the body touches, or the nearest point of a wall.
std::optional<Point> touched(const Sensors::Scene& scene, std::uint32_t body) {
  constexpr double kFeelsWithin = 0.01;  // more than the contact solver keeps bodies apart [m]
  const Point here = scene.bodies.position(body);
  const double radius = scene.bodies.radius[body];
  std::optional<Point> out;
  double nearest = kFeelsWithin;
  const auto feel = [&](Point thing, double its_radius) {
    const double gap = geom::distance(here, thing) - radius - its_radius;
    if (gap >= nearest) return;
    nearest = gap;
    out = thing;
  };
  const double reach = radius + kFeelsWithin;
  const Box box = Box::around(here.x, here.y, reach);
  scene.statics.visit_discs(box, [&](std::uint32_t, const Disc& disc) { feel(disc.center, disc.radius); });
  for (const MovingDisc& roamer : scene.roamers) feel(roamer.center, roamer.radius);
  scene.statics.visit_walls(
      box, [&](std::uint32_t, const Wall& wall) { feel(nearest_point(wall.segment, here), 0.0); });
  scene.grid.visit(Box::around(here.x, here.y, reach + scene.grid.max_radius()),
                   [&](const PointGrid::Item& item) {
                     if (item.id != body) feel({item.x, item.y}, scene.bodies.radius[item.id]);
                   });
  return out;
}

}  // namespace

void SenseBuffer::reserve(std::size_t obstacles, std::size_t robots, std::size_t objects, std::size_t beams) {
  seen_.reserve(std::max({obstacles, robots, objects}));
  beams_.reserve(std::max<std::size_t>(beams, kWallRays));
  walls_.reserve(obstacles);
  obstacles_.reserve(obstacles);
  robots_.reserve(robots);
  objects_.reserve(objects);
  ranges_.reserve(beams);
}

Sensors::Sensors(const Scene& scene, std::uint32_t body, SenseBuffer& buffer)
    : scene_(scene),
      body_(body),
      here_(scene.bodies.position(body)),
      ahead_(scene.bodies.ahead[body]),
      buffer_(buffer) {}

void Sensors::forget(percept::Percepts& out) {
  out.obstacles = {};
  out.robots = {};
  out.objects = {};
  out.ranges = {};
  out.range_limit = 0.0;
  out.touch = {};
  out.radio = {};
}

void Sensors::sense(percept::Sensor sensor, double reach, percept::Percepts& out) {
  switch (sensor) {
    case percept::Sensor::kObstacles:
      sense_obstacles(reach, out);
      break;
    case percept::Sensor::kRobots:
      sense_robots(reach, out);
      break;
    case percept::Sensor::kObjects:
      sense_objects(reach, out);
      break;
    case percept::Sensor::kRanges:
      sense_ranges(out);
      break;
    case percept::Sensor::kTouch:
      if (const auto thing = touched(scene_, body_)) out.touch = geom::unit(to_robot(*thing));
      break;
    case percept::Sensor::kRadio:
      sense_radio(out);
      break;
    case percept::Sensor::kGround:  // is told
      break;
  }
}

Vector Sensors::to_robot(Point point) const {
  return turned(point - here_, ahead_);
}

void Sensors::see(double distance, std::uint32_t id, Point center, double radius) {
  const Vector v = to_robot(center);
  buffer_.seen_.push_back({distance, id, v.x, v.y, radius});
}

void Sensors::sort_seen() {
  if (buffer_.seen_.size() > 1) sort_all_seen();
}

[[gnu::noinline]] void Sensors::sort_all_seen() {
  std::ranges::sort(buffer_.seen_, [](const SenseBuffer::Detection& a, const SenseBuffer::Detection& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  });
}

/// The walls that may be within reach, each once.
void Sensors::collect_walls(double reach) {
  std::vector<std::uint32_t>& walls = buffer_.walls_;
  walls.clear();
  scene_.statics.visit_walls(Box::around(here_.x, here_.y, reach), [&](std::uint32_t index, const Wall&) {
    if (walls.empty() || walls.back() != index) walls.push_back(index);
  });
  if (walls.size() < 2) return;
  std::ranges::sort(walls);
  const auto doubles = std::ranges::unique(walls);
  walls.erase(doubles.begin(), doubles.end());
}

/// How fast the roamer is whose edge was hit there; zero where none was.
Vector Sensors::velocity_at(const Vector& hit) const {
  constexpr double kNear = 0.05;  // readings are rounded, and noisy [m]
  for (const MovingDisc& roamer : scene_.roamers) {
    if (std::abs(length(hit - to_robot(roamer.center)) - roamer.radius) < kNear)
      return turned(roamer.velocity, ahead_);
  }
  return {};
}

/// Obstacles as the ring's beams tell them: a point for each that hit something.
void Sensors::see_by_ring(double range, percept::Percepts& out) {
  percept::Percepts ring;
  sense_ranges(ring);
  const double radius = scene_.bodies.radius[body_];
  buffer_.seen_.clear();
  for (std::uint32_t beam = 0; beam < ring.ranges.size(); ++beam) {
    const percept::RangeReading& reading = ring.ranges[beam];
    const double distance = static_cast<double>(reading.distance) + radius;
    if (!reading.hit || distance > range) continue;
    const Vector hit = geom::polar(distance, static_cast<double>(reading.angle));
    buffer_.seen_.push_back({distance, beam, hit.x, hit.y, 0.0});
  }
  sort_seen();
  buffer_.obstacles_.clear();
  for (const auto& seen : buffer_.seen_) {
    const Vector hit{seen.x, seen.y, 0.0};
    buffer_.obstacles_.push_back({hit, 0.0, velocity_at(hit)});
  }
  out.obstacles = buffer_.obstacles_;
}

void Sensors::see_roamers(double range) {
  for (std::uint32_t k = 0; k < scene_.roamers.size(); ++k) {
    const MovingDisc& roamer = scene_.roamers[k];
    const double away = geom::distance(here_, roamer.center);
    if (away > range + roamer.radius) continue;
    const Vector v = to_robot(roamer.center);
    buffer_.seen_.push_back({away - roamer.radius, kRoamerId + k, v.x, v.y, roamer.radius});
  }
}

/// Of the obstacles that were told last.
void Sensors::tell_velocities() {
  for (std::size_t i = 0; i < buffer_.seen_.size(); ++i) {
    const std::uint32_t id = buffer_.seen_[i].id;
    if (id >= kRoamerId)
      buffer_.obstacles_[i].velocity = turned(scene_.roamers[id - kRoamerId].velocity, ahead_);
  }
}

/// Discs, and what rays hit of walls.
void Sensors::see_standing(double range) {
  scene_.statics.visit_discs(Box::around(here_.x, here_.y, range),
                             [&](std::uint32_t index, const Disc& disc) {
                               const double reach = range + disc.radius;
                               const double square = square_distance(here_, disc.center);
                               if (square <= reach * reach)
                                 see(std::sqrt(square) - disc.radius, index, disc.center, disc.radius);
                             });
  collect_walls(range);
  if (!buffer_.walls_.empty()) {
    buffer_.beams_.assign(kWallRays, range);
    for (const std::uint32_t index : buffer_.walls_) {
      const geom::Segment& wall = scene_.statics.walls()[index].segment;
      wall_rays().see_wall(to_robot(wall.a), to_robot(wall.b), range, buffer_.beams_);
    }
    const auto first_id = static_cast<std::uint32_t>(scene_.statics.discs().size());
    for (std::uint32_t ray = 0; ray < kWallRays; ++ray) {
      const double distance = buffer_.beams_[ray];
      if (!(distance < range)) continue;
      const Vector hit = wall_rays().axis(ray) * distance;
      buffer_.seen_.push_back({distance - kWallHitRadius, first_id + ray, hit.x, hit.y, kWallHitRadius});
    }
  }
}

void Sensors::sense_obstacles(double range, percept::Percepts& out) {
  if (scene_.kinds[scene_.bodies.kind[body_]].spec.has_ring_obstacles) {
    see_by_ring(range, out);
    return;
  }
  buffer_.seen_.clear();
  ClearPlace& clear = scene_.clear[body_];
  if (!clear.covers(scene_.statics, here_, range)) {
    see_standing(range);
    // So that it need not look again at once.
    if (buffer_.seen_.empty()) clear = ClearPlace::look(scene_.statics, here_, 1.25 * range);
  }
  if (!scene_.roamers.empty()) see_roamers(range);
  auto area_id = static_cast<std::uint32_t>(scene_.statics.discs().size()) + kWallRays;
  visit_areas(scene_.statics.walls(), here_, [&](const AreaSeen& area) {
    if (area.distance <= range) see(area.distance, area_id, area.center, area.radius);
    ++area_id;
  });
  sort_seen();
  const std::size_t count = buffer_.seen_.size();
  buffer_.obstacles_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& seen = buffer_.seen_[i];
    buffer_.obstacles_[i] = {{seen.x, seen.y, 0.0}, seen.radius, {}};
  }
  if (!scene_.roamers.empty()) tell_velocities();
  out.obstacles = buffer_.obstacles_;
}

/// All robots in sight within range, in no order.
void Sensors::collect_robots(double range) {
  const Bodies& bodies = scene_.bodies;
  const bool may_be_hidden = !scene_.statics.walls().empty();
  buffer_.seen_.clear();
  scene_.grid.visit(Box::around(here_.x, here_.y, range), [&](const PointGrid::Item& item) {
    const Point place{item.x, item.y};
    const double square = square_distance(here_, place);
    if (square > range * range || item.id == body_) return;
    if (may_be_hidden && !scene_.statics.in_sight(here_, place)) return;
    see(std::sqrt(square), item.id, place, bodies.radius[item.id]);
  });
}

void Sensors::sense_robots(double range, percept::Percepts& out) {
  const Bodies& bodies = scene_.bodies;
  collect_robots(range);
  sort_seen();
  // Who is hidden is not among them.
  if (scene_.statics.walls().empty()) {
    const double away = buffer_.seen_.empty() ? range : buffer_.seen_.front().distance;
    scene_.apart[body_] = {scene_.grid.builds(), away};
  }
  buffer_.robots_.clear();
  for (const auto& seen : buffer_.seen_) {
    buffer_.robots_.push_back(
        {.id = bodies.robot[seen.id],
         .center = {seen.x, seen.y, 0.0},
         .heading = base::wrap_angle(bodies.heading[seen.id] - bodies.heading[body_]),
         .radius = seen.radius,
         .is_unit_mate = bodies.unit[body_] != 0 && bodies.unit[body_] == bodies.unit[seen.id],
         .object_class = bodies.seen_as[seen.id]});
  }
  out.robots = buffer_.robots_;
}

// Of very many the strongest, and of equally strong ones the nearest.
void Sensors::sense_radio(percept::Percepts& out) {
  constexpr std::size_t kMost = 64;
  const Bodies& bodies = scene_.bodies;
  std::vector<percept::RadioContact>& heard = buffer_.radio_;
  const auto is_better = [](const percept::RadioContact& a, const percept::RadioContact& b) {
    const auto rank = [](const percept::RadioContact& one) {
      return std::tuple(-one.strength, dot(one.center, one.center), one.id);
    };
    return rank(a) < rank(b);
  };
  const auto keep_best = [&] {
    if (heard.size() <= kMost) return;
    std::ranges::nth_element(heard, heard.begin() + kMost, is_better);
    heard.resize(kMost);
  };
  heard.clear();
  const double range = scene_.kinds[bodies.kind[body_]].spec.radio.range;
  const Box reach = range == 0.0 ? kWholeWorld : Box::around(here_.x, here_.y, range);
  scene_.grid.visit(reach, [&](const PointGrid::Item& item) {
    if (item.id == body_) return;
    const double strength = signal_between(scene_, body_, item.id, buffer_.walls_);
    if (strength <= 0.0) return;
    const bool is_mate = bodies.unit[body_] != 0 && bodies.unit[body_] == bodies.unit[item.id];
    heard.push_back({bodies.robot[item.id], to_robot(bodies.position(item.id)), strength, is_mate});
    if (heard.size() == 2 * kMost) keep_best();
  });
  keep_best();
  std::ranges::sort(heard, is_better);
  out.radio = heard;
}

void Sensors::sense_objects(double range, percept::Percepts& out) {
  const Bodies& bodies = scene_.bodies;
  const FieldOfView view(scene_.kinds[bodies.kind[body_]].spec.camera, bodies.pan[body_]);
  collect_robots(range);
  for (auto& seen : buffer_.seen_) {
    seen.distance -= seen.radius;
    seen.id += kRobotObjectBase;
  }
  const auto look = [&](std::uint32_t id, Point center, double radius) {
    const double square = square_distance(here_, center);
    if (square <= range * range && scene_.statics.in_sight(here_, center)) {
      see(std::sqrt(square) - radius, id, center, radius);
    }
  };
  const Box box = Box::around(here_.x, here_.y, range);
  scene_.objects.visit_visible(
      box, [&](std::uint32_t index, const Object& o) { look(index, o.center, o.radius); });
  scene_.statics.visit_discs(box, [&](std::uint32_t index, const Disc& disc) {
    look(kDiscObjectBase + index, disc.center, disc.radius);
  });
  for (std::uint32_t k = 0; k < scene_.roamers.size(); ++k)
    look(kRoamerObjectBase + k, scene_.roamers[k].center, scene_.roamers[k].radius);
  std::erase_if(buffer_.seen_,
                [&](const SenseBuffer::Detection& seen) { return !view.contains({seen.x, seen.y, 0.0}); });
  sort_seen();
  buffer_.objects_.clear();
  for (const auto& seen : buffer_.seen_) {
    percept::ObjectReading reading{.id = {seen.id}, .center = {seen.x, seen.y, 0.0}, .radius = seen.radius};
    if (seen.id >= kDiscObjectBase) {
      reading.object_class = percept::ObjectClass::kRock;
    } else if (seen.id >= kRobotObjectBase) {
      const std::uint32_t other = seen.id - kRobotObjectBase;
      reading.object_class = bodies.seen_as[other];
      reading.id = {kRobotObjectBase + bodies.robot[other].value};
    } else {
      const Object& object = scene_.objects.list()[seen.id];
      reading.id = object.id;
      reading.object_class = object.object_class;
      reading.style = object.style;
    }
    buffer_.objects_.push_back(reading);
  }
  out.objects = buffer_.objects_;
}

void Sensors::sense_ranges(percept::Percepts& out) {
  const Bodies& bodies = scene_.bodies;
  const Kind& kind = scene_.kinds[bodies.kind[body_]];
  const RangeRing& ring = kind.spec.ring;
  const RingBeams& beams = kind.beams;
  if (beams.count() == 0) return;
  const double reach = beams.reach();
  out.range_limit = ring.range;
  buffer_.beams_.assign(beams.count(), reach);
  const std::span<double> distances = buffer_.beams_;

  const double most = reach + scene_.grid.max_radius();
  scene_.grid.visit(Box::around(here_.x, here_.y, most), [&](const PointGrid::Item& item) {
    if (square_distance(here_, {item.x, item.y}) >= most * most || item.id == body_) return;
    beams.see_disc(to_robot({item.x, item.y}), bodies.radius[item.id], reach, distances);
  });
  scene_.statics.visit_discs(Box::around(here_.x, here_.y, reach), [&](std::uint32_t, const Disc& disc) {
    const double limit = reach + disc.radius;
    if (square_distance(here_, disc.center) >= limit * limit) return;
    beams.see_disc(to_robot(disc.center), disc.radius, reach, distances);
  });
  for (const MovingDisc& roamer : scene_.roamers) {
    if (geom::distance(here_, roamer.center) < reach + roamer.radius)
      beams.see_disc(to_robot(roamer.center), roamer.radius, reach, distances);
  }
  collect_walls(reach);
  for (const std::uint32_t index : buffer_.walls_) {
    const geom::Segment& wall = scene_.statics.walls()[index].segment;
    beams.see_wall(to_robot(wall.a), to_robot(wall.b), reach, distances);
  }

  const bool is_noisy = ring.noise > 0.0 || ring.dropout > 0.0;
  const double radius = bodies.radius[body_];
  buffer_.ranges_ = beams.nothing_seen();
  for (std::size_t beam = 0; beam < beams.count(); ++beam) {
    if (!(distances[beam] < reach)) continue;
    double distance = std::max(0.0, distances[beam] - radius);
    if (is_noisy) {
      base::Random random = base::Random::of(scene_.seed, bodies.robot[body_].value,
                                             base::hash_text("range ring") + beam, scene_.cycle);
      const bool is_dropped = random.uniform() < ring.dropout;
      distance = std::max(0.0, distance + ring.noise * random.normal());
      if (is_dropped || distance >= ring.range) continue;
    }
    percept::RangeReading& reading = buffer_.ranges_[beam];
    reading.distance = static_cast<float>(distance);
    reading.hit = true;
  }
  out.ranges = buffer_.ranges_;
}

}  // namespace mlab::sim
