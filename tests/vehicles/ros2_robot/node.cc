#include "node.h"

#include <chrono>
#include <cmath>

#include <fmt/core.h>

namespace mlab::ros2_robot {
namespace {

constexpr double kPlaceEvery = 0.05;    // [s]
constexpr double kScanEvery = 0.1;      // [s]
constexpr double kBatteryEvery = 1.0;   // [s]
constexpr double kScannerHeight = 0.2;  // [m]
constexpr float kFullVoltage = 25.2F;
constexpr float kEmptyVoltage = 19.8F;
constexpr float kCapacity = 10.0F;  // [Ah]

/// A command that is older than this by its stamp is refused, as diff_drive_controller does; one of no stamp
/// at all is not [s].
constexpr double kOldest = 0.5;

bool is_too_old(const Time& stamp) {
  if (stamp.sec == 0 && stamp.nanosec == 0) return false;
  const Time now = time_now();
  const double age = static_cast<double>(now.sec) - stamp.sec + 1e-9 * now.nanosec - 1e-9 * stamp.nanosec;
  return age > kOldest;
}

constexpr const char* kOdom = "odom";
constexpr const char* kBase = "base_link";
constexpr const char* kLaser = "laser";

}  // namespace

Time time_now() {
  using std::chrono::duration_cast;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = duration_cast<std::chrono::seconds>(now);
  const auto rest = duration_cast<std::chrono::nanoseconds>(now - seconds);
  return {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>(rest.count())};
}

PoseMessage message_of(const geom::Pose& pose) {
  return {{pose.position.x, pose.position.y, 0.0},
          {0.0, 0.0, std::sin(pose.heading / 2.0), std::cos(pose.heading / 2.0)}};
}

geom::Pose pose_of(const PoseMessage& message) {
  const Quaternion& q = message.orientation;
  const double heading = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  return {{message.position.x, message.position.y}, heading};
}

Node::Node(Participant& participant, const NodeSettings& settings, Robot& robot)
    : settings_(settings),
      robot_(robot),
      odometry_(participant.publish<Odometry>("rt" + settings.node_namespace + "/odom", {})),
      scans_(participant.publish<LaserScan>("rt" + settings.node_namespace + "/scan", kSensorData)),
      batteries_(participant.publish<BatteryState>("rt" + settings.node_namespace + "/battery_state", {})),
      transforms_(participant.publish<Transforms>("rt/tf", {.depth = 100})),
      mounts_(participant.publish<Transforms>("rt/tf_static", kLatched)) {
  const std::string topic = "rt" + settings.node_namespace + "/cmd_vel";
  if (settings.is_stamped) {
    stamped_ = participant.subscribe<TwistStamped>(topic, {});
  } else {
    twists_ = participant.subscribe<Twist>(topic, {});
  }
  say_mount();
}

int Node::obey() {
  int out = 0;
  const auto take = [&](const Twist& twist) {
    robot_.command({twist.linear.x, twist.angular.z});
    ++out;
  };
  if (twists_.has_value()) {
    for (Twist one; twists_->take(one);) take(one);
  }
  if (stamped_.has_value()) {
    for (TwistStamped one; stamped_->take(one);) {
      if (is_too_old(one.header.stamp)) {
        fmt::print("a command is too old\n");
      } else {
        take(one.twist);
      }
    }
  }
  return out;
}

bool Node::is_due(double& next, double every) const {
  if (robot_.time() + 1e-9 < next) return false;
  next = std::max(next + every, robot_.time());
  return true;
}

void Node::say() {
  if (is_due(next_place_, kPlaceEvery)) say_place();
  if (is_due(next_scan_, kScanEvery)) say_scan();
  if (is_due(next_battery_, kBatteryEvery)) say_battery();
}

Header Node::header(const char* frame) const {
  return {time_now(), settings_.frame_prefix + frame};
}

void Node::say_place() {
  const PoseMessage counted = message_of(robot_.counted());
  const Speeds speeds = robot_.speeds();
  Odometry told{.header = header(kOdom),
                .child_frame_id = settings_.frame_prefix + kBase,
                .pose = counted,
                .twist = {{speeds.ahead, 0.0, 0.0}, {0.0, 0.0, speeds.turn}}};
  for (const std::size_t diagonal : {0U, 7U, 35U}) {
    told.pose_covariance[diagonal] = 0.01;
    told.twist_covariance[diagonal] = 0.001;
  }
  odometry_.write(told);
  Transforms transforms;
  transforms.transforms.push_back({told.header, told.child_frame_id, counted});
  transforms_.write(transforms);
}

void Node::say_scan() {
  Scan scan = robot_.scan();
  const double last = scan.first_angle + scan.step * static_cast<double>(scan.ranges.size() - 1);
  LaserScan told{.header = header(kLaser),
                 .angle_min = static_cast<float>(scan.first_angle),
                 .angle_max = static_cast<float>(last),
                 .angle_increment = static_cast<float>(scan.step),
                 .scan_time = static_cast<float>(kScanEvery),
                 .range_min = static_cast<float>(robot_.spec().nearest),
                 .range_max = static_cast<float>(robot_.spec().range),
                 .ranges = std::move(scan.ranges)};
  scans_.write(told);
}

void Node::say_battery() {
  const auto left = static_cast<float>(robot_.battery());
  BatteryState told{.header = header(kBase),
                    .voltage = kEmptyVoltage + left * (kFullVoltage - kEmptyVoltage),
                    .temperature = std::nanf(""),
                    .current = -kCapacity / 2.0F,
                    .charge = left * kCapacity,
                    .capacity = kCapacity,
                    .design_capacity = kCapacity,
                    .percentage = left,
                    .power_supply_status = 2,      // it is discharging
                    .power_supply_health = 1,      // good
                    .power_supply_technology = 2,  // lithium ions
                    .present = true};
  batteries_.write(told);
}

void Node::say_mount() {
  Transforms told;
  PoseMessage mount = message_of({{kScannerAhead, 0.0}, 0.0});
  mount.position.z = kScannerHeight;
  told.transforms.push_back({header(kBase), settings_.frame_prefix + kLaser, mount});
  mounts_.write(told);
}

}  // namespace mlab::ros2_robot
