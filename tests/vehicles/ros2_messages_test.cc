// The bytes that go over the network are those that ROS has for the messages, as another implementation reads
// and writes them with ROS's own definitions.

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/source_folder.h"
#include "mlab/ros2/dds_link.h"
#include "mlab/ros2/testing/dds_robot.h"
#include "ros2.h"

namespace mlab::ros2 {
namespace {

using testing::DdsRobot;

struct Taken {
  std::string type;  // as the other implementation calls it
  std::string bytes;
};

std::string hex_of(const std::string& bytes) {
  std::string out;
  for (const char c : bytes) out += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return out;
}

// Without the zeros that make it a multiple of four bytes long, whose number the header has in its last bits.
std::string unpadded(std::string bytes) {
  const auto padding = static_cast<std::size_t>(bytes.at(3) & 3);
  bytes[3] = '\0';
  bytes.resize(bytes.size() - padding);
  return bytes;
}

// Each message as they read it, and the bytes that they write.
std::vector<nlohmann::json> read_by_them(const std::vector<Taken>& messages) {
  const std::string file = ::testing::TempDir() + "ros2_messages_" + std::to_string(::getpid());
  {
    std::ofstream out(file);
    for (const Taken& one : messages) out << one.type << ' ' << hex_of(one.bytes) << '\n';
  }
  const std::string script =
      (std::filesystem::path(base::source_folder()) / "tests/vehicles/ros2_messages.mjs").string();
  const std::string command = fmt::format("node '{}' '{}' < '{}'", script, MLAB_VEHICLES_FOLDER, file);
  std::vector<nlohmann::json> out;
  FILE* const pipe = ::popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    if (c != '\n') {
      text += static_cast<char>(c);
      continue;
    }
    out.push_back(nlohmann::json::parse(text));
    text.clear();
  }
  EXPECT_EQ(::pclose(pipe), 0);
  std::filesystem::remove(file);
  return out;
}

class Ros2Messages : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(std::filesystem::path(MLAB_VEHICLES_FOLDER) /
                                       "node_modules/@foxglove"))
      GTEST_SKIP() << "no @foxglove/rosmsg2-serialization in " << MLAB_VEHICLES_FOLDER
                   << ": ./mlab test --only e2e installs it";
    LinkSettings settings;
    settings.network.domain = testing::domain_of_this_process();
    settings.robot_namespace = testing::namespace_of_this_process();
    auto opened = open_link(settings);
    ASSERT_TRUE(opened) << opened.error();
    link = std::move(*opened);
  }
  Endpoint listen(const std::string& topic, const dds_topic_descriptor_t& descriptor) {
    auto made = plain.participant().reader(topic, descriptor, "",
                                           {.is_reliable = true, .is_for_latecomers = false, .depth = 10});
    EXPECT_TRUE(made) << made.error();
    return std::move(*made);
  }
  // Says it until it has come, and what it came as.
  Taken take(const std::string& type, DdsRobot& robot, const Endpoint& reader,
             const std::function<void()>& say) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      Heard heard;
      link->hear(heard);
      say();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (auto bytes = robot.take_bytes(reader)) return {type, unpadded(*bytes)};
    }
    ADD_FAILURE() << "nothing comes: " << type;
    return {};
  }

  DdsRobot plain{DdsRobot::Listens::kTwist};
  DdsRobot stamped{DdsRobot::Listens::kTwistStamped};
  DdsRobot publisher{DdsRobot::Listens::kNot};
  std::unique_ptr<Link> link;
};

