#include "mlab/console/published/overview.h"

#include <gtest/gtest.h>

#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

const PlaceOf kNowhere = [](const text::Place&) { return DocumentPlace{}; };

TEST(Plan, HoldsTheStepsInTheWordsOfTheMission) {
  const auto run = testing::run_of(testing::kTravel);
  Plan plan;
  encode_plan(run->mission(), 3, kNowhere, plan);
  EXPECT_EQ(plan.revision(), 3U);
  ASSERT_EQ(plan.steps_size(), 2);
  EXPECT_EQ(plan.steps(0).commands(0).text(), "UNIT pair START 100 100 0 40");
  EXPECT_EQ(plan.steps(1).commands(0).text(), "UNIT pair MOVETO 700 120 FORMATION Line");
  EXPECT_EQ(plan.steps(1).commands(0).goal().x(), 700.0);
}

TEST(Plan, WhatItSaysCanBeTypedAgain) {
  const auto run = testing::run_of(testing::kTravel);
  Plan plan;
  encode_plan(run->mission(), 1, kNowhere, plan);
  for (const Plan::Step& step : plan.steps()) {
    text::Diagnostics problems;
    EXPECT_TRUE(mdl::parse_immediate(step.commands(0).text(), run->mission(), problems).has_value())
        << text::render(problems);
  }
}

TEST(Roster, HoldsRobotsUnitsAndPrograms) {
  const auto run = testing::run_of(testing::kTravel);
  Roster roster;
  encode_roster(*run, roster);
  ASSERT_EQ(roster.robots_size(), 4);
  EXPECT_EQ(roster.robots(0).color(), "#0000ff");
  EXPECT_EQ(roster.robots(2).unit(), "rest");
  ASSERT_EQ(roster.units_size(), 2);
  EXPECT_EQ(roster.units(0).members_size(), 2);
  EXPECT_EQ(roster.units(1).parent(), -1);
  ASSERT_EQ(roster.programs_size(), 1) << "all robots share it";
  const auto& ports = roster.programs(0).ports();
  const auto speed = std::ranges::find(ports, "base_velocity", &Port::path);
  ASSERT_NE(speed, ports.end());
  EXPECT_EQ(speed->unit(), "m/s");
  EXPECT_EQ(speed->min(), 0.0);
  EXPECT_EQ(speed->max(), 100.0);
  EXPECT_EQ(speed->initial(), "5");
  EXPECT_TRUE(speed->is_number());
  EXPECT_FALSE(speed->help().empty());
  const auto reference = std::ranges::find(ports, "formation_reference", &Port::path);
  ASSERT_NE(reference, ports.end());
  EXPECT_EQ(reference->choices_size(), 3);
  const auto formation = std::ranges::find(ports, "formation", &Port::path);
  ASSERT_NE(formation, ports.end());
  EXPECT_EQ(formation->choices_size(), percept::kFormationCount);
}

TEST(Roster, ANestedUnitHasItsParent) {
  const auto run = testing::run_of(
      "UNIT <all> (<left> ROBOT ROBOT) (<right> ROBOT)\nCOMMAND LIST:\n0. UNIT all START 1 1 0 5\n");
  Roster roster;
  encode_roster(*run, roster);
  ASSERT_EQ(roster.units_size(), 3);
  EXPECT_EQ(roster.units(0).name(), "all");
  EXPECT_EQ(roster.units(1).parent(), 0);
  EXPECT_EQ(roster.units(2).parent(), 0);
  EXPECT_EQ(roster.robots(2).unit(), "right");
}

}  // namespace
}  // namespace mlab::console
