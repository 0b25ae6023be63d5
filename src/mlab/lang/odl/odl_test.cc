#include "mlab/lang/odl/odl.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"

namespace mlab::odl {
namespace {

using overlay::MeasureKind;
using overlay::Overlay;

text::SourcePtr source_of(std::string text) {
  return std::make_shared<const text::Source>("t.odl", std::move(text));
}

struct Loaded {
  Overlay overlay;
  text::Diagnostics sink;
};

Loaded load(const std::string& text, Overlay before = {}) {
  Loaded out{std::move(before), {}};
  apply(parse(source_of(text), out.sink), out.overlay, out.sink, Companions::kIgnore);
  return out;
}

// What the features of a whole overlay become; fails where that has anything to say.
Overlay features(const std::string& text) {
  const Loaded out = load("SITE x\nCONTROL MEASURES:\n" + text);
  EXPECT_EQ(text::render(out.sink), "");
  return out.overlay;
}

TEST(OdlInformation, IsStored) {
  const Loaded l = load(
      "scenario Demo SITE \"Demo C site, Colorado\" MISSION-AREA 1600 900 HEADING 180 SCALE 25000 SET "
      "zoom-factor 50 "
      "GLOBAL_REF_POINT 33.5 -84 LOAD-MAP a.mapinfo HEIGHTMAP a.hm 80 60 160 1.5 Control Measures:");
  EXPECT_EQ(text::render(l.sink), "");
  const Overlay& o = l.overlay;
  EXPECT_EQ(o.scenario, "Demo");
  EXPECT_EQ(o.site, "Demo C site, Colorado");
  EXPECT_EQ(o.mission_area().width, 1600.0);
  EXPECT_EQ(o.mission_area().height, 900.0);
  EXPECT_DOUBLE_EQ(o.heading, base::radians(180.0));
  EXPECT_EQ(o.scale, 25000.0);
  EXPECT_EQ(o.zoom_percent, 50.0);
  EXPECT_EQ(o.global_reference, (geom::Point{33.5, -84.0}));
  EXPECT_EQ(o.map_file, "a.mapinfo");
  const overlay::HeightMap height_map = o.height_map.value_or(overlay::HeightMap{});
  EXPECT_EQ(height_map.file, "a.hm");
  EXPECT_EQ(height_map.columns, 80);
  EXPECT_EQ(height_map.rows, 60);
  EXPECT_EQ(height_map.sea_level, 160.0);
  EXPECT_EQ(height_map.z_scale, 1.5);
}

TEST(OdlInformation, DefaultsToAThousandMetresSquare) {
  const Loaded l = load("SITE x CONTROL MEASURES: PP a 1 2");
  EXPECT_EQ(l.overlay.mission_area().width, 1000.0);
  EXPECT_FALSE(l.overlay.area);
}

struct Sized {
  const char* statement;
  MeasureKind kind;
  double default_size;
};

TEST(OdlFeatures, HaveTheirKindAndDefaultSize) {
  for (const Sized& s :
       {Sized{"AA", MeasureKind::kAssemblyArea, 50}, Sized{"ATK", MeasureKind::kAttackPosition, 50},
        Sized{"BP", MeasureKind::kBattlePosition, 50}, Sized{"OBJ", MeasureKind::kObjective, 50},
        Sized{"PP", MeasureKind::kPassagePoint, 10}, Sized{"SP", MeasureKind::kStartPoint, 0},
        Sized{"AXIS", MeasureKind::kAxis, 100}, Sized{"BOUNDARY", MeasureKind::kBoundary, 0},
        Sized{"LDLC", MeasureKind::kLineOfDeparture, 0}, Sized{"Ld/Lc", MeasureKind::kLineOfDeparture, 0},
        Sized{"PL", MeasureKind::kPhaseLine, 0}, Sized{"WALL", MeasureKind::kWall, 1},
        Sized{"ROOM", MeasureKind::kRoom, 0}, Sized{"door", MeasureKind::kDoor, 0},
        Sized{"ROAD", MeasureKind::kRoad, 10}}) {
    const Overlay o = features(std::string(s.statement) + " name 3 4");
    ASSERT_EQ(o.measures.size(), 1U) << s.statement;
    EXPECT_EQ(o.measures[0].kind, s.kind) << s.statement;
    EXPECT_EQ(o.measures[0].size, s.default_size) << s.statement;
    EXPECT_EQ(o.measures[0].points, (std::vector<geom::Point>{{3, 4}})) << s.statement;
  }
  const Overlay gap = features("GAP g 1 2 3 4");
  EXPECT_EQ(gap.measures[0].size, 40.0);
}

TEST(OdlFeatures, TakeAnOddLastNumberAsTheirSize) {
  const Overlay o = features(
      "AA a 1 2 3\nOBJ b 1 2 3 4 5\nPP c 1 2 0.5\nGAP d 1 2 3 4 1.5\nROAD e 1 2 3 4 8\nWALL f 1 2 3 4 2.5");
  const double sizes[] = {3.0, 5.0, 0.5, 1.5, 8.0, 2.5};
  const std::size_t points[] = {1, 2, 1, 2, 2, 2};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(o.measures[i].size, sizes[i]) << i;
    EXPECT_EQ(o.measures[i].points.size(), points[i]) << i;
  }
}

TEST(OdlFeatures, WithANegativeSizeHaveTheDefault) {
  const Overlay o = features("PP a 1 2 -1\nAXIS b 1 2 3 4 -7\nATTRACTOR 1 2 -1\nBASKET 1 2 -1");
  EXPECT_EQ(o.measures[0].size, 10.0);
  EXPECT_EQ(o.measures[1].size, 100.0);
  EXPECT_EQ(o.objects[0].diameter, 0.2);
  EXPECT_EQ(o.objects[1].diameter, 0.4);
}

TEST(OdlFeatures, KeepTheirNameWithoutTheStarThatHidesTheLabel) {
  const Overlay o =
      features("PP Split* 1 2\nPP \"0*\" 1 2\nPP plain 1 2\nPP \"two words\" 1 2\nBOUNDARY \"\" 1 2");
  EXPECT_EQ(o.measures[0].name, "Split");
  EXPECT_FALSE(o.measures[0].shows_label);
  EXPECT_EQ(o.measures[1].name, "0");
  EXPECT_FALSE(o.measures[1].shows_label);
  EXPECT_TRUE(o.measures[2].shows_label);
  EXPECT_EQ(o.measures[3].name, "two words");
  EXPECT_EQ(o.measures[4].name, "");
}

TEST(OdlFeatures, MayBeCalledByAReservedWord) {
  const Overlay o =
      features("Gap Door 10.5 1.8 10.9 1.8 1.5\nPP wall 1 2\nAA Obstacle 1 2 3 4\nOBJECT 1 2 3 FIXED WIDTH");
  EXPECT_EQ(o.measures[0].name, "Door");
  EXPECT_EQ(o.measures[1].name, "wall");
  EXPECT_EQ(o.measures[2].name, "Obstacle");
  EXPECT_EQ(o.objects[0].color, "WIDTH");
}

TEST(OdlFeatures, MaySpreadOverLinesOrShareOne) {
  const Overlay o = features("AA a 1 2 -- the first\n  3 4 -- the second\n 5 6 PP b 7 8 9");
  ASSERT_EQ(o.measures.size(), 2U);
  EXPECT_EQ(o.measures[0].points.size(), 3U);
  EXPECT_EQ(o.measures[1].size, 9.0);
}

TEST(OdlHallway, HasACenterlineAWidthAndExtents) {
  const Overlay o = features("HALLWAY h CENTERLINE 1 2 3 4 WIDTH 1.7 EXTENTS 0 0 4 0 4 4");
  ASSERT_EQ(o.measures.size(), 1U);
  EXPECT_EQ(o.measures[0].centerline.size(), 2U);
  EXPECT_EQ(o.measures[0].points.size(), 3U);
  EXPECT_EQ(o.measures[0].size, 1.7);
}

TEST(OdlObstacle, HasARadiusAndPerhapsAHeight) {
  const Overlay o = features("OBSTACLE 1 2 3\nOBSTACLE 4 5 6 7");
  EXPECT_EQ(o.obstacles[0].center, (geom::Point{1, 2}));
  EXPECT_EQ(o.obstacles[0].radius, 3.0);
  EXPECT_EQ(o.obstacles[0].height, 0.0);
  EXPECT_EQ(o.obstacles[1].height, 7.0);
}

TEST(OdlObstacle, MayMoveAlongARoute) {
  const Overlay o =
      features("OBSTACLE 1 2 3 ROUTE 4 5 6 7 SPEED 1.5\nobstacle 4 5 6 7 route 8 9 speed 100 OBSTACLE 0 0 1");
  ASSERT_EQ(o.obstacles.size(), 3U);
  EXPECT_EQ(o.obstacles[0].route, (std::vector<geom::Point>{{4, 5}, {6, 7}}));
  EXPECT_EQ(o.obstacles[0].speed, 1.5);
  EXPECT_EQ(o.obstacles[0].height, 0.0);
  EXPECT_TRUE(o.obstacles[0].is_moving());
  EXPECT_EQ(o.obstacles[1].height, 7.0);
  EXPECT_EQ(o.obstacles[1].route.size(), 1U);
  EXPECT_EQ(o.obstacles[1].speed, 100.0);
  EXPECT_FALSE(o.obstacles[2].is_moving());
}

TEST(OdlObstacle, MayMoveBetweenPointsInDegrees) {
  const Loaded l = load(
      "ORIGIN UTM LAT 33.7774 LON -84.3973 CONTROL MEASURES: PP a UTM LAT 33.7783 LON -84.3962 OBSTACLE 1 2 "
      "3 "
      "ROUTE UTM LON -84.3962 LAT 33.7783 4 5 SPEED .1");
  ASSERT_EQ(l.overlay.obstacles.size(), 1U);
  EXPECT_EQ(l.overlay.obstacles[0].route,
            (std::vector<geom::Point>{l.overlay.measures[0].points[0], {4, 5}}));
}

TEST(OdlObjects, MayMoveAlongARoute) {
  const Overlay o = features(
      "OBJECT 1 2 0.5 MOVABLE red ROUTE 4 5 6 7 SPEED 1.5\nFLAG 1 2 ROUTE 3 4 SPEED 2 basket 1 2 0.7 route 1 "
      "9 speed 1 ATTRACTOR 1 2");
  ASSERT_EQ(o.objects.size(), 4U);
  EXPECT_EQ(o.objects[0].route, (std::vector<geom::Point>{{4, 5}, {6, 7}}));
  EXPECT_EQ(o.objects[0].speed, 1.5);
  EXPECT_EQ(o.objects[0].color, "red");
  EXPECT_EQ(o.objects[1].route.size(), 1U);
  EXPECT_EQ(o.objects[1].diameter, 0.4) << "the default";
  EXPECT_EQ(o.objects[2].diameter, 0.7);
  EXPECT_TRUE(o.objects[2].is_moving());
  EXPECT_FALSE(o.objects[3].is_moving());
}

TEST(OdlObjects, HaveTheirStyleAndColor) {
  const Overlay o = features(
      "OBJECT 1 2 0.5 Container red\nATTRACTOR 1 2\nBASKET 1 2\nFLAG 1 2\nOBJECT 1 2 0.5 MOVABLE \"light "
      "blue\"");
  EXPECT_EQ(o.objects[0].style, overlay::ObjectStyle::kContainer);
  EXPECT_EQ(o.objects[0].color, "red");
  EXPECT_EQ(o.objects[1].style, overlay::ObjectStyle::kMovable);
  EXPECT_EQ(o.objects[1].color, "orange");
  EXPECT_EQ(o.objects[1].diameter, 0.2);
  EXPECT_EQ(o.objects[2].style, overlay::ObjectStyle::kContainer);
  EXPECT_EQ(o.objects[2].diameter, 0.4);
  EXPECT_EQ(o.objects[3].color, "purple");
  EXPECT_EQ(o.objects[4].color, "light blue");
}

TEST(OdlOrigin, IsAddedToEveryPlainPointAndTheLastOneCounts) {
  const Loaded l = load(
      "ORIGIN 1 1 ORIGIN -185 -170 CONTROL MEASURES: PP a 200 180 OBSTACLE 0 0 1 ROUTE 5 0 SPEED 1 "
      "ATTRACTOR 185 170");
  EXPECT_EQ(l.overlay.measures[0].points[0], (geom::Point{15, 10}));
  EXPECT_EQ(l.overlay.obstacles[0].center, (geom::Point{-185, -170}));
  EXPECT_EQ(l.overlay.obstacles[0].route[0], (geom::Point{-180, -170}));
  EXPECT_EQ(l.overlay.objects[0].center, (geom::Point{0, 0}));
  EXPECT_EQ(l.overlay.origin, (geom::Offset{-185, -170}));
}

TEST(OdlOrigin, StaysForTheNextOverlay) {
  const Loaded first = load("ORIGIN 10 20 CONTROL MEASURES: PP a 1 2");
  const Loaded second = load("SITE x CONTROL MEASURES: PP b 1 2", first.overlay);
  ASSERT_EQ(second.overlay.measures.size(), 2U);
  EXPECT_EQ(second.overlay.measures[1].points[0], (geom::Point{11, 22}));
}

TEST(OdlUtm, PutsPointsWhereTheyLieFromTheOrigin) {
  const Loaded l = load(
      "ORIGIN UTM LAT 33.7774 LON -84.3973 CONTROL MEASURES: "
      "PP north UTM LAT 33.7783 LON -84.3973 5 PP east UTM LON -84.3962 LAT 33.7774 PP plain 30 40");
  EXPECT_EQ(text::render(l.sink), "");
  const auto& m = l.overlay.measures;
  // A ten-thousandth of a degree is 11.1 m to the north and 9.27 m to the east there; grid north is 1.45
  // degrees off.
  EXPECT_NEAR(m[0].points[0].y, 99.8, 0.3);
  EXPECT_NEAR(m[0].points[0].x, 0.0, 3.0);
  EXPECT_EQ(m[0].size, 5.0);
  EXPECT_NEAR(m[1].points[0].x, 101.9, 0.3);
  EXPECT_NEAR(m[1].points[0].y, 0.0, 3.0);
  EXPECT_EQ(m[2].points[0], (geom::Point{30, 40}));  // plain coordinates are metres from the same origin
}

TEST(OdlUtm, OriginIsForgottenWithAPlainOneBehindIt) {
  const Loaded l = load(
      "ORIGIN UTM LAT 33.7774 LON -84.3973 ORIGIN 10 20 CONTROL MEASURES: PP plain 30 40 "
      "PP north UTM LAT 33.7783 LON -84.3973");
  EXPECT_FALSE(l.overlay.utm_origin);
  EXPECT_EQ(l.overlay.measures[0].points[0], (geom::Point{40, 60}));
  EXPECT_NE(text::render(l.sink).find("utm-without-origin"), std::string::npos);
}

TEST(OdlUtm, HasNoSeamWhereTwoZonesMeet) {
  const Loaded l = load("ORIGIN UTM LAT 40 LON -84.001 CONTROL MEASURES: PP across UTM LAT 40 LON -83.999");
  const geom::Point at = l.overlay.measures[0].points[0];
  EXPECT_NEAR(geom::length(at - geom::Point{}), 170.8, 0.5);
}

constexpr std::string_view kVienna = "ORIGIN GEO \"48.2082 N 16.3738 E\" CONTROL MEASURES: ";

TEST(OdlGeo, PutsPlacesWhereTheyLieFromTheOrigin) {
  // The origin is 602065.207 m east and 5340353.594 m north in zone 33, whose grid lies 1.02 degrees off
  // there.
  const Loaded l =
      load(std::string(kVienna) +
           "PP here GEO \"48.2082 N 16.3738 E\" 5 PP east GEO \"48°12'29.52'' N 16.3751 E\" "
           "PP utm GEO \"33N 602165.207 5340353.594\" PP mgrs GEO \"33UXP0206540353\" PP plain 30 40");
  EXPECT_EQ(text::render(l.sink), "");
  const auto& m = l.overlay.measures;
  EXPECT_LT(distance(m[0].points[0], {0, 0}), 1e-6);
  EXPECT_EQ(m[0].size, 5.0);
  EXPECT_NEAR(m[1].points[0].x, 96.6, 0.1);
  EXPECT_NEAR(m[1].points[0].y, 0.0, 0.01);
  EXPECT_NEAR(distance(m[2].points[0], {0, 0}), 100.0, 0.05);
  EXPECT_NEAR(base::degrees(std::atan2(m[2].points[0].y, m[2].points[0].x)), -1.02, 0.01);
  EXPECT_NEAR(distance(m[3].points[0], {0, 0}), std::hypot(0.207, 0.594), 0.01);
  EXPECT_EQ(m[4].points[0], (geom::Point{30, 40}));
}

TEST(OdlGeo, StandsWhereverAPointMay) {
  const Loaded l =
      load(std::string(kVienna) +
           "AA a GEO \"48.2082 16.3738\" 10 20 GEO \"48.2083 16.3738\" 7\n"
           "HALLWAY h CENTERLINE GEO \"48.2082 16.3738\" 10 0 WIDTH 2 EXTENTS 0 1 GEO \"48.2082 16.3738\"\n"
           "OBSTACLE GEO \"48.2082 16.3738\" 2 ROUTE 5 5 GEO \"48.2083 16.3738\" SPEED 1\n"
           "OBJECT GEO \"48.2082 16.3738\" 1 FIXED red FLAG GEO \"48.2082 16.3738\"");
  EXPECT_EQ(text::render(l.sink), "");
  EXPECT_EQ(l.overlay.measures[0].points.size(), 3U);
  EXPECT_EQ(l.overlay.measures[0].size, 7.0);
  EXPECT_EQ(l.overlay.measures[1].points.size(), 2U);
  EXPECT_NEAR(l.overlay.obstacles[0].route[1].y, 11.12, 0.01);
  EXPECT_EQ(l.overlay.objects.size(), 2U);
}

TEST(OdlGeo, TakesDegreesOfUtmPointsToTheSamePlace) {
  const Loaded l = load(std::string(kVienna) +
                        "PP a UTM LAT 48.21 LON 16.38 PP b GEO \"48.21 16.38\" PP c UTM LON 16.38 LAT 48.21");
  EXPECT_EQ(text::render(l.sink), "");
  EXPECT_EQ(l.overlay.measures[0].points, l.overlay.measures[1].points);
  EXPECT_EQ(l.overlay.measures[0].points, l.overlay.measures[2].points);
}

TEST(OdlGeo, IsFoundOnHistoricMapsToo) {
  const Loaded l = load(
      "ORIGIN UTM LAT 33.7774 LON -84.3973 CONTROL MEASURES: PP a UTM LAT 33.7783 LON -84.3962 "
      "PP b GEO \"33.7783 N 84.3962 W\"");
  EXPECT_EQ(text::render(l.sink), "");
  EXPECT_LT(distance(l.overlay.measures[0].points[0], l.overlay.measures[1].points[0]), 0.001);
  EXPECT_NEAR(l.overlay.projection->to_earth({}).latitude_deg, 33.7774, 1e-8);
}

TEST(OdlGeo, StaysForTheNextOverlayUntilAPlainOrigin) {
  const Loaded first = load(std::string(kVienna));
  const Loaded second = load("SITE x CONTROL MEASURES: PP b GEO \"48.2082 16.3738\"", first.overlay);
  EXPECT_EQ(second.overlay.measures.size(), 1U);
  EXPECT_FALSE(load("ORIGIN 1 2 CONTROL MEASURES:", first.overlay).overlay.projection);
}

TEST(OdlGeo, IsANameWhereOneStands) {
  const Loaded l = load("CONTROL MEASURES: PP GEO 1 2 AA geo 3 4");
  EXPECT_EQ(text::render(l.sink), "");
  EXPECT_EQ(l.overlay.measures[0].name, "GEO");
}

TEST(OdlParser, ReadsTheOverlayOfTheReport) {
  const Loaded l = load(
      "SCENARIO \"example1\"\nSITE \"Robot Lab, MARC 362\"\nCONTROL MEASURES:\n\n"
      "Boundary \"MARC 362\" 0 0 10.7 0 10.7 6.1 1.7 6.1 1.7 3.4 0 3.4 0 0\nGap Door 10.5 1.8 10.9 1.8 1.5\n"
      "PP DoorWay 9.0 2.4 0.4\nPP Middle 5.0 3.0 0.4\n");
  EXPECT_EQ(text::render(l.sink), "");
  ASSERT_EQ(l.overlay.measures.size(), 4U);
  EXPECT_EQ(l.overlay.measures[0].points.size(), 7U);
  EXPECT_EQ(l.overlay.measures[1].name, "Door");
  EXPECT_EQ(l.overlay.measures[1].size, 1.5);
  const overlay::ControlMeasure* door_way = overlay::find_measure(l.overlay, "PP-DoorWay");
  ASSERT_NE(door_way, nullptr);
  EXPECT_EQ(door_way->center(), (geom::Point{9.0, 2.4}));
}

TEST(OdlParser, KeepsWhatStandsBesideBrokenStatements) {
  const Loaded l = load("SITE x\nCONTROL MEASURES:\nPP a 1\nPP b 3 4\nBONDARY c 1 2\nPP d 5 6 -- end");
  EXPECT_EQ(l.sink.error_count(), 2U);
  ASSERT_EQ(l.overlay.measures.size(), 2U);
  EXPECT_EQ(l.overlay.measures[0].name, "b");
  EXPECT_EQ(l.overlay.measures[1].name, "d");
}

TEST(LoadOverlay, SaysWhyAFileCannotBeRead) {
  Loaded l;
  EXPECT_FALSE(load_overlay("/nonexistent/a.odl", l.overlay, l.sink));
  ASSERT_EQ(l.sink.items().size(), 1U);
  EXPECT_EQ(l.sink.items()[0].kind, "cannot-read");
}

TEST(LoadOverlay, BringsInWaypointFilesAndPicturesThatLieBesideIt) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "odl_companions";
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
  write("a.odl",
        "ORIGIN 100 0\nLOAD-MAP a.mapinfo\nCONTROL MEASURES:\nPP a 1 2\nWAYPOINT-FILE \"w.wpt\"\nPP b 1 2\n");
  write("w.wpt", "PP \"Waypoint #1\" 5 6\n");
  write("a.pgm", "P2 1 1 1 0\n");
  write("a.mapinfo", "# with a map scale, the size is in pixels\na.pgm\n10 20 3272 6544 50\n");
  Loaded l;
  EXPECT_TRUE(load_overlay((folder / "a.odl").string(), l.overlay, l.sink)) << text::render(l.sink);
  EXPECT_EQ(text::render(l.sink), "");
  ASSERT_EQ(l.overlay.measures.size(), 3U);
  EXPECT_EQ(l.overlay.measures[1].name, "Waypoint #1");
  EXPECT_EQ(l.overlay.measures[1].points[0], (geom::Point{105, 6}));
  EXPECT_EQ(l.overlay.map_file, (folder / "a.mapinfo").string());
  const overlay::MapPicture picture = l.overlay.map_picture.value_or(overlay::MapPicture{});
  EXPECT_EQ(picture.file, (folder / "a.pgm").string());
  EXPECT_EQ(picture.lower_left, (geom::Point{10, 20}));
  EXPECT_DOUBLE_EQ(picture.width, 50.0);
  EXPECT_DOUBLE_EQ(l.overlay.mission_area().height, 100.0);
}

TEST(LooksLikeOdl, IsToldByTheHeaderOrByAStatementThatOnlyOverlaysHave) {
  EXPECT_TRUE(looks_like_odl("-- a map\nSCENARIO x\nCONTROL MEASURES:\n"));
  EXPECT_TRUE(looks_like_odl("SCENARIO x\nPP a 1 2\n"));
  EXPECT_TRUE(looks_like_odl("ORIGIN 1 2\n"));
  EXPECT_FALSE(looks_like_odl("MISSION NAME x\nOVERLAY a.odl\nSP a 1 2\nCOMMAND LIST:\n0. UNIT a STOP\n"));
  EXPECT_FALSE(looks_like_odl("SCENARIO x\nMISSION-AREA 1 2\nUNIT <a> ROBOT\n"));
  EXPECT_FALSE(looks_like_odl("procedure Vector X with\n"));
  EXPECT_FALSE(looks_like_odl("-- CONTROL MEASURES:\n"));
  EXPECT_FALSE(looks_like_odl(""));
}

}  // namespace
}  // namespace mlab::odl
