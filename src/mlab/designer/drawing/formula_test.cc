#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/testing/drawn_text.h"

namespace mlab::designer {
namespace {

using testing::DrawnText;

Drawing drawing_of(const DrawnText& text, const std::string& page) {
  return draw(text.model(), page, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }});
}

const Node* find_node(const Drawing& drawing, std::string_view name) {
  const auto found = std::ranges::find(drawing.nodes(), name, &Node::name);
  return found == drawing.nodes().end() ? nullptr : &*found;
}

// `from -> to.port`, one after the other.
std::string wires_of(const Drawing& drawing) {
  std::string out;
  for (const Wire& wire : drawing.wires()) out += wire.from() + "->" + wire.to() + "." + wire.port() + " ";
  return out;
}

constexpr const char* kGoTo =
    "assemblage GoTo(goal: Point, near: length = 2 m) {\n"
    "  let way = DetectGoal(goal);\n"
    "  let how = length(way) / (3 * near) + length(NotifiedPlace());\n"
    "  cooperate {\n    2 * 0.5: MoveToGoal(way);\n    how: Stand();\n  }\n}\n";

TEST(Formula, IsOneBoxWithItsWordsAndAWireFromEachNodeThatItReads) {
  const DrawnText text(kGoTo);
  const Drawing drawing = drawing_of(text, "GoTo");
  const Node* how = find_node(drawing, "how");
  ASSERT_NE(how, nullptr) << drawing.DebugString();
  EXPECT_EQ(how->shape(), Node::FORMULA);
  ASSERT_EQ(how->inputs_size(), 3);
  EXPECT_EQ(how->inputs(0).name(), "formula");
  EXPECT_EQ(how->inputs(0).value(), "length(way) / (3 * near) + length(NotifiedPlace())");
  EXPECT_EQ(how->inputs(1).name(), "way");
  EXPECT_EQ(how->inputs(2).name(), "NotifiedPlace");
  const std::string wires = wires_of(drawing);
  EXPECT_NE(wires.find("way->how.way "), std::string::npos) << wires;
  EXPECT_NE(wires.find("->how.NotifiedPlace "), std::string::npos) << wires;
}

TEST(Formula, OfConstantsAndParametersIsAField) {
  const DrawnText text(kGoTo);
  const Drawing drawing = drawing_of(text, "GoTo");
  const Node* sum = find_node(drawing, "cooperate");
  ASSERT_NE(sum, nullptr);
  EXPECT_EQ(sum->inputs(0).weight(), "2 * 0.5");
  EXPECT_EQ(find_node(drawing, "cooperate.gain"), nullptr);
}

TEST(Formula, IsTypedIntoItsField) {
  DrawnText text(kGoTo);
  text.set("GoTo", "how", "formula", "length(way) / near");
  EXPECT_NE(text.text().find("let how = length(way) / near;"), std::string::npos) << text.text();
  EXPECT_EQ(find_node(drawing_of(text, "GoTo"), "how")->inputs_size(), 2);
}

TEST(Formula, ReadsAnotherNodeWhereOneIsConnected) {
  DrawnText text(kGoTo);
  text.place("GoTo", "ClosestObstacle");
  text.connect("GoTo", "ClosestObstacle", "how", "way");
  EXPECT_NE(text.text().find("length(ClosestObstacle()) / (3 * near)"), std::string::npos) << text.text();
  text.disconnect("GoTo", "how", "ClosestObstacle");
  EXPECT_NE(text.text().find("length([0, 0]) / (3 * near)"), std::string::npos) << text.text();
}

TEST(Formula, KeepsTheUnitOfWhatIsTakenFromItWhateverItIs) {
  const auto without_way = [](const std::string& way) {
    DrawnText text(
        "assemblage A(near: length = 2 m, wait: duration = 1 s, turn: angle = 1 rad) {\n  let way = " + way +
        ";\n  let how = way / near + 2 * way / near;\n  cooperate { how / how: Stand(); }\n}\n");
    text.disconnect("A", "how", "way");
    return text.text().substr(text.text().find("let how"),
                              text.text().find(";\n  cooperate") - text.text().find("let how"));
  };
  EXPECT_EQ(without_way("near * near"), "let how = (0 * 1 m * 1 m) / near + 2 * way / near");
  EXPECT_EQ(without_way("near / wait"), "let how = 0 m/s / near + 2 * way / near");
  EXPECT_EQ(without_way("near / wait / wait"), "let how = (0 * 1 m / 1 s / 1 s) / near + 2 * way / near");
  EXPECT_EQ(without_way("1 / wait"), "let how = (0 / 1 s) / near + 2 * way / near");
  EXPECT_EQ(without_way("turn * near"), "let how = (0 * 1 m * 1 rad) / near + 2 * way / near");
}

TEST(Formula, IsPlacedAndThenTyped) {
  DrawnText text("assemblage A(way: Vector [m]) {\n}\n");
  text.place("A", "formula");
  const Drawing placed = drawing_of(text, "A");
  ASSERT_EQ(placed.nodes_size(), 2) << text.text();
  const std::string name = placed.nodes(1).name();
  text.set("A", name, placed.nodes(1).inputs(0).name(), "length(way) < 3 m");
  const Node* formula = nullptr;
  const Drawing typed = drawing_of(text, "A");
  formula = find_node(typed, name);
  ASSERT_NE(formula, nullptr) << text.text();
  EXPECT_EQ(formula->shape(), Node::FORMULA);
  EXPECT_EQ(formula->type(), "bool");
  EXPECT_NE(wires_of(typed).find("way->" + name + ".way"), std::string::npos);
}

TEST(Formula, IsChosenAsATriggerAndThenTyped) {
  DrawnText text(
      "assemblage A(way: Vector [m]) {\n  sequence {\n    start Go: Stand();\n"
      "      when Constant(value = false) goto Back;\n    final Back: Stand();\n  }\n}\n");
  text.change([](Change& change) {
    ChangeTrigger& one = *change.mutable_change_trigger();
    one.set_page("A");
    one.set_from("Go");
    one.set_how(ChangeTrigger::CHOOSE);
    one.set_component("comparison");
  });
  EXPECT_NE(text.text().find("when 0 < 1 goto Back;"), std::string::npos) << text.text();
}

TEST(Formula, OfATriggerIsDrawnOnItsPage) {
  const DrawnText text(
      "assemblage A(way: Vector [m], many: count = 3) {\n  sequence {\n    start Go: Stand();\n"
      "      when length(way) < 3 m goto Back;\n    Back: Stand();\n      when many > 2 goto Go;\n  }\n}\n");
  const Drawing states = drawing_of(text, "A");
  ASSERT_EQ(states.transitions_size(), 2);
  EXPECT_EQ(states.transitions(0).trigger(), "length(way) < 3 m");
  ASSERT_EQ(states.transitions(0).conditions_size(), 1);
  EXPECT_EQ(states.transitions(0).conditions(0).live(), "Go.Less");
}

}  // namespace
}  // namespace mlab::designer
