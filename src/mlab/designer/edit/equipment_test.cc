#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/testing/drawn_text.h"

namespace mlab::designer {
namespace {

using testing::DrawnText;

std::string forage_file() {
  std::ifstream in(base::source_folder() + std::string("/missions/forage/forager.cdl"));
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

Drawing drawn_page(const DrawnText& text, const std::string& page) {
  return draw(text.model(), page, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }});
}

Node node_of(const Drawing& drawing, const std::string& name) {
  for (const Node& node : drawing.nodes()) {
    if (node.name() == name) return node;
  }
  ADD_FAILURE() << "no node " << name << " on\n" << drawing.DebugString();
  return {};
}

Port input_of(const Node& node, const std::string& name) {
  for (const Port& port : node.inputs()) {
    if (port.name() == name) return port;
  }
  ADD_FAILURE() << "no input " << name << " of\n" << node.DebugString();
  return {};
}

bool has_port(const Node& node, const std::string& name) {
  return std::ranges::any_of(node.inputs(), [&](const Port& port) { return port.name() == name; });
}

void set_device(SetDevice& change, const std::string& owner, const std::string& device,
                const std::string& binds, const std::string& component) {
  change.set_owner(owner);
  change.set_device(device);
  if (!binds.empty()) change.set_binds(binds);
  if (!component.empty()) change.set_component(component);
}

void device(DrawnText& text, const std::string& owner, const std::string& name, const std::string& binds,
            const std::string& component) {
  text.change(
      [&](Change& change) { set_device(*change.mutable_set_device(), owner, name, binds, component); });
}

std::string why_no_device(const DrawnText& text, const std::string& owner, const std::string& name,
                          const std::string& binds, const std::string& component) {
  return text.refused([&](Edit& edit) {
    set_device(*edit.add_changes()->mutable_set_device(), owner, name, binds, component);
  });
}

void describe(DrawnText& text, const std::string& page, const std::string& words) {
  text.change([&](Change& change) {
    change.mutable_set_help()->set_page(page);
    change.mutable_set_help()->set_text(words);
  });
}

void member(DrawnText& text, const std::string& society, const std::vector<std::uint32_t>& path,
            const std::string& name, std::uint32_t count, const std::string& by = "") {
  text.change([&](Change& change) {
    SetMember& one = *change.mutable_set_member();
    one.set_society(society);
    for (const std::uint32_t at : path) one.add_path(at);
    one.set_name(name);
    one.set_count(count);
    one.set_by(by);
  });
}

void group(DrawnText& text, const std::vector<std::uint32_t>& members) {
  text.change([&](Change& change) {
    change.mutable_group_members()->set_society("S");
    for (const std::uint32_t at : members) change.mutable_group_members()->add_members(at);
  });
}

void ungroup(DrawnText& text, const std::vector<std::uint32_t>& path) {
  text.change([&](Change& change) {
    change.mutable_ungroup_members()->set_society("S");
    for (const std::uint32_t at : path) change.mutable_ungroup_members()->add_path(at);
  });
}

void move(DrawnText& text, const std::vector<std::uint32_t>& path, const std::vector<std::uint32_t>& into,
          std::uint32_t index) {
  text.change([&](Change& change) {
    MoveMember& one = *change.mutable_move_member();
    one.set_society("S");
    for (const std::uint32_t at : path) one.add_path(at);
    for (const std::uint32_t at : into) one.add_into(at);
    one.set_index(index);
  });
}

void set_value(DrawnText& text, const std::string& page, const std::string& node, const std::string& port,
               const std::string& value) {
  text.set(page, node, port, value);
}

std::string why_no_value(const DrawnText& text, const std::string& page, const std::string& node,
                         const std::string& port, const std::string& value) {
  return text.refused([&](Edit& edit) {
    SetValue& one = *edit.add_changes()->mutable_set_value();
    one.set_page(page);
    one.set_node(node);
    one.set_port(port);
    one.set_value(value);
  });
}

// The skills of the foragers are there; their body, robot and society are drawn, and come out word for word.
TEST(Equipment, BuildsFigures9And10WithoutText) {
  const std::string whole = forage_file();
  const std::size_t bodies = whole.find("/// What the foragers are");
  ASSERT_NE(bodies, std::string::npos);
  DrawnText text(whole.substr(0, bodies));
  text.declare("class", "Collector");
  describe(text, "Collector",
           "What the foragers are: a body that moves to all sides, and a camera that turns.");
  text.change([](Change& change) {
    SetParameter& one = *change.mutable_set_parameter();
    one.set_owner("Collector");
    one.set_name("speed");
    one.set_type("speed");
    one.set_initial("1 m/s");
    one.set_low("0");
    one.set_high("5");
  });
  const std::pair<const char*, std::pair<const char*, const char*>> kDevices[] = {
      {"ring", {"sense_obstacles", "DetectObstacles"}},
      {"radio", {"sense_robots", "DetectRobots"}},
      {"camera", {"sense_objects", "DetectObjects"}},
      {"choice", {"choose_target", "ClosestObject"}},
      {"base", {"movement", "Drive"}},
  };
  for (const auto& [name, serves] : kDevices) {
    device(text, "Collector", "", serves.first, serves.second);
    const Drawing page = drawn_page(text, "Collector");
    text.rename("Collector", page.equipment().devices().rbegin()->name(), name);
  }
  set_value(text, "Collector", "base", "base_velocity", "speed");
  set_value(text, "Collector", "base", "max_velocity", "speed");

  text.declare("robot", "Forager");
  describe(text, "Forager", "The complete configuration of one robot (Figure 9).");
  text.parameter("Forager", "attractor", "object_class", "Mine");
  text.change([](Change& change) {
    change.mutable_set_class()->set_robot("Forager");
    change.mutable_set_class()->set_class_name("Collector");
  });
  text.place("Forager", "Forage");
  text.set("Forager", "Forage", "attractor", "attractor");
  text.connect("Forager", "Forage", "$movement", "");

  text.declare("society", "Foragers");
  describe(text, "Foragers", "The society (Figure 10).");
  member(text, "Foragers", {}, "Forager", 3, "DistinctTargets");
  EXPECT_EQ(text.text(), whole);
  EXPECT_EQ(text.errors(), "");
}

TEST(Equipment, ShowsABodyWithUnitsRangesAndHelp) {
  DrawnText text("class Cart {\n  body { radius = 35 cm; drive = differential; max_turn_rate = 1.5; }\n}\n");
  const Drawing page = drawn_page(text, "Cart");
  EXPECT_EQ(page.kind(), Drawing::CLASS);
  const Port radius = input_of(node_of(page, "$body.body"), "radius");
  EXPECT_EQ(radius.value(), "35 cm");
  EXPECT_EQ(radius.unit(), "m");
  EXPECT_EQ(radius.initial(), "0.2 m");
  EXPECT_EQ(radius.max(), 1000.0);
  EXPECT_NE(radius.help(), "");
  const Node drive = node_of(page, "$body.drive");
  EXPECT_EQ(input_of(drive, "drive").choices_size(), 4);
  EXPECT_EQ(input_of(drive, "max_turn_rate").value(), "1.5 rad/s");  // a bare number is in SI units
  EXPECT_TRUE(has_port(drive, "axle"));
  EXPECT_FALSE(has_port(drive, "max_steer"));                         // cars have it
  EXPECT_FALSE(has_port(node_of(page, "$body.ring"), "ring_range"));  // there is no ring
}

TEST(Equipment, SetsWhatABodyHasInTheUnitOfItsField) {
  DrawnText text("class Cart {\n}\n");
  set_value(text, "Cart", "$body.drive", "max_turn_rate", "90");
  set_value(text, "Cart", "$body.drive", "drive", "car");
  set_value(text, "Cart", "$body.ring", "ring_count", "24");
  set_value(text, "Cart", "$body.body", "radius", "30 cm");
  EXPECT_EQ(text.text(),
            "class Cart {\n  body {\n    max_turn_rate = 90 deg/s;\n    drive = car;\n    ring_count = 24;\n"
            "    radius = 30 cm;\n  }\n}\n");
  EXPECT_EQ(text.errors(), "");
  set_value(text, "Cart", "$body.drive", "max_turn_rate", "");
  EXPECT_EQ(text.text().find("max_turn_rate"), std::string::npos);
  EXPECT_EQ(why_no_value(text, "Cart", "$body.body", "radius", "5 km"), "`radius` is 0.001 .. 1000 m");
  EXPECT_EQ(why_no_value(text, "Cart", "$body.body", "radius", "3 s"), "`radius` is in m");
  EXPECT_EQ(why_no_value(text, "Cart", "$body.drive", "drive", "sideways"), "a body has no drive `sideways`");
  EXPECT_EQ(why_no_value(text, "Cart", "$body.body", "wings", "2"), "a body has no `wings`");
  EXPECT_EQ(why_no_value(text, "Cart", "$body.body", "radius", "Noise()"), "`radius` is a number");
}

TEST(Equipment, MakesANumberOfTheBodyAParameterOfTheClass) {
  DrawnText text("class Cart {\n  body { radius = 30 cm; }\n}\n");
  text.expose("Cart", "$body.body", "radius");
  text.expose("Cart", "$body.drive", "max_turn_rate");
  EXPECT_EQ(text.text(),
            "class Cart(radius: double [m] = 30 cm, max_turn_rate: double [rad/s] = 0 deg/s) {\n  body {\n"
            "    radius = radius;\n    max_turn_rate = max_turn_rate;\n  }\n}\n");
  EXPECT_EQ(text.errors(), "");
  EXPECT_EQ(text.refused([](Edit& edit) {
    RemoveParameter& one = *edit.add_changes()->mutable_remove_parameter();
    one.set_owner("Cart");
    one.set_name("radius");
  }),
            "the body or a device reads `radius`: change that first");
}

TEST(Equipment, SaysWhyAComponentCantServe) {
  DrawnText text("class Cart {\n}\n");
  device(text, "Cart", "", "sense_obstacles", "DetectObstacles");
  EXPECT_EQ(text.text(), "class Cart {\n  sensor obstacles: DetectObstacles() binds sense_obstacles;\n}\n");
  EXPECT_EQ(why_no_device(text, "Cart", "", "sense_robots", "DetectObstacles"),
            "`DetectObstacles` can't serve `sense_robots`: it takes a list of robots, and this is a list of "
            "obstacles");
  EXPECT_EQ(why_no_device(text, "Cart", "", "movement", "DetectObstacles"),
            "`DetectObstacles` can't serve `movement`: it gives a value and moves nothing");
  EXPECT_EQ(why_no_device(text, "Cart", "", "sense_robots", "Drive"),
            "`Drive` can't serve `sense_robots`: it gives nothing");
  EXPECT_EQ(why_no_device(text, "Cart", "", "sense_smoke", "DetectObstacles"),
            "there is no binding point `sense_smoke`");
  EXPECT_EQ(why_no_device(text, "Cart", "nose", "", "DetectObstacles"), "`Cart` has no device `nose`");
  EXPECT_EQ(why_no_device(text, "Nobody", "", "movement", "Drive"), "there is no class or operator `Nobody`");
}

TEST(Equipment, ShowsWhatARobotAsksForAndNothingServes) {
  DrawnText text(
      "class Cart {\n  actuator wheels: Drive() binds movement;\n}\n\nrobot R is Cart {\n  movement = "
      "AvoidStaticObstacles(sense_obstacles(range = 2 m), sphere = 1 m, safety_margin = 0.5 m);\n}\n");
  const Drawing page = drawn_page(text, "Cart");
  const Node open = node_of(page, "$point.sense_obstacles");
  EXPECT_TRUE(open.inputs(0).is_required());
  EXPECT_EQ(open.inputs(0).label(), "nothing serves it");
  const auto wire = std::ranges::find(page.wires(), "wheels", &Wire::to);
  ASSERT_NE(wire, page.wires().end());
  EXPECT_EQ(wire->from(), "$point.movement");
  EXPECT_EQ(page.equipment().robots(0), "R");
  // By a wire from a device that serves something else.
  device(text, "Cart", "", "sense_obstacles", "DetectObstacles");
  const Node served = node_of(drawn_page(text, "Cart"), "$point.sense_obstacles");
  EXPECT_EQ(served.inputs(0).label(), "served by");
  EXPECT_EQ(text.errors(), "");
}

TEST(Equipment, MakesAClassForWhatARobotAsksFor) {
  DrawnText text("robot R {\n  movement = Wander();\n}\n");
  text.change([](Change& change) {
    AddDeclaration& one = *change.mutable_add_declaration();
    one.set_kind("class");
    one.set_name("RBody");
    one.set_robot("R");
  });
  EXPECT_EQ(text.text(),
            "robot R is RBody {\n  movement = Wander();\n}\n\nclass RBody {\n  body { radius = 0.3 m; }\n"
            "  actuator base: DriveAndSpin() binds movement;\n"
            "  sensor obstacles: DetectObstacles() binds sense_obstacles;\n}\n");
  EXPECT_EQ(text.errors(), "");
}

TEST(Equipment, ANewNameOfADeviceIsItsRobotsAsWell) {
  DrawnText text(
      "class Cart {\n  sensor near: DetectObstacles(range = 5 m) binds sense_obstacles;\n  sensor far: "
      "DetectObstacles() binds sense_obstacles;\n  actuator wheels: Drive() binds movement;\n}\n\n"
      "robot R is Cart {\n  use far for sense_obstacles;\n  movement = Wander();\n}\n\n"
      "layout Cart {\n  far 10 20;\n  body.drive 40 40;\n}\n");
  text.rename("Cart", "far", "scanner");
  EXPECT_NE(text.text().find("use scanner for sense_obstacles;"), std::string::npos) << text.text();
  EXPECT_NE(text.text().find("  scanner 10 20;"), std::string::npos) << text.text();
  EXPECT_EQ(node_of(drawn_page(text, "Cart"), "scanner").x(), 10.0);
  EXPECT_EQ(node_of(drawn_page(text, "Cart"), "$body.drive").x(), 40.0);
  text.remove("Cart", {"scanner"});
  EXPECT_EQ(text.text().find("scanner"), std::string::npos) << text.text();
  EXPECT_EQ(text.errors(), "");
  set_value(text, "Cart", "near", "range", "");
  EXPECT_NE(text.text().find("sensor near: DetectObstacles() binds"), std::string::npos) << text.text();
}

TEST(Equipment, AnOperatorServesEachBindingPointOnce) {
  DrawnText text("");
  text.declare("operator", "FarSighted");
  device(text, "FarSighted", "", "sense_objects", "DetectObjects");
  set_value(text, "FarSighted", "sense_objects", "range", "60 m");
  EXPECT_EQ(text.text(), "operator FarSighted {\n  sense_objects = DetectObjects(range = 60 m);\n}\n");
  EXPECT_EQ(why_no_device(text, "FarSighted", "", "sense_objects", "DetectObjects"),
            "`sense_objects` is served already");
  device(text, "FarSighted", "", "sense_robots", "DetectRobots");
  text.remove("FarSighted", {"sense_objects"});
  EXPECT_EQ(text.text(), "operator FarSighted {\n  sense_robots = DetectRobots();\n}\n");
  EXPECT_EQ(text.errors(), "");
}

TEST(Equipment, ABindingPointOfOnesOwn) {
  DrawnText text("");
  text.declare("binding", "sense_water");
  text.parameter("sense_water", "range", "length", "5 m");
  text.change([](Change& change) {
    change.mutable_set_binding()->set_binding("sense_water");
    change.mutable_set_binding()->set_type("Objects");
  });
  EXPECT_EQ(text.text(), "binding sense_water(range: length = 5 m) -> Objects;\n");
  text.declare("class", "Cart");
  device(text, "Cart", "", "sense_water", "DetectObjects");
  const Drawing page = drawn_page(text, "sense_water");
  EXPECT_EQ(page.kind(), Drawing::BINDING);
  EXPECT_EQ(page.equipment().devices(0).owner(), "Cart");
  EXPECT_EQ(page.parameters(0).name(), "range");
  text.change([](Change& change) { change.mutable_set_binding()->set_binding("sense_water"); });
  EXPECT_EQ(text.text().substr(0, 45), "binding sense_water(range: length = 5 m);\n\ncl");
  EXPECT_EQ(text.refused([](Edit& edit) {
    edit.add_changes()->mutable_set_binding()->set_binding("sense_water");
    edit.mutable_changes(0)->mutable_set_binding()->set_type("Wine");
  }),
            "there is no type `Wine`");
}

TEST(Societies, GroupTheirMembersAndTakeThemApart) {
  DrawnText text(
      "robot A is Scout {\n  movement = Stand();\n}\n\nrobot B is Scout {\n  movement = Stand();\n}\n");
  const std::string robots = text.text();
  text.declare("society", "S");
  EXPECT_EQ(text.text(), robots + "\nsociety S: team of 3 A;\n");
  member(text, "S", {1}, "B", 2);
  member(text, "S", {2}, "A", 1, "DistinctTargets");
  group(text, {0, 1});
  EXPECT_EQ(text.text(), robots +
                             "\nsociety S: caste {\n  caste {\n    team of 3 A;\n    team of 2 B;\n  };\n"
                             "  A by DistinctTargets;\n};\n");
  move(text, {1}, {0}, 0);
  EXPECT_EQ(text.text(), robots +
                             "\nsociety S: caste {\n  caste {\n    A by DistinctTargets;\n    team of 3 A;\n"
                             "    team of 2 B;\n  };\n};\n");
  ungroup(text, {0});
  EXPECT_EQ(text.text(), robots +
                             "\nsociety S: caste {\n  A by DistinctTargets;\n  team of 3 A;\n  team of 2 B;\n"
                             "};\n");
  move(text, {2}, {}, 0);
  EXPECT_NE(text.text().find("caste {\n  team of 2 B;\n  A by"), std::string::npos) << text.text();
  EXPECT_EQ(text.errors(), "");
}

TEST(Societies, BeginWithoutARobotAndNeverHoldThemselves) {
  DrawnText text("");
  text.declare("society", "S");
  EXPECT_EQ(text.text(), "society S: caste { };\n");
  text.declare("robot", "A");
  member(text, "S", {0}, "A", 2);
  EXPECT_EQ(text.text().substr(0, 35), "society S: caste {\n  team of 2 A;\n}");
  text.declare("society", "T");
  member(text, "T", {}, "S", 1);
  EXPECT_EQ(text.refused([](Edit& edit) {
    SetMember& one = *edit.add_changes()->mutable_set_member();
    one.set_society("S");
    one.add_path(1);
    one.set_name("T");
  }),
            "`S` would be a part of itself");
  text.change([](Change& change) {
    change.mutable_remove_member()->set_society("S");
    change.mutable_remove_member()->add_path(0);
  });
  EXPECT_EQ(text.text().substr(0, 21), "society S: caste {\n};");
}

}  // namespace
}  // namespace mlab::designer
