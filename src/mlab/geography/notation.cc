#include "mlab/geography/notation.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include <fmt/core.h>
#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>

namespace mlab::geography {
namespace {

constexpr int kDigitsOfMetre = 5;        // for each of easting and northing
constexpr std::size_t kMostDigits = 14;  // of both: a centimetre

bool is_in_grid(const Utm& utm) {
  return utm.zone >= 1 && utm.zone <= 60 && utm.easting >= 0.0 && utm.easting <= 1e6 && utm.northing >= 0.0 &&
         utm.northing <= 1e7;
}

// One angle: `48°12'29.5200'' N`. To a tenth of a millisecond, 3 mm.
std::string seconds(double degrees, char positive, char negative) {
  const auto units = static_cast<std::int64_t>(std::llround(std::abs(degrees) * 3600.0 * 1e4));
  const std::int64_t whole = units / 10000;
  return fmt::format("{}°{:02}'{:02}.{:04}'' {}", whole / 3600, whole / 60 % 60, whole % 60, units % 10000,
                     degrees < 0.0 ? negative : positive);
}

}  // namespace

std::optional<Utm> utm_of(GeoPoint place) {
  if (!is_between_the_caps(place) || !std::isfinite(place.longitude_deg)) return std::nullopt;
  Utm out;
  try {
    GeographicLib::UTMUPS::Forward(place.latitude_deg, place.longitude_deg, out.zone, out.is_north,
                                   out.easting, out.northing, GeographicLib::UTMUPS::UTM);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
  return out;
}

std::optional<GeoPoint> place_of(const Utm& utm) {
  if (!is_in_grid(utm)) return std::nullopt;
  GeoPoint out;
  try {
    GeographicLib::UTMUPS::Reverse(utm.zone, utm.is_north, utm.easting, utm.northing, out.latitude_deg,
                                   out.longitude_deg);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
  return out;
}

std::optional<std::string> mgrs_of(GeoPoint place) {
  const std::optional<Utm> utm = utm_of(place);
  if (!utm) return std::nullopt;
  std::string out;
  try {
    GeographicLib::MGRS::Forward(utm->zone, utm->is_north, utm->easting, utm->northing, place.latitude_deg,
                                 kDigitsOfMetre, out);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
  return out;
}

std::optional<GeoPoint> place_of_mgrs(std::string_view square) {
  // GeographicLib also takes whole zones and polar squares; those are not for maps.
  const auto behind_letters = std::ranges::find_if_not(
      std::ranges::find_if_not(square, [](unsigned char c) { return std::isdigit(c) != 0; }), square.end(),
      [](unsigned char c) { return std::isalpha(c) != 0; });
  const auto digits = static_cast<std::size_t>(square.end() - behind_letters);
  if (digits == 0 || digits % 2 != 0 || digits > kMostDigits) return std::nullopt;
  Utm utm;
  int precision = 0;
  try {
    GeographicLib::MGRS::Reverse(std::string(square), utm.zone, utm.is_north, utm.easting, utm.northing,
                                 precision, false);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
  return place_of(utm);
}

std::string written(GeoPoint place, Notation notation) {
  if (notation == Notation::kUtm) {
    if (const std::optional<Utm> utm = utm_of(place))
      return fmt::format("{}{} {:.2f} {:.2f}", utm->zone, utm->is_north ? 'N' : 'S', utm->easting,
                         utm->northing);
  }
  if (notation == Notation::kMgrs) {
    if (std::optional<std::string> mgrs = mgrs_of(place)) return *std::move(mgrs);
  }
  if (notation == Notation::kSeconds) {
    return fmt::format("{} {}", seconds(place.latitude_deg, 'N', 'S'),
                       seconds(place.longitude_deg, 'E', 'W'));
  }
  return fmt::format("{:.7f} {} {:.7f} {}", std::abs(place.latitude_deg),
                     place.latitude_deg < 0.0 ? 'S' : 'N', std::abs(place.longitude_deg),
                     place.longitude_deg < 0.0 ? 'W' : 'E');
}

}  // namespace mlab::geography
