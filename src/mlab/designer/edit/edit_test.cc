#include "mlab/designer/edit/edit.h"

#include <fstream>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/testing/drawn_text.h"
#include "mlab/designer/testing/wander.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

using testing::DrawnText;

TEST(Edit, BuildsTheWanderOfFigure4) {
  DrawnText text("");
  testing::draw_wander(text);
  EXPECT_EQ(text.text(), R"(assemblage Wander(curious: gain = 0.8, cautious: gain = 0.5) {
  let sense_obstacles = sense_obstacles(range = 2 m);
  cooperate {
    curious: Noise(persistence = 10 s);
    cautious: AvoidStaticObstacles(readings = sense_obstacles, sphere = 1 m, safety_margin = 0.5 m);
    curious: Probe(readings = sense_obstacles);
  }
}

layout Wander {
  Noise 40 40;
  AvoidStaticObstacles 40 160;
  Probe 40 320;
  sense_obstacles -280 200;
  cooperate 400 160;
}
)");
  EXPECT_EQ(text.errors(), "");
}

TEST(Edit, InlinesANodeThatOneReads) {
  DrawnText text("assemblage A() {\n}\n");
  text.place("A", "MoveToGoal");
  text.place("A", "DetectGoal");
  text.set("A", "DetectGoal", "goal", "[10 m, 5 m]");
  text.connect("A", "DetectGoal", "MoveToGoal", text.first_input("A", "MoveToGoal"));
  text.connect("A", "MoveToGoal", "$result", "");
  EXPECT_NE(text.text().find("MoveToGoal(" + text.first_input("A", "MoveToGoal") +
                             " = DetectGoal(goal = [10 m, 5 m]));"),
            std::string::npos)
      << text.text();
}

TEST(Edit, DisconnectsANodeAsALet) {
  DrawnText text(
      "assemblage A() {\n  cooperate {\n    /// Drifts.\n    0.8: Noise(persistence = 10 s);\n    1: "
      "Stand();\n  }\n}\n");
  text.disconnect("A", "cooperate", "members", 0);
  EXPECT_EQ(text.text(),
            "assemblage A() {\n  /// Drifts.\n  let Noise = Noise(persistence = 10 s);\n  cooperate {\n    "
            "1: Stand();\n  }\n}\n");
}

TEST(Edit, GivesALetItsNameWhereItIsRead) {
  DrawnText text("assemblage A() {\n  let drift = Noise();\n  cooperate {\n    1: Stand();\n  }\n}\n");
  text.connect("A", "drift", "cooperate", "members");
  EXPECT_EQ(text.text(), "assemblage A() {\n  cooperate {\n    1: Stand();\n    Noise() as drift;\n  }\n}\n");
}

TEST(Edit, RefusesAWireThatDoesNotFit) {
  DrawnText text("assemblage A() {\n  let near = Detect(Mine);\n  cooperate {\n    1: Stand();\n  }\n}\n");
  EXPECT_EQ(text.refused([](Edit& edit) {
    Connect& wire = *edit.add_changes()->mutable_connect();
    wire.set_page("A");
    wire.set_from_node("near");
    wire.set_to_node("cooperate");
    wire.set_to_port("members");
  }),
            "it takes a Vector, and this is a truth value");
}

TEST(Edit, RefusesAParameterThatIsCalledAsAValue) {
  DrawnText text("assemblage A() {\n  let near = Noise();\n  near\n}\n");
  EXPECT_EQ(text.refused([](Edit& edit) {
    SetParameter& parameter = *edit.add_changes()->mutable_set_parameter();
    parameter.set_owner("A");
    parameter.set_name("near");
    parameter.set_type("Vector");
  }),
            "`near` is taken already");
}

