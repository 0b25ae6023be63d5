// Goals by Nav2's action NavigateToPose, asked for from Cyclone DDS as rmw_cyclonedds asks.

#include <signal.h>

#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "cyclone_side.h"
#include "robot_process.h"

namespace mlab::ros2_robot {
namespace {

using GoalRequest = nav2_msgs_action_dds__NavigateToPose_SendGoal_Request_;
using GoalResponse = nav2_msgs_action_dds__NavigateToPose_SendGoal_Response_;
using ResultRequest = nav2_msgs_action_dds__NavigateToPose_GetResult_Request_;
using ResultResponse = nav2_msgs_action_dds__NavigateToPose_GetResult_Response_;
using CancelRequest = action_msgs_srv_dds__CancelGoal_Request_;
using CancelResponse = action_msgs_srv_dds__CancelGoal_Response_;
using FeedbackSample = nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_;
using StatusSample = action_msgs_msg_dds__GoalStatusArray_;

constexpr int kSucceeded = 4;
constexpr int kCanceled = 5;
constexpr int kAborted = 6;
constexpr std::uint64_t kSelf = 0x1234'5678'9abc'def0;  // who asks

/// A client of the action; its goals are told apart by one number.
class Client {
 public:
  explicit Client(const CycloneSide& side)
      : goals_(side.writer(nav2_msgs_action_dds__NavigateToPose_SendGoal_Request__desc,
                           name("rq", "send_goalRequest"))),
        accepted_(side.reliable_reader(nav2_msgs_action_dds__NavigateToPose_SendGoal_Response__desc,
                                       name("rr", "send_goalReply"))),
        questions_(side.writer(nav2_msgs_action_dds__NavigateToPose_GetResult_Request__desc,
                               name("rq", "get_resultRequest"))),
        results_(side.reliable_reader(nav2_msgs_action_dds__NavigateToPose_GetResult_Response__desc,
                                      name("rr", "get_resultReply"))),
        cancels_(
            side.writer(action_msgs_srv_dds__CancelGoal_Request__desc, name("rq", "cancel_goalRequest"))),
        canceled_(side.reliable_reader(action_msgs_srv_dds__CancelGoal_Response__desc,
                                       name("rr", "cancel_goalReply"))),
        feedback_(side.reliable_reader(nav2_msgs_action_dds__NavigateToPose_FeedbackMessage__desc,
                                       name("rt", "feedback"))),
        states_(side.reader(action_msgs_msg_dds__GoalStatusArray__desc, name("rt", "status"), true)) {}

  bool is_connected() const {
    for (const dds_entity_t one :
         {goals_, accepted_, questions_, results_, cancels_, canceled_, feedback_, states_}) {
      if (!has_partner(one)) return false;
    }
    return true;
  }
  /// Sends a goal, waits whether it is accepted, and asks for its result.
  bool send(std::uint8_t number, double x, const std::string& frame = "map") {
    GoalRequest asked{};
    asked.guid = kSelf;
    asked.seq = ++sequence_;
    asked.goal_id[0] = number;
    std::string frame_id = frame;
    std::string tree;
    asked.pose.header.frame_id = frame_id.data();
    asked.behavior_tree = tree.data();
    asked.pose.pose.position.x = x;
    asked.pose.pose.orientation.w = 1.0;
    dds_write(goals_, &asked);
    std::optional<bool> is_accepted;
    becomes([&] {
      take<GoalResponse>(accepted_, [&](const GoalResponse& one) {
        if (one.guid == kSelf && one.seq == sequence_) is_accepted = one.accepted;
      });
      return is_accepted.has_value();
    });
    EXPECT_TRUE(is_accepted.has_value());
    ResultRequest question{};
    question.guid = kSelf;
    question.seq = ++sequence_;
    question.goal_id[0] = number;
    asked_[sequence_] = number;
    dds_write(questions_, &question);
    return is_accepted.value_or(false);
  }
  int cancel(std::uint8_t number) {
    CancelRequest asked{};
    asked.guid = kSelf;
    asked.seq = ++sequence_;
    asked.goal_info.goal_id[0] = number;
    dds_write(cancels_, &asked);
    std::optional<int> code;
    becomes([&] {
      take<CancelResponse>(canceled_, [&](const CancelResponse& one) {
        if (one.seq != sequence_) return;
        code = one.return_code;
        EXPECT_EQ(one.goals_canceling._length, one.return_code == 0 ? 1U : 0U);
      });
      return code.has_value();
    });
    return code.value_or(-1);
  }
  /// The state by which the goal ended; 0: it has not yet.
  int result(std::uint8_t number) {
    take<ResultResponse>(results_, [&](const ResultResponse& one) {
      EXPECT_EQ(one.guid, kSelf);
      results_of_[asked_[one.seq]] = static_cast<unsigned char>(one.status);
    });
    return results_of_[number];
  }
  /// That was told last of the goal as not yet driven [m].
  double distance(std::uint8_t number) {
    take<FeedbackSample>(
        feedback_, [&](const FeedbackSample& one) { distances_[one.goal_id[0]] = one.distance_remaining; });
    return distances_.contains(number) ? distances_[number] : std::nan("");
  }
  int state(std::uint8_t number) {
    take<StatusSample>(states_, [&](const StatusSample& one) {
      for (std::uint32_t i = 0; i < one.status_list._length; ++i)
        states_of_[one.status_list._buffer[i].goal_info.goal_id[0]] =
            static_cast<unsigned char>(one.status_list._buffer[i].status);
    });
    return states_of_[number];
  }

