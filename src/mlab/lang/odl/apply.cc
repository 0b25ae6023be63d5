#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/geography/place_text.h"
#include "mlab/lang/odl/companions.h"
#include "mlab/lang/odl/limits.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/parser.h"
#include "mlab/overlay/course.h"
#include "mlab/overlay/utm.h"
#include "mlab/text/shown.h"

namespace mlab::odl {
namespace {

// Applies statements to an overlay. Its own copy of the names makes the search for duplicates fast.
class Applier {
 public:
  Applier(overlay::Overlay& into, text::Diagnostics& sink, Companions companions, const text::Files& files)
      : into_(into), sink_(sink), companions_(companions), files_(files) {
    for (std::size_t i = 0; i < into.measures.size(); ++i)
      by_name_.insert_or_assign(into.measures[i].name, i);
  }

  void apply(const Tree& tree) {
    source_ = tree.source;
    files_read_.insert(source_->name());
    for (const Statement& statement : tree.statements) apply(statement);
  }

 private:
  // NOLINTNEXTLINE(readability-function-size): a row for each keyword
  void apply(const Statement& s) {
    if (const auto kind = measure_of(s.keyword)) {
      add_measure(s, overlay::info(*kind));
      return;
    }
    switch (s.keyword) {
      case Keyword::kScenario:
        into_.scenario = s.name.text;
        return;
      case Keyword::kSite:
        into_.site = s.name.text;
        return;
      case Keyword::kOrigin:
        set_origin(s.points.front());
        return;
      case Keyword::kGlobalRefPoint:
        set_global_reference(s);
        return;
      case Keyword::kHeading:
        set_heading(s.numbers.front());
        return;
      case Keyword::kMissionArea:
        set_area(s);
        return;
      case Keyword::kLoadMap:
        load_map(s.name);
        return;
      case Keyword::kSet:
        set_zoom(s.numbers.front());
        return;
      case Keyword::kScale:
        set_scale(s.numbers.front());
        return;
      case Keyword::kHeightmap:
        set_height_map(s);
        return;
      case Keyword::kObstacle:
        add_obstacle(s);
        return;
      case Keyword::kObject:
        add_object(s, s.style, s.name.text, 0.0);
        return;
      case Keyword::kAttractor:
        add_object(s, overlay::ObjectStyle::kMovable, "orange", 0.2);
        return;
      case Keyword::kBasket:
        add_object(s, overlay::ObjectStyle::kContainer, "green", 0.4);
        return;
      case Keyword::kFlag:
        add_object(s, overlay::ObjectStyle::kMovable, "purple", 0.4);
        return;
      case Keyword::kWaypointFile:
        include_waypoints(s.name);
        return;
      case Keyword::kNone:
      case Keyword::kControlMeasures:
      case Keyword::kZoomFactor:
      case Keyword::kLat:
      case Keyword::kLon:
      case Keyword::kUtm:
      case Keyword::kGeo:
      case Keyword::kCenterline:
      case Keyword::kWidth:
      case Keyword::kExtents:
      case Keyword::kRoute:
      case Keyword::kSpeed:
      case Keyword::kMovable:
      case Keyword::kFixed:
      case Keyword::kContainer:
      case Keyword::kFirstMeasure:
        return;
    }
  }

  text::Place place_of(text::Span span) const { return {source_, span}; }

  // The number where it lies in the range; an error and nothing where not.
  std::optional<double> in_range(const NumberSyntax& number, double low, double high, std::string_view what) {
    if (number.value >= low && number.value <= high) return number.value;
    const std::string_view written = source_->text(number.span);
    const std::string range = low == -high ? fmt::format("at most {:g} from 0", high)
                                           : fmt::format("between {:g} and {:g}", low, high);
    sink_
        .error("number-out-of-range", place_of(number.span),
               fmt::format("`{}` is out of range", text::shown(written)))
        .label = fmt::format("{} is {}", what, range);
    return std::nullopt;
  }

  std::optional<double> above_zero(const NumberSyntax& number, std::string_view what,
                                   double high = kMaxCoordinate) {
    if (number.value > 0.0 && number.value <= high) return number.value;
    const std::string_view written = source_->text(number.span);
    sink_
        .error("number-out-of-range", place_of(number.span),
               fmt::format("`{}` is out of range", text::shown(written)))
        .label = fmt::format("{} is above 0 and at most {:g}", what, high);
    return std::nullopt;
  }

