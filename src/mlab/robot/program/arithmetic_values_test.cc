// What formulas of configurations come to, by the procedures of the library.

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::robot {
namespace {

constexpr double kNothing = -9999.0;

// A robot with a slider of each sort, and `x` as the gain of its movement.
std::string robot_with(const std::string& x) {
  return "class Cart { actuator wheels: Drive() binds movement; }\n"
         "robot R(near: length = 2 m, fast: speed = 3 m/s, turn: angle [deg] = 90 deg, many: int = 7,\n"
         "        home: Point = [3 m, 4 m]) is Cart {\n"
         "  let way = SubtractVectors([6, 8], [3, 4]);\n"
         "  let metres = DetectGoal(home);\n"
         "  let x = " +
         x +
         ";\n"
         "  movement = cooperate { x: MoveAhead(); 0 * length(way + metres) / 1 m: MoveAhead();\n"
         "    0 * (fast * 1 s / near + turn / 1 rad + many): Stand(); };\n}\n";
}

std::optional<ConfiguredRobot> formula_robot(const std::string& text, text::Diagnostics& sink) {
  const auto source = std::make_shared<const text::Source>("a.cdl", text);
  return configure(source, "", "", {}, {}, sink);
}

// What the robot moves with, which is `x`.
double value_of(const std::string& x) {
  text::Diagnostics sink;
  const auto robot = formula_robot(robot_with(x), sink);
  EXPECT_TRUE(robot) << x << "\n" << text::render(sink);
  if (!robot) return kNothing;
  flow::Frame frame = robot->built.program->make_frame();
  percept::Action action;
  robot->built.program->step(frame.data(), {}, action, 1, 1);
  const flow::Port* movement = robot->built.program->find("movement");
  return movement == nullptr ? kNothing : flow::Program::number(frame.data(), *movement).value_or(kNothing);
}

double truth_of(const std::string& x) {
  return value_of("select by " + x + " { case true: 1; otherwise: 0; }");
}

TEST(Formulas, AreFoldedWhereAllIsConstant) {
  EXPECT_EQ(value_of("1 + 2 * 3 - 4 / 8"), 6.5);
  EXPECT_EQ(value_of("-(1 - 3)"), 2.0);
  EXPECT_EQ(value_of("(50 cm + 1 m) / 1 m"), 1.5);
  EXPECT_EQ(value_of("(50 cm + 50 cm) / 1 cm"), 100.0);
  EXPECT_EQ(value_of("36 km/h * 2 s / 10 m"), 2.0);
  EXPECT_EQ(value_of("min(3, 2) + max(3, 2) + abs(-1) + clamp(9, 0, 5)"), 11.0);
  EXPECT_DOUBLE_EQ(value_of("180 deg / 1 rad"), std::numbers::pi);
  text::Diagnostics sink;
  const auto robot = formula_robot(robot_with("1 + 2 * 3"), sink);
  ASSERT_TRUE(robot);
  for (const flow::Node& node : robot->lowered.network.nodes) EXPECT_NE(node.name, "x");
}

TEST(Formulas, AreComputedOfSlidersAndNodes) {
  EXPECT_EQ(value_of("near / 1 m"), 2.0);
  EXPECT_EQ(value_of("2 * near * fast * 1 s / 1 m / 1 m + 1"), 13.0);
  EXPECT_EQ(value_of("fast * 3 s / near"), 4.5);
  EXPECT_EQ(value_of("-near / 1 m + 3"), 1.0);
  EXPECT_EQ(value_of("many * 2 - 1"), 13.0);
  EXPECT_EQ(value_of("length(way)"), 5.0);
  EXPECT_EQ(value_of("length(way * 2 + [3, 4] - way)"), 10.0);
  EXPECT_EQ(value_of("length(-way / 2)"), 2.5);
  EXPECT_EQ(value_of("length(metres) / near"), 2.5);
  EXPECT_EQ(value_of("distance(home, [0, 0]) / 1 m"), 5.0);
  EXPECT_EQ(value_of("distance(way, [0, 4])"), 3.0);
  EXPECT_EQ(value_of("length(normalized(way))"), 1.0);
  EXPECT_DOUBLE_EQ(value_of("direction([0, 1] * near) / 1 rad"), std::numbers::pi / 2.0);
}

TEST(Formulas, CountAnglesInRadiansWhateverTheirSlidersCountIn) {
  EXPECT_DOUBLE_EQ(value_of("turn / 1 rad"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(value_of("(turn + 90 deg) / 1 rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(value_of("max(turn, 10 deg) / 1 rad"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(value_of("turn / 1 deg"), 90.0);
  // Behind a formula an angle stays one: who counts in degrees gets them.
  EXPECT_EQ(truth_of("2 * turn > 179 deg and 2 * turn < 181 deg"), 1.0);
}

TEST(Formulas, Compare) {
  EXPECT_EQ(truth_of("near < 3 m"), 1.0);
  EXPECT_EQ(truth_of("near > 300 cm"), 0.0);
  EXPECT_EQ(truth_of("near >= 2 m and near <= 2 m and near == 2 m"), 1.0);
  EXPECT_EQ(truth_of("many != 7"), 0.0);
  EXPECT_EQ(truth_of("not many > 6"), 0.0);
}

TEST(Formulas, NameTheirNodesAsTheyAreWritten) {
  text::Diagnostics sink;
  const auto robot = formula_robot(robot_with("near / 1 m + 2 * many - length(way)"), sink);
  ASSERT_TRUE(robot) << text::render(sink);
  std::set<std::string> names;
  for (const flow::Node& node : robot->lowered.network.nodes) names.insert(node.name);
  for (const char* name : {"x", "x.Divide", "x.Multiply", "x.Add", "x.length"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Formulas, OfAnAssemblageAreThoseOfItsInstance) {
  text::Diagnostics sink;
  const auto robot = formula_robot(
      "class Cart { actuator wheels: Drive() binds movement; }\n"
      "assemblage Half(of: length, share: gain = 1 / 2) { cooperate { share * of / 1 m: MoveAhead(); } }\n"
      "robot R() is Cart { movement = Half(2 * 3 m); }\n",
      sink);
  ASSERT_TRUE(robot) << text::render(sink);
  flow::Frame frame = robot->built.program->make_frame();
  percept::Action action;
  robot->built.program->step(frame.data(), {}, action, 1, 1);
  EXPECT_EQ(flow::Program::number(frame.data(), *robot->built.program->find("movement")), 3.0);
}

// What a robot moves with that calls `A`, declared as said, with this.
double movement_of(const std::string& declared, const std::string& called) {
  text::Diagnostics sink;
  const auto robot =
      formula_robot("class Cart { actuator wheels: Drive() binds movement; }\n" + declared +
                        "robot R(turn: angle [deg] = 90 deg, round: angle = 1 rad, many: int = 7) is Cart {\n"
                        "  movement = " +
                        called + ";\n}\n",
                    sink);
  EXPECT_TRUE(robot) << declared << "\n" << text::render(sink);
  if (!robot) return kNothing;
  flow::Frame frame = robot->built.program->make_frame();
  percept::Action action;
  robot->built.program->step(frame.data(), {}, action, 1, 1);
  const flow::Port* movement = robot->built.program->find("movement");
  return movement == nullptr ? kNothing : flow::Program::number(frame.data(), *movement).value_or(kNothing);
}

TEST(Formulas, OfAnAssemblageTakeAnglesHoweverTheirCallerCountsThem) {
  EXPECT_DOUBLE_EQ(
      movement_of("assemblage A(x: angle) { cooperate { x * 2 / 1 rad: MoveAhead(); } }\n", "A(turn)"),
      std::numbers::pi);
  EXPECT_DOUBLE_EQ(
      movement_of("assemblage A(x: angle) { cooperate { (x + x + 90 deg) / 2 rad: MoveAhead(); } }\n",
                  "A(turn)"),
      0.75 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(
      movement_of("assemblage A(x: angle) { cooperate { max(x, x) / 1 rad: MoveAhead(); } }\n", "A(turn)"),
      std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(
      movement_of("assemblage A(x: angle [deg]) { cooperate { x * 2 / 2 rad: MoveAhead(); } }\n", "A(round)"),
      1.0);
}

TEST(Formulas, TakeTheUnitThatIsDeclaredForWhatHasNone) {
  EXPECT_EQ(
      movement_of("assemblage A(x: length) { cooperate { (x + 1 m) / 1 m: MoveAhead(); } }\n", "A(many)"),
      8.0);
}

TEST(Formulas, KeepTheUnitOfAResultThatIsDeclared) {
  EXPECT_EQ(movement_of("assemblage Far(n: int) -> length { n * 2 }\n"
                        "assemblage A(n: int) { cooperate { (Far(n) + 1 m) / 1 m: MoveAhead(); } }\n",
                        "A(many)"),
            15.0);
}

TEST(Formulas, RefuseAnAngleThatNobodyKnowsTheUnitOf) {
  text::Diagnostics sink;
  EXPECT_FALSE(
      formula_robot("class Cart { actuator wheels: Drive() binds movement; }\n"
                    "assemblage A(x: angle [deg]) { cooperate { x / 1 rad: MoveAhead(); } }\n"
                    "robot R(many: int = 7) is Cart { movement = A(many); }\n",
                    sink));
  EXPECT_NE(text::render(sink).find("a plain number that is declared in deg can't be converted"),
            std::string::npos)
      << text::render(sink);
}

// Divided by zero it is no number, and stays none whatever limits it: the robot stops for the fault.
TEST(Formulas, StopTheRobotThatMovesByADivisionByZero) {
  for (const char* x :
       {"1 m / (near - near)", "min(1 m / (near - near), 0.5)", "max(-1 m / (near - near), 0.5)",
        "clamp(1 m / (near - near), 0, 0.5)", "clamp(0.5, 0, 1 m / (near - near))"}) {
    text::Diagnostics sink;
    const auto robot = formula_robot(robot_with(x), sink);
    ASSERT_TRUE(robot) << text::render(sink);
    flow::Frame frame = robot->built.program->make_frame();
    percept::Action action;
    robot->built.program->step(frame.data(), {}, action, 1, 1);
    EXPECT_FALSE(std::isfinite(action.velocity.x)) << x << " moves it with " << action.velocity.x;
  }
}

TEST(NamedPlaces, CanNotBeSaidInCnl) {
  text::Diagnostics sink;
  const auto robot = formula_robot(
      "class Cart { actuator wheels: Drive() binds movement; }\n"
      "robot R(home: Point = place(\"Gate\"), at: Point = [1, 2]) is Cart {\n"
      "  movement = cooperate { MoveToGoal(DetectGoal(home)); MoveToGoal(DetectGoal(at)); };\n}\n",
      sink);
  ASSERT_TRUE(robot) << text::render(sink);
  cdl::check_for_cnl(robot->lowered.network, sink);
  ASSERT_EQ(sink.error_count(), 1U);
  EXPECT_NE(text::render(sink).find("a.cdl:2:23: error: `Gate` is a place of the mission's overlay"),
            std::string::npos)
      << text::render(sink);
}

TEST(NamedPlaces, AreParametersOfTheNetwork) {
  text::Diagnostics sink;
  const auto robot = formula_robot(
      "class Cart { actuator wheels: Drive() binds movement; }\n"
      "robot R(home: Point = place(\"Gate\")) is Cart {\n"
      "  movement = cooperate { MoveToGoal(DetectGoal(home)); MoveToGoal(DetectGoal(place(\"Old Mill\")));\n"
      "    MoveToGoal(DetectGoal(place(\"Old Mill\"))); MoveToGoal(DetectGoal(place(\"Old-Mill\"))); };\n}\n",
      sink);
  ASSERT_TRUE(robot) << text::render(sink);
  std::string told;
  for (const flow::Parameter& one : robot->lowered.network.parameters)
    told += one.name + "=" + one.place_name.text + " ";
  EXPECT_EQ(told, "home=Gate place_Old_Mill=Old Mill place_Old_Mill_2=Old-Mill ");
}

}  // namespace
}  // namespace mlab::robot
