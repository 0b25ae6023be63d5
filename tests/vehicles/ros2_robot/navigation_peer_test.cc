// Our binding gives goals to a robot's Nav2, whose services are spoken as either of ROS 2's two usual
// implementations has them, beside another client.

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

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

TEST_F(Nav2Peer, GoesByGoalsButForAnotherClientsAndStandsWhenTheyAreTakenBack) {
  const auto robot = start_with_nav2({});
  FastClient other(domain_);
  connect(ros2::Drives::kGoals);
  ASSERT_TRUE(becomes([&] { return is_ready() && other.is_connected(); })) << report().why;
  EXPECT_TRUE(is_told("has a navigator, which is asked as rmw_fastrtps asks"));
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

  device_->stop(Clock::now());
  EXPECT_NE(stands(*robot), "") << robot->said();
  // Its `cmd_vel`, which goes before its goals, was told zero, too: they are seen to be gone when that is
  // over.
  const double stood = robot->last("stands at ").value_or(0.0);
  ASSERT_TRUE(becomes([&] { return robot->last(" at ").value_or(0.0) > stood + 0.8; }));
  EXPECT_LT(robot->last("goes at ").value_or(0.0), stood) << robot->said();
}

// The patience with a navigator that does not say what became of a goal goes by on a clock of the test's.
class Nav2Link : public Nav2Peer {
 protected:
  void SetUp() override {
    auto opened = ros2::open_link(link_settings(true));
    ASSERT_TRUE(opened) << opened.error();
    link_ = std::move(*opened);
  }
  bool comes(const std::function<bool()>& is_so) {
    const auto end = Clock::now() + std::chrono::seconds(20);
    while (!is_so() && Clock::now() < end) {
      ros2::Heard heard;
      link_->hear(heard);
      goals_.take(heard, now_);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return is_so();
  }
  bool becomes_served(ros2::Services how) {
    return comes([&] { return link_->listeners().navigator == how; });
  }
  bool ask() {
    now_ += std::chrono::milliseconds(600);
    const auto goal = goals_.next({0.5, 0.0}, {}, "odom", {}, now_);
    if (goal) link_->send(*goal);
    return goal.has_value();
  }
  void take_back() {
    goals_.drop();
    for (const ros2::GoalId& one : goals_.to_take_back(now_)) link_->cancel(one);
  }

  std::unique_ptr<ros2::Link> link_;
  ros2::Goals goals_{2.0, 0.5, 1};
  Clock::time_point now_{std::chrono::hours(1)};
};

TEST_F(Nav2Link, KnowsWhatBecomesOfGoalsHoweverServicesAreSpoken) {
  for (const bool is_headed : {false, true}) {
    SCOPED_TRACE(is_headed);
    RobotProcess robot({"--domain", std::to_string(domain_), "--namespace", "/veh1", "--nav2", "--rmw",
                        is_headed ? "rmw_cyclonedds_cpp" : "rmw_fastrtps_cpp", "--refuses", "1", "--aborts",
                        "1"});
    ASSERT_TRUE(becomes_served(is_headed ? ros2::Services::kHeaded : ros2::Services::kPlain));
    ASSERT_TRUE(ask());
    ASSERT_TRUE(comes([&] { return robot.has_said("refuses a goal"); }));
    EXPECT_EQ(goals_.problem(), "");
    now_ += std::chrono::milliseconds(2100);
    ASSERT_TRUE(comes([&] { return goals_.problem() == "does not take the goals that it is given"; }));
    ASSERT_TRUE(ask());
    ASSERT_TRUE(comes([&] { return goals_.problem() == "finds no way to where it is to go"; }));
    ASSERT_TRUE(ask());
    ASSERT_TRUE(comes([&] { return robot.has_said("goes at ") && goals_.has_any(); })) << robot.said();
    take_back();
    EXPECT_TRUE(comes([&] { return robot.has_said("stands at ") && !goals_.has_any(); })) << robot.said();
    robot.end(SIGTERM);
    ASSERT_TRUE(becomes_served(ros2::Services::kNone));
  }
}

}  // namespace
}  // namespace mlab::ros2_robot
