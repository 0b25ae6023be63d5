// Our binding gives goals to a robot's Nav2, whose services are spoken as either of ROS 2's two usual
// implementations has them, beside another client.

#include <signal.h>

#include <algorithm>
#include <chrono>

#include "fast_client.h"
#include "mlab/ros2/goals.h"
#include "peer_fixture.h"

namespace mlab::ros2_robot {
namespace {

using vehicle::Clock;
using vehicle::Readiness;

class Nav2Peer : public Ros2Peer {
 protected:
  std::unique_ptr<RobotProcess> start_with_nav2(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"--nav2"};
    words.insert(words.end(), more.begin(), more.end());
    return start(words);
  }
  bool is_told(const std::string& news) {
    const auto told = device_->take_news();
    return std::ranges::find(told, news) != told.end();
  }
};

TEST_F(Nav2Peer, GoesByGoalsStandsWhenTheyAreTakenBackAndIsFoundAgain) {
  auto robot = start_with_nav2({});
  connect(ros2::Drives::kGoals);
  ASSERT_TRUE(becomes([&] { return is_ready(); })) << report().why;
  EXPECT_TRUE(is_told("has a navigator, which is asked as rmw_fastrtps asks"));
  ASSERT_TRUE(comes_to(0.2)) << report().why;
  device_->stop(Clock::now());
  EXPECT_NE(stands(*robot), "") << robot->said();
  // Its `cmd_vel`, which goes before its goals, was told zero, too: they are seen to be gone when that is
  // over.
  const double stood = robot->last("stands at ").value_or(0.0);
  ASSERT_TRUE(becomes([&] { return robot->last(" at ").value_or(0.0) > stood + 0.8; }));
  EXPECT_LT(robot->last("goes at ").value_or(0.0), stood) << robot->said();

  robot->end(SIGTERM);
  robot = start_with_nav2({"--rmw", "rmw_cyclonedds_cpp"});
  ASSERT_TRUE(becomes([&] { return is_told("has a navigator, which is asked as rmw_cyclonedds asks"); }));
  // Who counts from elsewhere is believed once the one before is silent.
  ASSERT_TRUE(becomes([&] { return is_ready() && x() < 0.1; })) << report().why;
  EXPECT_FALSE(robot->has_said("goes at ")) << "it stands until the next drive";
  ASSERT_TRUE(comes_to(0.2)) << report().why;
  device_->stop(Clock::now());
  EXPECT_NE(stands(*robot), "") << robot->said();
}

TEST_F(Nav2Peer, IsLeftToAnotherClientUntilItsGoalIsOver) {
  const auto robot = start_with_nav2({});
  FastClient other(domain_);
  connect(ros2::Drives::kGoals);
  ASSERT_TRUE(becomes([&] { return is_ready() && other.is_connected(); })) << report().why;
  const auto is_answered = [&] {
    std::optional<bool> out;
    EXPECT_TRUE(becomes([&] { return (out = other.is_accepted()).has_value(); }, [&] { drive(0.5); }));
    return out.value_or(false);
  };
  ASSERT_TRUE(comes_to(0.05)) << report().why;
  // Its goal is refused while ours is under way: that refusal is not ours.
  other.send(1, 9.0, "nowhere");
  EXPECT_FALSE(is_answered());
  ASSERT_TRUE(comes_to(x() + 0.05)) << report().why;
  EXPECT_EQ(report().readiness, Readiness::kReady) << report().why;

  other.send(2, 9.0);
  EXPECT_TRUE(is_answered());
  ASSERT_TRUE(becomes([&] { return report().readiness == Readiness::kTaken; }, [&] { drive(0.5); }));
  device_->stop(Clock::now());
  const double here = x();
  ASSERT_TRUE(becomes([&] { return x() > here + 0.15; })) << "what is not ours is not taken back";
  other.cancel(2);
  ASSERT_TRUE(becomes([&] { return other.cancel_code() == 0; }));
  ASSERT_TRUE(becomes([&] { return is_ready(); })) << report().why;
  EXPECT_TRUE(comes_to(x() + 0.05)) << "it is ours again";
  EXPECT_EQ(device_->checks(Clock::now())[1].result, vehicle::CheckResult::kPass);
  EXPECT_GT(other.strange_replies(), 0) << "those to us came to it, too";
}

// The patience with a navigator that does not say what became of a goal goes by on a clock of the test's.
TEST_F(Nav2Peer, IsKnownToRefuseAndToAbort) {
  const auto robot = start_with_nav2({"--refuses", "1", "--aborts", "1"});
  auto link = ros2::open_link(link_settings(true));
  ASSERT_TRUE(link) << link.error();
  ros2::Goals goals(2.0, 0.5, 1);
  Clock::time_point now{std::chrono::hours(1)};
  const auto comes = [&](const std::function<bool()>& is_so) {
    const auto end = Clock::now() + std::chrono::seconds(20);
    do {
      ros2::Heard heard;
      (*link)->hear(heard);
      goals.take(heard, now);
    } while (!is_so() && Clock::now() < end);
    return is_so();
  };
  const auto ask = [&] {
    now += std::chrono::milliseconds(600);
    const auto goal = goals.next({0.5, 0.0}, {}, "odom", {}, now);
    if (goal) (*link)->send(*goal);
    return goal.has_value();
  };
  ASSERT_TRUE(comes([&] { return (*link)->listeners().can_be_given_goals(); }));
  ASSERT_TRUE(ask());
  ASSERT_TRUE(comes([&] { return robot->has_said("refuses a goal"); }));
  EXPECT_EQ(goals.problem(), "");
  now += std::chrono::milliseconds(2100);
  ASSERT_TRUE(comes([&] { return goals.problem() == "does not take the goals that it is given"; }));
  ASSERT_TRUE(ask());
  ASSERT_TRUE(comes([&] { return goals.problem() == "finds no way to where it is to go"; }));
  ASSERT_TRUE(ask());
  ASSERT_TRUE(comes([&] { return robot->has_said("goes at "); })) << robot->said();
  EXPECT_TRUE(comes([&] { return goals.has_any(); }));
}

}  // namespace
}  // namespace mlab::ros2_robot
