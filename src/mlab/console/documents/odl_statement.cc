#include "mlab/console/documents/odl_statement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/published/scene_encoder.h"
#include "mlab/lang/odl/limits.h"
#include "mlab/lang/odl/write.h"
#include "mlab/overlay/course.h"

namespace mlab::console {
namespace {

using overlay::MeasureKind;

bool is_on_a_map(double value) {
  return std::abs(value) <= odl::kMaxCoordinate;
}  // false for NaN, too
bool is_length(double value) {
  return value > 0.0 && value <= odl::kMaxCoordinate;
}

bool is_same(double a, double b) {
  return std::abs(a - b) <= kSameNumber;
}
bool is_same(geom::Point a, geom::Point b) {
  return is_same(a.x, b.x) && is_same(a.y, b.y);
}

std::vector<geom::Point> points_of(const google::protobuf::RepeatedPtrField<Point>& from) {
  std::vector<geom::Point> out;
  for (const Point& p : from) out.push_back({p.x(), p.y()});
  return out;
}

// ---- parts of a statement that stand nowhere yet

odl::NumberSyntax number(double value) {
  return {value, {}};
}
odl::PointSyntax point(geom::Point world, geom::Offset origin) {
  return {.x = number(coordinate(world.x - origin.x)), .y = number(coordinate(world.y - origin.y))};
}
std::vector<odl::PointSyntax> points(const std::vector<geom::Point>& world, geom::Offset origin) {
  std::vector<odl::PointSyntax> out;
  for (const geom::Point& one : world) out.push_back(point(one, origin));
  return out;
}
odl::NameSyntax name_of(const Measure& measure) {
  return {measure.name(), !measure.shows_label(), {}};
}
overlay::ObjectStyle style_of(const WorldObject& object) {
  return object.style() == WorldObject::FIXED     ? overlay::ObjectStyle::kFixed
         : object.style() == WorldObject::MOVABLE ? overlay::ObjectStyle::kMovable
                                                  : overlay::ObjectStyle::kContainer;
}

// ---- parts as they are afterwards

odl::NumberSyntax moved(const odl::NumberSyntax& was, double before, double after) {
  return is_same(before, after) ? was : number(after);
}

odl::PointSyntax moved(const odl::PointSyntax& was, geom::Point before, geom::Point after,
                       geom::Offset origin) {
  if (is_same(before, after)) return was;
  if (was.form != odl::PointForm::kMetres) return point(after, origin);
  const auto along = [](const odl::NumberSyntax& word, double from, double to) {
    return is_same(from, to) ? word : number(coordinate(to - (from - word.value)));
  };
  return {.x = along(was.x, before.x, after.x), .y = along(was.y, before.y, after.y)};
}

// Told by any point that is written in metres.
geom::Offset origin_by(const std::vector<odl::PointSyntax>& written, const std::vector<geom::Point>& before,
                       geom::Offset otherwise) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i].form == odl::PointForm::kMetres)
      return before[i] - geom::Point{written[i].x.value, written[i].y.value};
  }
  return otherwise;
}

// What is the same at the beginning and at the end stays; of the rest as many points are moved as there are,
// and the others come or go.
std::vector<odl::PointSyntax> moved(const std::vector<odl::PointSyntax>& was,
                                    const std::vector<geom::Point>& before,
                                    const std::vector<geom::Point>& after, geom::Offset origin) {
  const std::size_t most = std::min(before.size(), after.size());
  std::size_t same = 0;
  while (same < most && is_same(before[same], after[same])) ++same;
  std::size_t tail = 0;
  while (tail < most - same && is_same(before[before.size() - 1 - tail], after[after.size() - 1 - tail]))
    ++tail;
  const geom::Offset told = origin_by(was, before, origin);
  std::vector<odl::PointSyntax> out;
  for (std::size_t i = 0; i < most - tail; ++i) out.push_back(moved(was[i], before[i], after[i], origin));
  for (std::size_t i = most - tail; i < after.size() - tail; ++i) out.push_back(point(after[i], told));
  out.insert(out.end(), was.end() - static_cast<std::ptrdiff_t>(tail), was.end());
  return out;
}

// Another statement in the place of one.
odl::Statement in_place_of(const odl::Statement& was, odl::Statement now) {
  now.span = was.span;
  now.first_token = was.first_token;
  now.end_token = was.end_token;
  return now;
}

}  // namespace