TEST(Edit, RefusesALoopWithoutADelay) {
  DrawnText text("assemblage A() {\n  let sum = cooperate {\n    1: Stand();\n  };\n  sum\n}\n");
  EXPECT_NE(text.refused([](Edit& edit) {
    Connect& wire = *edit.add_changes()->mutable_connect();
    wire.set_page("A");
    wire.set_from_node("sum");
    wire.set_to_node("sum");
    wire.set_to_port("members");
  }),
            "");
}

TEST(Edit, KeepsCommentsAndEverythingElse) {
  const std::string before =
      "// A file.\n\nassemblage A() {\n  // what it is made of\n  cooperate {\n    1: Noise();  // drifts\n"
      "    0.5: Stand(); /* stays */\n  }\n}\n";
  DrawnText text(before);
  text.set("A", "Noise", "persistence", "3 s");
  EXPECT_EQ(text.text(),
            "// A file.\n\nassemblage A() {\n  // what it is made of\n  cooperate {\n"
            "    1: Noise(persistence = 3 s);  // drifts\n    0.5: Stand(); /* stays */\n  }\n}\n");
}

TEST(Edit, ChangesOneLineOfATextThatNobodyLaidOut) {
  DrawnText text("assemblage A()\n{\n    cooperate { 1 : Noise( ) ;\n  2: Stand();  } }\n");
  text.set("A", "Noise", "persistence", "3 s");
  EXPECT_EQ(text.text(),
            "assemblage A()\n{\n    cooperate { 1 : Noise(persistence = 3 s) ;\n  2: Stand();  } }\n");
}

TEST(Edit, RemovesANodeAndKeepsWhatDroveIt) {
  DrawnText text(
      "assemblage A() {\n  cooperate {\n    1: AvoidStaticObstacles(readings = sense_obstacles(range = 2 "
      "m));\n    1: Stand();\n  }\n}\n");
  text.remove("A", {"AvoidStaticObstacles"});
  EXPECT_EQ(text.text(),
            "assemblage A() {\n  let sense_obstacles = sense_obstacles(range = 2 m);\n  cooperate {\n    1: "
            "Stand();\n  }\n}\n");
  text.remove("A", {"sense_obstacles"});
  EXPECT_EQ(text.text(), "assemblage A() {\n  cooperate {\n    1: Stand();\n  }\n}\n");
}

TEST(Edit, RenamesWithAllUses) {
  DrawnText text(
      "assemblage A(speed: gain = 1) {\n  cooperate {\n    speed: Noise();\n  }\n}\n\nassemblage B() {\n  "
      "A(speed = 2)\n}\n\n"
      "layout A {\n  Noise 1 2;\n}\n");
  text.rename("A", "speed", "pace");
  text.rename("A", "Noise", "drift");
  text.rename("", "A", "Drift");
  EXPECT_EQ(text.text(),
            "assemblage Drift(pace: gain = 1) {\n  cooperate {\n    pace: Noise() as drift;\n  "
            "}\n}\n\nassemblage B() {\n"
            "  Drift(pace = 2)\n}\n\nlayout Drift {\n  drift 1 2;\n}\n");
}

TEST(Edit, ExposesAnInputAsAParameter) {
  DrawnText text("assemblage A() {\n  cooperate {\n    0.7: Noise(persistence = 12 s);\n  }\n}\n");
  text.expose("A", "Noise", "persistence");
  text.expose("A", "cooperate", "weight", 0, "wild");
  EXPECT_EQ(text.text(),
            "assemblage A(persistence: duration = 12 s, wild: gain = 0.7) {\n  cooperate {\n"
            "    wild: Noise(persistence = persistence);\n  }\n}\n");
}

TEST(Edit, ASequenceThatLosesItsStartBeginsInTheFirstStateThatStays) {
  DrawnText text(R"(assemblage Walk() {
  sequence {
    start Out: MoveAhead();
      when Wait(delay = 3 s) goto Rest;
    final Rest: Stand();
    Back: MoveAhead();
      when Wait(delay = 3 s) goto Out;
  }
}
)");
  text.change([](Change& change) {
    change.mutable_remove()->set_page("Walk");
    change.mutable_remove()->add_nodes("Out");
  });
  EXPECT_EQ(text.text(), R"(assemblage Walk() {
  sequence {
    start final Rest: Stand();
    Back: MoveAhead();
  }
}
)");
}

