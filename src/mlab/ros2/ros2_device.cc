#include "mlab/ros2/ros2_device.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mlab/vehicle/steering.h"

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;
using vehicle::Readiness;

/// The same command is not said more often.
constexpr milliseconds kBetweenCommands{50};
/// Taking goals back is answered each time.
constexpr milliseconds kBetweenCancels{200};
/// Who does not drive for longer drives no more.
constexpr milliseconds kCommandLasts{300};
constexpr milliseconds kBetweenStates{1000};
constexpr milliseconds kBetweenNewStates{200};
constexpr int kPartingWords = 3;

double full_speed(const vehicle::Limits& limits) {
  return limits.kinematics.max_speed > 0.0 ? limits.kinematics.max_speed : 1.0;
}

}  // namespace

vehicle::Limits robot_limits() {
  vehicle::Limits out;
  out.kinematics = {.drive = binding::Drive::kDifferential, .max_speed = 0.5, .max_turn_rate = 1.0};
  out.standstill = 1.5;
  return out;
}

double standstill_with_goals(double look_ahead, double max_speed) {
  return 2.0 * look_ahead / max_speed + 5.0;
}

Ros2Device::Ros2Device(std::unique_ptr<Link> link, const RobotSettings& settings)
    : settings_(settings),
      link_(std::move(link)),
      name_(fmt::format("ROS 2 robot {} in {}",
                        settings.robot_namespace.empty() ? "/" : settings.robot_namespace, link_->name())),
      readings_(settings.places, settings.scanners, full_speed(settings.limits)),
      goals_(settings.look_ahead, full_speed(settings.limits), settings.session) {}

Ros2Device::~Ros2Device() {
  if (doing_ == Doing::kNothing) return;
  for (int i = 0; i < kPartingWords; ++i) {
    told_at_.reset();
    say_halt(now_);
  }
}

void Ros2Device::work(Time now) {
  now_ = now;
  heard_ = {};
  link_->hear(heard_);
  readings_.take(heard_, now);
  goals_.take(heard_);
  const bool is_left = now - driven_at_ > kCommandLasts;
  if (doing_ == Doing::kDriving && (is_left || !is_ready(now))) halt(now);
  if (doing_ == Doing::kHalting) {
    if (readings_.has_stood_since(halted_at_))
      doing_ = Doing::kNothing;
    else
      say_halt(now);
  }
  say_state(now);
}

std::string Ros2Device::why_not(Time now) const {
  if (!readings_.motion(now)) return readings_.why_no_motion(now);
  if (const double jump = readings_.jump(now); jump > 0.0)
    return fmt::format("has jumped by {:.1f} m, as it says", jump);
  const Listeners listeners = link_->listeners();
  if (settings_.drives == Drives::kGoals) {
    if (listeners.navigator) return "";
    return fmt::format("has no navigator: nobody serves {}/navigate_to_pose", settings_.robot_namespace);
  }
  if (!listeners.any_velocity())
    return fmt::format("would hear nothing: nobody listens to {}/cmd_vel", settings_.robot_namespace);
  return "";
}

const vehicle::Report& Ros2Device::report(Time now) {
  report_ = {};
  report_.is_global = settings_.places.is_global();
  report_.motion = readings_.motion(now);
  report_.battery = readings_.battery(now);
  report_.why = why_not(now);
  if (report_.why.empty())
    report_.readiness = Readiness::kReady;
  else
    report_.readiness = report_.motion ? Readiness::kNotReady : Readiness::kSilent;
  // Where it was when it saw something has to be known.
  if (report_.motion) readings_.scans(now, report_.scans);
  return report_;
}

void Ros2Device::drive(const vehicle::Command& command, Time now) {
  if (!is_ready(now)) {
    if (doing_ == Doing::kDriving) halt(now);
    return;
  }
  doing_ = Doing::kDriving;
  driven_at_ = now;
  tell(vehicle::cut_to(settings_.limits, command), now);
}

void Ros2Device::stop(Time now) {
  if (doing_ != Doing::kHalting) halt(now);
}

void Ros2Device::halt(Time now) {
  doing_ = Doing::kHalting;
  halted_at_ = now;
  told_at_.reset();
  say_halt(now);
}

void Ros2Device::say_halt(Time now) {
  const bool has_goals = settings_.drives == Drives::kGoals;
  if (told_at_ && now - *told_at_ < (has_goals ? kBetweenCancels : kBetweenCommands)) return;
  if (has_goals) {
    goals_.drop();
    link_->cancel_all_goals();
  }
  say_velocity({}, now);
}