double coordinate(double value) {
  return std::abs(value) < 0.005 ? 0.0 : value;
}

std::string problem_with(const Measure& measure) {
  if (!Measure::Kind_IsValid(measure.kind())) return "there is no such kind";
  const MeasureKind kind = decode_kind(measure.kind());
  const overlay::MeasureInfo& info = overlay::info(kind);
  const std::string word(info.keyword);
  if (odl::written_name(measure.name()).empty()) return "a name has no quotes and stands on one line";
  if (measure.name().ends_with('*'))
    return "a `*` at the end of a name hides its label, and is no part of it";
  const bool is_hallway = kind == MeasureKind::kHallway;
  const auto count = static_cast<std::size_t>(measure.points_size());
  if (count < info.min_points || count > info.max_points || (is_hallway && measure.centerline_size() == 0)) {
    return info.max_points != overlay::kAnyNumber
               ? fmt::format("{} has exactly {} point{}", word, info.max_points,
                             info.max_points == 1 ? "" : "s")
               : fmt::format("{} has at least {} point{}", word, info.min_points,
                             info.min_points == 1 ? "" : "s");
  }
  for (const auto* list : {&measure.points(), &measure.centerline()}) {
    for (const Point& p : *list) {
      if (!is_on_a_map(p.x()) || !is_on_a_map(p.y())) return "a coordinate is at most 100,000 km from 0";
    }
  }
  if (is_hallway && !is_length(measure.size())) return "the width of a hallway is more than 0";
  return std::isfinite(measure.size()) && measure.size() <= odl::kMaxCoordinate ? ""
                                                                                : "the size is too large";
}

template <class Thing>
static std::string problem_with_route(const Thing& thing) {
  if (thing.route().empty()) return "";
  std::vector<geom::Point> way = points_of(thing.route());
  way.insert(way.begin(), {thing.x(), thing.y()});
  if (!std::ranges::all_of(way, [](geom::Point p) { return is_on_a_map(p.x) && is_on_a_map(p.y); }))
    return "a coordinate is at most 100,000 km from 0";
  if (!(overlay::length_of(way) >= overlay::Course::kShortest)) return "a route leads somewhere";
  return thing.speed() > 0.0 && thing.speed() <= odl::kMaxRouteSpeed
             ? ""
             : fmt::format("a speed is more than 0 and at most {:g} m/s", odl::kMaxRouteSpeed);
}

std::string problem_with(const Obstacle& obstacle) {
  if (!is_on_a_map(obstacle.x()) || !is_on_a_map(obstacle.y()))
    return "a coordinate is at most 100,000 km from 0";
  if (!is_length(obstacle.radius())) return "the radius of an obstacle is more than 0";
  if (std::string problem = problem_with_route(obstacle); !problem.empty()) return problem;
  return is_on_a_map(obstacle.height()) ? "" : "the height is too large";
}

std::string problem_with(const WorldObject& object) {
  if (!is_on_a_map(object.x()) || !is_on_a_map(object.y()))
    return "a coordinate is at most 100,000 km from 0";
  if (!is_on_a_map(object.diameter()) || object.diameter() < 0.0)
    return "the diameter of an object is not below 0";
  if (std::string problem = problem_with_route(object); !problem.empty()) return problem;
  if (object.style() < WorldObject::FIXED || object.style() > WorldObject::CONTAINER)
    return "there is no such style";
  return odl::written_name(object.color()).empty() ? "a colour has no quotes and stands on one line" : "";
}

// ---- new statements

template <class Thing>
static void add_route(const Thing& thing, geom::Offset origin, odl::Statement& out) {
  out.route = points(points_of(thing.route()), origin);
  if (!out.route.empty()) out.speed = number(thing.speed());
}

odl::Statement statement_of(const Measure& measure, geom::Offset origin) {
  const MeasureKind kind = decode_kind(measure.kind());
  odl::Statement out;
  out.keyword = odl::keyword_of(kind);
  out.name = name_of(measure);
  out.points = points(points_of(measure.points()), origin);
  if (kind == MeasureKind::kHallway) {
    out.centerline = points(points_of(measure.centerline()), origin);
    out.numbers = {number(measure.size())};
    return out;
  }
  const double usual = overlay::info(kind).default_size;
  if (usual > 0.0 && measure.size() > 0.0 && !is_same(measure.size(), usual))
    out.numbers = {number(measure.size())};
  return out;
}

