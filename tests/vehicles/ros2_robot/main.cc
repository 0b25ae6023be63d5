// mlab_ros2_robot: a robot with two driven wheels, a laser scanner and Nav2, on Fast DDS, for tests.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "mlab/base/angle.h"
#include "mlab/lang/odl/odl.h"
#include "navigation_server.h"
#include "node.h"
#include "participant.h"
#include "robot.h"

namespace mlab::ros2_robot {
namespace {

constexpr const char* kDescription =
    "A ROS 2 robot that isn't there: two driven wheels and a laser scanner in the world of an overlay, for "
    "tests.\n"
    "It speaks over Fast DDS, on the loopback alone, without an installation of ROS 2; in its namespace it "
    "has\n"
    "\n"
    "  cmd_vel           Twist or TwistStamped, which it obeys; 0.5 s after the last one it brakes, and one "
    "whose\n"
    "                    stamp is older than that it refuses\n"
    "  odom              Odometry, 20 a second: counted from where it was switched on, and it drifts\n"
    "  scan              LaserScan, 10 a second\n"
    "  battery_state     BatteryState, 1 a second\n"
    "  navigate_to_pose  the action, with --nav2; cmd_vel goes before\n"
    "\n"
    "and besides /tf (odom to base_link), /tf_static (base_link to laser, 0.1 m ahead), ros_discovery_info.\n"
    "It prints `ready`; then, each with the seconds since it was switched on, `goes at T`, `brakes at T: "
    "WHY`\n"
    "(its commanded velocity became zero), `stands at T`; and with --log, 20 times a second, where it "
    "really\n"
    "is: `at X Y DEGREES SPEED at T`. It runs until it is interrupted, or for --seconds.";

constexpr double kStep = 0.01;  // [s]
/// What it misses where the machine was busy for longer: neither does it move, nor does it lose patience [s].
constexpr double kLongestGap = 0.1;
constexpr double kLogEvery = 0.05;  // [s]
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadInput = 2;

volatile std::sig_atomic_t has_to_end = 0;

void note_end(int) {
  has_to_end = 1;
}

struct Options {
  NodeSettings node;
  RobotSpec robot;
  std::vector<double> at = {0.0, 0.0, 0.0};
  std::string world;
  double battery_percent = 90.0;
  double seconds = 0.0;   // 0: without end
  double speed_up = 1.0;  // of its time, against the machine's
  bool has_nav2 = false;
  NavigationSettings navigation;
  bool logs = false;
};

void add_navigation(CLI::App& app, Options& options) {
  app.add_flag("--nav2", options.has_nav2, "goals by Nav2's action NavigateToPose");
  app.add_option("--rmw", options.navigation.services, "how its services are spoken")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Services>{
          {"rmw_fastrtps_cpp", Services::kPlain}, {"rmw_cyclonedds_cpp", Services::kHeaded}}))
      ->default_str("rmw_fastrtps_cpp");
  app.add_option("--refuses", options.navigation.refused, "so many goals at first")->capture_default_str();
  app.add_option("--aborts", options.navigation.aborted, "so many of those that it accepts at first")
      ->capture_default_str();
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--namespace", options.node.node_namespace, "of its topics, such as /veh1")
      ->check([](const std::string& name) {
        const bool is_good = name.size() > 1 && name.front() == '/' && name.back() != '/';
        return is_good ? "" : "a namespace begins with `/`, such as /veh1, not `" + name + "`";
      });
  app.add_option("--domain", options.node.domain, "of DDS, as ROS_DOMAIN_ID has it")
      ->check(CLI::Range(0, 232))
      ->capture_default_str();
  app.add_option("--at", options.at,
                 "where it is switched on: metres, and degrees counter-clockwise from east")
      ->type_name("X,Y,DEGREES")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--world", options.world, "what is around it: an overlay; without one there is nothing")
      ->type_name("FILE.odl");
  app.add_flag("--stamped", options.node.is_stamped, "cmd_vel is TwistStamped instead of Twist");
  app.add_option("--frame-prefix", options.node.frame_prefix,
                 "before the names of its frames, such as veh1/");
  app.add_option("--max-speed", options.robot.max_speed, "[m/s]")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--acceleration", options.robot.acceleration, "with which it starts and brakes [m/s^2]")
      ->check(CLI::Range(0.01, 20.0))
      ->capture_default_str();
  app.add_option("--drift", options.robot.drift, "by what share its odometry is off")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--beams", options.robot.beams, "of its scanner, one a degree: 360 all round, 180 ahead")
      ->check(CLI::IsMember({180, 360}))
      ->capture_default_str();
  app.add_option("--range", options.robot.range, "of its scanner [m]")
      ->check(CLI::Range(0.5, 100.0))
      ->capture_default_str();
  app.add_option("--range-noise", options.robot.range_noise, "of its scanner, standard deviation [m]")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--battery", options.battery_percent, "that is left at the beginning [percent]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--seed", options.robot.seed, "of drift and noise")->capture_default_str();
  app.add_option("--speed-up", options.speed_up, "its time runs so many times as fast as the machine's")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  app.add_option("--seconds", options.seconds, "of its time, that it runs; 0: until it is interrupted")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_flag("--log", options.logs, "says 20 times a second where it is");
}

