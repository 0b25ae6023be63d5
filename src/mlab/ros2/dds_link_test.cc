// A link and a robot's topics, each on a participant of its own, over the network of this machine.

#include "mlab/ros2/dds_link.h"

#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/ros2/testing/dds_robot.h"

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;
using testing::DdsRobot;

LinkSettings settings_here(bool has_goals = false) {
  LinkSettings out;
  out.network.domain = testing::domain_of_this_process();
  out.robot_namespace = testing::namespace_of_this_process();
  out.scanners = {out.robot_namespace + "/scan"};
  out.has_goals = has_goals;
  return out;
}

// Whether it comes to hold within the limit, which only a machine under load comes near to.
bool comes_true(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return true;
}

class DdsLinkTest : public ::testing::Test {
 protected:
  void open(bool has_goals = false) {
    auto opened = open_link(settings_here(has_goals));
    ASSERT_TRUE(opened) << opened.error();
    link = std::move(*opened);
  }
  std::unique_ptr<Link> link;
  Heard heard;
};

TEST_F(DdsLinkTest, HearsWhatARobotPublishes) {
  open();
  DdsRobot robot(DdsRobot::Listens::kNot);
  robot.say_mount("base_link", "laser", 0.25);
  LaserScan scan{.topic = 0,
                 .stamp = {7, 9},
                 .frame = "laser",
                 .angle_min = -1.0F,
                 .angle_increment = 0.5F,
                 .range_min = 0.1F,
                 .range_max = 9.0F,
                 .ranges = {1.0F, 2.0F, 3.0F}};
  ASSERT_TRUE(comes_true([&] {
    robot.say(Odometry{.stamp = {5, 6},
                       .frame = "odom",
                       .child_frame = "base_link",
                       .position = {1.0, 2.0, 0.0},
                       .orientation = {0.0, 0.0, 0.6, 0.8},
                       .speed = 0.5,
                       .turn_rate = -0.25,
                       .writer = 0});
    robot.say(scan);
    robot.say_battery(0.5F);
    link->hear(heard);
    return !heard.odometry.empty() && !heard.scans.empty() && !heard.batteries.empty() &&
           !heard.transforms.empty();
  }));
  const Odometry& odometry = heard.odometry[0];
  EXPECT_EQ(odometry.stamp, (Stamp{5, 6}));
  EXPECT_EQ(odometry.frame, "odom");
  EXPECT_EQ(odometry.child_frame, "base_link");
  EXPECT_EQ(odometry.position.y, 2.0);
  EXPECT_EQ(odometry.orientation.z, 0.6);
  EXPECT_EQ(odometry.speed, 0.5);
  EXPECT_EQ(odometry.turn_rate, -0.25);
  EXPECT_NE(odometry.writer, 0U);
  EXPECT_EQ(heard.scans[0].ranges, scan.ranges);
  EXPECT_EQ(heard.scans[0].frame, "laser");
  EXPECT_EQ(heard.scans[0].angle_increment, 0.5F);
  EXPECT_EQ(heard.batteries[0].percentage, 0.5F);
  EXPECT_EQ(heard.transforms[0].child, "laser");
  EXPECT_TRUE(heard.transforms[0].is_static);
  EXPECT_FALSE(link->listeners().any_velocity());
}

TEST_F(DdsLinkTest, SaysVelocitiesAsTheKindThatIsListenedTo) {
  open();
  DdsRobot plain(DdsRobot::Listens::kTwist);
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return link->listeners().twist;
  }));
  EXPECT_FALSE(link->listeners().twist_stamped);
  const Velocity velocity{0.5, -0.25, {11, 12}, "base_link"};
  link->say(velocity);
  std::vector<DdsRobot::Told> told;
  ASSERT_TRUE(comes_true([&] { return !(told = plain.take_told()).empty(); }));
  EXPECT_EQ(told[0].speed, 0.5);
  EXPECT_EQ(told[0].turn_rate, -0.25);

  // Another one, of the other kind, beside it: both are told.
  DdsRobot stamped(DdsRobot::Listens::kTwistStamped);
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return link->listeners().twist && link->listeners().twist_stamped;
  }));
  link->say(velocity);
  ASSERT_TRUE(comes_true([&] { return !plain.take_told().empty(); }));
  ASSERT_TRUE(comes_true([&] { return !(told = stamped.take_told()).empty(); }));
  EXPECT_EQ(told[0].speed, 0.5);
  EXPECT_EQ(told[0].stamp, (Stamp{11, 12}));
  EXPECT_EQ(told[0].frame, "base_link");
}

TEST_F(DdsLinkTest, IsListedAsANodeAndLeavesWithItsLastWord) {
  open();
  DdsRobot robot(DdsRobot::Listens::kTwist);
  std::vector<std::string> nodes;
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return !(nodes = robot.take_nodes()).empty() && link->listeners().twist;
  }));
  EXPECT_EQ(nodes[0], testing::namespace_of_this_process() + "/missionlab");
  link->say(Velocity{});
  link.reset();
  EXPECT_TRUE(comes_true([&] { return robot.take_told().size() == 1; }));
  EXPECT_TRUE(comes_true([&] { return robot.velocities().writers() == 0; }));
}

