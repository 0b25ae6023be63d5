#include "mlab/robot/process/conversation.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/robot/process/testing/programs.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace mlab::robot_process {
namespace {

using robot_wire::testing::same;

const wire::FromRobot& ask(Conversation& conversation, const wire::ToRobot& message) {
  return conversation.answer(message.SerializeAsString());
}

wire::ToRobot start(std::uint32_t robot, std::uint64_t seed, const char* pace = nullptr) {
  wire::ToRobot message;
  message.mutable_start()->set_robot(robot);
  message.mutable_start()->set_seed(seed);
  if (pace != nullptr) {
    wire::Setting& setting = *message.mutable_start()->add_settings();
    setting.set_port("pace");
    setting.set_value(pace);
  }
  return message;
}

// A robot that comes past two obstacles.
struct Walk {
  std::vector<percept::Obstacle> obstacles;
  percept::Percepts percepts;

  explicit Walk(int cycle) {
    const double at = 0.1 * cycle;
    obstacles = {{{4.0 - at, 1.0, 0.0}, 0.5}, {{9.0 - at, -0.3, 0.0}, 1.0}};
    percepts.pose = {{at, 0.0}, 0.01 * cycle};
    percepts.time = at;
    percepts.obstacles = obstacles;
  }
};

TEST(Conversation, ActsAsTheProgramInsideOfARunBitForBit) {
  const auto program = wandering_program();
  Conversation conversation(program, "1");
  constexpr std::uint64_t kSeed = 7;
  std::vector<flow::Frame> frames;
  for (const std::uint32_t robot : {1U, 2U, 5U}) {
    ASSERT_TRUE(ask(conversation, start(robot, kSeed)).has_ready());
    frames.push_back(program->make_frame());
  }
  for (int cycle = 0; cycle < 200; ++cycle) {
    const Walk walk(cycle);
    wire::ToRobot message;
    for (const std::uint32_t robot : {1U, 2U, 5U}) {
      wire::RobotCycle& part = *message.mutable_cycle()->add_robots();
      part.set_robot(robot);
      robot_wire::encode(walk.percepts, *part.mutable_percepts());
    }
    const wire::FromRobot& answer = ask(conversation, message);
    ASSERT_EQ(answer.actions().robots_size(), 3);
    for (int i = 0; i < 3; ++i) {
      const wire::RobotActed& acted = answer.actions().robots(i);
      percept::Action here;
      program->step(frames[static_cast<std::size_t>(i)].data(), walk.percepts, here, kSeed, acted.robot());
      percept::Action there;
      ASSERT_FALSE(robot_wire::decode(acted.action(), there));
      ASSERT_TRUE(same(here, there)) << "robot " << acted.robot() << ", cycle " << cycle;
      ASSERT_GT(geom::length(here.velocity), 0.0);
      EXPECT_EQ(acted.needs().obstacles(), 7.0);
    }
  }
}

TEST(Conversation, DescribesPortsWithTheSettingsThatItTook) {
  Conversation conversation(wandering_program(), "1");
  wire::ToRobot message;
  for (const auto& [port, value] :
       {std::pair("pace", "2.5"), std::pair("pase", "1"), std::pair("walk.range", "-1")}) {
    wire::Setting& setting = *message.mutable_describe()->add_settings();
    setting.set_port(port);
    setting.set_value(value);
  }
  const wire::Description& description = ask(conversation, message).description();
  ASSERT_EQ(description.results_size(), 3);
  EXPECT_EQ(description.results(0).problem(), "");
  EXPECT_TRUE(description.results(1).is_unknown());
  EXPECT_EQ(description.results(2).problem(), "-1 is out of range: `walk.range` takes 0 .. 100 m");
  ASSERT_GT(description.ports_size(), 0);
  const wire::Port& pace = description.ports(0);
  EXPECT_EQ(pace.path(), "pace");
  EXPECT_EQ(pace.role(), wire::Port::PARAMETER);
  EXPECT_EQ(pace.type(), "double");
  EXPECT_EQ(pace.value().number(), 2.5);
  EXPECT_EQ(pace.max(), 10.0);
}

TEST(Conversation, SetsAParameterOfOneRobotAndReadsItsPorts) {
  Conversation conversation(wandering_program(), "1");
  ask(conversation, start(1, 1));
  ask(conversation, start(2, 1, "3"));
  wire::ToRobot set;
  set.mutable_set()->set_robot(1);
  set.mutable_set()->mutable_setting()->set_port("walk.range");
  set.mutable_set()->mutable_setting()->set_value("12");
  EXPECT_EQ(ask(conversation, set).ready().needs().obstacles(), 12.0);
  const auto pace_of = [&](std::uint32_t robot) {
    wire::ToRobot read;
    read.mutable_read_ports()->set_robot(robot);
    read.mutable_read_ports()->add_ports(0);
    const wire::FromRobot& answer = ask(conversation, read);
    return answer.port_values().values_size() == 1 ? answer.port_values().values(0).number() : -1.0;
  };
  EXPECT_EQ(pace_of(1), 1.0);
  EXPECT_EQ(pace_of(2), 3.0);
  set.mutable_set()->mutable_setting()->set_value("far");
  EXPECT_EQ(ask(conversation, set).ready().problem(),
            "`far` is no number: `walk.range` takes a number, 0 .. 100 [m]");
}

TEST(Conversation, ARobotThatIsStartedAgainBeginsAnew) {
  Conversation conversation(wandering_program(), "1");
  ask(conversation, start(1, 1, "3"));
  ask(conversation, start(1, 1));
  wire::ToRobot read;
  read.mutable_read_ports()->set_robot(1);
  read.mutable_read_ports()->add_ports(0);
  const wire::FromRobot& answer = ask(conversation, read);
  ASSERT_EQ(answer.port_values().values_size(), 1);
  EXPECT_EQ(answer.port_values().values(0).number(), 1.0);
}

TEST(Conversation, AnswersWhatItCannotServeAndChangesNothing) {
  Conversation conversation(wandering_program(), "1");
  ask(conversation, start(1, 1));
  EXPECT_EQ(conversation.answer("\xff\xff\xff").problem().text(), "this is no message of the protocol");
  EXPECT_EQ(conversation.answer("").problem().text(), "a message of a kind that this program does not know");
  wire::ToRobot message;
  message.mutable_hello()->set_protocol(2);
  EXPECT_EQ(ask(conversation, message).problem().text(),
            "this program speaks version 1 of the protocol, not 2");
  message.mutable_cycle()->add_robots()->set_robot(1);
  message.mutable_cycle()->add_robots()->set_robot(9);
  EXPECT_EQ(ask(conversation, message).problem().text(), "robot 9 was never started here");
  message.mutable_cycle()->mutable_robots(1)->set_robot(1);
  EXPECT_EQ(ask(conversation, message).problem().text(), "robot 1 stands in one cycle twice");
  message.mutable_cycle()->mutable_robots(1)->mutable_percepts()->mutable_ranges()->add_hit(true);
  EXPECT_EQ(ask(conversation, message).problem().text(),
            "the percepts of robot 1: the columns of the ranges are not equally long");
  message.mutable_read_ports()->set_robot(1);
  message.mutable_read_ports()->add_ports(1000);
  EXPECT_TRUE(ask(conversation, message).problem().text().starts_with("there is no port 1000"));
  EXPECT_EQ(ask(conversation, start(1, 1, "fast")).ready().problem(),
            "`fast` is no number: `pace` takes a number, 0 .. 10");
}

TEST(Conversation, NamesThePortWhereANumberWentWrong) {
  Conversation conversation(wandering_program(), "1");
  ask(conversation, start(1, 1));
  Walk walk(0);
  walk.obstacles[0].center.x = std::numeric_limits<double>::quiet_NaN();
  wire::ToRobot message;
  wire::RobotCycle& part = *message.mutable_cycle()->add_robots();
  part.set_robot(1);
  robot_wire::encode(walk.percepts, *part.mutable_percepts());
  EXPECT_EQ(ask(conversation, message).actions().robots(0).fault(), "walk");
}

}  // namespace
}  // namespace mlab::robot_process
