#include "mlab/mission/phase_line.h"

#include <gtest/gtest.h>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// Three robots in a column that go from x = 0 .. 20 to x = 200, across lines of the test's choice.
std::shared_ptr<const Mission> advance_across(std::vector<PhaseLine> lines) {
  MissionMaker m;
  const auto unit = m.unit("scouts", 3);
  UnitCommand move = move_to(unit, "A", {200, 0});
  move.phase_lines = std::move(lines);
  m.step({start(unit, {20, 0}, {-10, 0})}).step({move});
  return m.make();
}

PhaseLine line_at(double x) {
  PhaseLine line;
  line.name = "PL-Red";
  line.points = {{x, -50}, {x, 0.5}, {x + 5, 50}};
  return line;
}

double foremost(const ToyFleet& fleet) {
  return fleet.position(1).x;
}

TEST(PhaseLine, CrossingIsToldAndTheUnitGoesOn) {
  PhaseLine line = line_at(100);
  line.acknowledge = "crossing red";
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(
      fleet.run_until([&] { return fleet.has_told("unit scouts is at phase line PL-Red: crossing red"); }));
  EXPECT_NEAR(foremost(fleet), 98.0, 1.1) << "just before the line";
  EXPECT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.count<effect::Ask>(), 0);
  EXPECT_EQ(fleet.count<effect::Order>(), 1) << "nobody was halted";
}

TEST(PhaseLine, HoldsTheWholeUnitBeforeItUntilItIsAcknowledged) {
  PhaseLine line = line_at(100);
  line.acknowledge = "crossing red";
  line.waits = true;
  ToyFleet fleet(advance_across({line}), {.patience = 20.0});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  EXPECT_EQ(fleet.questions().at(1).text,
            "Unit \"scouts\" is at phase line PL-Red: crossing red. Acknowledge?");
  const std::uint32_t sequence = fleet.robot(1).order.order.sequence;
  EXPECT_TRUE(fleet.robot(1).order.order.halted);
  EXPECT_TRUE(fleet.robot(3).order.order.halted);
  fleet.cycle();
  EXPECT_TRUE(awaits_only_operator(fleet.state()));
  EXPECT_EQ(waits_for(fleet.state()).at(0), "unit scouts MOVETO A: the acknowledgement at phase line PL-Red");
  fleet.run_cycles(1000);
  EXPECT_LT(foremost(fleet), 100.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kRunning) << "waiting is no lack of progress";
  fleet.answer(1);
  fleet.cycle();
  EXPECT_FALSE(fleet.robot(3).order.order.halted);
  EXPECT_EQ(fleet.robot(3).order.order.sequence, sequence) << "the same order, released";
  EXPECT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet.has_told("unit scouts goes on across phase line PL-Red"));
}

TEST(PhaseLine, HoldsTheUnitUntilItsTimeHasCome) {
  PhaseLine line = line_at(100);
  line.not_before = MissionTime{MissionTime::Kind::kOfDay, 12 * 3600 + 60.0};
  ToyFleet fleet(advance_across({line}), {.epoch_seconds = 12 * 3600.0});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until(
      [&] { return fleet.has_told("unit scouts holds, waiting for 12:01:00 at phase line PL-Red"); }));
  EXPECT_LT(fleet.time(), 20.0);
  EXPECT_FALSE(awaits_only_operator(fleet.state()));
  ASSERT_TRUE(fleet.run_until([&] { return foremost(fleet) > 100.0; }));
  EXPECT_NEAR(fleet.time(), 60.5, 0.6);
  EXPECT_TRUE(fleet.run());
}

TEST(PhaseLine, NeedsBothTimeAndAcknowledgementWhereBothAreSaid) {
  PhaseLine line = line_at(100);
  line.not_before = MissionTime{MissionTime::Kind::kSinceStart, 60.0};
  line.acknowledge = "red";
  line.waits = true;
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  fleet.answer(1);
  fleet.run_cycles(100);
  EXPECT_LT(foremost(fleet), 100.0);
  ASSERT_TRUE(fleet.run());
  EXPECT_GT(fleet.time(), 60.0);
}

TEST(PhaseLine, WhoseTimeIsPastIsCrossedWithoutAHalt) {
  PhaseLine line = line_at(100);
  line.not_before = MissionTime{MissionTime::Kind::kSinceStart, 1.0};
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.count<effect::Order>(), 1);
}

TEST(PhaseLine, OfASinglePointIsReachedWithinItsRadius) {
  PhaseLine line;
  line.name = "PP-1";
  line.points = {{100, 8}};
  line.radius = 10.0;
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.has_told("unit scouts is at phase line PP-1"); }));
  EXPECT_NEAR(foremost(fleet), 91.5, 1.1) << "6 m before the foot of the perpendicular, 2.5 m ahead of time";
}

TEST(PhaseLine, ThatIsNotOnTheWaySaysNothing) {
  PhaseLine line = line_at(100);
  for (geom::Point& p : line.points) p.y += 100.0;
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_FALSE(fleet.has_told("phase line"));
}

TEST(PhaseLine, SeveralOfOneCommandAreCrossedOneAfterTheOther) {
  PhaseLine first = line_at(60);
  PhaseLine second = line_at(120);
  second.name = "PL-Blue";
  first.acknowledge = second.acknowledge = "here";
  first.waits = second.waits = true;
  ToyFleet fleet(advance_across({second, first}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  EXPECT_LT(foremost(fleet), 60.0);
  fleet.answer(1);
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  EXPECT_NEAR(foremost(fleet), 118.0, 2.0);
  fleet.answer(2);
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(PhaseLine, IsAcknowledgedAtOnceWhereEveryQuestionIs) {
  PhaseLine line = line_at(100);
  line.acknowledge = "red";
  line.waits = true;
  ToyFleet fleet(advance_across({line}), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.count<effect::Ask>(), 0);
}

TEST(PhaseLine, NotAcknowledgedAborts) {
  PhaseLine line = line_at(100);
  line.acknowledge = "red";
  line.waits = true;
  ToyFleet fleet(advance_across({line}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  fleet.answer(1, false);
  EXPECT_EQ(fleet.state().outcome, Outcome::kAborted);
}

}  // namespace
}  // namespace mlab::mission