TEST(Edit, DrawsStates) {
  DrawnText text("assemblage Forage(attractor: object_class = Mine) {\n}\n");
  text.place("Forage", "sequence");
  text.connect("Forage", "sequence", "$result", "");
  text.change([](Change& change) {
    change.mutable_rename()->set_page("Forage");
    change.mutable_rename()->set_node("Waiting");
    change.mutable_rename()->set_name("Searching");
  });
  text.change([](Change& change) {
    SetState& state = *change.mutable_set_state();
    state.set_page("Forage");
    state.set_state("Searching");
    state.set_is_final(false);
    state.set_member("Wander()");
  });
  text.change([](Change& change) {
    AddState& state = *change.mutable_add_state();
    state.set_page("Forage");
    state.set_name("Acquiring");
    state.set_x(200);
  });
  text.change([](Change& change) {
    SetState& state = *change.mutable_set_state();
    state.set_page("Forage");
    state.set_state("Acquiring");
    state.set_member("Acquire(attractor)");
  });
  for (const auto& [from, to, trigger] : {std::tuple("Searching", "Acquiring", "Detect(attractor)"),
                                          std::tuple("Acquiring", "Searching", "not Detect(attractor)"),
                                          std::tuple("Acquiring", "Searching", "Holding(attractor)")}) {
    text.change([&](Change& change) {
      AddTransition& one = *change.mutable_add_transition();
      one.set_page("Forage");
      one.set_from(from);
      one.set_to(to);
      one.set_trigger(trigger);
    });
  }
  text.change([](Change& change) {
    SetTransition& one = *change.mutable_set_transition();
    one.set_page("Forage");
    one.set_from("Acquiring");
    one.set_index(1);
    one.set_new_index(0);
    one.set_restarts(true);
  });
  EXPECT_EQ(text.text(), R"(assemblage Forage(attractor: object_class = Mine) {
  sequence {
    start Searching: Wander();
      when Detect(attractor) goto Acquiring;
    Acquiring: Acquire(attractor);
      when Holding(attractor) goto Searching restart;
      when not Detect(attractor) goto Searching;
  }
}

layout Forage {
  Acquiring 200 0;
}
)");
  EXPECT_EQ(text.errors(), "");
  text.remove("Forage", {"Acquiring"});
  EXPECT_EQ(text.text(),
            "assemblage Forage(attractor: object_class = Mine) {\n  sequence {\n    start Searching: "
            "Wander();\n  }\n}\n");
}

TEST(Edit, BindsARobotAndMakesASociety) {
  DrawnText text("");
  text.declare("robot", "Forager");
  text.place("Forager", "Forage");
  text.connect("Forager", "Forage", "$movement", "v");
  text.change([](Change& change) {
    change.mutable_set_class()->set_robot("Forager");
    change.mutable_set_class()->set_class_name("MRV2");
  });
  text.declare("society", "Foragers");
  text.change([](Change& change) {
    SetMember& member = *change.mutable_set_member();
    member.set_society("Foragers");
    member.set_name("Forager");
    member.set_count(5);
    member.set_by("DistinctTargets");
  });
  EXPECT_EQ(text.text(),
            "robot Forager is MRV2 {\n  movement = Forage();\n}\n\nsociety Foragers: team of 5 Forager by "
            "DistinctTargets;\n");
}

TEST(Edit, NamesWhoCoordinatesACaste) {
  const std::string members = "caste {\n  team of 2 Scout;\n  MRV2;\n}";
  DrawnText text("society All: " + members + ";\n");
  const auto coordinate = [&](const std::string& by) {
    return text.change([&](Change& change) {
      change.mutable_set_member()->set_society("All");
      change.mutable_set_member()->set_is_caste(true);
      change.mutable_set_member()->set_by(by);
    });
  };
  coordinate("DistinctTargets");
  EXPECT_EQ(text.text(), "society All: " + members + " by DistinctTargets;\n");
  coordinate("");
  EXPECT_EQ(text.text(), "society All: " + members + ";\n");
}

