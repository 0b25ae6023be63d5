#include "mlab/console/published/scene_encoder.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <filesystem>
#include <tuple>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/text/utf8.h"

namespace mlab::console {
namespace {

void encode(geom::Point from, Point& to) {
  to.set_x(from.x);
  to.set_y(from.y);
}

void encode(const geography::Projection& from, Projection& to) {
  to.set_semi_major(from.semi_major);
  to.set_flattening(from.flattening);
  to.set_scale(from.scale);
  to.set_central_meridian(from.central_meridian_deg);
  encode(geom::Point{} + from.origin, *to.mutable_origin());
}

template <class Message>
void set_place(const PlaceOf& place_of, const text::Place& place, Message& to) {
  const DocumentPlace at = place_of(place);
  to.set_document(at.document);
  to.set_line(at.line);
}

std::string zone_name(overlay::ZoneKind zone) {
  switch (zone) {
    case overlay::ZoneKind::kWeather:
      return "weather";
    case overlay::ZoneKind::kNoFly:
      return "no-fly";
    case overlay::ZoneKind::kNoCommunication:
      return "no-communication";
    case overlay::ZoneKind::kNone:
      break;
  }
  return "";
}

void encode(const overlay::ControlMeasure& from, const PlaceOf& place_of, Measure& to) {
  to.set_kind(encode_kind(from.kind));
  to.set_name(text::as_utf8(from.name));
  to.set_shows_label(from.shows_label);
  for (const geom::Point p : from.points) encode(p, *to.add_points());
  for (const geom::Point p : from.centerline) encode(p, *to.add_centerline());
  to.set_size(from.size);
  to.set_zone(zone_name(overlay::zone_kind(from)));
  set_place(place_of, from.place, to);
}

template <class From, class To>
void encode_route(const From& from, To& to) {
  for (const geom::Point& point : from.route) encode(point, *to.add_route());
  to.set_speed(from.speed);
}

void encode(const overlay::ObstacleDisc& from, const PlaceOf& place_of, Obstacle& to) {
  to.set_x(from.center.x);
  to.set_y(from.center.y);
  to.set_radius(from.radius);
  to.set_height(from.height);
  encode_route(from, to);
  if (is_written(from)) set_place(place_of, from.place, to);
}

void encode(const overlay::WorldObject& from, const PlaceOf& place_of, WorldObject& to) {
  to.set_x(from.center.x);
  to.set_y(from.center.y);
  to.set_diameter(from.diameter);
  to.set_style(static_cast<WorldObject::Style>(from.style));
  to.set_color(text::as_utf8(from.color));
  encode_route(from, to);
  set_place(place_of, from.place, to);
}

}  // namespace

// Both enumerations have the same order; the test holds them to it.
static_assert(Measure::Kind_ARRAYSIZE == overlay::kMeasures.size());
Measure::Kind encode_kind(overlay::MeasureKind kind) {
  return static_cast<Measure::Kind>(kind);
}
overlay::MeasureKind decode_kind(Measure::Kind kind) {
  return static_cast<overlay::MeasureKind>(kind);
}

bool is_written(const overlay::ObstacleDisc& obstacle) {
  if (!obstacle.place.source) return false;
  const std::string_view text = obstacle.place.source->text(obstacle.place.span);
  return !text.empty() && std::toupper(static_cast<unsigned char>(text[0])) != 'C';
}

std::vector<std::uint32_t> obstacles_in_scene_order(const overlay::Overlay& map, const PlaceOf& place_of) {
  std::vector<std::uint32_t> out;
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < map.obstacles.size(); ++i) {
    const overlay::ObstacleDisc& obstacle = map.obstacles[i];
    const bool is_editable = is_written(obstacle) && !place_of(obstacle.place).document.empty();
    (is_editable ? out : others).push_back(i);
  }
  out.insert(out.end(), others.begin(), others.end());
  return out;
}

