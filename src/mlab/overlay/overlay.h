#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mlab/geography/projection.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/measure_kinds.h"
#include "mlab/text/source.h"

namespace mlab::overlay {

/// A named control measure. All points are world points, ORIGIN added [m].
struct ControlMeasure {
  MeasureKind kind = MeasureKind::kPassagePoint;
  std::string name;                     ///< without the trailing `*`; may be empty
  bool shows_label = true;              ///< false where the name ended in `*`
  std::vector<geom::Point> points;      ///< at least one; for a hallway its extents
  std::vector<geom::Point> centerline;  ///< hallway only
  double size = 0.0;  ///< diameter, width or height, the kind's default where none was given [m]
  text::Place place;  ///< of the name

  /// Where the measure is when one point is wanted: the mean of its vertices.
  geom::Point center() const;
  /// Whether FOLLOW takes it.
  bool is_line() const { return info(kind).is_line; }
};

struct ObstacleDisc {
  geom::Point center;
  double radius = 0.0;  ///< [m], > 0
  double height = 0.0;  ///< [m]; 0: none said
  text::Place place;
  /// Where it goes from its centre, which is not among them, at an even speed; empty: it stands.
  std::vector<geom::Point> route = {};
  double speed = 0.0;  ///< [m/s], > 0 where it moves

  bool is_moving() const { return !route.empty(); }
};

enum class ObjectStyle : std::uint8_t { kFixed, kMovable, kContainer };
/// OBJECT, ATTRACTOR, BASKET: something that robots perceive, and perhaps carry.
struct WorldObject {
  geom::Point center;
  double diameter = 0.0;  ///< [m]
  ObjectStyle style = ObjectStyle::kFixed;
  std::string color;
  text::Place place;
  /// As of an obstacle; it goes there until somebody takes it up, and stays where that one puts it.
  std::vector<geom::Point> route = {};
  double speed = 0.0;  ///< [m/s], > 0 where it moves

  bool is_moving() const { return !route.empty(); }
};

/// A BOUNDARY whose name makes it a zone.
enum class ZoneKind : std::uint8_t { kNone, kWeather, kNoFly, kNoCommunication };
ZoneKind zone_kind(const ControlMeasure& measure);

/// Where the world's origin lies on the Earth (ORIGIN UTM), so that UTM points find their place on the map.
struct UtmOrigin {
  int zone = 0;         ///< 1..60; all UTM points of the map are projected in this zone
  geom::Offset offset;  ///< easting, northing [m]
};

/// Width and height of the mission area, whose lower left corner is the world's origin [m].
struct Area {
  double width = 1000.0;
  double height = 1000.0;

  /// Its edge is part of it.
  bool contains(geom::Point p) const { return p.x >= 0.0 && p.y >= 0.0 && p.x <= width && p.y <= height; }
};

/// Heights of the ground, a byte for each cell, row by row (HEIGHTMAP). Cells below the sea level are water.
struct HeightMap {
  std::string file;
  int columns = 0;
  int rows = 0;
  double sea_level = 0.0;
  double z_scale = 1.0;
};

/// A background picture and the rectangle of the world that it covers (LOAD-MAP).
struct MapPicture {
  std::string file;
  geom::Point lower_left;  ///< [m]
  double width = 0.0;      ///< [m]
  double height = 0.0;     ///< [m]
};

/// The map: everything that one or several ODL files say. Missions add to it (MISSION-AREA, OBSTACLE, SP).
struct Overlay {
  std::string scenario;
  std::string site;
  geom::Offset origin;  ///< the ORIGIN in force at the end; later plain coordinates have it added [m]
  std::optional<UtmOrigin> utm_origin;  ///< set by ORIGIN UTM; then `origin` is zero
  /// How the world lies on the Earth (ORIGIN GEO, ORIGIN UTM); then `origin` is zero.
  std::optional<geography::Projection> projection;
  std::optional<Area> area;                     ///< as stated; without a statement the default applies
  double heading = 0.0;                         ///< initial heading of all robots [rad]
  std::optional<geom::Point> global_reference;  ///< GLOBAL_REF_POINT: x latitude, y longitude [degrees]
  std::optional<double> scale;                  ///< SCALE 1:n
  std::optional<double> zoom_percent;
  std::string map_file;                   ///< LOAD-MAP, found or as written; empty: none
  std::optional<MapPicture> map_picture;  ///< what the map file says; empty where it could not be read
  std::optional<HeightMap> height_map;
  std::vector<ControlMeasure> measures;  ///< in file order; equal names are all kept
  std::vector<ObstacleDisc> obstacles;
  std::vector<WorldObject> objects;

  Area mission_area() const { return area.value_or(Area{}); }
};

/// Finds what a location reference names: `AA-AA1`, `PP-CHARLIE`, `Split`. The last of several equal names
/// wins.
///
/// The first hit of: the reference exactly; after one type prefix is stripped, exactly; with every character
/// after the first lowered; with the first raised; all capitals. The prefix is decoration, the kind is not
/// compared.
/// @return null where nothing has that name
const ControlMeasure* find_measure(const Overlay& overlay, std::string_view reference);

/// All names that a reference may stand for; the first that some measure has wins. For whoever looks up so
/// many references that searching the list each time would take too long.
std::array<std::string, 5> spellings(std::string_view reference);

/// The name in the overlay that somebody who wrote `reference` may have meant, for a hint; empty where none
/// is near. Looks at a bounded number of names, so it may be called for every mistake of a large file.
std::string nearest_measure_name(const Overlay& overlay, std::string_view reference);

}  // namespace mlab::overlay