TEST(Edit, MakesAnAssemblageOfNodesAndTakesItApart) {
  const std::string before =
      "assemblage A(curious: gain = 0.8) {\n  let around = sense_obstacles(range = 2 m);\n  compete by "
      "priority {\n"
      "    cooperate {\n      curious: Noise();\n      1: AvoidStaticObstacles(readings = around);\n    };\n "
      "   Stand();\n  }\n}\n";
  DrawnText text(before);
  text.change([](Change& change) {
    Group& group = *change.mutable_group();
    group.set_page("A");
    for (const char* one : {"cooperate", "cooperate.Noise", "cooperate.AvoidStaticObstacles"})
      group.add_nodes(one);
    group.set_name("Drift");
  });
  EXPECT_EQ(text.text(), R"(assemblage Drift(around: Obstacles, curious: gain = 0.8) {
  cooperate {
    curious: Noise();
    1: AvoidStaticObstacles(readings = around);
  }
}

assemblage A(curious: gain = 0.8) {
  let around = sense_obstacles(range = 2 m);
  compete by priority {
    Drift(around = around, curious = curious);
    Stand();
  }
}
)");
  EXPECT_EQ(text.errors(), "");
  text.change([](Change& change) {
    change.mutable_ungroup()->set_page("A");
    change.mutable_ungroup()->set_node("Drift");
  });
  EXPECT_EQ(text.errors(), "");
  EXPECT_EQ(text.text().substr(text.text().find("assemblage A")), before);
}

TEST(Edit, KeepsTheArrangementOfWhatBecomesAnAssemblage) {
  DrawnText text(R"(assemblage A() {
  let around = sense_obstacles(range = 2 m);
  compete by priority {
    cooperate {
      1: Noise();
      1: AvoidStaticObstacles(readings = around);
    };
    Stand();
  }
}

layout A {
  around 0 300;
  compete 800 100;
  cooperate 500 120;
  cooperate.Noise 240 40;
  cooperate.AvoidStaticObstacles 240 200;
}
)");
  ASSERT_EQ(text.errors(), "");
  text.change([](Change& change) {
    Group& group = *change.mutable_group();
    group.set_page("A");
    for (const char* one : {"cooperate", "cooperate.Noise", "cooperate.AvoidStaticObstacles"})
      group.add_nodes(one);
    group.set_name("Drift");
    group.set_x(360);
    group.set_y(120);
  });
  EXPECT_EQ(text.errors(), "");
  EXPECT_EQ(text.text().substr(text.text().find("layout A")), R"(layout A {
  around 0 300;
  compete 800 100;
  Drift 360 120;
}

layout Drift {
  AvoidStaticObstacles 240 200;
  Noise 240 40;
  cooperate 500 120;
}
)") << text.text();
}

TEST(Edit, NodesThatAreWrittenAlikeStayTwoWhereAGroupLeavesThemOutside) {
  DrawnText text("assemblage A() {\n  cooperate {\n    1: Noise();\n    1: Noise();\n  }\n}\n");
  text.change([](Change& change) {
    change.mutable_group()->set_page("A");
    change.mutable_group()->add_nodes("cooperate");
    change.mutable_group()->set_name("Drift");
  });
  EXPECT_EQ(text.errors(), "");
  EXPECT_NE(text.text().find("Drift(Noise = Noise(), Noise_2 = Noise())"), std::string::npos) << text.text();
}