Scene encode_scene(const overlay::Overlay& map, const PlaceOf& place_of) {
  Scene out;
  out.set_scenario(text::as_utf8(map.scenario));
  out.set_site(text::as_utf8(map.site));
  out.set_width(map.mission_area().width);
  out.set_height(map.mission_area().height);
  for (const auto& measure : map.measures) encode(measure, place_of, *out.add_measures());
  for (const std::uint32_t i : obstacles_in_scene_order(map, place_of))
    encode(map.obstacles[i], place_of, *out.add_obstacles());
  for (std::size_t i = 0; i < map.objects.size(); ++i) {
    encode(map.objects[i], place_of, *out.add_objects());
    out.mutable_objects(static_cast<int>(i))->set_id(static_cast<std::uint32_t>(i + 1));
  }
  if (map.map_picture) {
    Picture& picture = *out.mutable_picture();
    picture.set_x(map.map_picture->lower_left.x);
    picture.set_y(map.map_picture->lower_left.y);
    picture.set_width(map.map_picture->width);
    picture.set_height(map.map_picture->height);
  }
  if (map.global_reference) encode(*map.global_reference, *out.mutable_global_reference());
  encode(geom::Point{} + map.origin, *out.mutable_origin());
  if (map.projection) encode(*map.projection, *out.mutable_projection());
  return out;
}

Diagnostic encode_diagnostic(const text::Diagnostic& diagnostic, const PlaceOf& place_of) {
  Diagnostic out;
  out.set_is_warning(diagnostic.severity != text::Severity::kError);
  out.set_kind(diagnostic.kind);
  std::string message = diagnostic.message;
  const DocumentPlace place = place_of(diagnostic.place);
  const text::Source* source = diagnostic.place.source.get();
  if (source != nullptr) {
    const text::LineColumn at = source->line_column(diagnostic.place.span.begin);
    const bool is_file = source->name().contains('/');
    if (place.document.empty() && is_file) {
      message = fmt::format("{}:{}: {}", std::filesystem::path(source->name()).filename().string(), at.line,
                            message);
    } else {
      out.set_document(place.document);
      out.set_begin(diagnostic.place.span.begin);
      out.set_end(diagnostic.place.span.end);
      out.set_line(at.line);
      out.set_column(at.column);
    }
  }
  out.set_message(text::as_utf8(message));
  out.set_label(text::as_utf8(diagnostic.label));
  for (const std::string& hint : diagnostic.hints) out.add_hints(text::as_utf8(hint));
  for (const text::Note& note : diagnostic.notes) {
    const DocumentPlace at = place_of(note.place);
    out.add_hints(text::as_utf8(
        at.document.empty() ? note.message : fmt::format("{}: {}:{}", note.message, at.document, at.line)));
  }
  return out;
}

void add_other_obstacles(const binding::WorldView& world, Scene& scene) {
  using Round = std::tuple<double, double, double>;
  std::vector<Round> shown;
  for (const Obstacle& obstacle : scene.obstacles())
    if (obstacle.route().empty()) shown.emplace_back(obstacle.x(), obstacle.y(), obstacle.radius());
  std::ranges::sort(shown);
  for (const binding::Disc& disc : world.discs()) {
    if (std::ranges::binary_search(shown, Round{disc.center.x, disc.center.y, disc.radius})) continue;
    Obstacle& extra = *scene.add_obstacles();
    extra.set_x(disc.center.x);
    extra.set_y(disc.center.y);
    extra.set_radius(disc.radius);
  }
}

std::uint64_t obstacles_key(const binding::WorldView& world) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  std::uint64_t key = world.discs().size();
  for (const binding::Disc& disc : world.discs()) {
    key = base::combine_bits(key, bits(disc.center.x));
    key = base::combine_bits(key, bits(disc.center.y) ^ bits(disc.radius));
  }
  return key;
}

}  // namespace mlab::console