 private:
  static std::string name(const std::string& prefix, const std::string& what) {
    return prefix + "/veh1/navigate_to_pose/_action/" + what;
  }
  dds_entity_t goals_;
  dds_entity_t accepted_;
  dds_entity_t questions_;
  dds_entity_t results_;
  dds_entity_t cancels_;
  dds_entity_t canceled_;
  dds_entity_t feedback_;
  dds_entity_t states_;
  std::int64_t sequence_ = 0;
  std::map<std::int64_t, std::uint8_t> asked_;
  std::map<std::uint8_t, int> results_of_;
  std::map<std::uint8_t, int> states_of_;
  std::map<std::uint8_t, double> distances_;
};

TEST(Ros2RobotNavigation, GoesToGoalsTheNewestFirstAndStandsWhereOneIsCanceled) {
  const int domain = free_domain();
  const CycloneSide side(domain);
  RobotProcess robot({"--domain", std::to_string(domain), "--namespace", "/veh1", "--nav2", "--rmw",
                      "rmw_cyclonedds_cpp", "--log", "--drift", "0", "--speed-up", "4", "--seconds", "300"});
  Client client(side);
  ASSERT_TRUE(becomes([&] { return client.is_connected(); })) << robot.said();
  EXPECT_FALSE(client.send(1, 5.0, "nowhere")) << "a frame that it does not know";
  EXPECT_TRUE(client.send(2, 5.0));
  EXPECT_TRUE(becomes([&] { return client.distance(2) < 4.95; })) << robot.said();
  EXPECT_TRUE(client.send(3, 0.5));
  EXPECT_TRUE(becomes([&] { return client.result(2) == kAborted; })) << "the newer one goes before";
  EXPECT_TRUE(becomes([&] { return client.result(3) == kSucceeded; })) << robot.said();
  EXPECT_EQ(client.result(1), 0);
  EXPECT_TRUE(becomes([&] { return client.state(3) == kSucceeded && client.state(2) == kAborted; }));
  ASSERT_TRUE(becomes([&] { return robot.has_said("\nstands at "); })) << robot.said();

  EXPECT_TRUE(client.send(4, 5.0));
  EXPECT_TRUE(becomes([&] { return client.distance(4) < 4.3; })) << robot.said();
  const double stood = robot.last("\nstands at ").value_or(0.0);
  EXPECT_EQ(client.cancel(4), 0);
  EXPECT_EQ(client.cancel(9), 2) << "there is no such goal";
  EXPECT_TRUE(becomes([&] { return client.result(4) == kCanceled; }));
  EXPECT_TRUE(becomes([&] { return robot.last("\nstands at ").value_or(0.0) > stood; })) << robot.said();
  EXPECT_EQ(client.cancel(4), 3) << "it is over";
}

}  // namespace
}  // namespace mlab::ros2_robot