TEST(Edit, NodesThatAreKeptAtOnceHaveNamesOfTheirOwn) {
  DrawnText text(R"(assemblage A() {
  let Noise = Noise();
  let Noise_2 = Noise();
  sequence {
    start Going: cooperate {
      Noise(): Noise();
    };
  }
}
)");
  text.disconnect("A.Going", "cooperate", "members", 0);
  EXPECT_NE(text.text().find("let Noise_3 = Noise();"), std::string::npos) << text.text();
  EXPECT_NE(text.text().find("let Noise_4 = Noise();"), std::string::npos) << text.text();
}

TEST(Edit, SaysWhatToChooseWhereAnAssemblageWouldGiveSeveralValues) {
  DrawnText text("assemblage A() {\n  cooperate {\n    1: Noise();\n    1: MoveAhead();\n  }\n}\n");
  const std::string refusal = text.refused([](Edit& edit) {
    Group& group = *edit.add_changes()->mutable_group();
    group.set_page("A");
    group.add_nodes("Noise");
    group.add_nodes("MoveAhead");
    group.set_name("Drift");
  });
  EXPECT_NE(refusal.find("choose what they lead to as well"), std::string::npos) << refusal;
}

TEST(Edit, CopiesAndPastes) {
  DrawnText text("assemblage A() {\n  cooperate {\n    1: Noise(persistence = 3 s);\n  }\n}\n");
  Copy copy;
  copy.set_page("A");
  copy.add_nodes("Noise");
  const text::Result<std::string> words = copied(text.model(), copy);
  ASSERT_TRUE(words.has_value());
  EXPECT_EQ(*words, "let Noise = Noise(persistence = 3 s);\n");
  for (int i = 0; i < 2; ++i) {
    text.change([&](Change& change) {
      change.mutable_paste()->set_page("A");
      change.mutable_paste()->set_text(*words);
    });
  }
  EXPECT_NE(
      text.text().find("let Noise_2 = Noise(persistence = 3 s);\n  let Noise_3 = Noise(persistence = 3 s);"),
      std::string::npos)
      << text.text();
}

TEST(Edit, PastesNodesAsTheyStood) {
  DrawnText text(
      "assemblage A() {\n  cooperate {\n    Noise();\n    Stand();\n  }\n}\n\nassemblage B() {\n}\n");
  Copy copy;
  copy.set_page("A");
  const auto stands = [&](const std::string& name, double x, double y) {
    copy.add_nodes(name);
    Arrange::At& at = *copy.add_places();
    at.set_node(name);
    at.set_x(x);
    at.set_y(y);
  };
  stands("cooperate", 300, 40);
  stands("Noise", 20, 30);
  stands("Stand", 24, 160);
  const text::Result<std::string> words = copied(text.model(), copy);
  ASSERT_TRUE(words.has_value());
  EXPECT_EQ(*words, R"(let cooperate = cooperate {
    Noise();
    Stand();
  };
layout {
  cooperate 300 40;
  cooperate.Noise 20 30;
  cooperate.Stand 24 160;
}
)");
  for (const double x : {1000.0, 2000.0}) {
    text.change([&](Change& change) {
      Paste& paste = *change.mutable_paste();
      paste.set_page("B");
      paste.set_text(*words);
      paste.set_x(x);
      paste.set_y(500);
    });
  }
  EXPECT_EQ(text.text().substr(text.text().find("layout")), R"(layout B {
  cooperate 1280 510;
  cooperate.Noise 1000 500;
  cooperate.Stand 1004 630;
  cooperate_2 2280 510;
  cooperate_2.Noise 2000 500;
  cooperate_2.Stand 2004 630;
}
)");
  EXPECT_EQ(text.errors(), "");
}

