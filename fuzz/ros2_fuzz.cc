// Whatever a robot under ROS 2 publishes, message by message: numbers out of the input, among them those that
// are none, stamps of any time, frames with few names, so that they meet. What is reported is a number and
// not of the future, and the robot is never told to be faster than its limits, nor to move while nobody
// drives it.

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "mlab/ros2/ros2_device.h"
#include "vehicle_bytes.h"

namespace {

using namespace mlab;
using vehicle::Clock;

class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool is_over() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t out = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return out;
  }
  std::uint32_t word() {
    std::uint32_t out = 0;
    for (int i = 0; i < 4; ++i) out = out << 8U | byte();
    return out;
  }
  /// Mostly one that a robot could say.
  double number() {
    constexpr double kAwkward[] = {0.0, -0.0, 1e300, -1e300, 1e-300, 1e7, -1.0, 1.0};
    const std::uint8_t kind = byte();
    if (kind < 8) return kAwkward[kind];
    if (kind == 8) return std::numeric_limits<double>::quiet_NaN();
    if (kind == 9) return std::numeric_limits<double>::infinity();
    if (kind == 10) return std::bit_cast<float>(word());
    return (static_cast<double>(byte()) - 128.0) / (kind < 128 ? 64.0 : 4.0);
  }
  std::string frame() {
    constexpr const char* kFrames[] = {"odom", "base_link", "laser", "map", "/base_link", "", "a", "b"};
    return kFrames[byte() % std::size(kFrames)];
  }
  ros2::Stamp stamp(Clock::time_point now) {
    const auto seconds =
        std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
    const std::uint8_t kind = byte();
    if (kind < 16) return {static_cast<std::int32_t>(word()), word()};
    const auto late = static_cast<std::int64_t>(kind) - 200;
    const std::int64_t millis = seconds + std::min<std::int64_t>(late, 0) * 4;
    return {static_cast<std::int32_t>(millis / 1000), static_cast<std::uint32_t>(millis % 1000) * 1'000'000U};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// Hears what is in the input, and looks at what is said.
class Script final : public ros2::Link {
 public:
  explicit Script(Input& input) : input_(input) {}
  const std::string& name() const override { return name_; }
  void hear(ros2::Heard& heard) override {
    for (int i = input_.byte() % 4; i > 0; --i) add(heard);
  }
  ros2::Listeners listeners() const override { return listeners_; }
  void say(const ros2::Velocity& velocity) override {
    fuzz::require(std::abs(velocity.speed) <= 0.5 && std::abs(velocity.turn_rate) <= 1.0);
    fuzz::require(may_move || (velocity.speed == 0.0 && velocity.turn_rate == 0.0));
  }
  void say(const ros2::State& state) override { fuzz::require(state.message.size() < 1000); }
  void send(const ros2::Goal& goal) override {
    fuzz::require(may_move && std::isfinite(goal.x) && std::isfinite(goal.y) && std::isfinite(goal.heading));
    fuzz::require(listeners_.can_be_given_goals());
    ids_[++sent_ % ids_.size()] = goal.id;
  }
  void cancel(const ros2::GoalId& id) override {
    fuzz::require(std::ranges::equal(kMark, std::span(id.bytes).first<4>()));
  }
  void cancel_all_goals() override { fuzz::require(may_stop_all); }
  std::vector<std::string> take_news() override { return {}; }

  Clock::time_point now;
  bool may_move = false;
  bool may_stop_all = false;

 private:
  /// What ids of goals of ours begin with: others' are not taken back one by one.
  static constexpr std::array<std::uint8_t, 4> kMark = {'m', 'l', 'a', 'b'};
  /// One of those that were sent, or of somebody.
  ros2::GoalId goal_id() {
    const std::uint8_t kind = input_.byte();
    if (kind < 160) return ids_[kind % ids_.size()];
    ros2::GoalId out;
    for (std::uint8_t& one : out.bytes) one = kind < 240 ? 0 : input_.byte();
    out.bytes[0] = kind % 4;
    return out;
  }
  void add(ros2::Heard& heard) {
    switch (input_.byte() % 9) {
      case 0:
        add_scan(heard);
        break;
      case 1:
        heard.transforms.push_back({input_.frame(), input_.frame(), vector(), rotation(),
                                    input_.byte() % 2 == 0, input_.byte() % 2 == 0});
        break;
      case 2:
        heard.batteries.push_back({static_cast<float>(input_.number()), static_cast<float>(input_.number())});
        break;
      case 3: {
        const std::uint8_t bits = input_.byte();
        listeners_.twist = (bits & 1U) != 0;
        listeners_.twist_stamped = (bits & 2U) != 0;
        if ((bits & 4U) != 0) listeners_.navigator = static_cast<ros2::Services>(bits >> 6U);
        if ((bits & 8U) != 0) ++listeners_.navigators_so_far;
        break;
      }
      case 4: {
        if (!heard.goals) heard.goals.emplace();
        const std::size_t times = input_.byte() % 32 == 0 ? 100 : 1;
        for (std::size_t i = input_.byte() % 4 * times; i > 0; --i)
          heard.goals->push_back({goal_id(), static_cast<ros2::GoalState>(input_.byte() % 7)});
        break;
      }
      case 5:
        heard.feedback.push_back({goal_id(), static_cast<std::int16_t>(input_.word())});
        break;
      default:
        heard.odometry.push_back({input_.stamp(now), input_.frame(), input_.frame(), vector(), rotation(),
                                  input_.number(), input_.number(), input_.byte() % 2U + 1U});
    }
  }
  void add_scan(ros2::Heard& heard) {
    ros2::LaserScan& scan = heard.scans.emplace_back();
    scan.topic = input_.byte() % 3;
    scan.stamp = input_.stamp(now);
    scan.frame = input_.frame();
    scan.angle_min = static_cast<float>(input_.number());
    scan.angle_increment = static_cast<float>(input_.number());
    scan.range_min = static_cast<float>(input_.number());
    scan.range_max = static_cast<float>(input_.number());
    const std::size_t times = input_.byte() % 16 == 0 ? 40 : 1;
    const std::size_t count = times * input_.byte();
    for (std::size_t i = 0; i < count; ++i)
      scan.ranges.push_back(i < 32 ? static_cast<float>(input_.number()) : 1.0F);
  }
  ros2::Vector3 vector() { return {input_.number(), input_.number(), 0.0}; }
  ros2::Quaternion rotation() {
    if (input_.byte() % 4 != 0) return {};
    return {input_.number(), input_.number(), input_.number(), input_.number()};
  }

  Input& input_;
  const std::string name_ = "fuzz";
  ros2::Listeners listeners_{.twist = true, .twist_stamped = true, .navigator = ros2::Services::kPlain};
  std::array<ros2::GoalId, 4> ids_{};
  std::size_t sent_ = 0;
};

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  Input input(std::span(data, size));
  ros2::RobotSettings settings;
  const std::uint8_t kind = input.byte();
  if ((kind & 1U) != 0) settings.drives = ros2::Drives::kGoals;
  if ((kind & 2U) != 0) settings.places.map_frame = "map";
  settings.scanners = {"scan", "scan_2"};
  auto link = std::make_unique<Script>(input);
  Script& script = *link;
  ros2::Ros2Device device(std::move(link), settings);
  Clock::time_point now{std::chrono::hours(1)};
  for (int i = 0; i < 300 && !input.is_over(); ++i) {
    const std::uint8_t step = input.byte();
    now += std::chrono::milliseconds(step % 8 == 0 ? 10 * step : 50);
    script.now = now;
    script.may_move = false;
    device.work(now);
    fuzz::check_report(device.report(now), now);
    fuzz::require(device.report(now).scans.size() <= 2);
    script.may_move = true;
    if (step % 5 == 4) device.stop(now);
    script.may_stop_all = script.may_stop_all || step % 32 == 31;
    if (step % 32 == 31) device.stop_in_emergency(now);
    if (step % 16 == 15) device.engage(now);
    if (step % 3 == 0) device.drive({1e300, input.number()}, now);
    fuzz::require(device.take_news().size() <= 64);
  }
  script.may_move = false;
  return 0;
}
