#include "mlab/console/odl_statement.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/mission_text.h"
#include "mlab/console/scene_encoder.h"
#include "mlab/lang/odl/limits.h"

namespace mlab::console {
namespace {

using overlay::MeasureKind;

constexpr std::uint32_t kWordsOfUtm = 5;  // UTM LAT a LON b

bool is_on_a_map(double value) {
  return std::abs(value) <= odl::kMaxCoordinate;
}  // false for NaN, too
bool is_length(double value) {
  return value > 0.0 && value <= odl::kMaxCoordinate;
}

std::vector<geom::Point> points_of(const google::protobuf::RepeatedPtrField<Point>& from) {
  std::vector<geom::Point> out;
  for (const Point& p : from) out.push_back({p.x(), p.y()});
  return out;
}

std::string style_word(WorldObject::Style style) {
  return style == WorldObject::FIXED ? "FIXED" : style == WorldObject::MOVABLE ? "MOVABLE" : "CONTAINER";
}

// With the star that hides its label.
std::string name_word(const Measure& measure) {
  return written_name(measure.shows_label() ? measure.name() : measure.name() + '*');
}

bool is_same(geom::Point a, geom::Point b) {
  return std::abs(a.x - b.x) <= kSameNumber && std::abs(a.y - b.y) <= kSameNumber;
}

std::string written(const std::vector<geom::Point>& points, std::size_t from, std::size_t end,
                    geom::Offset origin) {
  std::string out;
  for (std::size_t i = from; i < end; ++i) out += (i == from ? "" : " ") + brief_point(points[i], origin);
  return out;
}

}  // namespace

std::string brief_number(double value) {
  if (value != 0.0 && std::abs(value) < 0.005) return fmt::format("{:.2g}", value);
  std::string out = fmt::format("{:.2f}", value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string brief_point(geom::Point world, geom::Offset origin) {
  // What is left of a coordinate after taking the origin off may be dust.
  const auto coordinate = [](double value) { return brief_number(std::abs(value) < 0.005 ? 0.0 : value); };
  return coordinate(world.x - origin.x) + ' ' + coordinate(world.y - origin.y);
}

std::string problem_with(const Measure& measure) {
  if (!Measure::Kind_IsValid(measure.kind())) return "there is no such kind";
  const MeasureKind kind = decode_kind(measure.kind());
  const overlay::MeasureInfo& info = overlay::info(kind);
  const std::string word(info.keyword);
  if (written_name(measure.name()).empty()) return "a name has no quotes and stands on one line";
  if (measure.name().ends_with('*'))
    return "a `*` at the end of a name hides its label, and is no part of it";
  const bool is_hallway = kind == MeasureKind::kHallway;
  const auto count = static_cast<std::size_t>(measure.points_size());
  if (count < info.min_points || count > info.max_points || (is_hallway && measure.centerline_size() == 0)) {
    return info.max_points != overlay::kAnyNumber
               ? fmt::format("{} has exactly {} point{}", word, info.max_points,
                             info.max_points == 1 ? "" : "s")
               : fmt::format("{} has at least one point", word);
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

std::string problem_with(const Obstacle& obstacle) {
  if (!is_on_a_map(obstacle.x()) || !is_on_a_map(obstacle.y()))
    return "a coordinate is at most 100,000 km from 0";
  if (!is_length(obstacle.radius())) return "the radius of an obstacle is more than 0";
  return is_on_a_map(obstacle.height()) ? "" : "the height is too large";
}

std::string problem_with(const WorldObject& object) {
  if (!is_on_a_map(object.x()) || !is_on_a_map(object.y()))
    return "a coordinate is at most 100,000 km from 0";
  if (!is_on_a_map(object.diameter()) || object.diameter() < 0.0)
    return "the diameter of an object is not below 0";
  if (object.style() < WorldObject::FIXED || object.style() > WorldObject::CONTAINER)
    return "there is no such style";
  return written_name(object.color()).empty() ? "a colour has no quotes and stands on one line" : "";
}

std::string odl_statement(const Measure& measure, geom::Offset origin) {
  const MeasureKind kind = decode_kind(measure.kind());
  const auto points = points_of(measure.points());
  std::string out = fmt::format("{} {} ", overlay::keyword(kind), name_word(measure));
  if (kind == MeasureKind::kHallway) {
    const auto line = points_of(measure.centerline());
    return out + fmt::format("CENTERLINE {} WIDTH {} EXTENTS {}", written(line, 0, line.size(), origin),
                             brief_number(measure.size()), written(points, 0, points.size(), origin));
  }
  out += written(points, 0, points.size(), origin);
  const double usual = overlay::info(kind).default_size;
  if (usual > 0.0 && measure.size() > 0.0 && std::abs(measure.size() - usual) > kSameNumber)
    out += ' ' + brief_number(measure.size());
  return out;
}

std::string odl_statement(const Obstacle& obstacle, geom::Offset origin) {
  std::string out = fmt::format("OBSTACLE {} {}", brief_point({obstacle.x(), obstacle.y()}, origin),
                                brief_number(obstacle.radius()));
  if (obstacle.height() > 0.0) out += ' ' + brief_number(obstacle.height());
  return out;
}

std::string odl_statement(const WorldObject& object, geom::Offset origin) {
  return fmt::format("OBJECT {} {} {} {}", brief_point({object.x(), object.y()}, origin),
                     brief_number(object.diameter()), style_word(object.style()),
                     written_name(object.color()));
}

text::Span StatementEdit::first_word(const odl::PointSyntax& point) const {
  return tree_.tokens[point.first_token].span;
}

text::Span StatementEdit::last_word(const odl::PointSyntax& point) const {
  return tree_.tokens[point.first_token + (point.is_utm ? kWordsOfUtm : 2) - 1].span;
}

void StatementEdit::rewrite(const std::string& statement) {
  const text::Span keyword = tree_.tokens[statement_.first_token].span;
  splices_.replace(keyword, statement);
  splices_.erase({keyword.end, statement_.span.end});
}

void StatementEdit::number(text::Span word, double before, double after) {
  if (std::abs(before - after) > kSameNumber) splices_.replace(word, brief_number(after));
}

void StatementEdit::point(const odl::PointSyntax& written, geom::Point before, geom::Point after) {
  if (is_same(before, after)) return;
  if (written.is_utm) {
    const text::Span first = first_word(written);
    splices_.replace(first, brief_point(after, origin_));
    splices_.erase({first.end, last_word(written).end});
    return;
  }
  const auto coordinate = [&](const odl::NumberSyntax& word, double was, double is) {
    if (std::abs(was - is) <= kSameNumber) return;
    const double value = is - (was - word.value);
    splices_.replace(word.span, brief_number(std::abs(value) < 0.005 ? 0.0 : value));
  };
  coordinate(written.x, before.x, after.x);
  coordinate(written.y, before.y, after.y);
}

// What is the same at the beginning and at the end stays; of the rest as many points are moved as there are,
// and the others come or go.
void StatementEdit::points(const std::vector<odl::PointSyntax>& written_points,
                           const std::vector<geom::Point>& before, const std::vector<geom::Point>& after) {
  const std::size_t most = std::min(before.size(), after.size());
  std::size_t same = 0;
  while (same < most && is_same(before[same], after[same])) ++same;
  std::size_t tail = 0;
  while (tail < most - same && is_same(before[before.size() - 1 - tail], after[after.size() - 1 - tail]))
    ++tail;
  geom::Offset origin = origin_;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (written_points[i].is_utm) continue;
    origin = before[i] - geom::Point{written_points[i].x.value, written_points[i].y.value};
    break;
  }
  const std::size_t moved_end = most - tail;
  last_point_ = tail > 0 ? before.size() - 1 : moved_end - 1;
  for (std::size_t i = same; i < moved_end; ++i) point(written_points[i], before[i], after[i]);
  if (after.size() > before.size()) {
    const text::Span behind = moved_end > 0 ? last_word(written_points[moved_end - 1])
                                            : tree_.tokens[written_points[0].first_token - 1].span;
    splices_.insert_behind(behind, written(after, moved_end, after.size() - tail, origin));
  } else if (before.size() > after.size()) {
    splices_.erase({first_word(written_points[moved_end]).begin,
                    last_word(written_points[before.size() - tail - 1]).end});
  }
}

void StatementEdit::name(const overlay::ControlMeasure& before, const Measure& after) {
  if (before.name == after.name() && before.shows_label == after.shows_label()) return;
  splices_.replace(statement_.name.span, name_word(after));
}

void StatementEdit::size(double before, double after, MeasureKind kind) {
  const double usual = overlay::info(kind).default_size;
  if (!statement_.numbers.empty()) {
    if (usual == 0.0) {
      splices_.erase(statement_.numbers[0].span);
    } else if (after >= 0.0) {
      number(statement_.numbers[0].span, before, after);
    }
  } else if (usual > 0.0 && after > 0.0 && std::abs(after - usual) > kSameNumber) {
    splices_.insert_behind(last_word(statement_.points[last_point_]), brief_number(after));
  }
}

void StatementEdit::replace(const overlay::ControlMeasure& before, const Measure& after) {
  const MeasureKind kind = decode_kind(after.kind());
  const bool was_hallway = before.kind == MeasureKind::kHallway;
  if (was_hallway != (kind == MeasureKind::kHallway)) {
    const auto plain = std::ranges::find(statement_.points, false, &odl::PointSyntax::is_utm);
    const geom::Offset origin =
        plain == statement_.points.end()
            ? origin_
            : before.points[static_cast<std::size_t>(plain - statement_.points.begin())] -
                  geom::Point{plain->x.value, plain->y.value};
    rewrite(odl_statement(after, origin));
    return;
  }
  if (kind != before.kind)
    splices_.replace(tree_.tokens[statement_.first_token].span, overlay::keyword(kind));
  name(before, after);
  points(statement_.points, before.points, points_of(after.points()));
  if (was_hallway) {
    points(statement_.centerline, before.centerline, points_of(after.centerline()));
    number(statement_.numbers[0].span, before.size, after.size());
  } else {
    size(before.size, after.size(), kind);
  }
}

void StatementEdit::replace(const overlay::ObstacleDisc& before, const Obstacle& after) {
  point(statement_.points[0], before.center, {after.x(), after.y()});
  const text::Span radius = statement_.numbers[0].span;
  number(radius, before.radius, after.radius());
  if (statement_.numbers.size() > 1) {
    number(statement_.numbers[1].span, before.height, std::max(after.height(), 0.0));
  } else if (after.height() > 0.0) {
    splices_.insert_behind(radius, brief_number(after.height()));
  }
}

void StatementEdit::replace(const overlay::WorldObject& before, const WorldObject& after) {
  const bool is_same_style = static_cast<int>(before.style) == static_cast<int>(after.style());
  const bool is_object = statement_.keyword == odl::Keyword::kObject;
  if (!is_object && (!is_same_style || before.color != after.color())) {
    const odl::PointSyntax& at = statement_.points[0];
    rewrite(odl_statement(after, at.is_utm ? origin_ : before.center - geom::Point{at.x.value, at.y.value}));
    return;
  }
  point(statement_.points[0], before.center, {after.x(), after.y()});
  if (!statement_.numbers.empty()) {
    number(statement_.numbers[0].span, before.diameter, after.diameter());
  } else if (std::abs(before.diameter - after.diameter()) > kSameNumber) {
    splices_.insert_behind(last_word(statement_.points[0]), brief_number(after.diameter()));
  }
  if (!is_object) return;
  if (before.color != after.color()) splices_.replace(statement_.name.span, written_name(after.color()));
  for (std::uint32_t i = statement_.first_token; i < statement_.end_token && !is_same_style; ++i) {
    const odl::Token& token = tree_.tokens[i];
    const bool is_style =
        token.keyword >= odl::Keyword::kMovable && token.keyword <= odl::Keyword::kContainer;
    if (is_style) splices_.replace(token.span, style_word(after.style()));
  }
}

}  // namespace mlab::console
