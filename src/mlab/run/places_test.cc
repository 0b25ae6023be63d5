#include "mlab/run/places.h"

#include <gtest/gtest.h>

namespace mlab::run {
namespace {

mission::Mission mission_with_gate() {
  mission::Mission out;
  overlay::ControlMeasure gate;
  gate.kind = overlay::MeasureKind::kAssemblyArea;
  gate.name = "Gate";
  gate.points = {{10.0, 20.0}};
  out.overlay.measures.push_back(gate);
  out.overlay.origin = {100.0, 200.0};
  return out;
}

TEST(MissionPlaces, AreNamedAsInCommands) {
  const mission::Mission mission = mission_with_gate();
  const MissionPlaces places(mission);
  EXPECT_EQ(places.find("Gate"), (geom::Point{10.0, 20.0}));
  EXPECT_EQ(places.find("AA-GATE"), (geom::Point{10.0, 20.0}));
  EXPECT_FALSE(places.find("Gait"));
}

TEST(MissionPlaces, AreCoordinatesFromTheOrigin) {
  const mission::Mission mission = mission_with_gate();
  const MissionPlaces places(mission);
  EXPECT_EQ(places.find("1.5 -2"), (geom::Point{101.5, 198.0}));
  EXPECT_EQ(places.find(" 1, 2 "), (geom::Point{101.0, 202.0}));
  for (const char* words : {"", "1", "1 2 3", "1 x", "nan 1", "1e999 1"})
    EXPECT_FALSE(places.find(words)) << words;
}

TEST(MissionPlaces, SayWhatWasMeantPerhaps) {
  const mission::Mission mission = mission_with_gate();
  text::Diagnostic d;
  MissionPlaces(mission).explain("Gatte", d);
  EXPECT_EQ(d.hints, std::vector<std::string>{"did you mean `Gate`?"});
  const mission::Mission empty;
  MissionPlaces(empty).explain("Gatte", d);
  EXPECT_EQ(d.label, "the mission has no overlay with places");
}

}  // namespace
}  // namespace mlab::run