bool read_world(const std::string& file, overlay::Overlay& into) {
  if (file.empty()) return true;
  text::Diagnostics sink;
  const bool is_read = odl::load_overlay(file, into, sink);
  std::fputs(text::render(sink).c_str(), stderr);
  return is_read;
}

/// Says what the robot does, for who waits for it.
class Teller {
 public:
  explicit Teller(bool logs) : logs_(logs) {}

  void tell(const Robot& robot) {
    const Speeds told = robot.commanded();
    const Speeds moves = robot.speeds();
    const bool is_told = told.ahead != 0.0 || told.turn != 0.0;
    const bool stands = !is_told && moves.ahead == 0.0 && moves.turn == 0.0;
    if (is_told && !was_told_) fmt::print("goes at {:.3f}\n", robot.time());
    if (!is_told && was_told_) fmt::print("brakes at {:.3f}: {}\n", robot.time(), reason(robot));
    if (stands && !stood_) fmt::print("stands at {:.3f}\n", robot.time());
    was_told_ = is_told;
    was_driven_ = robot.is_driven();
    stood_ = stands;
    if (logs_ && robot.time() + 1e-9 >= next_) {
      next_ = std::max(next_ + kLogEvery, robot.time());
      const geom::Pose pose = robot.pose();
      fmt::print("at {:.3f} {:.3f} {:.1f} {:.3f} at {:.3f}\n", pose.position.x, pose.position.y,
                 base::degrees(pose.heading), moves.ahead, robot.time());
    }
  }

 private:
  std::string reason(const Robot& robot) const {
    if (robot.is_driven()) return "it was told so";
    return was_driven_ ? fmt::format("nobody has told it anything since {:.3f}", robot.heard_at())
                       : "its navigation has it so";
  }
  bool logs_;
  bool was_told_ = false;
  bool was_driven_ = false;
  bool stood_ = true;
  double next_ = 0.0;
};

void serve(const Options& options, const overlay::Overlay& world) {
  using Clock = std::chrono::steady_clock;
  Robot robot(world, options.robot);
  Participant participant(options.node.domain, options.node.node_namespace, "mlab_ros2_robot");
  Node node(participant, options.node, robot);
  std::unique_ptr<NavigationServer> navigation;
  if (options.has_nav2)
    navigation = std::make_unique<NavigationServer>(participant, options.node, options.navigation, robot);
  participant.introduce();
  fmt::print("ready\n");
  std::fflush(stdout);
  Teller teller(options.logs);
  Clock::time_point stepped = Clock::now();
  const auto of_the_machine = [&](double seconds) {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(seconds / options.speed_up));
  };
  const auto step = of_the_machine(kStep);
  const auto longest = of_the_machine(kLongestGap);
  while (has_to_end == 0 && (options.seconds == 0.0 || robot.time() < options.seconds)) {
    std::this_thread::sleep_until(stepped + step);
    stepped = std::max(stepped, Clock::now() - longest);
    node.obey();
    if (navigation) navigation->work();
    for (; stepped + step <= Clock::now(); stepped += step) {
      robot.step(kStep);
      teller.tell(robot);
    }
    node.say();
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  CLI::App app(kDescription, "mlab_ros2_robot");
  Options options;
  add_options(app, options);
  add_navigation(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kBadInput;
  }
  overlay::Overlay world;
  if (!read_world(options.world, world)) return kBadInput;
  options.robot.place = {{options.at[0], options.at[1]}, base::radians(options.at[2])};
  options.robot.battery = options.battery_percent / 100.0;
  std::signal(SIGINT, note_end);
  std::signal(SIGTERM, note_end);
  serve(options, world);
  return kDone;
}

}  // namespace
}  // namespace mlab::ros2_robot

int main(int argc, char** argv) {
  try {
    return mlab::ros2_robot::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "mlab_ros2_robot: {}\n", e.what());
    return mlab::ros2_robot::kFailed;
  }
}