  // The statement's last number, or the default where there is none or it is negative.
  std::optional<double> size(const Statement& s, double default_size) {
    if (s.numbers.empty()) return default_size;
    const std::optional<double> given =
        in_range(s.numbers.front(), -kMaxCoordinate, kMaxCoordinate, "a size in metres");
    return given && *given < 0.0 ? default_size : given;
  }

  // --- points ---

  std::optional<overlay::GeoPoint> geo_point(const PointSyntax& p) {
    const auto latitude =
        in_range(p.y, -overlay::kMaxUtmLatitude, overlay::kMaxUtmLatitude, "a latitude in UTM");
    const auto longitude = in_range(p.x, -360.0, 360.0, "a longitude");
    if (!latitude || !longitude) return std::nullopt;
    return overlay::GeoPoint{*latitude, *longitude};
  }

  std::optional<geom::Point> point(const PointSyntax& p) {
    if (p.form == PointForm::kUtm) return utm_point(p);
    if (p.form == PointForm::kGeo) return earth_point(p);
    const auto x = in_range(p.x, -kMaxCoordinate, kMaxCoordinate, "a coordinate in metres");
    const auto y = in_range(p.y, -kMaxCoordinate, kMaxCoordinate, "a coordinate in metres");
    if (!x || !y) return std::nullopt;
    return geom::Point{*x, *y} + into_.origin;
  }

  std::optional<geom::Point> utm_point(const PointSyntax& p) {
    const std::optional<overlay::GeoPoint> place = geo_point(p);
    if (!place) return std::nullopt;
    if (!into_.utm_origin) {
      if (into_.projection) return within_reach(p, *place);
      warn_without_origin(p);
      return geom::Point{} +
             (overlay::utm_project(*place, overlay::utm_zone(place->longitude_deg)) - into_.origin);
    }
    const int zone = into_.utm_origin->zone;
    if (std::abs(overlay::degrees_from_center(*place, zone)) > overlay::kMaxZoneDistance) {
      sink_
          .error("utm-too-far", place_of(p.x.span),
                 fmt::format("`{}` is too far from `ORIGIN UTM` for one map", source_->text(p.x.span)))
          .label = fmt::format("the origin lies in zone {}, whose middle is at {:g} degrees", zone,
                               overlay::central_meridian_deg(zone));
      return std::nullopt;
    }
    return geom::Point{} + (overlay::utm_project(*place, zone) - into_.utm_origin->offset);
  }

  // What stands in the quotes of GEO; an error and nothing where that is no place.
  std::optional<overlay::GeoPoint> earth_place(const PointSyntax& p) {
    std::string_view written = source_->text(p.x.span).substr(1);
    if (written.ends_with('"')) written.remove_suffix(1);
    const text::Result<overlay::GeoPoint> place = geography::read_place(written);
    if (place) return *place;
    sink_.error("unreadable-place", place_of(p.x.span), place.error().message).label = place.error().label;
    return std::nullopt;
  }

  std::optional<geom::Point> earth_point(const PointSyntax& p) {
    if (!into_.projection) {
      sink_
          .error("place-without-origin", place_of(p.x.span),
                 "a place on the Earth, on a map without an origin there")
          .label = "`ORIGIN GEO \"place\"` says where the map's (0, 0) lies";
      return std::nullopt;
    }
    const std::optional<overlay::GeoPoint> place = earth_place(p);
    return place ? within_reach(p, *place) : std::nullopt;
  }

  std::optional<geom::Point> within_reach(const PointSyntax& p, overlay::GeoPoint place) {
    const double far = geography::distance_on_earth(into_.projection->to_earth({}), place);
    if (far <= geography::kReach) return into_.projection->to_world(place);
    sink_
        .error("place-too-far", place_of({p.x.span.begin, p.x.span.end}),
               fmt::format("a place {:.0f} km from the map's origin", far / 1000.0))
        .label = fmt::format("a map has places within {:g} km", geography::kReach / 1000.0);
    return std::nullopt;
  }

  void warn_without_origin(const PointSyntax& p) {
    if (std::exchange(warned_of_utm_, true)) return;
    sink_
        .warning("utm-without-origin", place_of({p.x.span.begin, p.x.span.end}),
                 "a UTM point without an `ORIGIN UTM` before it")
        .label = "it lies hundreds of kilometres from the mission area";
  }

  std::optional<std::vector<geom::Point>> points(const std::vector<PointSyntax>& syntax) {
    std::vector<geom::Point> out;
    out.reserve(syntax.size());
    for (const PointSyntax& p : syntax) {
      const std::optional<geom::Point> at = point(p);
      if (!at) return std::nullopt;
      out.push_back(*at);
    }
    return out;
  }

  // --- information ---