TEST_F(Ros2Messages, AreReadAndWrittenAlikeByAnotherImplementation) {
  const std::string in = "rt" + testing::namespace_of_this_process();
  const Velocity velocity{0.5, -0.25, {1'700'000'000, 123'456'789}, "base_link"};
  const State state{.stamp = {7, 8},
                    .level = Level::kWarning,
                    .name = "missionlab/veh1",
                    .message = "drives it",
                    .hardware_id = "veh1",
                    .values = {{"speed", "0.500"}, {"turn_rate", "-0.250"}}};
  const Odometry odometry{.stamp = {5, 6},
                          .frame = "odom",
                          .child_frame = "base_link",
                          .position = {1.0, 2.0, 0.0},
                          .orientation = {0.0, 0.0, 0.6, 0.8},
                          .speed = 0.5,
                          .turn_rate = 0.0,
                          .writer = 0};
  const LaserScan scan{.topic = 0,
                       .stamp = {5, 7},
                       .frame = "laser",
                       .angle_min = -1.0F,
                       .angle_increment = 0.5F,
                       .range_min = 0.125F,
                       .range_max = 9.0F,
                       .ranges = {1.0F, 2.0F, 3.0F}};
  const Endpoint states = listen("rt/diagnostics", diagnostic_msgs_msg_dds__DiagnosticArray__desc);
  const Endpoint places = listen(in + "/odom", nav_msgs_msg_dds__Odometry__desc);
  const Endpoint scans = listen(in + "/scan", sensor_msgs_msg_dds__LaserScan__desc);
  const Endpoint batteries = listen(in + "/battery_state", sensor_msgs_msg_dds__BatteryState__desc);
  const Endpoint frames = listen("rt/tf_static", tf2_msgs_msg_dds__TFMessage__desc);

  const std::vector<Taken> taken = {
      take("geometry_msgs/Twist", plain, plain.velocities(), [&] { link->say(velocity); }),
      take("geometry_msgs/TwistStamped", stamped, stamped.velocities(), [&] { link->say(velocity); }),
      take("diagnostic_msgs/DiagnosticArray", plain, states, [&] { link->say(state); }),
      take("nav_msgs/Odometry", plain, places, [&] { publisher.say(odometry); }),
      take("sensor_msgs/LaserScan", plain, scans, [&] { publisher.say(scan); }),
      take("sensor_msgs/BatteryState", plain, batteries, [&] { publisher.say_battery(0.5F); }),
      take("tf2_msgs/TFMessage", plain, frames, [&] { publisher.say_mount("base_link", "laser", 0.25); })};
  const auto read = read_by_them(taken);
  ASSERT_EQ(read.size(), taken.size());
  for (std::size_t i = 0; i < taken.size(); ++i)
    EXPECT_EQ(read[i]["bytes"], hex_of(taken[i].bytes)) << taken[i].type;

  EXPECT_EQ(read[0]["message"]["linear"]["x"], 0.5);
  EXPECT_EQ(read[0]["message"]["angular"]["z"], -0.25);
  EXPECT_EQ(read[1]["message"]["header"]["stamp"]["sec"], 1'700'000'000);
  EXPECT_EQ(read[1]["message"]["header"]["stamp"]["nanosec"], 123'456'789);
  EXPECT_EQ(read[1]["message"]["header"]["frame_id"], "base_link");
  EXPECT_EQ(read[1]["message"]["twist"]["angular"]["z"], -0.25);
  const auto& status = read[2]["message"]["status"][0];
  EXPECT_EQ(status["level"], 1);
  EXPECT_EQ(status["name"], "missionlab/veh1");
  EXPECT_EQ(status["message"], "drives it");
  EXPECT_EQ(status["values"][1]["value"], "-0.250");
  EXPECT_EQ(read[3]["message"]["pose"]["pose"]["orientation"]["w"], 0.8);
  EXPECT_EQ(read[3]["message"]["twist"]["twist"]["linear"]["x"], 0.5);
  EXPECT_EQ(read[4]["message"]["range_min"], 0.125);
  EXPECT_EQ(read[4]["message"]["ranges"], (std::vector<float>{1.0F, 2.0F, 3.0F}));
  EXPECT_EQ(read[5]["message"]["percentage"], 0.5);
  EXPECT_EQ(read[6]["message"]["transforms"][0]["transform"]["translation"]["x"], 0.25);
}

}  // namespace
}  // namespace mlab::ros2
