#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::ObjectClass;

const std::vector<percept::ObjectReading> kFlagFiveAway = {
    {.id = {1}, .object_class = ObjectClass::kFlag, .center = {6.0, 0.0}, .radius = 1.0}};

bool run(const char* name, const char* classes, const char* range_name, double range) {
  flow::BehaviorProbe p = probe(name);
  p.percepts.objects = kFlagFiveAway;
  p.set_text("classes", classes).set(range_name, range).step();
  return p.output<bool>();
}

TEST(IsAtGoal, HoldsUpToTheSuccessRadius) {
  flow::BehaviorProbe p = probe("IS_AT_GOAL");
  p.set("success_radius", 5.0).set("goal", Vector{3.0, 4.0}).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("goal", Vector{3.0, 4.01}).step();
  EXPECT_FALSE(p.output<bool>());
  p.set("goal", Vector{}).set("have_a_goal", false).step();
  EXPECT_FALSE(p.output<bool>());
}

TEST(Wait, CountsFromWhenItStarted) {
  flow::BehaviorProbe p = probe("Wait");
  p.percepts.time = 100.0;
  p.percepts.cycle_duration = 0.1;
  p.set("delay", 0.3);
  const auto next = [&] {
    p.step();
    return p.output<bool>();
  };
  EXPECT_FALSE(next());
  EXPECT_FALSE(next());
  EXPECT_FALSE(next());
  EXPECT_TRUE(next());
  EXPECT_TRUE(next());
  p.skip();
  EXPECT_FALSE(next());
}

TEST(Wait, OfNoTimeIsOverAtOnce) {
  flow::BehaviorProbe p = probe("Wait");
  p.set("delay", 0.0).step();
  EXPECT_TRUE(p.output<bool>());
}

TEST(Detect, SeesItsClassesWithinItsRange) {
  EXPECT_TRUE(run("Detect", "Flag", "range", 5.0));
  EXPECT_FALSE(run("Detect", "Flag", "range", 4.9));
  EXPECT_FALSE(run("Detect", "Basket", "range", 50.0));
  EXPECT_TRUE(run("Detect", "Basket|Flag", "range", 5.0));
  EXPECT_TRUE(run("Detect", "AnyObject", "range", 5.0));
}

TEST(Near, IsTheOppositeOfAwayFrom) {
  for (const double distance : {0.1, 4.9, 5.0, 50.0}) {
    EXPECT_EQ(run("Near", "Flag", "distance", distance), distance >= 5.0);
    EXPECT_EQ(run("AwayFrom", "Flag", "distance", distance), distance < 5.0);
  }
}

TEST(AwayFrom, HoldsWhereThereIsNothing) {
  EXPECT_TRUE(run("AwayFrom", "Mine", "distance", 100.0));
}

TEST(Holding, IsAboutWhatTheRobotCarries) {
  flow::BehaviorProbe p = probe("Holding");
  flow::BehaviorProbe n = probe("NotHolding");
  const auto holds = [&](std::uint32_t id, ObjectClass object_class) {
    for (flow::BehaviorProbe* one : {&p, &n}) {
      one->percepts.carried = {id};
      one->percepts.carried_class = object_class;
      one->set_text("classes", "Flag|Mine").step();
    }
    EXPECT_NE(p.output<bool>(), n.output<bool>());
    return p.output<bool>();
  };
  EXPECT_FALSE(holds(0, ObjectClass::kFlag));
  EXPECT_TRUE(holds(4, ObjectClass::kFlag));
  EXPECT_TRUE(holds(4, ObjectClass::kMine));
  EXPECT_FALSE(holds(4, ObjectClass::kTree));
}

}  // namespace
}  // namespace mlab::library_test