TEST(Edit, PastesBesideWhatIsThere) {
  const auto pasted = [](double x, double y, bool is_taken) {
    DrawnText text("assemblage A() {\n}\n");
    text.change([&](Change& change) {
      Paste& paste = *change.mutable_paste();
      paste.set_page("A");
      paste.set_text("let One = Noise();\nlet Two = Noise();\nlayout {\n  One 0 0;\n  Two 0 120;\n}\n");
      paste.set_x(x);
      paste.set_y(y);
      Paste::Box box;
      box.set_x(0);
      box.set_y(0);
      box.set_width(150);
      box.set_height(60);
      if (is_taken) *paste.add_taken() = box;
    });
    const std::string& all = text.text();
    return all.substr(std::min(all.find("layout"), all.size()));
  };
  EXPECT_EQ(pasted(12, 12, false), "layout A {\n  One 12 12;\n  Two 12 132;\n}\n");
  EXPECT_EQ(pasted(400, 12, true), "layout A {\n  One 400 12;\n  Two 400 132;\n}\n");
  EXPECT_EQ(pasted(12, 12, true), "layout A {\n  One 12 84;\n  Two 12 204;\n}\n");
}

TEST(Edit, PastesStatesAsTheyStood) {
  DrawnText text(
      "assemblage A() {\n  sequence {\n    start Go: Noise();\n      when Wait(1 s) goto Rest;\n"
      "    final Rest: Stand();\n  }\n}\n");
  Copy copy;
  copy.set_page("A");
  copy.add_nodes("Go");
  Arrange::At& at = *copy.add_places();
  at.set_node("Go");
  at.set_x(80);
  const text::Result<std::string> words = copied(text.model(), copy);
  ASSERT_TRUE(words.has_value());
  text.change([&](Change& change) {
    Paste& paste = *change.mutable_paste();
    paste.set_page("A");
    paste.set_text(*words);
    paste.set_x(400);
    paste.set_y(16);
  });
  EXPECT_NE(text.text().find("Go_2: Noise();"), std::string::npos) << text.text();
  EXPECT_NE(text.text().find("  Go_2 400 16;"), std::string::npos) << text.text();
}

TEST(Edit, PastesStatesUnderNamesOfTheirOwn) {
  DrawnText text(
      "assemblage A() {\n  sequence {\n    start Go: Noise();\n      when Wait(1 s) goto Rest;\n"
      "    final Rest: Stand();\n  }\n}\n");
  text.change([](Change& change) {
    change.mutable_paste()->set_page("A");
    change.mutable_paste()->set_text(
        "Go: Noise();\n  when Wait(1 s) goto Go_2;\nGo_2: Stand();\n  when Wait(1 s) goto Go;\n");
  });
  EXPECT_NE(text.text().find("Go_2: Noise();"), std::string::npos) << text.text();
  EXPECT_NE(text.text().find("Go_2_2: Stand();"), std::string::npos) << text.text();
  EXPECT_EQ(text.errors(), "");
}

TEST(Edit, WritesNotesAndFrames) {
  DrawnText text("assemblage A() {\n  Stand();\n}\n");
  const auto note = [&](const std::string& id, const std::string& words, double width, bool is_frame) {
    text.change([&](Change& change) {
      SetNote& one = *change.mutable_set_note();
      one.set_page("A");
      one.set_id(id);
      one.set_text(words);
      one.set_x(10);
      one.set_y(20);
      one.set_width(width);
      one.set_height(width);
      one.set_is_frame(is_frame);
    });
  };
  note("", "stands\n\"still\"", 0, false);
  note("", "all of it", 300, true);
  EXPECT_EQ(text.text(),
            "assemblage A() {\n  Stand();\n}\n\nlayout A {\n  note 10 20 \"stands\" \"'still'\";\n"
            "  frame 10 20 300 300 \"all of it\";\n}\n");
  const Drawing drawing = draw(text.model(), "A", {"a.cdl", 1, false, {}});
  ASSERT_EQ(drawing.notes_size(), 2);
  EXPECT_EQ(drawing.notes(0).text(), "stands\n'still'");
  note("1", "", 0, false);
  EXPECT_EQ(draw(text.model(), "A", {"a.cdl", 1, false, {}}).notes_size(), 1);
}

}  // namespace
}  // namespace mlab::designer
