// The configuration of Figures 4 to 9 of GIT-COGSCI-95/02, drawn from an empty canvas.

#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/testing/drawn_text.h"
#include "mlab/designer/testing/wander.h"

namespace mlab::designer {
namespace {

using testing::DrawnText;

void add_state(DrawnText& text, const std::string& name, const std::string& component, double x, double y) {
  text.change([&](Change& change) {
    AddState& state = *change.mutable_add_state();
    state.set_page("Forage");
    state.set_name(name);
    state.set_component(component);
    state.set_x(x);
    state.set_y(y);
  });
}

void help(DrawnText& text, const std::string& page, const std::string& words) {
  text.change([&](Change& change) {
    change.mutable_set_help()->set_page(page);
    change.mutable_set_help()->set_text(words);
  });
}

// Figure 6: three skills; Figure 7: told what to look for and where to bring it.
void draw_skills(DrawnText& text) {
  text.declare("assemblage", "Forage");
  help(text, "Forage", "Finds attractors and brings them home, one at a time.");
  text.place("Forage", "sequence");
  text.connect("Forage", "sequence", "$result", "");
  text.rename("Forage", "Waiting", "Searching");
  text.change([](Change& change) {
    SetState& state = *change.mutable_set_state();
    state.set_page("Forage");
    state.set_state("Searching");
    state.set_is_final(false);
    state.set_member("Wander()");
  });
  text.change([](Change& change) {
    change.mutable_arrange()->set_page("Forage");
    Arrange::At& at = *change.mutable_arrange()->add_nodes();
    at.set_node("Searching");
    at.set_x(40);
    at.set_y(200);
  });
  add_state(text, "Acquiring", "Acquire", 320, 40);
  add_state(text, "Delivering", "Deliver", 320, 360);
  text.expose("Forage.Acquiring", "Acquire", "classes", std::nullopt, "attractor");
  text.expose("Forage.Delivering", "Deliver", "home");
}

// Figure 8: what leads from one to another.
void draw_transitions(DrawnText& text) {
  for (const auto& [from, to, trigger] : {std::tuple("Searching", "Acquiring", "Detect(attractor)"),
                                          std::tuple("Acquiring", "Delivering", "Holding(attractor)"),
                                          std::tuple("Acquiring", "Searching", "not Detect(attractor)"),
                                          std::tuple("Delivering", "Searching", "not Holding(attractor)")}) {
    text.change([&](Change& change) {
      AddTransition& one = *change.mutable_add_transition();
      one.set_page("Forage");
      one.set_from(from);
      one.set_to(to);
      one.set_trigger(trigger);
    });
  }
}

// Figure 9: the configuration of one robot.
void draw_robot(DrawnText& text) {
  text.declare("robot", "Forager");
  text.change([](Change& change) {
    change.mutable_set_class()->set_robot("Forager");
    change.mutable_set_class()->set_class_name("MRV2");
  });
  text.place("Forager", "Forage", 40, 40);
  text.set("Forager", "Forage", "attractor", "Orange");
  text.connect("Forager", "Forage", "$movement", "v");
}

TEST(Forage, IsDrawnFromNothingAsTheReportDoes) {
  DrawnText text("");
  testing::draw_wander(text);
  help(text, "Wander", "Drifts about, towards free space, around whatever is in the way.");
  draw_skills(text);
  draw_transitions(text);
  draw_robot(text);
  EXPECT_EQ(text.text(), R"(/// Drifts about, towards free space, around whatever is in the way.
assemblage Wander(curious: gain = 0.8, cautious: gain = 0.5) {
  let sense_obstacles = sense_obstacles(range = 2 m);
  cooperate {
    curious: Noise(persistence = 10 s);
    cautious: AvoidStaticObstacles(readings = sense_obstacles, sphere = 1 m, safety_margin = 0.5 m);
    curious: Probe(readings = sense_obstacles);
  }
}

/// Finds attractors and brings them home, one at a time.
assemblage Forage(attractor: object_class = Mine, home: object_class = Basket) {
  sequence {
    start Searching: Wander();
      when Detect(attractor) goto Acquiring;
    Acquiring: Acquire(classes = attractor);
      when Holding(attractor) goto Delivering;
      when not Detect(attractor) goto Searching;
    Delivering: Deliver(home = home);
      when not Holding(attractor) goto Searching;
  }
}

robot Forager is MRV2 {
  movement = Forage(attractor = Orange);
}

layout Wander {
  Noise 40 40;
  AvoidStaticObstacles 40 160;
  Probe 40 320;
  sense_obstacles -280 200;
  cooperate 400 160;
}

layout Forage {
  Searching 40 200;
  Acquiring 320 40;
  Delivering 320 360;
}

layout Forager {
  movement 40 40;
}
)");
  EXPECT_EQ(text.errors(), "");
}

TEST(Forage, IsDrawnWithItsStatesAndTheirOrder) {
  DrawnText text("");
  testing::draw_wander(text);
  help(text, "Wander", "Drifts about, towards free space, around whatever is in the way.");
  draw_skills(text);
  draw_transitions(text);
  const Drawing drawing =
      draw(text.model(), "Forage", {"a.cdl", 1, false, [](std::string_view) { return std::string(); }});
  EXPECT_EQ(drawing.kind(), Drawing::STATES);
  ASSERT_EQ(drawing.states_size(), 3);
  EXPECT_TRUE(drawing.states(0).is_start());
  ASSERT_EQ(drawing.transitions_size(), 4);
  EXPECT_EQ(drawing.transitions(1).trigger(), "Holding(attractor)");
  EXPECT_EQ(drawing.transitions(1).index(), 0U);
  EXPECT_EQ(drawing.transitions(2).trigger(), "not Detect(attractor)");
  EXPECT_EQ(drawing.transitions(2).index(), 1U);
}

}  // namespace
}  // namespace mlab::designer