odl::Statement statement_of(const Obstacle& obstacle, geom::Offset origin) {
  odl::Statement out;
  out.keyword = odl::Keyword::kObstacle;
  out.points = {point({obstacle.x(), obstacle.y()}, origin)};
  out.numbers = {number(obstacle.radius())};
  if (obstacle.height() > 0.0) out.numbers.push_back(number(obstacle.height()));
  add_route(obstacle, origin, out);
  return out;
}

odl::Statement statement_of(const WorldObject& object, geom::Offset origin) {
  odl::Statement out;
  out.keyword = odl::Keyword::kObject;
  out.points = {point({object.x(), object.y()}, origin)};
  out.numbers = {number(object.diameter())};
  out.style = style_of(object);
  out.name = {object.color(), false, {}};
  add_route(object, origin, out);
  return out;
}

// ---- changed statements

odl::Statement changed(const odl::Statement& was, const overlay::ControlMeasure& before, const Measure& after,
                       geom::Offset origin) {
  const MeasureKind kind = decode_kind(after.kind());
  const bool was_hallway = before.kind == MeasureKind::kHallway;
  if (was_hallway != (kind == MeasureKind::kHallway))
    return in_place_of(was, statement_of(after, origin_by(was.points, before.points, origin)));
  odl::Statement out = was;
  out.keyword = odl::keyword_of(kind);
  if (before.name != after.name() || before.shows_label != after.shows_label()) out.name = name_of(after);
  out.points = moved(was.points, before.points, points_of(after.points()), origin);
  const double usual = overlay::info(kind).default_size;
  if (was_hallway) {
    out.centerline = moved(was.centerline, before.centerline, points_of(after.centerline()), origin);
    out.numbers[0] = moved(was.numbers[0], before.size, after.size());
  } else if (usual == 0.0) {
    out.numbers.clear();
  } else if (was.numbers.empty()) {
    if (after.size() > 0.0 && !is_same(after.size(), usual)) out.numbers = {number(after.size())};
  } else if (after.size() >= 0.0) {
    out.numbers[0] = moved(was.numbers[0], before.size, after.size());
  }
  return out;
}

// What moves keeps its route, which goes where it goes.
template <class Before, class After>
static std::vector<geom::Point> moved_route(const Before& before, const After& after) {
  std::vector<geom::Point> out = before.route;
  for (geom::Point& point : out) point = point + (geom::Point{after.x(), after.y()} - before.center);
  return out;
}

odl::Statement changed(const odl::Statement& was, const overlay::ObstacleDisc& before, const Obstacle& after,
                       geom::Offset origin) {
  odl::Statement out = was;
  out.route = moved(was.route, before.route, moved_route(before, after),
                    origin_by(was.points, {before.center}, origin));
  out.points[0] = moved(was.points[0], before.center, {after.x(), after.y()}, origin);
  out.numbers[0] = moved(was.numbers[0], before.radius, after.radius());
  if (was.numbers.size() > 1)
    out.numbers[1] = moved(was.numbers[1], before.height, std::max(after.height(), 0.0));
  else if (after.height() > 0.0)
    out.numbers.push_back(number(after.height()));
  return out;
}

// FLAG and BASKET have neither style nor colour.
odl::Statement changed(const odl::Statement& was, const overlay::WorldObject& before,
                       const WorldObject& after, geom::Offset origin) {
  const bool is_object = was.keyword == odl::Keyword::kObject;
  const bool looks_same = before.style == style_of(after) && before.color == after.color();
  if (!is_object && !looks_same) {
    const geom::Offset plain = origin_by(was.points, {before.center}, origin);
    odl::Statement now = statement_of(after, plain);
    now.route = points(moved_route(before, after), plain);
    now.speed = was.speed;
    return in_place_of(was, now);
  }
  odl::Statement out = was;
  out.route = moved(was.route, before.route, moved_route(before, after),
                    origin_by(was.points, {before.center}, origin));
  out.points[0] = moved(was.points[0], before.center, {after.x(), after.y()}, origin);
  if (!was.numbers.empty())
    out.numbers[0] = moved(was.numbers[0], before.diameter, after.diameter());
  else if (!is_same(before.diameter, after.diameter()))
    out.numbers = {number(after.diameter())};
  out.style = style_of(after);
  if (is_object && before.color != after.color()) out.name = {after.color(), false, {}};
  return out;
}

}  // namespace mlab::console
