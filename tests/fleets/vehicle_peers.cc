#include "vehicle_peers.h"

#include <array>
#include <cstdlib>

#include "mlab/mavlink/rover_device.h"
#include "mlab/ros2/ros2_device.h"

namespace mlab::testing {
namespace {

constexpr const char* kPort = "14550";
constexpr const char* kDomain = "7";
constexpr auto kAnswers = 20s;

/// The number behind the last `text` of a whole line; nothing: -1.
double last_number(const std::string& said, const std::string& text) {
  const auto end = said.rfind('\n');
  const auto at = end == std::string::npos ? end : said.rfind(text, end);
  return at == std::string::npos ? -1.0 : std::strtod(said.c_str() + at + text.size(), nullptr);
}

class Ros2Robot final : public VehiclePeer {
 public:
  Ros2Robot(network::Host& host, const std::string& world, const std::string& at)
      : process_(host.start(words(world, at))) {
    EXPECT_TRUE(process_.prints("ready", kFleetPatience)) << process_.output() << process_.errors();
  }
  Moment now() override {
    const std::string said = process_.output();
    const auto end = said.rfind('\n');
    const auto line = end == std::string::npos ? end : said.rfind("\nat ", end);
    Moment out;
    if (line == std::string::npos) return out;
    std::array<double, 4> numbers{};
    char* next = const_cast<char*>(said.c_str()) + line + 4;
    for (double& one : numbers) one = std::strtod(next, &next);
    out.x = numbers[0];
    out.y = numbers[1];
    out.speed = numbers[3];
    out.time = last_number(said, " at ");
    out.stood_at = last_number(said, "stands at ");
    out.stands = out.stood_at >= last_number(said, "goes at ");
    return out;
  }
  std::vector<std::string> options() const override {
    std::vector<std::string> out = {"--binding",   "ros2", "--namespace",     "/veh", "--domain", kDomain,
                                    "--max-speed", "1",    "--max-turn-rate", "45"};
    if (by_nav2_) out.insert(out.end(), {"--drives", "nav2"});
    return out;
  }
  void drive_by_nav2(bool is_so) override { by_nav2_ = is_so; }
  bool is_known_to(const network::Process& robot) const override {
    return robot.prints("the vehicle is ready", kFleetPatience);
  }
  double standstill() const override {
    return by_nav2_ ? ros2::standstill_with_goals(ros2::look_ahead_for(kFullSpeed), kFullSpeed)
                    : standstill_when_told();
  }
  double standstill_when_told() const override { return ros2::robot_limits().standstill; }
  std::string said() const override { return process_.output(); }

 private:
  static std::vector<std::string> words(const std::string& world, const std::string& at) {
    std::vector<std::string> out = {MLAB_ROS2_ROBOT, "--namespace", "/veh", "--domain", kDomain,
                                    "--log",         "--nav2",      "--at", at};
    if (!world.empty()) out.insert(out.end(), {"--world", world});
    return out;
  }
  static constexpr double kFullSpeed = 1.0;  // as the options say [m/s]
  network::Process process_;
  bool by_nav2_ = false;
};

class MavlinkRover final : public VehiclePeer {
 public:
  explicit MavlinkRover(network::Host& host)
      : process_(host.start({"node", base::source_folder() + "/tests/vehicles/rover.mjs",
                             MLAB_VEHICLES_FOLDER, kPort, "1", "obstacle=0"})) {
    EXPECT_TRUE(process_.prints("ready", kFleetPatience)) << process_.output() << process_.errors();
  }
  Moment now() override {
    const std::string question = fmt::format("tell {}", ++questions_);
    if (!process_.write(question + "\n")) return {};
    const std::string asked = fmt::format("\"asked\":\"{}\"}}\n", question);
    for (const auto end = network::Clock::now() + kAnswers; network::Clock::now() < end;) {
      if (const std::string said = process_.output(); said.ends_with(asked)) return read(said);
      std::this_thread::sleep_for(2ms);
    }
    ADD_FAILURE() << "the rover says nothing";
    return {};
  }
  std::vector<std::string> options() const override {
    return {"--binding",   "mavlink", "--device",        std::string("udp:") + kPort,
            "--max-speed", "1",       "--max-turn-rate", "45"};
  }
  // Being driven is what makes it ready: armed, and in mode GUIDED.
  bool is_known_to(const network::Process& robot) const override {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      const std::string said = robot.output();
      for (const char* const state : {"it is not armed", "not GUIDED", "the vehicle is ready"}) {
        if (said.find(state) != std::string::npos) return true;
      }
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }
  double standstill() const override { return mavlink::rover_limits().standstill; }
  std::string said() const override { return process_.output(); }

 private:
  static Moment read(const std::string& said) {
    const auto begin = said.rfind('\n', said.size() - 2);
    const Json told = Json::parse(said.substr(begin == std::string::npos ? 0 : begin + 1));
    return {.time = told["time"],
            .x = told["east"],
            .y = told["north"],
            .speed = told["speed"],
            .stands = told["speed"] == 0.0 && told["yawRate"] == 0.0,
            .stood_at = told["stoodAt"]};
  }
  network::Process process_;
  int questions_ = 0;
};

}  // namespace

std::unique_ptr<VehiclePeer> start_ros2_robot(network::Host& host, const std::string& world,
                                              const std::string& at) {
  return std::make_unique<Ros2Robot>(host, world, at);
}

std::unique_ptr<VehiclePeer> start_mavlink_rover(network::Host& host) {
  return std::make_unique<MavlinkRover>(host);
}

network::Process start_robot(network::Host& host, const std::string& name, const VehiclePeer& peer) {
  std::vector<std::string> words = {MLAB_COMMAND, "robot", "--fleet",   "alpha",
                                    "--name",     name,    "--network", host.address()};
  const auto options = peer.options();
  words.insert(words.end(), options.begin(), options.end());
  return host.start(words, {.environment = {{"XDG_STATE_HOME", kAgentState}}});
}

std::string why_no_peers() {
  if (std::string_view(MLAB_ROS2_ROBOT).empty())
    return "no ROS 2 robot: Fast DDS (libfastrtps-dev) is missing";
  if (!std::filesystem::is_directory(std::filesystem::path(MLAB_VEHICLES_FOLDER) / "node_modules"))
    return "no node-mavlink in " MLAB_VEHICLES_FOLDER ": ./mlab test --only e2e installs it";
  return "";
}

}  // namespace mlab::testing
