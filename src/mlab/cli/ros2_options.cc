#include "mlab/cli/ros2_options.h"

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/option_groups.h"
#include "mlab/ros2/dds_link.h"
#include "mlab/ros2/names.h"
#include "mlab/ros2/ros2_device.h"

namespace mlab::cli {
namespace {

std::expected<int, std::string> domain_of(const Ros2Options& options) {
  if (options.domain) return *options.domain;
  const char* const set =
      std::getenv("ROS_DOMAIN_ID");  // NOLINT(concurrency-mt-unsafe): nobody sets any here
  const std::string text = set == nullptr ? "" : set;
  if (text.empty()) return 0;
  int out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error == std::errc{} && end == text.data() + text.size()) return out;
  return std::unexpected(
      fmt::format("ROS_DOMAIN_ID is `{}`: expected a number from 0 to {}", text, ros2::kLastDomain));
}

/// The fleet's sockets are closed to the network where it is on this machine alone, by their ports; which are
/// the robot's, too, where the numbers are the same.
std::string problem_of(const ros2::RosNetwork& network, const NetworkOptions& fleet) {
  const std::string name = fleet_of(fleet.fleet);
  const auto is_here = [&](const std::string& interface_name) {
    return dds::is_loopback_only({.fleet = name, .interface_name = interface_name, .peers = {}});
  };
  if (network.domain != dds::domain_of(name) || !is_here(fleet.interface_name) ||
      is_here(network.interface_name))
    return "";
  return fmt::format(
      "--domain {}: the fleet `{}` has the same number of DDS, and is on this machine alone: another fleet's "
      "name, or --network, mends that",
      network.domain, name);
}

/// Scanners in full.
std::expected<std::vector<std::string>, std::string> scanners_of(const Ros2Options& options,
                                                                 const std::string& robot_namespace) {
  std::vector<std::string> out;
  const std::vector<std::string> usual = {"scan"};
  for (const std::string& one : options.scans.empty() ? usual : options.scans) {
    auto name = ros2::full_name(robot_namespace, one);
    if (!name) return std::unexpected("--scan: " + name.error());
    out.push_back(std::move(*name));
  }
  if (out.size() > ros2::kMostScanners)
    return std::unexpected(fmt::format("--scan: {} scanners, {} at most", out.size(), ros2::kMostScanners));
  return out;
}

ros2::RobotSettings settings_of(const RobotOptions& options) {
  ros2::RobotSettings out;
  binding::Kinematics& kinematics = out.limits.kinematics;
  kinematics.max_speed = options.max_speed.value_or(kinematics.max_speed);
  if (options.max_turn_rate) kinematics.max_turn_rate = base::radians(*options.max_turn_rate);
  out.limits.radius = options.radius.value_or(out.limits.radius);
  out.places.map_frame = options.ros2.map_frame;
  if (options.origin) out.places.origin = geom::Point{(*options.origin)[0], (*options.origin)[1]};
  if (options.ros2.drives == kDrivesNav2) out.drives = ros2::Drives::kGoals;
  out.look_ahead = options.ros2.look_ahead.value_or(ros2::look_ahead_for(kinematics.max_speed));
  if (out.drives == ros2::Drives::kGoals)
    out.limits.standstill = ros2::standstill_with_goals(*out.look_ahead, kinematics.max_speed);
  out.limits.standstill = options.ros2.standstill.value_or(out.limits.standstill);
  const auto now = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
  out.session = base::combine_bits(now, static_cast<std::uint64_t>(::getpid()));
  return out;
}

}  // namespace

void add_ros2(CLI::App* c, Ros2Options& o) {
  c->add_option("--namespace", o.robot_namespace, "of the robot in ROS: /veh1; without, it has none")
      ->check(refuse_if_empty)
      ->type_name("NAME");
  c->add_option("--domain", o.domain, "ROS's number of the network (default: ROS_DOMAIN_ID, or 0)")
      ->check(CLI::Range(0, ros2::kLastDomain))
      ->type_name("N");
  c->add_option("--scan", o.scans,
                "topic of a scanner, in the namespace or from / on; again for each (default: scan)")
      ->check(refuse_if_empty)
      ->type_name("TOPIC");
  c->add_option("--ros-network", o.interface_name,
                "the network interface, or its address, that the robot is reached by; without, it is on this "
                "machine")
      ->check(refuse_if_empty)
      ->type_name("INTERFACE|ADDRESS");
  c->add_option("--ros-peer", o.peers,
                "address of the robot's machine, where the network carries no multicast; again for each")
      ->check(refuse_if_empty)
      ->type_name("ADDRESS");
  c->add_option(
       "--drives", o.drives,
       "velocities: the robot is told how fast to go, on cmd_vel; nav2: where to go, as goals of Nav2")
      ->check(CLI::IsMember({kDrivesVelocities, kDrivesNav2}))
      ->default_str(kDrivesVelocities)
      ->type_name("WORD");
  c->add_option("--look-ahead", o.look_ahead,
                "with nav2, how far ahead goals are at full speed [m] (default: 2 s of it, 0.8 m at least)")
      ->check(CLI::Range(0.2, 100.0))
      ->type_name("METRES");
  c->add_option("--map-frame", o.map_frame,
                "the frame of tf that is the mission's map; without, the robot begins where START puts it")
      ->check(refuse_if_empty)
      ->type_name("FRAME");
  c->add_option("--standstill", o.standstill,
                "so long after the last command the robot stands by itself, whatever becomes of us [s]")
      ->check(CLI::Range(0.1, 600.0))
      ->type_name("SECONDS");
}

std::expected<std::shared_ptr<vehicle::Device>, std::string> make_ros2(const RobotOptions& options) {
  const Ros2Options& own = options.ros2;
  auto robot_namespace = ros2::namespace_of(own.robot_namespace);
  if (!robot_namespace) return std::unexpected("--namespace: " + robot_namespace.error());
  const auto domain = domain_of(own);
  if (!domain) return std::unexpected(domain.error());
  auto scanners = scanners_of(own, *robot_namespace);
  if (!scanners) return std::unexpected(scanners.error());
  ros2::LinkSettings link{.network = {*domain, own.interface_name, own.peers},
                          .robot_namespace = *robot_namespace,
                          .scanners = *scanners,
                          .has_goals = own.drives == kDrivesNav2};
  if (std::string problem = problem_of(link.network, options.network); !problem.empty())
    return std::unexpected(std::move(problem));
  auto opened = ros2::open_link(link);
  if (!opened) return std::unexpected("ROS's network: " + opened.error());
  ros2::RobotSettings settings = settings_of(options);
  settings.robot_namespace = *robot_namespace;
  settings.scanners = std::move(*scanners);
  return std::make_shared<ros2::Ros2Device>(std::move(*opened), settings);
}

}  // namespace mlab::cli
