// Triggers by choosing: what steps of the trigger's builder do to the text, and what its page shows.

#include <gtest/gtest.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/testing/drawn_text.h"

namespace mlab::designer {
namespace {

using testing::DrawnText;

std::string patrol(const std::string& trigger) {
  return "assemblage Patrol(range: length = 5 m) {\n  sequence {\n    start Going: Wander();\n      when " +
         trigger + " goto Resting;\n    Resting: Stand();\n  }\n}\n";
}

ChangeTrigger step(ChangeTrigger::How how, const std::vector<std::uint32_t>& part = {},
                   const std::string& component = "") {
  ChangeTrigger out;
  out.set_page("Patrol");
  out.set_from("Going");
  out.set_how(how);
  out.set_component(component);
  for (const std::uint32_t at : part) out.add_part(at);
  return out;
}

// What a step makes of a trigger.
std::string after(const std::string& trigger, const ChangeTrigger& step) {
  DrawnText text(patrol(trigger));
  text.change([&](Change& change) { *change.mutable_change_trigger() = step; });
  const std::string& now = text.text();
  const std::size_t begin = now.find("when ") + 5;
  EXPECT_EQ(text.errors(), "");
  return now.substr(begin, now.find(" goto") - begin);
}

Drawing drawn(const DrawnText& text, const std::string& page) {
  DrawingContext context;
  context.document_of = [](std::string_view) { return std::string(); };
  return draw(text.model(), page, context);
}

TEST(EditTriggers, AreChosen) {
  EXPECT_EQ(after("Constant(value = false)", step(ChangeTrigger::CHOOSE, {}, "Near")), "Near()");
  EXPECT_EQ(after("Wait() and Detect()", step(ChangeTrigger::CHOOSE, {1}, "Near")), "Wait() and Near()");
}

TEST(EditTriggers, KeepWhatTheOtherOneTakes) {
  EXPECT_EQ(after("Near(Flag, distance = 2 m)", step(ChangeTrigger::CHOOSE, {}, "AwayFrom")),
            "AwayFrom(classes = Flag, distance = 2 m)");
  EXPECT_EQ(after("Near(Flag, distance = 2 m)", step(ChangeTrigger::CHOOSE, {}, "Detect")),
            "Detect(classes = Flag)");
}

TEST(EditTriggers, AreJoined) {
  EXPECT_EQ(after("Near()", step(ChangeTrigger::AND, {}, "Wait")), "Near() and Wait()");
  EXPECT_EQ(after("Near()", step(ChangeTrigger::OR, {}, "Wait")), "Near() or Wait()");
  // One more of the same kind is one more operand, wherever it was asked for.
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::AND, {}, "Detect")),
            "Near() and Wait() and Detect()");
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::AND, {0}, "Detect")),
            "Near() and Detect() and Wait()");
  // What binds less gets its parentheses.
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::OR, {1}, "Detect")),
            "Near() and (Wait() or Detect())");
  EXPECT_EQ(after("Near() or Wait()", step(ChangeTrigger::AND, {}, "Detect")),
            "(Near() or Wait()) and Detect()");
}

TEST(EditTriggers, AreNegated) {
  EXPECT_EQ(after("Near()", step(ChangeTrigger::NOT)), "not Near()");
  EXPECT_EQ(after("not Near()", step(ChangeTrigger::NOT)), "Near()");
  EXPECT_EQ(after("not Near()", step(ChangeTrigger::NOT, {0})), "Near()");
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::NOT, {1})), "Near() and not Wait()");
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::NOT)), "not (Near() and Wait())");
}

TEST(EditTriggers, AreSwitchedBetweenAndAndOr) {
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::SWITCH)), "Near() or Wait()");
  EXPECT_EQ(after("Near() and (Wait() or Detect())", step(ChangeTrigger::SWITCH)),
            "Near() or Wait() or Detect()");
}

TEST(EditTriggers, HoldNoAndInAnAnd) {
  EXPECT_EQ(after("Near() and (Wait() or Detect())", step(ChangeTrigger::SWITCH, {1})),
            "Near() and Wait() and Detect()");
  EXPECT_EQ(after("Near() and (Wait() or Detect() and IsHalted())", step(ChangeTrigger::REMOVE, {1, 0})),
            "Near() and Detect() and IsHalted()");
  EXPECT_EQ(after("Near() or not (Wait() or Detect())", step(ChangeTrigger::NOT, {1})),
            "Near() or Wait() or Detect()");
  EXPECT_EQ(after("Near() and not (Wait() or Detect())", step(ChangeTrigger::NOT, {1})),
            "Near() and (Wait() or Detect())");
}

TEST(EditTriggers, AreTakenAway) {
  EXPECT_EQ(after("Near()", step(ChangeTrigger::REMOVE)), "Constant(value = false)");
  EXPECT_EQ(after("not Near()", step(ChangeTrigger::REMOVE, {0})), "Constant(value = false)");
  EXPECT_EQ(after("Near() and Wait()", step(ChangeTrigger::REMOVE, {0})), "Wait()");
  EXPECT_EQ(after("Near() and not Wait()", step(ChangeTrigger::REMOVE, {1, 0})), "Near()");
  EXPECT_EQ(after("Near() and Wait() and Detect()", step(ChangeTrigger::REMOVE, {1})), "Near() and Detect()");
}

