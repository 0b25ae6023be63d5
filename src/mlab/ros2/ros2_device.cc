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

std::string_view words_of(Services navigator) {
  switch (navigator) {
    case Services::kNone:
      return "nobody";
    case Services::kPlain:
      return "a navigator on rmw_fastrtps";
    case Services::kHeaded:
      return "a navigator on rmw_cyclonedds";
    case Services::kUnknown:
      return "a navigator that speaks services in no way that is known";
  }
  return "";
}

}  // namespace

vehicle::Limits robot_limits() {
  vehicle::Limits out;
  out.kinematics = {.drive = binding::Drive::kDifferential, .max_speed = 0.5, .max_turn_rate = 1.0};
  out.standstill = 1.5;
  return out;
}

double standstill_with_goals(double look_ahead, double max_speed) {
  return 2.0 * look_ahead / max_speed + 3.0;
}

Ros2Device::Ros2Device(std::unique_ptr<Link> link, const RobotSettings& settings)
    : settings_(settings),
      link_(std::move(link)),
      name_(fmt::format("ROS 2 robot {} in {}",
                        settings.robot_namespace.empty() ? "/" : settings.robot_namespace, link_->name())),
      readings_(settings.places, settings.scanners, full_speed(settings.limits)),
      goals_(settings.look_ahead.value_or(look_ahead_for(full_speed(settings.limits))),
             full_speed(settings.limits), settings.session) {}

Ros2Device::~Ros2Device() {
  if (doing_ == Doing::kNothing) return;
  for (int i = 0; i < kPartingWords; ++i) {
    told_at_.reset();
    taken_back_at_.reset();
    say_halt(now_);
  }
}

void Ros2Device::hear(Time now) {
  heard_ = {};
  link_->hear(heard_);
  const std::uint32_t so_far = link_->listeners().navigators_so_far;
  if (std::exchange(navigators_, so_far) != so_far) goals_.forget();
  readings_.take(heard_, now);
  goals_.take(heard_, now);
}

bool Ros2Device::has_halted() const {
  // Nobody is told anything who goes for somebody else.
  if (is_taken() && !is_emergency_) return true;
  return readings_.has_stood_since(halted_at_) && !(is_emergency_ && goals_.has_any());
}

void Ros2Device::work(Time now) {
  now_ = now;
  hear(now);
  const bool is_left = now - driven_at_ > kCommandLasts;
  if (doing_ == Doing::kDriving && (is_left || !is_ready(now))) halt(now);
  if (doing_ == Doing::kHalting) {
    if (has_halted())
      doing_ = Doing::kNothing;
    else
      say_halt(now);
  }
  // What comes late to its navigator, or is left from a process that was killed, has nobody who drives it.
  if (doing_ == Doing::kNothing) take_goals_back(now);
  say_state(now);
}

std::string Ros2Device::why_not(Time now) const {
  if (!readings_.motion(now)) return readings_.why_no_motion(now);
  if (const double jump = readings_.jump(now); jump > 0.0)
    return fmt::format("has jumped by {:.1f} m, as it says", jump);
  if (has_goals()) return why_no_navigator();
  if (!link_->listeners().any_velocity())
    return fmt::format("would hear nothing: nobody listens to {}/cmd_vel", settings_.robot_namespace);
  return "";
}

std::string Ros2Device::why_no_navigator() const {
  const Listeners listeners = link_->listeners();
  if (listeners.navigator == Services::kNone)
    return fmt::format("has no navigator: nobody serves {}/navigate_to_pose", settings_.robot_namespace);
  if (!listeners.can_be_given_goals())
    return "can't be given goals: its navigator speaks services in no way that is known";
  return goals_.is_taken() ? "goes to a goal that somebody else gave its navigator" : "";
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
    report_.readiness = !report_.motion ? Readiness::kSilent
                        : is_taken()    ? Readiness::kTaken
                                        : Readiness::kNotReady;
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
  is_emergency_ = false;
  driven_at_ = now;
  tell(vehicle::cut_to(settings_.limits, command), now);
}

void Ros2Device::stop(Time now) {
  is_emergency_ = false;
  if (doing_ != Doing::kHalting) halt(now);
}

void Ros2Device::stop_in_emergency(Time now) {
  const bool is_new = !std::exchange(is_emergency_, true);
  if (is_new || doing_ != Doing::kHalting) halt(now);
}