TEST_F(DdsLinkTest, AsksANavigatorForGoalsAndTakesThemBack) {
  open(true);
  DdsRobot robot(DdsRobot::Listens::kNot, Services::kHeaded);
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return link->listeners().can_be_given_goals();
  }));
  EXPECT_EQ(link->listeners().navigator, Services::kHeaded);
  EXPECT_EQ(link->take_news(),
            std::vector<std::string>{"has a navigator, which is asked as rmw_cyclonedds asks"});
  Goal goal;
  goal.id.bytes[3] = 4;
  goal.frame = "odom";
  goal.x = 2.0;
  goal.heading = 1.0;
  link->send(goal);
  std::vector<Goal> goals;
  ASSERT_TRUE(comes_true([&] { return !(goals = robot.take_goals()).empty(); }));
  EXPECT_EQ(goals[0].id, goal.id);
  EXPECT_EQ(goals[0].x, 2.0);
  EXPECT_NEAR(goals[0].heading, 1.0, 1e-9);
  robot.say_goal_state(goal.id, GoalState::kExecuting);
  robot.say_feedback(goal.id, 3);
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return heard.goals && !heard.feedback.empty();
  }));
  ASSERT_EQ(heard.goals->size(), 1U);
  EXPECT_EQ(heard.goals->at(0).id, goal.id);
  EXPECT_EQ(heard.goals->at(0).state, GoalState::kExecuting);
  EXPECT_EQ(heard.feedback[0].id, goal.id);
  EXPECT_EQ(heard.feedback[0].recoveries, 3);
  link->cancel(goal.id);
  link->cancel_all_goals();
  std::vector<GoalId> cancels;
  ASSERT_TRUE(comes_true([&] {
    for (const GoalId& id : robot.take_cancels()) cancels.push_back(id);
    return cancels.size() >= 2;
  }));
  EXPECT_EQ(cancels, (std::vector{goal.id, GoalId{}}));
}

TEST_F(DdsLinkTest, HearsGoalsOfTwoNavigatorsAndForgetsThoseOfTheOneThatGoes) {
  open(true);
  std::optional<DdsRobot> first(std::in_place, DdsRobot::Listens::kNot, Services::kHeaded);
  DdsRobot second(DdsRobot::Listens::kNot, Services::kHeaded);
  GoalId one, other;
  one.bytes[0] = 1;
  other.bytes[0] = 2;
  first->say_goal_state(one, GoalState::kExecuting);
  second.say_goal_state(other, GoalState::kExecuting);
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return heard.goals && heard.goals->size() == 2 && link->listeners().navigators_so_far == 2;
  }));
  first.reset();
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return heard.goals && heard.goals->size() == 1;
  }));
  EXPECT_EQ(heard.goals->at(0).id, other);
}

TEST_F(DdsLinkTest, AsksNothingOfANavigatorThatWouldTakeItForSomethingElse) {
  open(true);
  DdsRobot robot(DdsRobot::Listens::kNot, Services::kUnknown);
  std::vector<std::string> news;
  ASSERT_TRUE(comes_true([&] {
    link->hear(heard);
    return !(news = link->take_news()).empty();
  }));
  EXPECT_EQ(news[0],
            "has a navigator that is asked nothing: it speaks services neither as rmw_fastrtps nor as "
            "rmw_cyclonedds, or there are two that don't agree");
  EXPECT_EQ(link->listeners().navigator, Services::kUnknown);
  link->send(Goal{});
  link->cancel(GoalId{});
  link->cancel_all_goals();
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_TRUE(robot.take_goals().empty());
  EXPECT_TRUE(robot.take_cancels().empty());
}

TEST_F(DdsLinkTest, SharesAProcessWithAFleetOfTheSameNumber) {
  dds::Network fleet;
  fleet.fleet = testing::namespace_of_this_process().substr(1);
  auto member = dds::Participant::open(fleet);
  ASSERT_TRUE(member) << member.error();
  LinkSettings settings = settings_here();
  settings.network.domain = dds::domain_of(fleet.fleet);
  const auto opened = open_link(settings);
  ASSERT_TRUE(opened) << opened.error();
  (*opened)->hear(heard);
  EXPECT_FALSE((*opened)->listeners().any_velocity());
}

TEST(LinkSettings, SayWhatCanNotBe) {
  LinkSettings settings;
  settings.network.domain = 233;
  EXPECT_EQ(open_link(settings).error(), "233 is no domain of ROS: 0 to 232");
  settings.network.domain = 0;
  settings.network.interface_name = "<x>";
  EXPECT_EQ(open_link(settings).error(), "`<x>` is no network interface such as eth0");
  settings.network.interface_name = "";
  settings.network.peers = {"10.0.0.7"};
  EXPECT_EQ(open_link(settings).error(),
            "`10.0.0.7` can't be reached: without a network interface nothing leaves this machine");
  settings.network.peers = {"robot"};
  EXPECT_EQ(open_link(settings).error(),
            "`robot` is no IPv4 address such as 10.0.0.7: names are not looked up");
  settings.network.peers.clear();
  settings.network.interface_name = "no-such-one";
  const auto opened = open_link(settings);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("no-such-one"), std::string::npos) << opened.error();
}

}  // namespace
}  // namespace mlab::ros2
