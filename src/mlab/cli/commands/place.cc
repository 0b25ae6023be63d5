// `mlab place`: where a place lies on a map, and how else it is written.

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/option_groups.h"
#include "mlab/cli/terminal.h"
#include "mlab/geography/notation.h"
#include "mlab/geography/place_text.h"
#include "mlab/geography/projection.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::cli {

void add_place(CLI::App& app, PlaceOptions& o) {
  CLI::App* c = app.add_subcommand(
      "place",
      "Tell where a place on the Earth lies on a map, and how else it is written (docs/geography.md).");
  c->add_option("map", o.map, "the overlay; it says where it lies with ORIGIN GEO")
      ->required()
      ->type_name("MAP.odl");
  c->add_option("place", o.place, "in degrees, UTM or MGRS: \"48.2 N 16.4 E\"")
      ->required()
      ->type_name("PLACE");
}

int tell_place(const PlaceOptions& options) {
  overlay::Overlay map;
  text::Diagnostics sink;
  const bool is_read = odl::load_overlay(options.map, map, sink);
  if (is_read && !map.projection)
    sink.error("map-without-origin", {},
               fmt::format("{} does not say where it lies on the Earth", options.map))
        .hints.emplace_back("`ORIGIN GEO \"latitude longitude\"` in it says that");
  text::Result<geography::GeoPoint> place = geography::read_place(options.place);
  if (!place) sink.report(std::move(place.error()));
  tell(sink);
  if (sink.has_errors()) return kBadInput;
  const geom::Point at = map.projection->to_world(*place);
  const double far = geography::distance_on_earth(map.projection->to_earth({}), *place);
  if (far > geography::kReach) {
    fmt::print(stderr,
               "mlab place: that is {:.0f} km from the map's origin; a map has places within {:g} km\n",
               far / 1000.0, geography::kReach / 1000.0);
    return kBadInput;
  }
  fmt::print("{:<26}{:.2f} {:.2f}\n", "metres of the map", at.x + 0.0, at.y + 0.0);
  for (const geography::NotationInfo& one : geography::kNotations)
    fmt::print("{:<26}{}\n", one.name, geography::written(*place, one.notation));
  return kDone;
}

}  // namespace mlab::cli