void Ros2Device::engage(Time /*now*/) {
  goals_.engage();
}

void Ros2Device::halt(Time now) {
  doing_ = Doing::kHalting;
  halted_at_ = now;
  told_at_.reset();
  taken_back_at_.reset();
  say_halt(now);
}

void Ros2Device::say_halt(Time now) {
  if (has_goals()) {
    goals_.drop();
    take_goals_back(now);
    if (is_taken() && !is_emergency_) return;
  }
  if (told_at_ && now - *told_at_ < (has_goals() ? kBetweenCancels : kBetweenCommands)) return;
  say_velocity({}, now);
}

void Ros2Device::take_goals_back(Time now) {
  if (!has_goals() || (taken_back_at_ && now - *taken_back_at_ < kBetweenCancels)) return;
  const bool all = is_emergency_ && doing_ == Doing::kHalting;
  const std::vector<GoalId> ids = goals_.to_take_back(now);
  if (!all && ids.empty()) return;
  taken_back_at_ = now;
  if (all) link_->cancel_all_goals();
  for (const GoalId& one : ids) link_->cancel(one);
}

void Ros2Device::tell(const vehicle::Command& command, Time now) {
  if (has_goals()) {
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
  link_->send(*goal);
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
  std::string why = why_not(now);
  if (why.empty()) why = goals_.problem();
  const std::string_view doing = doing_ == Doing::kDriving          ? "drives it"
                                 : doing_ == Doing::kHalting        ? "has it stand"
                                 : goals_.to_take_back(now).empty() ? "leaves it alone"
                                                                    : "takes its goals back";
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
  if (has_goals()) state.values.push_back({"navigator", std::string(words_of(link_->listeners().navigator))});
  link_->say(state);
}

std::vector<std::string> Ros2Device::take_news() {
  std::vector<std::string> out = link_->take_news();
  for (std::string& one : readings_.take_news()) out.push_back(std::move(one));
  if (std::string problem(goals_.problem()); problem != told_problem_) {
    told_problem_ = std::move(problem);
    if (!told_problem_.empty()) out.push_back(told_problem_);
  }
  return out;
}

vehicle::Check Ros2Device::listener_check() const {
  using enum vehicle::CheckResult;
  const Listeners listeners = link_->listeners();
  const std::string_view kinds = listeners.twist && listeners.twist_stamped ? "Twist and TwistStamped"
                                 : listeners.twist                          ? "Twist"
                                 : listeners.twist_stamped                  ? "TwistStamped"
                                                                            : "nothing";
  return {"listener", listeners.any_velocity() ? kPass : kFail,
          fmt::format("takes {} on {}/cmd_vel", kinds, settings_.robot_namespace), "Twist or TwistStamped"};
}

vehicle::Check Ros2Device::navigator_check() const {
  using enum vehicle::CheckResult;
  const Listeners listeners = link_->listeners();
  const std::string_view problem = goals_.problem();
  const vehicle::CheckResult result = !listeners.can_be_given_goals() || is_taken() ? kFail
                                      : problem.empty()                             ? kPass
                                                                                    : kWarn;
  std::string is = fmt::format("{}/navigate_to_pose is served by {}", settings_.robot_namespace,
                               words_of(listeners.navigator));
  if (is_taken())
    is += ", which goes to somebody else's goal";
  else if (!problem.empty())
    is += fmt::format(", which {}", problem);
  return {"navigator", result, std::move(is), "a navigator on rmw_fastrtps or rmw_cyclonedds"};
}

vehicle::Check Ros2Device::watchdog_check() const {
  return {"watchdog", vehicle::CheckResult::kUnknown,
          has_goals() ? "goes on to its last goal without us, and can't be asked how long that takes"
                      : "can't be asked whether it stops by itself without velocities",
          fmt::format("stands within {:.1f} s, as --standstill says", settings_.limits.standstill)};
}

std::vector<vehicle::Check> Ros2Device::checks(Time now) {
  using enum vehicle::CheckResult;
  const auto motion = readings_.motion(now);
  std::vector<vehicle::Check> out;
  out.push_back(
      {"odometry", motion ? kPass : kFail,
       motion ? fmt::format("counts in `{}`", readings_.odometry_frame()) : readings_.why_no_motion(now),
       "says where it is"});
  out.push_back(has_goals() ? navigator_check() : listener_check());
  out.push_back(watchdog_check());
  return out;
}

}  // namespace mlab::ros2