  void set_origin(const PointSyntax& p) {
    if (p.form == PointForm::kGeo) {
      const std::optional<overlay::GeoPoint> place = earth_place(p);
      if (!place) return;
      into_.projection = geography::Projection::around(*place);
      into_.utm_origin.reset();
      into_.origin = {};
      return;
    }
    if (p.form == PointForm::kUtm) {
      const std::optional<overlay::GeoPoint> place = geo_point(p);
      if (!place) return;
      const int zone = overlay::utm_zone(place->longitude_deg);
      into_.utm_origin = overlay::UtmOrigin{zone, overlay::utm_project(*place, zone)};
      into_.projection = geography::Projection::historic_grid(zone, into_.utm_origin->offset);
      into_.origin = {};
      return;
    }
    into_.origin = {};
    if (const std::optional<geom::Point> at = point(p)) {
      into_.origin = *at - geom::Point{};
      into_.utm_origin.reset();
      into_.projection.reset();
    }
  }

  void set_global_reference(const Statement& s) {
    const auto latitude = in_range(s.numbers[0], -90.0, 90.0, "a latitude");
    const auto longitude = in_range(s.numbers[1], -360.0, 360.0, "a longitude");
    if (latitude && longitude) into_.global_reference = geom::Point{*latitude, *longitude};
  }

  void set_heading(const NumberSyntax& degrees) {
    if (const auto heading = in_range(degrees, -kMaxCoordinate, kMaxCoordinate, "a heading in degrees")) {
      into_.heading = base::radians(*heading);
    }
  }

  void set_area(const Statement& s) {
    const auto width = above_zero(s.numbers[0], "the width of the mission area");
    const auto height = above_zero(s.numbers[1], "the height of the mission area");
    if (width && height) into_.area = overlay::Area{*width, *height};
  }

  void set_zoom(const NumberSyntax& percent) {
    if (const auto zoom = in_range(percent, 10.0, 400.0, "the zoom factor in per cent"))
      into_.zoom_percent = zoom;
  }

  void set_scale(const NumberSyntax& number) {
    if (const auto scale = above_zero(number, "the scale")) into_.scale = scale;
  }

  void set_height_map(const Statement& s) {
    const auto columns = in_range(s.numbers[0], 1.0, kMaxHeightMapCells, "the width in cells");
    const auto rows = in_range(s.numbers[1], 1.0, kMaxHeightMapCells, "the height in cells");
    const auto sea = in_range(s.numbers[2], -kMaxCoordinate, kMaxCoordinate, "the sea level");
    const auto scale = in_range(s.numbers[3], -kMaxCoordinate, kMaxCoordinate, "the z scale");
    if (!columns || !rows || !sea || !scale) return;
    const std::optional<std::string> found = companion(s.name);
    if (!found && companions_ == Companions::kRead) {
      sink_.warning("missing-height-map", place_of(s.name.span),
                    fmt::format("there is no height map `{}`", text::shown(s.name.text, 200)));
    }
    into_.height_map =
        overlay::HeightMap{found.value_or(s.name.text), static_cast<int>(std::lround(*columns)),
                           static_cast<int>(std::lround(*rows)), *sea, *scale};
  }

  // --- files ---

  std::optional<std::string> companion(const NameSyntax& name) const {
    if (companions_ == Companions::kIgnore) return std::nullopt;
    return find_companion(name.text, source_->name(), files_);
  }

  void load_map(const NameSyntax& name) {
    if (companions_ == Companions::kRead) {
      odl::load_map(name.text, source_->name(), place_of(name.span), into_, sink_, files_);
    } else {
      into_.map_file = name.text;
    }
  }

  // A waypoint file is features in this language. Each is read once, and none brings in another, so that
  // files which name each other end.
  void include_waypoints(const NameSyntax& name) {
    if (companions_ == Companions::kIgnore) return;
    if (is_included_) {
      sink_.error("nested-waypoint-file", place_of(name.span), "a waypoint file names no other one");
      return;
    }
    const std::optional<std::string> path = companion(name);
    text::Result<text::SourcePtr> source = path ? files_.read(*path) : std::unexpected(text::Diagnostic{});
    if (!source) {
      sink_.warning("missing-waypoint-file", place_of(name.span),
                    fmt::format("there is no waypoint file `{}`", text::shown(name.text, 200)));
      return;
    }
    if (!files_read_.insert(*path).second) {
      sink_.warning("repeated-waypoint-file", place_of(name.span),
                    fmt::format("`{}` is read once", text::shown(*path, 200)));
      return;
    }
    const text::SourcePtr including = std::exchange(source_, *source);
    is_included_ = true;
    const Tree tree = parse_features(source_, sink_);
    for (const Statement& statement : tree.statements) apply(statement);
    is_included_ = false;
    source_ = including;
  }

