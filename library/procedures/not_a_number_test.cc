// A vector that is no number goes on through whatever it passes, up to the robot's action, where it is seen
// and told with the node that made it. What swallowed it would let the robot stand or drive as if all were
// well.

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::library_test {
namespace {

using flow::Behavior;
using flow::Input;
using flow::TypeKind;
using geom::Vector;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// What the robot of a movement that is made of `bad`, an infinite vector, is told to be wrong.
std::string fault_of(const std::string& movement) {
  const auto source =
      std::make_shared<const text::Source>("fault.cdl",
                                           "class Cart { actuator wheels: Drive() binds movement; }\n"
                                           "robot R is Cart {\n"
                                           "  let large = ScaleVector([1e200, 1e200], 1e200);\n"
                                           "  let bad = SubtractVectors(large, large);\n"
                                           "  movement = " +
                                               movement + ";\n}\n");
  text::Diagnostics sink;
  const auto robot = robot::configure(source, "", "", {}, {}, sink);
  if (!robot) return text::render(sink);
  flow::Frame frame = robot->built.program->make_frame();
  const percept::Percepts percepts;
  percept::Action action;
  robot->built.program->step(frame.data(), percepts, action, 1, 1);
  const flow::Port* port = robot->built.program->find_fault(frame.data());
  if (std::isfinite(action.velocity.x + action.velocity.y)) return "nothing is told";
  return port == nullptr ? "no port" : port->path;
}

TEST(NotANumber, IsToldThroughEveryOperatorWithTheNodeThatMadeIt) {
  for (const char* movement : {"bad",
                               "large",
                               "cooperate { bad; }",
                               "cooperate { bad; MoveAhead(); }",
                               "cooperate { MoveAhead(); bad; }",
                               "cooperate { 0.5: bad; 2: large; }",
                               "cooperate { 0: bad; MoveAhead(); }",
                               "compete by priority { bad; }",
                               "compete by priority { bad; MoveAhead(); }",
                               "compete by priority { MoveAhead(); bad; }",
                               "compete by strength { bad; MoveAhead(); }",
                               "compete by strength { MoveAhead(); bad; }",
                               "compete by strength { 0.9: MoveAhead(); 0.1: bad; }",
                               "compete by strength { 0.1: MoveAhead(); 0.9: bad; }",
                               "compete by strength { Length(bad): MoveAhead(); 0.9: Stand(); }",
                               "coordinate by WeightedSum { MoveAhead(); bad; }",
                               "sequence { start A: bad; when Wait(delay = 9 s) goto B; final B: Stand(); }",
                               "select by SumIntegers([1]) { case 1: bad; otherwise: Stand(); }",
                               "ScaleVector(bad, 2)",
                               "ScaleVector(MoveAhead(), Length(bad))",
                               "SubtractVectors(MoveAhead(), bad)",
                               "MoveToGoal(goal = bad)",
                               "MoveTo(goal = bad)",
                               "MoveToGuarded(goal = bad)",
                               "MaintainFormation(offset = bad)",
                               "large + MoveAhead()",
                               "-(bad * 2) / 3",
                               "normalized(bad)",
                               "cooperate { length(large) / 2: MoveAhead(); Stand(); }",
                               "cooperate { Length(large): MoveAhead(); Stand(); }"}) {
    EXPECT_EQ(fault_of(movement), "large") << movement;
  }
  EXPECT_EQ(fault_of("cooperate { MoveAhead(); Stand(); }"), "nothing is told");
  EXPECT_EQ(fault_of("cooperate { 1 / (CountObjects(NoObjects()) * 2) as share: MoveAhead(); }"),
            "movement.gain");
}

bool is_number(const Behavior& behavior, flow::BehaviorProbe& probe) {
  if (behavior.output == nullptr) {
    const Vector v = probe.action.velocity;
    return std::isfinite(v.x + v.y + probe.action.spin);
  }
  return behavior.output->kind != TypeKind::kVector ||
         std::isfinite(probe.output<Vector>().x + probe.output<Vector>().y);
}

// One cycle with `value` as that input, lists with `value` between two others.
flow::BehaviorProbe stepped(const Behavior& behavior, const Input& input, double value) {
  flow::BehaviorProbe probe(behavior);
  for (const Input& one : behavior.inputs) {
    if (one.type->kind == TypeKind::kVector && !one.is_list) probe.set<Vector>(one.name, {3.0, 4.0});
    if (one.type->kind == TypeKind::kVector && one.is_list)
      probe.set_list<Vector>(one.name, {{1, 0}, {0, 2}, {1, 0}});
    if (one.type->kind == TypeKind::kReal && one.default_text.empty() && !one.is_list)
      probe.set<double>(one.name, 1.0);
  }
  const Vector vector{value, value};
  if (input.type->kind == TypeKind::kVector && input.is_list)
    probe.set_list<Vector>(input.name, {{1, 0}, vector, {0, 1}});
  else if (input.type->kind == TypeKind::kVector)
    probe.set<Vector>(input.name, vector);
  else if (input.is_list)
    probe.set_list<double>(input.name, {1.0, value, 1.0});
  else
    probe.set<double>(input.name, value);
  probe.step();
  return probe;
}

// Those that look at a vector only when the order asks for it (a task, a formation), and those of the camera,
// which moves no robot.
const std::set<std::string> kMayKeepSilent = {"ComputeFormationPosition",
                                              "DetectFormationPosition",
                                              "Executive",
                                              "LookAt",
                                              "LookTo",
                                              "PanTilt",
                                              "ReportArrival",
                                              "ReportStatus"};

TEST(NotANumber, ComesOutOfEverySchemaThatItGoesInto) {
  std::size_t tried = 0;
  for (const Behavior* behavior : mlab_library_behaviors()) {
    if (behavior->output != nullptr && behavior->output->kind != TypeKind::kVector) continue;
    for (const Input& input : behavior->inputs) {
      const bool is_vector = input.type->kind == TypeKind::kVector;
      if (!is_vector && !(input.type->kind == TypeKind::kReal && input.is_list)) continue;
      const std::string name = fmt::format("{}.{}", behavior->name, input.name);
      if (kMayKeepSilent.contains(std::string(behavior->name))) continue;
      ++tried;
      for (const double value : {kNaN, kInf, -kInf}) {
        flow::BehaviorProbe probe = stepped(*behavior, input, value);
        EXPECT_FALSE(is_number(*behavior, probe)) << name << " = " << value;
      }
    }
  }
  EXPECT_GT(tried, 10U);
}

}  // namespace
}  // namespace mlab::library_test
