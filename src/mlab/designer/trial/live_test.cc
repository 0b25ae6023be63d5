#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/designer/testing/live_desk.h"
#include "mlab/designer/trial/live_paths.h"
#include "mlab/designer/trial/trial.h"

namespace mlab::designer {
namespace {

using console::Status;
using testing::LiveDesk;

constexpr const char* kForager = "examples:forage/forager.cdl";

constexpr const char* kGoHome =
    "assemblage Home(pull: gain = 1) {\n"
    "  cooperate {\n"
    "    pull: MoveToGoal(goal = DetectGoal(goal = GetOrderGoal()), success_radius = 20 cm);\n"
    "    0.5: AvoidStaticObstacles(readings = sense_obstacles(range = 3 m), sphere = 1.5 m, safety_margin = "
    "0.4 m);\n"
    "  }\n"
    "}\n";

std::set<std::string> port_paths(console::testing::Browser& browser) {
  std::set<std::string> out;
  for (const console::Port& port : browser.roster().programs(0).ports()) out.insert(port.path());
  return out;
}

// `place` and `live` as a browser puts them together.
std::string port_of(const std::string& place, const std::string& live) {
  return live == "." ? place : joined_path(place, live);
}

TEST(Live, EveryNodeThatIsDrawnHasAPortOfTheProgramThatRuns) {
  LiveDesk desk;
  const std::string path = desk.open(kForager);
  ASSERT_TRUE(desk.try_out(path, "Forager").ok());
  ASSERT_TRUE(desk.browser().wait([&] { return desk.browser().roster().programs_size() == 1; }));
  const std::set<std::string> ports = port_paths(desk.browser());
  const std::string program = "forager.cdl#Forager:";
  int nodes = 0;
  for (const char* page :
       {"Forager", "Forage", "Forage.Searching", "Wander", "KeepClear", "Acquire", "Deliver", "Watch"}) {
    const Drawing drawing = desk.drawing(path, page);
    const std::vector<std::string> places = desk.live(path, page);
    ASSERT_FALSE(places.empty()) << page;
    for (const std::string& place : places) {
      ASSERT_TRUE(place.starts_with(program)) << place;
      for (const Node& node : drawing.nodes()) {
        // What moves nothing else (PickUp, a sink) and what is shared has its value elsewhere or none.
        if (node.live().empty() || node.type().empty()) continue;
        const std::string port = port_of(place.substr(program.size()), node.live());
        EXPECT_TRUE(ports.contains(port)) << page << " " << node.name() << ": " << port;
        ++nodes;
      }
    }
  }
  EXPECT_GT(nodes, 40);
}

TEST(Live, FindsAPageInAllPlacesWhereItRuns) {
  LiveDesk desk;
  const std::string path = desk.open(kForager);
  ASSERT_TRUE(desk.try_out(path, "Forager").ok());
  EXPECT_EQ(desk.live(path, "Wander"), std::vector<std::string>{"forager.cdl#Forager:movement.Searching"});
  EXPECT_EQ(desk.live(path, "Forage"), std::vector<std::string>{"forager.cdl#Forager:movement"});
  EXPECT_EQ(desk.live(path, "Forage.Delivering"),
            std::vector<std::string>{"forager.cdl#Forager:movement.Delivering"});
  EXPECT_EQ(desk.live(path, "KeepClear").size(), 4U) << "in four states";
  EXPECT_TRUE(desk.live(path, "Nothing").empty());
}

TEST(Live, FindsAPageInProgramsThatWereNotTriedHere) {
  LiveDesk desk;
  const std::string path = desk.open(kForager);
  using Places = std::vector<std::string>;
  EXPECT_EQ(desk.live(path, "Wander", {"forager.cdl"}), Places{"forager.cdl:movement.Searching"});
  EXPECT_EQ(desk.live(path, "Forage", {"sheep.cdl", "robots/forager.cdl#Forager"}),
            Places{"robots/forager.cdl#Forager:movement"});
  EXPECT_TRUE(desk.live(path, "Forage", {"forager.cdl#Other", "sheep.cdl", "robot", ""}).empty());
}

TEST(Live, KnowsBeforeItRunsWhereAPageWould) {
  LiveDesk desk;
  const std::string path = desk.open(kForager);
  const auto planned = [&](const std::string& page) {
    const Answer answer = desk.ask([&](ToDesigner& m) {
      m.mutable_find_live()->set_document(path);
      m.mutable_find_live()->set_page(page);
      m.mutable_find_live()->set_is_planned(true);
    });
    return answer.ok() && answer.live().places_size() == 1 ? answer.live().places(0).path() : answer.error();
  };
  EXPECT_TRUE(desk.live(path, "Wander").empty());
  EXPECT_EQ(planned("Forage"), "movement");
  EXPECT_EQ(planned("Wander"), "movement.Searching");
  EXPECT_EQ(planned("Forage.Delivering"), "movement.Delivering");
  EXPECT_EQ(planned("Nothing"), "there is no assemblage, robot or society `Nothing`");
}

TEST(Live, StatesThatAreDrawnAreThoseThatRobotsTell) {
  LiveDesk desk;
  const std::string path = desk.open(kForager);
  ASSERT_TRUE(desk.try_out(path, "Forager").ok());
  const Drawing drawing = desk.drawing(path, "Forage");
  std::set<std::string> states;
  for (const State& state : drawing.states()) states.insert("movement." + state.live());
  auto watch = std::make_unique<console::ToServer>();
  watch->mutable_watch()->add_details(1);
  desk.browser().send(std::move(watch));
  ASSERT_TRUE(desk.browser().wait([&] {
    return desk.browser().frame().details_size() > 0 && desk.browser().frame().details(0).states_size() > 0;
  }));
  EXPECT_TRUE(states.contains(desk.browser().frame().details(0).states(0)));
}

Answer write_back(LiveDesk& desk, const std::string& path, const std::string& port,
                  const std::string& value) {
  return desk.ask([&](ToDesigner& m) {
    m.mutable_write_back()->set_document(path);
    m.mutable_write_back()->set_port(port);
    m.mutable_write_back()->set_value(value);
  });
}

TEST(WriteBack, PutsTheValueWhereTheAuthorWroteTheOldOne) {
  LiveDesk desk;
  const std::string path = desk.write(kGoHome);
  ASSERT_TRUE(desk.try_out(path).ok());
  const auto expect = [&](const char* port, const char* value, const char* before, const char* after) {
    std::string wanted = desk.document(path).text();
    const std::size_t at = wanted.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    wanted.replace(at, std::string(before).size(), after);
    const Answer answer = write_back(desk, path, port, value);
    ASSERT_TRUE(answer.ok()) << port << ": " << answer.error();
    EXPECT_EQ(desk.document(path).text(), wanted);
  };
  expect("movement.gains[0]", "0.7", "gain = 1)", "gain = 0.7)");
  EXPECT_EQ(desk.document(path).undo(), "write back movement.gains[0] = 0.7");
  expect("movement.gains[1]", "0.25", "0.5:", "0.25:");
  expect("movement.MoveToGoal.success_radius", "0.3", "20 cm", "0.3 m");
  expect("movement.AvoidStaticObstacles.sphere", "2", "1.5 m", "2 m");
  ASSERT_TRUE(desk.ask([&](ToDesigner& m) { m.mutable_undo()->set_document(path); }).ok());
  EXPECT_NE(desk.document(path).text().find("sphere = 1.5 m"), std::string::npos);
}

TEST(WriteBack, WritesADefaultThatNobodySaid) {
  LiveDesk desk;
  const std::string path = desk.write("assemblage Drift() {\n  Noise()\n}\n");
  ASSERT_TRUE(desk.try_out(path).ok());
  const Answer answer = write_back(desk, path, "movement.persistence", "4");
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_NE(desk.document(path).text().find("Noise(persistence = 4"), std::string::npos)
      << desk.document(path).text();
}

TEST(WriteBack, RefusesWhatHasNoPlaceInTheText) {
  LiveDesk desk;
  const std::string path = desk.write("assemblage Roam() { Wander() }\n" + std::string(kGoHome));
  ASSERT_TRUE(desk.try_out(path, "Roam").ok());
  const std::string text = desk.document(path).text();
  EXPECT_NE(write_back(desk, path, "movement.Noise.persistence", "4").error(), "") << "of the library";
  EXPECT_NE(write_back(desk, path, "movement.nothing", "4").error(), "");
  ASSERT_TRUE(desk.try_out(path, "Home").ok());
  EXPECT_NE(write_back(desk, path, "movement.gains[0]", "; }").error(), "");
  EXPECT_NE(write_back(desk, path, "movement.gains[0]", "north").error(), "");
  EXPECT_NE(write_back(desk, path, "movement.MoveToGoal.goal", "4").error(), "") << "a wire";
  EXPECT_EQ(desk.document(path).text(), text);
}

TEST(WriteBack, KeepsTextsInQuotesAndRefusesWhatTheyCanNotHold) {
  LiveDesk desk;
  const std::string path =
      desk.write("assemblage Call() {\n  sequence { start Telling: NotifySelf(message = \"here\"); }\n}\n");
  ASSERT_TRUE(desk.try_out(path).ok());
  const Answer done = write_back(desk, path, "movement.Telling.message", "there, now");
  ASSERT_TRUE(done.ok()) << done.error();
  const std::string text = desk.document(path).text();
  EXPECT_NE(text.find("message = \"there, now\""), std::string::npos) << text;
  EXPECT_NE(write_back(desk, path, "movement.Telling.message", "\"there\"").error(), "");
  EXPECT_NE(write_back(desk, path, "movement.Telling.message", "there\\now").error(), "");
  EXPECT_NE(write_back(desk, path, "movement.Telling.message", "two\nlines").error(), "");
  EXPECT_EQ(desk.document(path).text(), text);
}

TEST(ReadField, TheStandardBodySensesAsFarAsThePageAsks) {
  LiveDesk desk;
  const std::string path = desk.write(
      "assemblage Shy() {\n"
      "  AvoidStaticObstacles(readings = sense_obstacles(range = 30 m), sphere = 30 m, safety_margin = 5 m)\n"
      "}\n");
  std::vector<LiveDesk::Arrow> arrows;
  const Answer answer = desk.field(path, "Shy", "", 0, &arrows);
  ASSERT_TRUE(answer.ok()) << answer.error();
  // At (80, 40) the nearest obstacle is 22 m away.
  const auto near = std::ranges::find_if(
      arrows, [](const auto& one) { return std::hypot(one.x - 80.0, one.y - 40.0) < 0.1; });
  ASSERT_NE(near, arrows.end());
  EXPECT_GT(std::hypot(near->dx, near->dy), 0.01);
}

TEST(ReadField, PointsToTheGoalAndAwayFromObstacles) {
  LiveDesk desk;
  const std::string path = desk.write(kGoHome);
  std::vector<LiveDesk::Arrow> arrows;
  const Answer answer = desk.field(path, "Home", "MoveToGoal", 0, &arrows);
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_NE(answer.field().note(), "");
  ASSERT_EQ(arrows.size(), 13U * 9U);
  for (const LiveDesk::Arrow& arrow : arrows) {
    const double to_x = kTrialGoal.x - arrow.x;
    const double to_y = kTrialGoal.y - arrow.y;
    const double far = std::hypot(to_x, to_y);
    if (far < 1.0) continue;
    EXPECT_NEAR(arrow.dx, to_x / far, 1e-3) << arrow.x << " " << arrow.y;
    EXPECT_NEAR(arrow.dy, to_y / far, 1e-3);
  }
  // Beside the obstacle at (58, 56), of radius 3, what it is pushed by points away.
  ASSERT_TRUE(desk.field(path, "Home", "AvoidStaticObstacles", 0, &arrows).ok());
  bool is_pushed = false;
  for (const LiveDesk::Arrow& arrow : arrows) {
    const double away = (arrow.x - 58.0) * arrow.dx + (arrow.y - 56.0) * arrow.dy;
    const double distance = std::hypot(arrow.x - 58.0, arrow.y - 56.0);
    if (distance < 4.8 && std::hypot(arrow.dx, arrow.dy) > 0.01) {
      EXPECT_GT(away, 0.0);
      is_pushed = true;
    }
  }
  EXPECT_TRUE(is_pushed);
}

TEST(ReadField, TakesNamedPlacesWhereTheMissionHasThem) {
  LiveDesk desk;
  desk.folder().write("project/field.odl", "MISSION-AREA 160 120\nCONTROL MEASURES:\nPP Gate 120 90\n");
  const std::string path =
      desk.write("assemblage ToGate() {\n  MoveToGoal(DetectGoal(place(\"Gate\")))\n}\n");
  const std::string alone = desk.field(path, "ToGate", "", 0, nullptr).error();
  EXPECT_NE(alone.find("no place `Gate`"), std::string::npos) << alone;
  const Answer tried =
      desk.try_out(path, "ToGate", 1, [](Try& request) { request.set_overlay("field.odl"); });
  ASSERT_TRUE(tried.ok()) << tried.DebugString();
  for (const std::uint32_t robot : {0U, 1U}) {
    std::vector<LiveDesk::Arrow> arrows;
    const Answer answer = desk.field(path, "ToGate", "", robot, &arrows);
    ASSERT_TRUE(answer.ok()) << answer.error();
    ASSERT_EQ(arrows.size(), 13U * 9U);
    EXPECT_NEAR(arrows[0].dx, 100.0 / std::hypot(100.0, 70.0), 1e-3) << robot;
    EXPECT_NEAR(arrows[0].dy, 70.0 / std::hypot(100.0, 70.0), 1e-3) << robot;
  }
}

TEST(ReadField, DoesNotDisturbTheRun) {
  std::vector<std::string> places;
  for (const bool looks : {false, true}) {
    LiveDesk desk(0.0);
    const std::string path = desk.open(kForager);
    ASSERT_TRUE(desk.try_out(path, "Forager", 2, [](Try& request) { request.set_execute(false); }).ok());
    console::ToServer stop;
    console::Breakpoint& breakpoint = *stop.mutable_set_breakpoint()->mutable_breakpoint();
    breakpoint.mutable_transition()->set_sequence("movement");
    breakpoint.mutable_transition()->set_to("Delivering");
    ASSERT_TRUE(desk.browser().ask(stop).ok());
    ASSERT_EQ(desk.browser().control(console::Control::EXECUTE), "");
    for (int i = 0; looks && i < 10; ++i) {
      std::vector<LiveDesk::Arrow> arrows;
      const Answer answer = desk.field(path, "Wander", "", i % 3 == 0 ? 0 : 1, &arrows);
      EXPECT_TRUE(answer.ok()) << answer.error();
      EXPECT_EQ(arrows.size(), 13U * 9U);
    }
    ASSERT_TRUE(desk.browser().wait(
        [&] {
          return desk.browser().status().mode() == Status::PAUSED && desk.browser().halted().hits_size() > 0;
        },
        120.0));
    const std::uint64_t cycle = desk.browser().halted().cycle();
    ASSERT_TRUE(desk.browser().wait([&] { return desk.browser().frame().cycle() == cycle; }));
    places.push_back(std::to_string(cycle) + desk.browser().frame().robots());
  }
  EXPECT_EQ(places[0], places[1]);
}

TEST(ReadField, TakesTheStateOfTheRobotThatRuns) {
  LiveDesk desk;
  const std::string path = desk.write(kGoHome);
  const Answer tried = desk.try_out(path);
  ASSERT_TRUE(tried.ok()) << tried.DebugString();
  ASSERT_TRUE(desk.runs_until(1.0));
  std::vector<LiveDesk::Arrow> before;
  ASSERT_TRUE(desk.field(path, "Home", "", 1, &before).ok());
  console::ToServer set;
  set.mutable_set_parameter()->add_robots(1);
  set.mutable_set_parameter()->set_port("movement.gains[0]");
  set.mutable_set_parameter()->set_value("0");
  const console::Reply reply = desk.browser().ask(set);
  ASSERT_TRUE(reply.ok()) << reply.error();
  std::vector<LiveDesk::Arrow> after;
  const Answer answer = desk.field(path, "Home", "", 1, &after);
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_GT(std::hypot(before[0].dx, before[0].dy), 0.5);
  EXPECT_LT(std::hypot(after[0].dx, after[0].dy), 1e-6) << "nothing pulls any more, and no obstacle is near";
}

TEST(ReadField, AnswersWhatIsWrongWithTheRequest) {
  LiveDesk desk;
  const std::string path = desk.write(kGoHome);
  EXPECT_FALSE(desk.field("nothing", "Home", "", 0, nullptr).ok());
  EXPECT_FALSE(desk.field(path, "Nowhere", "", 0, nullptr).ok());
  EXPECT_FALSE(desk.field(path, "Home", "Nothing", 0, nullptr).ok());
  EXPECT_FALSE(desk.field(path, "Home", "", 7, nullptr).ok()) << "no such robot";
  std::string sensor;
  const Drawing home = desk.drawing(path, "Home");
  for (const Node& node : home.nodes()) {
    if (node.component() == "sense_obstacles") sensor = node.name();
  }
  ASSERT_NE(sensor, "");
  const Answer percept = desk.field(path, "Home", sensor, 0, nullptr);
  EXPECT_FALSE(percept.ok());
  EXPECT_NE(percept.error().find("gives no movement"), std::string::npos) << percept.error();
  const Answer far = desk.ask([&](ToDesigner& m) {
    m.mutable_read_field()->set_document(path);
    m.mutable_read_field()->set_page("Home");
    m.mutable_read_field()->mutable_area()->set_x_max(std::nan(""));
  });
  EXPECT_FALSE(far.ok());
}

}  // namespace
}  // namespace mlab::designer
