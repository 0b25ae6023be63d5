#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/geography/geo_point.h"

namespace mlab::geography {

/// How a place on the Earth is written. All but the last are exact to a centimetre.
enum class Notation : std::uint8_t { kDegrees, kSeconds, kUtm, kMgrs };

struct NotationInfo {
  Notation notation = Notation::kDegrees;
  std::string_view name;     ///< for people: `degrees`
  std::string_view example;  ///< a place in Vienna
};

inline constexpr std::array kNotations = {
    NotationInfo{Notation::kDegrees, "degrees", "48.2082000 N 16.3738000 E"},
    NotationInfo{Notation::kSeconds, "degrees, minutes, seconds", "48°12'29.5200'' N 16°22'25.6800'' E"},
    NotationInfo{Notation::kUtm, "UTM", "33N 602065.21 5340353.59"},
    NotationInfo{Notation::kMgrs, "MGRS", "33UXP0206540353"},
};
static_assert(base::has_a_row_for_each<kNotations, &NotationInfo::notation>());

/// A place in a zone of the Universal Transverse Mercator grid of WGS 84, with the zones of Norway and
/// Svalbard.
struct Utm {
  int zone = 0;           ///< 1..60
  bool is_north = true;   ///< hemisphere
  double easting = 0.0;   ///< [m]; the zone's middle is at 500 km
  double northing = 0.0;  ///< from the equator, or in the south from 10000 km below it [m]
};

/// In the zone that the grid says. Nothing where the grid ends: beyond 80 S and 84 N.
std::optional<Utm> utm_of(GeoPoint place);
/// Nothing where no such place is: a zone outside of 1..60, an easting outside of 0 to 1000 km, a northing
/// beyond the hemisphere's.
std::optional<GeoPoint> place_of(const Utm& utm);

/// The square with a side of a metre that a place lies in: `33UXP0206540353`. Nothing beyond 80 S and 84 N.
std::optional<std::string> mgrs_of(GeoPoint place);
/// The south-western corner of a square: `33UXP02064035`. Nothing where it isn't one: letters that the zone
/// does not have, an odd number of digits, none, or more than 14 (a centimetre's needs that many).
std::optional<GeoPoint> place_of_mgrs(std::string_view square);

/// A place in a notation, as `read_place` takes it. In degrees where the grid ends.
std::string written(GeoPoint place, Notation notation);

}  // namespace mlab::geography