  // --- features ---

  void add_obstacle(const Statement& s) {
    const std::optional<geom::Point> at = point(s.points.front());
    const std::optional<double> radius = above_zero(s.numbers.front(), "the radius of an obstacle");
    std::optional<double> height = 0.0;
    if (s.numbers.size() > 1)
      height = in_range(s.numbers[1], -kMaxCoordinate, kMaxCoordinate, "a height in metres");
    auto movement = movement_of(s, at);
    if (!at || !radius || !height || !movement) return;
    into_.obstacles.push_back({*at, *radius, std::max(*height, 0.0), place_of(s.span),
                               std::move(movement->route), movement->speed});
  }

  struct Movement {
    std::vector<geom::Point> route;
    double speed = 0.0;
  };
  // Of what begins at a place, where that is one.
  std::optional<Movement> movement_of(const Statement& s, std::optional<geom::Point> at) {
    auto route = points(s.route);
    const auto speed = s.speed ? above_zero(*s.speed, "a speed in m/s", kMaxRouteSpeed) : std::optional(0.0);
    if (!at || !route || !speed || !leads_somewhere(s, *at, *route)) return std::nullopt;
    return Movement{std::move(*route), *speed};
  }

  bool leads_somewhere(const Statement& s, geom::Point from, const std::vector<geom::Point>& route) {
    if (route.empty()) return true;
    const double length = distance(from, route.front()) + overlay::length_of(route);
    if (length >= overlay::Course::kShortest) return true;
    sink_
        .error("route-without-length", place_of({s.route.front().x.span.begin, s.route.back().y.span.end}),
               "a route that leads nowhere")
        .label =
        fmt::format("it is at least {:g} m long; what stands has no `ROUTE`", overlay::Course::kShortest);
    return false;
  }

  void add_object(const Statement& s, overlay::ObjectStyle style, std::string color,
                  double default_diameter) {
    const std::optional<geom::Point> at = point(s.points.front());
    const std::optional<double> diameter =
        default_diameter > 0.0
            ? size(s, default_diameter)
            : in_range(s.numbers.front(), 0.0, kMaxCoordinate, "the diameter of an object");
    auto movement = movement_of(s, at);
    if (!at || !diameter || !movement) return;
    into_.objects.push_back({*at, *diameter, style, std::move(color), place_of(s.span),
                             std::move(movement->route), movement->speed});
  }

  void add_measure(const Statement& s, const overlay::MeasureInfo& info) {
    overlay::ControlMeasure out;
    out.kind = info.kind;
    out.name = s.name.text;
    out.shows_label = !s.name.has_star;
    out.place = place_of(s.name.span);
    auto vertices = points(s.points);
    auto centerline = points(s.centerline);
    const std::optional<double> given = info.shape == overlay::MeasureShape::kHallway
                                            ? above_zero(s.numbers.front(), "the width of a hallway")
                                            : size(s, info.default_size);
    if (!vertices || !centerline || !given) return;
    out.points = std::move(*vertices);
    out.centerline = std::move(*centerline);
    out.size = *given;
    remember_name(out);
    into_.measures.push_back(std::move(out));
  }

  void remember_name(const overlay::ControlMeasure& measure) {
    const auto [entry, is_new] = by_name_.try_emplace(measure.name, into_.measures.size());
    if (is_new || measure.name.empty()) return;
    const overlay::ControlMeasure& earlier =
        into_.measures[std::exchange(entry->second, into_.measures.size())];
    text::Diagnostic& d =
        sink_.warning("duplicate-name", measure.place,
                      fmt::format("a second feature is called `{}`", text::shown(measure.name)));
    d.label = "missions that name it mean this one";
    d.notes.push_back({"the first one is here", earlier.place});
  }

  overlay::Overlay& into_;
  text::Diagnostics& sink_;
  Companions companions_;
  const text::Files& files_;
  text::SourcePtr source_;
  std::unordered_map<std::string, std::size_t> by_name_;  // the last feature of each name
  std::set<std::string> files_read_;
  bool is_included_ = false;
  bool warned_of_utm_ = false;
};

}  // namespace

void apply(const Tree& tree, overlay::Overlay& into, text::Diagnostics& sink, Companions companions,
           const text::Files& files) {
  Applier(into, sink, companions, files).apply(tree);
}

}  // namespace mlab::odl
