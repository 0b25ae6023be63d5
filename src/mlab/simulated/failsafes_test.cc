// Failsafes of missions, carried out: below whatever the programs of robots want.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/fleet/testing/failsafe_row.h"
#include "mlab/fleet/what_if.h"
#include "mlab/mission/mission.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab::run {
namespace {

using fleet::testing::lasting;
using mission::FailsafeAction;
using mission::FailsafeCondition;

constexpr const char* kEast =
    "class Cart { actuator wheels: Drive(max_velocity = 4 m/s, base_velocity = 4 m/s) binds movement; }\n"
    "robot R is Cart { movement = MoveAhead(); }";

text::Files only_east() {
  text::Files out;
  out.is_file = [](const std::string& path) { return path == "east.cdl"; };
  out.read = [](const std::string& path) -> text::Result<text::SourcePtr> {
    return std::make_shared<const text::Source>(path, kEast);
  };
  return out;
}

mission::Failsafe row(mission::FailsafeCondition condition, mission::FailsafeAction action,
                      double seconds = 0.0) {
  mission::Failsafe out;
  out.condition = condition;
  out.action = action;
  out.seconds = seconds;
  if (condition != mission::FailsafeCondition::kOutside) return out;
  out.fence_name = "Field";
  out.fence = {{10, 10}, {60, 10}, {60, 90}, {10, 90}};
  return out;
}

// The mission of one robot.
std::shared_ptr<const mission::Mission> mission_with(std::vector<mission::Failsafe> failsafes, bool has_wall,
                                                     double x) {
  auto out = std::make_shared<mission::Mission>();
  out->source = std::make_shared<const text::Source>("test.mdl", "NEW-ROBOT r x\nUNIT u START\n");
  out->overlay.area = overlay::Area{200.0, 100.0};
  if (has_wall) {
    overlay::ControlMeasure rock;
    rock.kind = overlay::MeasureKind::kWall;
    rock.name = "Rock";
    rock.points = {{40, 0}, {40, 100}};
    out->overlay.measures.push_back(rock);
  }
  out->types.push_back({"r", "east.cdl", "blue", "", {}, {out->source, {0, 9}}});
  out->robots = {{{1}, 0, {}}};
  out->units.push_back({"u", {{1}}, {}, {}});
  out->failsafes = std::move(failsafes);
  mission::UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {x, 50.0};
  start.place = {out->source, {14, 20}};
  out->steps.push_back({"0", {start}, {}});
  return out;
}

// A robot that drives to the east at 4 m/s, whatever it is ordered.
struct Drive {
  std::unique_ptr<MissionRun> run;
  std::vector<std::string> told;

  explicit Drive(std::vector<mission::Failsafe> failsafes, bool has_wall = false, double x = 20.0) {
    static const text::Files kInMemory = only_east();
    robot::ProgramSources sources;
    sources.files = &kInMemory;
    text::Diagnostics sink;
    const auto mission = mission_with(std::move(failsafes), has_wall, x);
    RunSettings settings;
    settings.goes_on_when_done = true;
    run = simulated::make_run(mission, sources, settings, sink);
    EXPECT_NE(run, nullptr) << text::render(sink);
    run->set_observer([this](const mission::Effect& effect) {
      if (const auto* one = std::get_if<mission::effect::Tell>(&effect)) told.push_back(one->text);
    });
    run->post(mission::event::Execute{});
  }
  void go(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10.0); ++i) run->step();
  }
  const fleet::FleetRobot& robot() const { return run->fleet().robots().front(); }
  /// Steps until it is so. @return  how many cycles that took; no more than a minute's
  template <class IsTrue>
  int step_until(IsTrue is_true) {
    int cycles = 0;
    for (; !is_true() && cycles < 600; ++cycles) run->step();
    return cycles;
  }
  bool acts() const { return robot().failsafe.active != fleet::FailsafeState::kNone; }
  fleet::WhatIfOutcome what_if(const fleet::WhatIf& conditions) const {
    const auto out = fleet::what_if(run->fleet().failsafes(), run->fleet().situation(robot()), conditions,
                                    run->cycle_duration());
    EXPECT_TRUE(out.has_value()) << (out ? "" : out.error());
    return out.value_or(fleet::WhatIfOutcome{});
  }
  double x() const { return run->fleet().pose(robot()).position.x; }
  int count(const std::string& text) const {
    int out = 0;
    for (const std::string& one : told) out += one.find(text) != std::string::npos ? 1 : 0;
    return out;
  }
};

TEST(Failsafes, OfNoMissionChangeNothing) {
  Drive drive({});
  drive.go(20.0);
  EXPECT_GT(drive.x(), 90.0);
}