TEST(EditTriggers, RefuseWhatGivesNoTruthValue) {
  const DrawnText text(patrol("Near()"));
  const auto why = [&](const ChangeTrigger& step) {
    return text.refused([&](Edit& edit) { *edit.add_changes()->mutable_change_trigger() = step; });
  };
  EXPECT_EQ(why(step(ChangeTrigger::AND, {}, "Wander")), "`Wander` is no trigger: it gives no truth value");
  EXPECT_EQ(why(step(ChangeTrigger::AND, {}, "Nowhere")), "nothing answers to `Nowhere`");
  EXPECT_EQ(why(step(ChangeTrigger::NOT, {3})), "that part of the trigger has gone");
  EXPECT_EQ(why(step(ChangeTrigger::SWITCH)), "only `and` becomes `or`, and the other way round");
  ChangeTrigger gone = step(ChangeTrigger::NOT);
  gone.set_index(4);
  EXPECT_EQ(why(gone), "the transition has gone");
}

TEST(EditTriggers, HaveAPageWithTheirInputs) {
  DrawnText text(patrol("Near(distance = range) and not IsAtGoal(DetectGoal([1 m, 2 m]))"));
  const Drawing page = drawn(text, "Patrol/Going/0");
  EXPECT_EQ(page.kind(), Drawing::DATAFLOW);
  std::string nodes;
  for (const Node& node : page.nodes()) nodes += node.name() + " ";
  EXPECT_EQ(
      nodes,
      "Going.And Going.And.Near Going.And.Not Going.And.Not.IsAtGoal Going.And.Not.IsAtGoal.DetectGoal ");
  EXPECT_EQ(page.result_node(), "Going.And");
  const Node& near = page.nodes(1);
  EXPECT_EQ(near.component(), "Near");
  ASSERT_EQ(near.inputs_size(), 2);
  EXPECT_EQ(near.inputs(1).name(), "distance");
  EXPECT_EQ(near.inputs(1).unit(), "m");
  EXPECT_EQ(near.inputs(1).min(), 0.0);
  EXPECT_EQ(near.inputs(1).value(), "range");
  EXPECT_TRUE(near.inputs(1).is_exposed());
  EXPECT_EQ(drawn(text, "Patrol/Going/1").nodes_size(), 0);
  EXPECT_EQ(drawn(text, "Patrol/Nowhere/0").nodes_size(), 0);
  EXPECT_EQ(drawn(text, "Patrol/Going/x").nodes_size(), 0);
}

TEST(EditTriggers, HaveAPageWhereTheyAreNegatedAsAWhole) {
  const Drawing page = drawn(DrawnText(patrol("not Near()")), "Patrol/Going/0");
  ASSERT_EQ(page.nodes_size(), 2);
  EXPECT_EQ(page.result_node(), page.nodes(0).name());
  EXPECT_EQ(page.nodes(0).component(), "not");
}

TEST(EditTriggers, InputsAreSetAsThoseOfANode) {
  DrawnText text(patrol("Near() or IsAtGoal()"));
  const std::string page = "Patrol/Going/0";
  text.set(page, "Going.Or.Near", "distance", "3 m");
  EXPECT_NE(text.text().find("when Near(distance = 3 m) or IsAtGoal()"), std::string::npos) << text.text();
  text.change([&](Change& change) {
    Place& place = *change.mutable_place();
    place.set_page(page);
    place.set_component("DetectGoal");
    place.set_to_node("Going.Or.IsAtGoal");
    place.set_to_port("goal");
  });
  EXPECT_NE(text.text().find("or IsAtGoal(goal = DetectGoal()) goto"), std::string::npos) << text.text();
  // What is taken away is not kept: it would be drawn nowhere.
  text.disconnect(page, "Going.Or.IsAtGoal", "goal");
  EXPECT_NE(text.text().find("or IsAtGoal() goto"), std::string::npos) << text.text();
  EXPECT_EQ(text.text().find("let "), std::string::npos) << text.text();
  text.set(page, "Going.Or.Near", "distance", "");
  EXPECT_EQ(text.text(), patrol("Near() or IsAtGoal()"));
}

TEST(EditTriggers, HaveTheirProblems) {
  Model model(DrawnText(patrol("Near(distance = 2 s)")).model().source(), robot::library_environment());
  model.check();
  DrawingContext context;
  context.document_of = [](std::string_view) { return std::string(); };
  std::string nodes;
  for (const text::Diagnostic& one : model.problems().items()) {
    if (one.severity == text::Severity::kError) nodes += problem_of(one, model, context).node() + " ";
  }
  EXPECT_EQ(nodes, "Going/0 ");
}

TEST(EditTriggers, FitOnlyWhatGivesATruthValue) {
  const DrawnText text(patrol("Near()"));
  Fits request;
  request.set_page("Patrol/Going/0");
  request.set_to_node("$result");
  const FitList list = fitting(text.model(), request, {});
  const auto reason = [&](const std::string& name) -> std::string {
    for (const FitList::Fit& fit : list.fits())
      if (fit.port() == "component" && fit.node() == name) return fit.reason();
    return "not offered";
  };
  EXPECT_EQ(reason("Near"), "");
  EXPECT_NE(reason("Wander"), "");
}

}  // namespace
}  // namespace mlab::designer
