#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/geography/notation.h"
#include "mlab/geography/projection.h"

namespace mlab::geography {
namespace {

// Places of all kinds: hemispheres, exceptions of the zones, edges of zones and bands, both ends of the grid.
constexpr GeoPoint kPlaces[] = {
    {48.2082, 16.3738}, {-33.8568, 151.2153},  {0.0, 0.0},          {-0.0001, -0.0001},
    {60.39, 5.32},      {56.0, 3.0},           {63.9999, 11.9999},  {78.22, 15.65},
    {72.0, 0.0},        {80.0, 9.0},           {83.9, 32.9},        {83.999, -179.9},
    {-79.99, 179.999},  {33.7774, -84.3973},   {-54.8019, -68.303}, {69.6492, 18.9553},
    {52.0, 179.9999},   {-17.7134, -179.9999}, {40.0, -84.001},     {40.0, -83.999},
    {8.0001, 6.0001},   {7.9999, 5.9999},      {-8.0, -6.0},        {35.6586, 139.7454},
    {71.9999, 20.9999}, {-22.9519, -43.2105},  {27.9881, 86.925},   {64.1466, -21.9426}};

// One line for each place: what stands in it, and where it is on a map round a place near it.
std::string table() {
  std::string out;
  for (const GeoPoint place : kPlaces) {
    const Projection on =
        Projection::around({std::round(place.latitude_deg * 10.0) / 10.0 - 0.05, place.longitude_deg + 0.1});
    const geom::Point at = on.to_world(place);
    out += fmt::format(
        "{{\"latitude\": {}, \"longitude\": {}, \"projection\": {{\"semiMajor\": {}, \"flattening\": {}, "
        "\"scale\": {}, \"centralMeridian\": {}, \"origin\": {{\"x\": {:.6f}, \"y\": {:.6f}}}}}, "
        "\"x\": {:.6f}, \"y\": {:.6f}",
        place.latitude_deg, place.longitude_deg, on.semi_major, on.flattening, on.scale,
        on.central_meridian_deg, on.origin.x, on.origin.y, at.x, at.y);
    for (const auto& [key, notation] :
         {std::pair{"degrees", Notation::kDegrees}, std::pair{"seconds", Notation::kSeconds},
          std::pair{"utm", Notation::kUtm}, std::pair{"mgrs", Notation::kMgrs}})
      out += fmt::format(", \"{}\": \"{}\"", key, written(place, notation));
    out += "}\n";
  }
  return out;
}

// The page computes places itself; its test reads the same table.
TEST(PlacesOfThePage, AreThoseOfThisModule) {
  const std::string path = std::string(base::source_folder()) + "/web/core/projection_places.jsonl";
  if (std::getenv("MLAB_UPDATE_GOLDEN") != nullptr) std::ofstream(path) << table();
  std::ostringstream written;
  written << std::ifstream(path).rdbuf();
  EXPECT_EQ(written.str(), table()) << "MLAB_UPDATE_GOLDEN=1 writes it anew";
}

}  // namespace
}  // namespace mlab::geography
