#include "mlab/agents/fleet_runner.h"

#include <chrono>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "mlab/agents/topics.h"
#include "mlab/dds/participant.h"
#include "mlab/presence.pb.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::agents {
namespace {

using std::chrono::seconds;

// A mission names ten machines, none of which is there.
TEST(FleetRunner, WaitsForAllThatAreMissingTogether) {
  const auto roster =
      Roster::join({.fleet = "runner-" + std::to_string(::getpid()), .interface_name = {}, .peers = {}});
  ASSERT_TRUE(roster) << roster.error();
  constexpr seconds kPatience(1);
  const auto runner = make_fleet_runner(*roster, 1, "test", 0.0, {}, kPatience);
  std::vector<robot::RobotProgram> programs(10);
  const Clock::time_point begin = Clock::now();
  for (std::uint32_t i = 0; i < programs.size(); ++i) {
    programs[i].name = "robot";
    programs[i].host = "w" + std::to_string(i);
    const auto member = runner->add({i + 1}, programs[i]);
    if (i > 0) continue;
    EXPECT_GE(Clock::now() - begin, kPatience);
    EXPECT_EQ(runner->start(member).value_or("").substr(0, 50),
              "has no agent: none of the name `w0` has joined the");
  }
  EXPECT_LT(Clock::now() - begin, 5 * kPatience) << "not one after the other";
}

// Somebody who says that he is an agent, and nothing else.
class Presence {
 public:
  Presence(const std::string& fleet, const std::string& name)
      : participant_(dds::Participant::open({.fleet = fleet, .interface_name = {}, .peers = {}}).value()),
        writer_(participant_.writer(kPresenceTopic, dds::ChannelKind::kPresence).value()),
        name_(name) {
    wire::AgentPresence said;
    said.set_name(name);
    said.set_host("n1");
    EXPECT_EQ(writer_.write(name, said.SerializeAsString()), dds::Written::kDone);
  }
  /// In order.
  void leave() { EXPECT_EQ(writer_.end(name_), dds::Written::kDone); }

 private:
  dds::Participant participant_;
  dds::Writer writer_;
  std::string name_;
};

TEST(FleetRunner, SaysOfWhoHasGoneThatHeHas) {
  const std::string fleet = "gone-" + std::to_string(::getpid());
  const auto roster = Roster::join({.fleet = fleet, .interface_name = {}, .peers = {}});
  ASSERT_TRUE(roster) << roster.error();
  const auto is_there = [](bool wanted) {
    return [wanted](const std::vector<Member>& members) {
      return !members.empty() && (members[0].state == Member::State::kThere) == wanted;
    };
  };
  const auto runner = make_fleet_runner(*roster, 1, "test", 0.0, {}, std::chrono::milliseconds(10));
  std::vector<robot::RobotProgram> programs(2);
  programs[0].host = "north";
  programs[0].name = programs[1].name = "robot";
  std::vector<robot::ProgramRunner::Member> robots;
  for (std::uint32_t i = 0; i < programs.size(); ++i) robots.push_back(runner->add({i + 1}, programs[i]));
  EXPECT_TRUE(runner->start(robots[1]).value_or("").starts_with("has no agent: none has joined the fleet"));
  Presence north(fleet, "north");
  ASSERT_TRUE((*roster)->wait(is_there(true), Clock::now() + seconds(60)));
  north.leave();
  ASSERT_TRUE((*roster)->wait(is_there(false), Clock::now() + seconds(60)));
  const std::string left = "`north`, on `n1`, left the fleet `" + fleet + "` ";
  EXPECT_TRUE(runner->start(robots[0]).value_or("").starts_with("has no agent: " + left))
      << *runner->start(robots[0]);
  EXPECT_TRUE(runner->start(robots[1]).value_or("").starts_with("has no agent: nobody is left: " + left))
      << *runner->start(robots[1]);
}

}  // namespace
}  // namespace mlab::agents
