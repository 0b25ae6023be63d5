#include "mlab/overlay/overlay.h"

#include <gtest/gtest.h>

namespace mlab::overlay {
namespace {

Overlay with(std::initializer_list<std::pair<MeasureKind, const char*>> measures) {
  Overlay out;
  for (const auto& [kind, name] : measures)
    out.measures.push_back({kind, name, true, {{1.0, 2.0}}, {}, 0.0, {}});
  return out;
}

std::string found(const Overlay& overlay, std::string_view reference) {
  const ControlMeasure* measure = find_measure(overlay, reference);
  return measure ? measure->name : "nothing";
}

const Overlay kDemo = with({{MeasureKind::kAssemblyArea, "AA1"},
                            {MeasureKind::kPassagePoint, "Charlie"},
                            {MeasureKind::kAttackPosition, "AP1"},
                            {MeasureKind::kPassagePoint, "Split"},
                            {MeasureKind::kPassagePoint, "0"},
                            {MeasureKind::kBattlePosition, "Telop-Start"},
                            {MeasureKind::kObjective, "Control Tower"},
                            {MeasureKind::kAssemblyArea, "Alpha-1"},
                            {MeasureKind::kPassagePoint, "Gamma1"}});

TEST(FindMeasure, TakesTheExactNameOrTheNameAfterAPrefix) {
  EXPECT_EQ(found(kDemo, "Split"), "Split");
  EXPECT_EQ(found(kDemo, "Control Tower"), "Control Tower");
  EXPECT_EQ(found(kDemo, "AA-AA1"), "AA1");
  EXPECT_EQ(found(kDemo, "AA-Alpha-1"), "Alpha-1");
  EXPECT_EQ(found(kDemo, "PP-0"), "0");
}

TEST(FindMeasure, TakesAPrefixThatHasAHyphenItself) {
  const Overlay o =
      with({{MeasureKind::kLandingZone, "Eagle"}, {MeasureKind::kLandingZone, "LANDING-ZONE-1"}});
  EXPECT_EQ(found(o, "LANDING-ZONE-Eagle"), "Eagle");
  EXPECT_EQ(found(o, "landing-zone-EAGLE"), "Eagle");
  EXPECT_EQ(found(o, "LANDING-ZONE-LANDING-ZONE-1"), "LANDING-ZONE-1");
  EXPECT_EQ(found(o, "LANDING-ZONE-1"), "LANDING-ZONE-1");
  EXPECT_EQ(found(o, "LANDING-Eagle"), "nothing");
  EXPECT_EQ(found(o, "LANDING-ZONE-"), "nothing");
}

TEST(FindMeasure, DoesNotCompareThePrefixWithTheKind) {
  EXPECT_EQ(found(kDemo, "AXIS-Gamma1"), "Gamma1");
  EXPECT_EQ(found(kDemo, "road-Gamma1"), "Gamma1");
}

TEST(FindMeasure, FallsBackToOtherLetterCases) {
  EXPECT_EQ(found(kDemo, "PP-CHARLIE"), "Charlie");
  EXPECT_EQ(found(kDemo, "pp-charlie"), "Charlie");
  EXPECT_EQ(found(kDemo, "atk-ap1"), "AP1");
}

TEST(FindMeasure, FindsMixedCaseOnlyExactly) {
  EXPECT_EQ(found(kDemo, "BP-Telop-Start"), "Telop-Start");
  EXPECT_EQ(found(kDemo, "telop-START"), "nothing");
}

TEST(FindMeasure, StripsOnlyOnePrefixAndOnlyAKnownOne) {
  EXPECT_EQ(found(kDemo, "PP-PP-Split"), "nothing");
  EXPECT_EQ(found(kDemo, "XX-Split"), "nothing");
  EXPECT_EQ(found(kDemo, "PP-"), "nothing");
  EXPECT_EQ(found(kDemo, ""), "nothing");
}

TEST(FindMeasure, PrefersTheExactNameToOneAfterAPrefix) {
  const Overlay o = with({{MeasureKind::kPassagePoint, "PP-x"}, {MeasureKind::kPassagePoint, "x"}});
  EXPECT_EQ(found(o, "PP-x"), "PP-x");
}

TEST(FindMeasure, TakesTheLastOfEqualNames) {
  const Overlay o = with({{MeasureKind::kPassagePoint, "x"}, {MeasureKind::kAssemblyArea, "x"}});
  EXPECT_EQ(find_measure(o, "x")->kind, MeasureKind::kAssemblyArea);
}

TEST(NearestMeasureName, HintsAtWhatWasMeant) {
  EXPECT_EQ(nearest_measure_name(kDemo, "PP-Chralie"), "Charlie");
  EXPECT_EQ(nearest_measure_name(kDemo, "ATK-AP9"), "AP1");
  EXPECT_EQ(nearest_measure_name(kDemo, "xyzzyxyzzy"), "");
}

TEST(ControlMeasure, HasItsCenterAtTheMeanOfItsVertices) {
  const ControlMeasure triangle{
      MeasureKind::kAssemblyArea, "a", true, {{0, 0}, {3, 0}, {0, 6}}, {}, 50.0, {}};
  EXPECT_EQ(triangle.center(), (geom::Point{1.0, 2.0}));
}

TEST(ControlMeasure, OfLineKindCanBeFollowed) {
  ControlMeasure m;
  for (const MeasureKind line :
       {MeasureKind::kAxis, MeasureKind::kGap, MeasureKind::kRoad, MeasureKind::kPhaseLine}) {
    m.kind = line;
    EXPECT_TRUE(m.is_line()) << keyword(line);
  }
  m.kind = MeasureKind::kAssemblyArea;
  EXPECT_FALSE(m.is_line());
}

TEST(ZoneKind, IsToldByTheNameOfABoundary) {
  ControlMeasure m{MeasureKind::kBoundary, "NoFlyZone-3", true, {{0, 0}}, {}, 0.0, {}};
  EXPECT_EQ(zone_kind(m), ZoneKind::kNoFly);
  m.name = "East WeatherZone NoFlyZone";
  EXPECT_EQ(zone_kind(m), ZoneKind::kWeather);
  m.name = "noflyzone";
  EXPECT_EQ(zone_kind(m), ZoneKind::kNone);
  m = {MeasureKind::kWall, "NoCommZone", true, {{0, 0}}, {}, 0.0, {}};
  EXPECT_EQ(zone_kind(m), ZoneKind::kNone);
}

TEST(Keyword, OfAMeasureIsTheWordOfItsStatement) {
  EXPECT_EQ(keyword(MeasureKind::kLineOfDeparture), "LDLC");
  EXPECT_EQ(keyword(MeasureKind::kRoad), "ROAD");
}

}  // namespace
}  // namespace mlab::overlay
