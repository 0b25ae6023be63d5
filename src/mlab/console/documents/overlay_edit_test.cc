#include "mlab/console/documents/overlay_edit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/documents/odl_statement.h"
#include "mlab/console/testing/map_of_texts.h"
#include "mlab/overlay/random_obstacles.h"

namespace mlab::console {
namespace {

using testing::MapOfTexts;

Measure measure(Measure::Kind kind, const std::string& name,
                const std::vector<std::pair<double, double>>& points, double size = 0.0) {
  Measure out;
  out.set_kind(kind);
  out.set_name(name);
  out.set_shows_label(true);
  out.set_size(size);
  for (const auto& [x, y] : points) {
    Point& p = *out.add_points();
    p.set_x(x);
    p.set_y(y);
  }
  return out;
}

MapChange add(const Measure& what) {
  MapChange out;
  *out.mutable_add_measure() = what;
  return out;
}

MapChange replace(std::uint32_t index, const Measure& by) {
  MapChange out;
  out.mutable_replace_measure()->set_index(index);
  *out.mutable_replace_measure()->mutable_measure() = by;
  return out;
}

MapChange remove_measure(std::uint32_t index) {
  MapChange out;
  out.set_remove_measure(index);
  return out;
}

MapChange replace_object(std::uint32_t index, const WorldObject& object) {
  MapChange out;
  out.mutable_replace_object()->set_index(index);
  *out.mutable_replace_object()->mutable_object() = object;
  return out;
}

MapChange move_obstacle(std::uint32_t index, double x, double y, double radius, double height = 0.0) {
  MapChange out;
  out.mutable_replace_obstacle()->set_index(index);
  Obstacle& obstacle = *out.mutable_replace_obstacle()->mutable_obstacle();
  obstacle.set_x(x);
  obstacle.set_y(y);
  obstacle.set_radius(radius);
  obstacle.set_height(height);
  return out;
}

MapChange set_area(double width, double height) {
  MapChange out;
  out.mutable_set_area()->set_width(width);
  out.mutable_set_area()->set_height(height);
  return out;
}

const std::string kHeader = "CONTROL MEASURES:\n";

// ---- adding

TEST(OverlayEdit, AddsEveryKindSoThatItReadsAsAsked) {
  for (int k = Measure::Kind_MIN; k <= Measure::Kind_MAX; ++k) {
    const auto kind = static_cast<Measure::Kind>(k);
    const overlay::MeasureInfo& info = overlay::info(static_cast<overlay::MeasureKind>(k));
    Measure wanted = measure(kind, "New place", {{1.5, 2.25}, {30, 40}, {5, 60}});
    const auto most = static_cast<int>(std::clamp<std::size_t>(2, info.min_points, info.max_points));
    while (wanted.points_size() > most) wanted.mutable_points()->RemoveLast();
    if (kind == Measure::HALLWAY) {
      *wanted.mutable_centerline() = wanted.points();
      wanted.set_size(1.7);
    }
    MapOfTexts texts(kHeader + "-- the end");
    ASSERT_EQ(texts.change({add(wanted)}), "") << k;
    EXPECT_EQ(texts.said(), "");
    ASSERT_EQ(texts.map().measures.size(), 1U) << texts.overlay();
    const overlay::ControlMeasure& got = texts.map().measures[0];
    EXPECT_EQ(static_cast<int>(got.kind), k);
    EXPECT_EQ(got.name, "New place");
    ASSERT_EQ(got.points.size(), static_cast<std::size_t>(wanted.points_size()));
    EXPECT_EQ(got.points[0], (geom::Point{1.5, 2.25}));
    EXPECT_TRUE(texts.overlay().starts_with(kHeader + "-- the end\n"));
  }
}

TEST(OverlayEdit, WritesASizeOnlyWhereItIsNotTheUsualOne) {
  MapOfTexts texts(kHeader);
  ASSERT_EQ(texts.change({add(measure(Measure::ASSEMBLY_AREA, "A", {{1, 2}}, 50)),
                          add(measure(Measure::ASSEMBLY_AREA, "B", {{1, 2}}, 20)),
                          add(measure(Measure::PHASE_LINE, "C", {{1, 2}, {3, 4}}, 7))}),
            "");
  EXPECT_EQ(texts.overlay(), kHeader + "AA A 1 2\nAA B 1 2 20\nPL C 1 2 3 4\n");
}

TEST(OverlayEdit, TakesTheOriginOffAndWritesBriefly) {
  MapOfTexts texts("ORIGIN 0.25 100\n" + kHeader);
  MapChange obstacle;
  obstacle.mutable_add_obstacle()->set_x(10.2512345);
  obstacle.mutable_add_obstacle()->set_y(100.0);
  obstacle.mutable_add_obstacle()->set_radius(2.0 / 3.0);
  MapChange object;
  object.mutable_add_object()->set_x(0.25);
  object.mutable_add_object()->set_y(90.0);
  object.mutable_add_object()->set_diameter(0.3);
  object.mutable_add_object()->set_style(WorldObject::MOVABLE);
  object.mutable_add_object()->set_color("dark red");
  ASSERT_EQ(texts.change({obstacle, object}), "");
  EXPECT_EQ(texts.overlay(),
            "ORIGIN 0.25 100\n" + kHeader + "OBSTACLE 10 0 0.67\nOBJECT 0 -10 0.3 MOVABLE \"dark red\"\n");
  EXPECT_EQ(texts.said(), "");
  EXPECT_EQ(texts.map().objects[0].center, (geom::Point{0.25, 90.0}));
}

TEST(OverlayEdit, PutsNewThingsIntoTheOverlayThatIsMeant) {
  MapOfTexts texts("OVERLAY a.odl\nOVERLAY b.odl\nCOMMAND LIST:\n 0. QUIT\n",
                   {{"a.odl", "ORIGIN 10 0\n" + kHeader}, {"b.odl", "ORIGIN 20 0\n" + kHeader}});
  ASSERT_EQ(texts.change({add(measure(Measure::PASSAGE_POINT, "x", {{30, 1}}))}, "a.odl"), "");
  ASSERT_EQ(texts.change({add(measure(Measure::PASSAGE_POINT, "y", {{30, 1}}))}, "b.odl"), "");
  EXPECT_EQ(texts.overlay("a.odl"), "ORIGIN 10 0\n" + kHeader + "PP x 20 1\n");
  EXPECT_EQ(texts.overlay("b.odl"), "ORIGIN 20 0\n" + kHeader + "PP y 10 1\n");
  EXPECT_NE(texts.change({add(measure(Measure::PASSAGE_POINT, "z", {{30, 1}}))}, "c.odl"), "");
}

TEST(OverlayEdit, RefusesWhatAnOverlayCannotSay) {
  MapOfTexts texts(kHeader + "PP a 1 2\n");
  const double nan = std::nan("");
  for (const Measure& odd :
       {measure(Measure::GAP, "g", {{1, 2}}), measure(Measure::PASSAGE_POINT, "p", {{1, 2}, {3, 4}}),
        measure(Measure::WALL, "w", {}), measure(Measure::WALL, "w", {{nan, 0}}),
        measure(Measure::WALL, "w", {{1e9, 0}}), measure(Measure::WALL, "a\"b", {{1, 0}}),
        measure(Measure::WALL, "a\nb", {{1, 0}}), measure(Measure::WALL, "star*", {{1, 0}}),
        measure(Measure::HALLWAY, "h", {{1, 0}}, 2.0), measure(Measure::WALL, "w", {{1, 0}}, nan),
        measure(Measure::LANDING_ZONE, "z", {{1, 0}, {2, 0}})}) {
    EXPECT_NE(texts.change({add(odd)}), "") << odd.ShortDebugString();
  }
  EXPECT_NE(texts.change({move_obstacle(0, 1, 2, 3)}), "");
  EXPECT_NE(texts.change({remove_measure(1)}), "");
  EXPECT_NE(texts.change({remove_measure(0), remove_measure(0)}), "");
  EXPECT_NE(texts.change({set_area(0, 5)}), "");
  EXPECT_NE(texts.change({MapChange()}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "PP a 1 2\n");
}

// ---- moving

TEST(OverlayEdit, MovesOnlyTheWordsThatChange) {
  MapOfTexts texts(
      "-- Map.\nORIGIN 0.25 0.5\nControl Measures:\n\nAA Middle 6. 2.50  7 2 -- one\n   7 +3,  6e0 3 -- "
      "two\nPP p 1 2 3\tWALL\tw 0 0 5 5\n");
  Measure area = texts.scene().measures(0);
  area.mutable_points(2)->set_x(9.0);
  Measure wall = texts.scene().measures(2);
  wall.mutable_points(1)->set_y(7.125);
  wall.set_size(2.0);
  ASSERT_EQ(texts.change({replace(0, area), replace(2, wall)}), "");
  EXPECT_EQ(
      texts.overlay(),
      "-- Map.\nORIGIN 0.25 0.5\nControl Measures:\n\nAA Middle 6. 2.50  7 2 -- one\n   8.75 +3,  6e0 3 -- "
      "two\nPP p 1 2 3\tWALL\tw 0 0 5 6.62 2\n");
  EXPECT_EQ(texts.map().measures[0].points[2], (geom::Point{9.0, 3.5}));
}

TEST(OverlayEdit, AddsAndRemovesVertices) {
  MapOfTexts texts(kHeader + "AXIS a 0 0 10 0 -- bend\n  20 5 30 5 150 -- end\n");
  Measure axis = texts.scene().measures(0);
  axis.clear_points();
  for (const auto& [x, y] : {std::pair(0, 0), {10, 0}, {15, 2}, {20, 5}, {30, 5}}) {
    axis.add_points()->set_x(x);
    axis.mutable_points(axis.points_size() - 1)->set_y(y);
  }
  ASSERT_EQ(texts.change({replace(0, axis)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "AXIS a 0 0 10 0 15 2 -- bend\n  20 5 30 5 150 -- end\n");
  axis.mutable_points()->DeleteSubrange(1, 3);
  ASSERT_EQ(texts.change({replace(0, axis)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "AXIS a 0 0 -- bend\n  30 5 150 -- end\n");
  axis.mutable_points()->DeleteSubrange(0, 1);
  ASSERT_EQ(texts.change({replace(0, axis)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "AXIS a -- bend\n  30 5 150 -- end\n");
  axis.add_points()->set_x(40);
  axis.mutable_points(1)->set_y(6);
  axis.mutable_points()->SwapElements(0, 1);
  ASSERT_EQ(texts.change({replace(0, axis)}), "");
  EXPECT_EQ(texts.map().measures[0].points, (std::vector<geom::Point>{{40, 6}, {30, 5}}));
  EXPECT_EQ(texts.map().measures[0].size, 150.0);
}

TEST(OverlayEdit, MakesAMovedUtmPointMetres) {
  MapOfTexts texts(
      "ORIGIN UTM LAT 33.7774 LON -84.3973\n" + kHeader +
      "PP gate UTM LAT 33.7783 LON -84.3973 -- old\nPP parking UTM LON -84.3962 LAT 33.7774 15\n");
  Measure gate = texts.scene().measures(0);
  gate.mutable_points(0)->set_x(12.5);
  gate.mutable_points(0)->set_y(-3);
  ASSERT_EQ(texts.change({replace(0, gate)}), "");
  EXPECT_EQ(texts.overlay(), "ORIGIN UTM LAT 33.7774 LON -84.3973\n" + kHeader +
                                 "PP gate 12.5 -3 -- old\nPP parking UTM LON -84.3962 LAT 33.7774 15\n");
  EXPECT_EQ(texts.map().measures[0].points[0], (geom::Point{12.5, -3}));
}

TEST(OverlayEdit, MakesAMovedPlaceOnTheEarthMetres) {
  MapOfTexts texts("ORIGIN GEO \"33.7774 N 84.3973 W\"\n" + kHeader +
                   "PP gate GEO \"33.7783 N 84.3973 W\" -- old\nPP parking GEO \"84.3962 W 33.7774 N\" 15\n");
  Measure gate = texts.scene().measures(0);
  gate.mutable_points(0)->set_x(12.5);
  gate.mutable_points(0)->set_y(-3);
  ASSERT_EQ(texts.change({replace(0, gate)}), "");
  EXPECT_EQ(texts.overlay(), "ORIGIN GEO \"33.7774 N 84.3973 W\"\n" + kHeader +
                                 "PP gate 12.5 -3 -- old\nPP parking GEO \"84.3962 W 33.7774 N\" 15\n");
  EXPECT_EQ(texts.map().measures[0].points[0], (geom::Point{12.5, -3}));
}

TEST(OverlayEdit, ChangesHallwaysObstaclesAndObjects) {
  MapOfTexts texts(
      kHeader +
      "HALLWAY h CENTERLINE 1 2 9 2 WIDTH 1.5 EXTENTS 1 1 9 1 9 3\nOBSTACLE 1 2 3\nOBSTACLE 4 5 6 7\n"
      "OBJECT 1 1 0.5 Fixed white\nFLAG 2 2\nBASKET 3 3 1\n");
  Measure hallway = texts.scene().measures(0);
  hallway.set_size(2.0);
  hallway.mutable_centerline(1)->set_x(8);
  hallway.mutable_points(0)->set_y(0);
  MapChange object;
  object.mutable_replace_object()->set_index(0);
  *object.mutable_replace_object()->mutable_object() = texts.scene().objects(0);
  object.mutable_replace_object()->mutable_object()->set_style(WorldObject::CONTAINER);
  object.mutable_replace_object()->mutable_object()->set_color("light blue");
  MapChange flag;
  flag.mutable_replace_object()->set_index(1);
  *flag.mutable_replace_object()->mutable_object() = texts.scene().objects(1);
  flag.mutable_replace_object()->mutable_object()->set_diameter(0.7);
  MapChange basket;
  basket.mutable_replace_object()->set_index(2);
  *basket.mutable_replace_object()->mutable_object() = texts.scene().objects(2);
  basket.mutable_replace_object()->mutable_object()->set_color("red");
  ASSERT_EQ(texts.change({replace(0, hallway), move_obstacle(0, 1, 2, 3.5, 2), move_obstacle(1, 4, 6, 6, 7),
                          object, flag, basket}),
            "");
  EXPECT_EQ(texts.overlay(),
            kHeader +
                "HALLWAY h CENTERLINE 1 2 8 2 WIDTH 2 EXTENTS 1 0 9 1 9 3\nOBSTACLE 1 2 3.5 2\n"
                "OBSTACLE 4 6 6 7\nOBJECT 1 1 0.5 CONTAINER \"light blue\"\nFLAG 2 2 0.7\n"
                "OBJECT 3 3 1 CONTAINER red\n");
  EXPECT_EQ(texts.said(), "");
}

TEST(OverlayEdit, AnObstacleThatMovesTakesItsRouteWithIt) {
  MapOfTexts texts(
      "ORIGIN 10 20\n" + kHeader +
      "obstacle 1 2.0 3 route 4 5 -- there\n 6 7 Speed 1.50\nOBSTACLE 0 0 1 4 ROUTE 9 0 0 0 SPEED 2\n");
  const Obstacle shown = texts.scene().obstacles(0);
  ASSERT_EQ(shown.route_size(), 2);
  EXPECT_EQ(shown.route(1).x(), 16.0);
  EXPECT_EQ(shown.route(1).y(), 27.0);
  EXPECT_EQ(shown.speed(), 1.5);
  ASSERT_EQ(texts.change({move_obstacle(0, 12.5, 22, 4), move_obstacle(1, 10, 21, 1, 5)}), "");
  EXPECT_EQ(texts.overlay(), "ORIGIN 10 20\n" + kHeader +
                                 "obstacle 2.5 2.0 4 route 5.5 5 -- there\n 7.5 7 Speed 1.50\nOBSTACLE 0 1 1 "
                                 "5 ROUTE 9 1 0 1 SPEED 2\n");
  EXPECT_EQ(texts.map().obstacles[1].route.back(), texts.map().obstacles[1].center)
      << "still round and round";
  EXPECT_EQ(texts.said(), "");
}

TEST(OverlayEdit, AnObjectThatMovesTakesItsRouteWithIt) {
  MapOfTexts texts(kHeader +
                   "flag 1 2.0 route 4 5 -- there\n 6 7 Speed 1.50\nOBJECT 0 0 1 FIXED red ROUTE 9 0 "
                   "SPEED 2\n");
  WorldObject flag = texts.scene().objects(0);
  WorldObject box = texts.scene().objects(1);
  ASSERT_EQ(flag.route_size(), 2);
  EXPECT_EQ(flag.speed(), 1.5);
  flag.clear_route();  // nobody who changes it need know of it
  box.clear_route();
  flag.set_x(2);
  box.set_y(1);
  ASSERT_EQ(texts.change({replace_object(0, flag), replace_object(1, box)}), "");
  EXPECT_EQ(texts.overlay(), kHeader +
                                 "flag 2 2.0 route 5 5 -- there\n 7 7 Speed 1.50\nOBJECT 0 1 1 FIXED red "
                                 "ROUTE 9 1 SPEED 2\n");
  flag.set_style(WorldObject::FIXED);
  ASSERT_EQ(texts.change({replace_object(0, flag)}), "");
  EXPECT_EQ(texts.map().objects[0].style, overlay::ObjectStyle::kFixed);
  EXPECT_EQ(texts.map().objects[0].route, (std::vector<geom::Point>{{5, 5}, {7, 7}}));
  EXPECT_EQ(texts.map().objects[0].speed, 1.5);
  EXPECT_EQ(texts.said(), "");
}

TEST(OverlayEdit, AddsAnObstacleThatMoves) {
  MapOfTexts texts(kHeader);
  MapChange added;
  Obstacle& obstacle = *added.mutable_add_obstacle();
  obstacle.set_x(1);
  obstacle.set_y(2);
  obstacle.set_radius(3);
  Point& point = *obstacle.add_route();
  point.set_x(4);
  point.set_y(5);
  for (const double speed : {0.0, -1.0, 101.0, std::nan("")}) {
    obstacle.set_speed(speed);
    EXPECT_EQ(texts.change({added}), "a speed is more than 0 and at most 100 m/s") << speed;
  }
  obstacle.set_speed(1.5);
  ASSERT_EQ(texts.change({added}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "OBSTACLE 1 2 3 ROUTE 4 5 SPEED 1.5\n");
  point.set_x(1);
  point.set_y(2);
  EXPECT_EQ(texts.change({added}), "a route leads somewhere");
}

TEST(OverlayEdit, ChangesAKindAndKeepsTheRest) {
  MapOfTexts texts(kHeader + "AA a 1 2 20 -- here\nWALL w 1 2 3 4\n");
  Measure area = texts.scene().measures(0);
  area.set_kind(Measure::OBJECTIVE);
  Measure wall = texts.scene().measures(1);
  wall.set_kind(Measure::ROAD);
  wall.set_size(4);
  ASSERT_EQ(texts.change({replace(0, area), replace(1, wall)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "OBJ a 1 2 20 -- here\nROAD w 1 2 3 4 4\n");
  wall.set_kind(Measure::HALLWAY);
  *wall.mutable_centerline() = wall.points();
  area.set_kind(Measure::PHASE_LINE);
  ASSERT_EQ(texts.change({replace(0, area), replace(1, wall)}), "");
  EXPECT_EQ(texts.overlay(),
            kHeader + "PL a 1 2 -- here\nHALLWAY w CENTERLINE 1 2 3 4 WIDTH 4 EXTENTS 1 2 3 4\n");
  EXPECT_EQ(texts.said(), "");
}

// ---- removing

TEST(OverlayEdit, RemovesAStatementAndNothingElse) {
  MapOfTexts texts(
      kHeader +
      "-- first\nPP a 1 2\nPP b 3 4 -- bee\nAA c -- cee\n  1 2\n  3 4\nPP d 5 6 PP e 7 8 OBSTACLE 1 1 "
      "1\nPP f 9 9");
  std::vector<MapChange> all = {remove_measure(0), remove_measure(1), remove_measure(2), remove_measure(3)};
  ASSERT_EQ(texts.change(all), "");
  EXPECT_EQ(texts.overlay(), kHeader + "-- first\n-- bee\n-- cee\nPP e 7 8 OBSTACLE 1 1 1\nPP f 9 9");
  MapChange obstacle;
  obstacle.set_remove_obstacle(0);
  ASSERT_EQ(texts.change({obstacle, remove_measure(1)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "-- first\n-- bee\n-- cee\nPP e 7 8\n");
}

// ---- names

TEST(OverlayEdit, RenamesTheReferencesOfTheMissionToo) {
  MapOfTexts texts(
      "OVERLAY o.odl\nFAILSAFE OUTSIDE Fence HOLD\nUNIT <u> ROBOT\nCOMMAND LIST:\n 0. UNIT u START aa-home "
      "-- "
      "from aa-home\n 1. UNIT u "
      "MOVETO "
      "CHARLIE PHASE-LINE \"Red\" ACK \"Red\"\n 2. UNIT u MOVETO PP-Charlie\n",
      {{"o.odl", kHeader + "AA Home 1 2\nPP Charlie* 3 4\nPL Red 1 1 2 2\nBOUNDARY Fence 0 0 0 9 9 9\n"}});
  EXPECT_EQ(texts.said(), "");
  Measure fence = texts.scene().measures(3);
  fence.set_name("Limit");
  Measure home = texts.scene().measures(0);
  home.set_name("new home");
  Measure charlie = texts.scene().measures(1);
  charlie.set_name("Column");
  Measure red = texts.scene().measures(2);
  red.set_name("PL7");
  ASSERT_EQ(texts.change({replace(0, home), replace(1, charlie), replace(2, red), replace(3, fence)}), "");
  EXPECT_EQ(texts.overlay(),
            kHeader + "AA \"new home\" 1 2\nPP Column* 3 4\nPL PL7 1 1 2 2\nBOUNDARY Limit 0 0 0 9 9 9\n");
  EXPECT_EQ(texts.mission(),
            "OVERLAY o.odl\nFAILSAFE OUTSIDE Limit HOLD\nUNIT <u> ROBOT\nCOMMAND LIST:\n 0. UNIT u START "
            "\"AA-new home\" -- from "
            "aa-home\n 1. UNIT "
            "u MOVETO \"Column\" PHASE-LINE PL7 ACK \"Red\"\n 2. UNIT u MOVETO PP-Column\n");
  EXPECT_EQ(texts.said(), "");
}

TEST(OverlayEdit, RefusesNamesThatWouldSendUnitsElsewhere) {
  MapOfTexts texts("OVERLAY o.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n 0. UNIT u START Home\n",
                   {{"o.odl", kHeader + "AA Home 1 2\nPP other 3 4\n"}});
  Measure other = texts.scene().measures(1);
  other.set_name("Home");
  EXPECT_NE(texts.change({replace(1, other)}), "");
  EXPECT_NE(texts.change({add(measure(Measure::PASSAGE_POINT, "Home", {{5, 5}}))}), "");
  Measure home = texts.scene().measures(0);
  home.set_name("");
  EXPECT_NE(texts.change({replace(0, home)}), "");
  other.set_name("free");
  EXPECT_EQ(texts.change({replace(1, other)}), "");
}

TEST(OverlayEdit, HidesAndShowsLabels) {
  MapOfTexts texts(kHeader + "PP a 1 2\nPP \"b c*\" 1 2\n");
  Measure a = texts.scene().measures(0);
  a.set_shows_label(false);
  Measure b = texts.scene().measures(1);
  b.set_shows_label(true);
  ASSERT_EQ(texts.change({replace(0, a), replace(1, b)}), "");
  EXPECT_EQ(texts.overlay(), kHeader + "PP a* 1 2\nPP \"b c\" 1 2\n");
}

// ---- what stands in the mission

TEST(OverlayEdit, ChangesWhatStandsInTheMission) {
  MapOfTexts texts(
      "OVERLAY o.odl -- map\nSP s 1 2 OBSTACLE 3 4 5 -- disc\nMISSION-AREA 100 200\nUNIT <u> ROBOT\nCOMMAND "
      "LIST:\n 0. "
      "UNIT u START s\n",
      {{"o.odl", "ORIGIN 10 20\n" + kHeader}});
  EXPECT_FALSE(texts.has_errors()) << texts.said();
  Measure start = texts.scene().measures(0);
  start.set_name("gate");
  start.mutable_points(0)->set_x(14);
  ASSERT_EQ(texts.change({replace(0, start), move_obstacle(0, 13, 25, 2.5), set_area(150, 200)}), "");
  EXPECT_EQ(texts.mission(),
            "OVERLAY o.odl -- map\nSP gate 4 2 OBSTACLE 3 5 2.5 -- disc\nMISSION-AREA 150 200\nUNIT <u> "
            "ROBOT\nCOMMAND LIST:\n 0. UNIT u START gate\n");
  EXPECT_EQ(texts.map().mission_area().width, 150.0);
  MapChange obstacle;
  obstacle.set_remove_obstacle(0);
  ASSERT_EQ(texts.change({obstacle}), "");
  EXPECT_EQ(texts.mission(),
            "OVERLAY o.odl -- map\nSP gate 4 2 -- disc\nMISSION-AREA 150 200\nUNIT <u> ROBOT\nCOMMAND "
            "LIST:\n 0. UNIT "
            "u START gate\n");
  ASSERT_EQ(texts.change({remove_measure(0)}), "");
  EXPECT_TRUE(texts.mission().starts_with("OVERLAY o.odl -- map\n-- disc\nMISSION-AREA 150 200\n"));
}

TEST(OverlayEdit, SetsTheAreaWhereItIsSaid) {
  MapOfTexts plain("SITE x\n" + kHeader);
  ASSERT_EQ(plain.change({set_area(300, 200.5)}), "");
  EXPECT_EQ(plain.overlay(), "SITE x\nMISSION-AREA 300 200.5\n" + kHeader);
  MapOfTexts twice("MISSION-AREA 1 2 MISSION-AREA 3 4 -- this\n" + kHeader);
  ASSERT_EQ(twice.change({set_area(5, 4)}), "");
  EXPECT_EQ(twice.overlay(), "MISSION-AREA 1 2 MISSION-AREA 5 4 -- this\n" + kHeader);
  MapOfTexts behind_map("MISSION-AREA 1 2\nLOAD-MAP x.map\n" + kHeader);
  ASSERT_EQ(behind_map.change({set_area(5, 4)}), "");
  EXPECT_EQ(behind_map.overlay(), "MISSION-AREA 1 2\nLOAD-MAP x.map\nMISSION-AREA 5 4\n" + kHeader);
}

// ---- random obstacles

TEST(OverlayEdit, CreatesTheHistoricObstacles) {
  MapOfTexts texts("MISSION-AREA 1000 1000\n" + kHeader + "OBSTACLE 5 5 1\n");
  CreateObstacles request;
  request.set_coverage_percent(2);
  request.set_min_radius(6);
  request.set_max_radius(15);
  request.set_replace(true);
  ASSERT_EQ(texts.create(request, 945816576), "");
  const auto expected = overlay::create_obstacles(overlay::Area{1000, 1000}, {2, 6, 15}, 945816576).obstacles;
  ASSERT_EQ(texts.map().obstacles.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(texts.map().obstacles[i].center.x, expected[i].center.x, 0.0051);
    EXPECT_NEAR(texts.map().obstacles[i].radius, expected[i].radius, 0.0051);
  }
  const std::size_t before = texts.map().obstacles.size();
  request.set_replace(false);
  request.set_coverage_percent(4);
  ASSERT_EQ(texts.create(request, 3), "");
  EXPECT_GT(texts.map().obstacles.size(), before);
  request.set_coverage_percent(31);
  EXPECT_NE(texts.create(request, 3), "");
}

TEST(OverlayEdit, PutsObstaclesBehindCreateObstaclesWhichWouldRemoveThem) {
  const std::string mission =
      "OVERLAY o.odl\nSET SEED 5\nCREATE-OBSTACLES -- many\nCOMMAND LIST:\n 0. QUIT\n";
  MapOfTexts texts(mission, {{"o.odl", "ORIGIN 1 1\n" + kHeader}});
  const std::size_t created = texts.map().obstacles.size();
  ASSERT_GT(created, 0U);
  MapChange obstacle;
  obstacle.mutable_add_obstacle()->set_x(500);
  obstacle.mutable_add_obstacle()->set_y(500);
  obstacle.mutable_add_obstacle()->set_radius(4);
  ASSERT_EQ(texts.change({obstacle}), "");
  EXPECT_EQ(
      texts.mission(),
      "OVERLAY o.odl\nSET SEED 5\nCREATE-OBSTACLES -- many\nOBSTACLE 499 499 4\nCOMMAND LIST:\n 0. QUIT\n");
  EXPECT_EQ(texts.map().obstacles.size(), created + 1);
  EXPECT_EQ(texts.scene().obstacles(0).radius(), 4.0);
  EXPECT_NE(texts.change({move_obstacle(1, 5, 5, 5)}), "");
  CreateObstacles request;
  request.set_coverage_percent(1);
  request.set_min_radius(5);
  request.set_max_radius(8);
  request.set_replace(true);
  ASSERT_EQ(texts.create(request, 9), "");
  EXPECT_EQ(texts.mission(), "OVERLAY o.odl\nSET SEED 5\n-- many\nCOMMAND LIST:\n 0. QUIT\n");
  EXPECT_EQ(texts.scene().obstacles(0).document(), "o.odl");
}

}  // namespace
}  // namespace mlab::console