TEST(Failsafes, HoldARobotBeforeTheFence) {
  Drive drive({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  drive.go(30.0);
  EXPECT_LT(drive.x(), 59.8);
  EXPECT_GT(drive.x(), 59.0);
  EXPECT_EQ(drive.count("robot 1: `FAILSAFE OUTSIDE Field HOLD` acts"), 1) << "once";
  EXPECT_EQ(drive.count("is over"), 0);
}

TEST(Failsafes, BringARobotHomeAndLetItStandThere) {
  Drive drive({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  drive.go(60.0);
  EXPECT_NEAR(drive.x(), 20.0, 1.0);
  EXPECT_EQ(drive.count("acts"), 1);
}

TEST(Failsafes, BackARobotAwayFromTheFence) {
  Drive drive({row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)});
  drive.go(60.0);
  EXPECT_NEAR(drive.x(), 56.8, 0.1) << "three metres between its body and the line";
}

TEST(Failsafes, StopAProgramThatRunsIntoAWall) {
  Drive drive({row(FailsafeCondition::kInContact, FailsafeAction::kStop, 1.0)}, true);
  drive.go(30.0);
  EXPECT_EQ(drive.robot().life, fleet::RobotLife::kStopped);
  EXPECT_EQ(drive.count("acts"), 1);
}

TEST(Failsafes, NoticeWhoIsStuckAtAWall) {
  Drive drive({row(FailsafeCondition::kStuck, FailsafeAction::kContinue, 3.0)}, true);
  drive.go(6.0);
  EXPECT_EQ(drive.count("acts"), 0);
  drive.go(6.0);
  EXPECT_EQ(drive.count("`FAILSAFE STUCK AFTER 3 CONTINUE` acts"), 1);
}

TEST(Failsafes, GiveTheSameRunEachTime) {
  Drive one({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  Drive other({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  for (int i = 0; i < 400; ++i) {
    one.run->step();
    other.run->step();
    ASSERT_EQ(one.run->fleet().pose(one.robot()), other.run->fleet().pose(other.robot()));
  }
}

// ---- what a what-if says is what comes

double when_it_acts(const fleet::WhatIfOutcome& outcome) {
  for (const fleet::WhatIfEvent& event : outcome.events) {
    if (event.what == fleet::WhatIfEvent::What::kActs) return event.time;
  }
  return -1.0;
}

TEST(WhatIfOfARun, ForetellsWhereARobotStandsBeforeItsFence) {
  for (const FailsafeAction action : {FailsafeAction::kHold, FailsafeAction::kReverseInside}) {
    Drive drive({row(FailsafeCondition::kOutside, action)});
    drive.step_until([&] { return drive.x() > 51.0; });
    const fleet::WhatIfOutcome foretold =
        drive.what_if({.speed = 4.0, .fence = fleet::WhatIf::AtFence{.depth = 60.0 - drive.x()}});
    const int cycles = drive.step_until([&] { return drive.acts(); });
    EXPECT_NEAR(when_it_acts(foretold), cycles * 0.1, 1e-6);
    drive.go(20.0);
    EXPECT_NEAR(foretold.to.position.x, drive.x(), 1e-6);
    EXPECT_TRUE(foretold.stood);
  }
}

TEST(WhatIfOfARun, ForetellsWhenAStuckRobotIsNoticed) {
  Drive drive({row(FailsafeCondition::kStuck, FailsafeAction::kStop, 3.0)}, true, 39.79);
  const fleet::WhatIfOutcome foretold =
      drive.what_if({.lasting = lasting({{FailsafeCondition::kStuck, 10.0}}), .speed = 4.0});
  drive.step_until([&] { return drive.robot().failsafe.has_begun; });
  const int cycles = 1 + drive.step_until([&] { return drive.acts(); });
  EXPECT_NEAR(when_it_acts(foretold), cycles * 0.1, 1e-6);
  EXPECT_TRUE(foretold.has_stopped);
  EXPECT_EQ(drive.robot().life, fleet::RobotLife::kStopped);
}

TEST(WhatIfOfARun, ForetellsWhichOfTwoRowsActsAtAWall) {
  Drive drive({row(FailsafeCondition::kStuck, FailsafeAction::kReturn, 3.0),
               row(FailsafeCondition::kInContact, FailsafeAction::kContinue, 1.0)},
              true, 39.79);
  const fleet::WhatIfOutcome foretold = drive.what_if(
      {.lasting = lasting({{FailsafeCondition::kInContact, 3.3}, {FailsafeCondition::kStuck, 3.3}}),
       .speed = 4.0});
  drive.go(4.5);
  std::vector<std::string> acts;
  for (const fleet::WhatIfEvent& event : foretold.events) {
    if (event.what == fleet::WhatIfEvent::What::kActs)
      acts.push_back(mission::words_of(drive.run->mission().failsafes[event.row]));
  }
  ASSERT_EQ(acts.size(), 2U);
  EXPECT_EQ(drive.count("acts"), 2);
  EXPECT_EQ(drive.count("`" + acts[0] + "` acts"), 1);
  EXPECT_EQ(drive.count("`" + acts[1] + "` acts, before `" + acts[0] + "`"), 1);
}

TEST(WhatIfOfARun, LeavesTheRunAsItIs) {
  Drive one({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  Drive other({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  for (int i = 0; i < 200; ++i) {
    one.run->step();
    other.run->step();
    one.what_if(
        {.lasting = lasting({{FailsafeCondition::kLinkLost, 3.0}, {FailsafeCondition::kStuck, 1.0}})});
    ASSERT_EQ(one.run->fleet().pose(one.robot()), other.run->fleet().pose(other.robot()));
  }
  EXPECT_EQ(one.told, other.told);
}

}  // namespace
}  // namespace mlab::run