void Ros2Device::tell(const vehicle::Command& command, Time now) {
  if (settings_.drives == Drives::kGoals) {
    tell_by_goal(command, now);
    return;
  }
  if (told_at_ && command == told_ && now - *told_at_ < kBetweenCommands) return;
  say_velocity(command, now);
}

// Standing is no goal: what it has is taken back.
void Ros2Device::tell_by_goal(const vehicle::Command& command, Time now) {
  if (command == vehicle::Command{}) {
    say_halt(now);
    return;
  }
  const auto pose = readings_.odometry_pose(now);
  if (!pose) return;
  const auto goal =
      goals_.next(command, *pose, readings_.odometry_frame(), readings_.clock().theirs(now), now);
  if (!goal) return;
  goals_.sent(link_->send(*goal));
  told_at_.reset();
}

void Ros2Device::say_velocity(const vehicle::Command& command, Time now) {
  told_ = command;
  told_at_ = now;
  link_->say(
      Velocity{command.speed, command.turn_rate, readings_.clock().theirs(now), readings_.base_frame()});
}

void Ros2Device::say_state(Time now) {
  const auto since = state_at_ ? now - *state_at_ : kBetweenStates;
  if (since < kBetweenNewStates) return;
  const std::string why = why_not(now);
  const std::string_view doing = doing_ == Doing::kDriving   ? "drives it"
                                 : doing_ == Doing::kHalting ? "has it stand"
                                                             : "leaves it alone";
  const std::string message = why.empty() ? std::string(doing) : fmt::format("{}: it {}", doing, why);
  if (message == told_state_ && since < kBetweenStates) return;
  state_at_ = now;
  told_state_ = message;
  State state;
  state.stamp = readings_.clock().theirs(now);
  state.level = why.empty() ? Level::kOk : readings_.motion(now) ? Level::kWarning : Level::kStale;
  state.name = fmt::format("missionlab{}", settings_.robot_namespace);
  state.message = message;
  state.hardware_id = settings_.robot_namespace.empty() ? "robot" : settings_.robot_namespace.substr(1);
  const vehicle::Command told = doing_ == Doing::kDriving ? told_ : vehicle::Command{};
  state.values = {{"speed", fmt::format("{:.3f}", told.speed)},
                  {"turn_rate", fmt::format("{:.3f}", told.turn_rate)}};
  link_->say(state);
}

std::vector<std::string> Ros2Device::take_news() {
  std::vector<std::string> out = link_->take_news();
  for (std::string& one : readings_.take_news()) out.push_back(std::move(one));
  if (std::string problem = goals_.problem(); problem != told_problem_) {
    told_problem_ = std::move(problem);
    if (!told_problem_.empty()) out.push_back(told_problem_);
  }
  return out;
}

vehicle::Check Ros2Device::listener_check() const {
  using enum vehicle::CheckResult;
  const Listeners listeners = link_->listeners();
  const std::string& in = settings_.robot_namespace;
  if (settings_.drives == Drives::kGoals)
    return {"navigator", listeners.navigator ? kPass : kFail,
            fmt::format("{}/navigate_to_pose is served by {}", in,
                        listeners.navigator ? "a navigator" : "nobody"),
            "a navigator, as rmw_cyclonedds has it"};
  const std::string_view kinds = listeners.twist && listeners.twist_stamped ? "Twist and TwistStamped"
                                 : listeners.twist                          ? "Twist"
                                 : listeners.twist_stamped                  ? "TwistStamped"
                                                                            : "nothing";
  return {"listener", listeners.any_velocity() ? kPass : kFail,
          fmt::format("takes {} on {}/cmd_vel", kinds, in), "Twist or TwistStamped"};
}

std::vector<vehicle::Check> Ros2Device::checks(Time now) {
  using enum vehicle::CheckResult;
  const auto motion = readings_.motion(now);
  std::vector<vehicle::Check> out;
  out.push_back(
      {"odometry", motion ? kPass : kFail,
       motion ? fmt::format("counts in `{}`", readings_.odometry_frame()) : readings_.why_no_motion(now),
       "says where it is"});
  out.push_back(listener_check());
  out.push_back({"watchdog", kUnknown, "can't be asked whether it stops by itself without velocities",
                 fmt::format("stands within {:.1f} s, as --standstill says", settings_.limits.standstill)});
  return out;
}

}  // namespace mlab::ros2
