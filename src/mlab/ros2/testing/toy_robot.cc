#include "mlab/ros2/testing/toy_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mlab/base/angle.h"

namespace mlab::ros2::testing {
namespace {

constexpr std::int64_t kEpoch = 1'700'000'000;  // [s], what its clock showed when ours began

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

Quaternion facing(double heading) {
  return {0.0, 0.0, std::sin(heading / 2.0), std::cos(heading / 2.0)};
}

}  // namespace

void ToyNetwork::put(std::deque<Message>& way, Delivery delivery, Time now) {
  if (is_cut || random_.uniform() < loss) return;
  way.push_back({now + delay, std::move(delivery)});
}

void ToyNetwork::deliver(std::deque<Message>& way, Time now) const {
  while (!is_held_back && !way.empty() && way.front().at <= now) {
    const Delivery delivery = std::move(way.front().delivery);
    way.pop_front();
    delivery();
  }
}

class ToyRobot::End final : public Link {
 public:
  explicit End(ToyRobot& robot) : robot_(robot) {}
  const std::string& name() const override { return name_; }
  void hear(Heard& heard) override {
    robot_.network.deliver_to_device(robot_.now_);
    heard = std::exchange(robot_.arrived_, {});
  }
  Listeners listeners() const override {
    const bool is_there = robot_.is_on && robot_.listens;
    return {.twist = is_there && !robot_.spec_.is_stamped,
            .twist_stamped = is_there && robot_.spec_.is_stamped,
            .navigator = is_there ? robot_.spec_.navigator : Services::kNone,
            .navigators_so_far = robot_.navigators_};
  }
  void say(const Velocity& velocity) override {
    robot_.network.to_robot([robot = &robot_, velocity] { robot->obey(velocity); }, robot_.now_);
  }
  void say(const State& state) override {
    robot_.network.to_robot([robot = &robot_, state] { robot->states.push_back(state); }, robot_.now_);
  }
  void send(const Goal& sent) override {
    robot_.network.to_robot([robot = &robot_, sent] { robot->give(sent); }, robot_.now_);
  }
  void cancel(const GoalId& id) override {
    robot_.network.to_robot([robot = &robot_, id] { robot->cancel(id); }, robot_.now_);
  }
  void cancel_all_goals() override {
    robot_.network.to_robot([robot = &robot_] { robot->cancel({}); }, robot_.now_);
  }
  std::vector<std::string> take_news() override { return {}; }

 private:
  ToyRobot& robot_;
  std::string name_ = "a toy's domain";
};

std::unique_ptr<Link> ToyRobot::link() {
  return std::make_unique<End>(*this);
}

Stamp ToyRobot::stamp_of(Time now) const {
  const auto nanos = std::chrono::nanoseconds(now.time_since_epoch()).count();
  return {static_cast<std::int32_t>(kEpoch + nanos / 1'000'000'000),
          static_cast<std::uint32_t>(nanos % 1'000'000'000)};
}

void ToyRobot::obey(const Velocity& velocity) {
  if (!is_on) return;
  ++velocities;
  told = velocity;
  obeyed_ = velocity;
  told_at_ = now_;
  if (!spec_.is_stamped) return;
  const Stamp is = stamp_of(now_);
  const double age = static_cast<double>(is.sec - velocity.stamp.sec) +
                     (static_cast<double>(is.nanosec) - static_cast<double>(velocity.stamp.nanosec)) * 1e-9;
  told_at_ = now_ - std::chrono::duration_cast<vehicle::Clock::duration>(std::chrono::duration<double>(age));
}

void ToyRobot::give(const Goal& given) {
  if (!is_on || spec_.navigator == Services::kNone || !takes_goals) return;
  ++goals;
  set(given.id, GoalState::kExecuting);
  if (goal) set(goal->id, GoalState::kAborted);
  goal = given;
  if (finds_ways) return;
  set(given.id, GoalState::kAborted);
  goal.reset();
}

void ToyRobot::cancel(const std::optional<GoalId>& id) {
  if (!is_on) return;
  ++(id ? cancels : cancels_of_all);
  if (!goal || (id && *id != goal->id)) return;
  set(goal->id, GoalState::kCanceled);
  goal.reset();
}

void ToyRobot::restart_navigator() {
  ++navigators_;
  goal.reset();
  states_of_goals_.clear();
  tell_states();
}

void ToyRobot::set(const GoalId& id, GoalState state) {
  constexpr std::size_t kKept = 16;
  const auto known = std::ranges::find(states_of_goals_, id, &GoalStatus::id);
  if (known != states_of_goals_.end())
    known->state = state;
  else
    states_of_goals_.push_back({id, state});
  if (states_of_goals_.size() > kKept) states_of_goals_.erase(states_of_goals_.begin());
  tell_states();
}

void ToyRobot::tell_states() {
  Heard heard;
  heard.goals = states_of_goals_;
  tell(std::move(heard), now_);
}

void ToyRobot::navigate(double& wanted_speed, double& wanted_turn) {
  const geom::Pose is{geom::Point{} + (pose.position - origin_.position), pose.heading};
  const geom::Offset to = geom::Point{goal->x, goal->y} - is.position;
  if (geom::length(to) < 0.1) {
    set(goal->id, GoalState::kSucceeded);
    goal.reset();
    return;
  }
  const double off = base::wrap_angle(geom::direction(to) - is.heading);
  wanted_turn = std::clamp(2.0 * off, -1.0, 1.0);
  wanted_speed = std::abs(off) < 0.5 ? spec_.cruise : 0.0;
}

void ToyRobot::step(Time now, double dt) {
  now_ = now;
  network.deliver_to_robot(now);
  double wanted_speed = 0.0;
  double wanted_turn = 0.0;
  const bool is_told = is_on && told_at_ && vehicle::seconds_between(*told_at_, now) <= spec_.watchdog;
  if (is_on && goal) {
    navigate(wanted_speed, wanted_turn);
  } else if (is_told) {
    wanted_speed = obeyed_.speed;
    wanted_turn = obeyed_.turn_rate;
  }
  speed = towards(speed, wanted_speed, spec_.acceleration * dt);
  turn_rate = towards(turn_rate, wanted_turn, spec_.turn_acceleration * dt);
  pose.position = pose.point_at({speed * dt, 0.0, 0.0});
  pose.heading = base::wrap_angle(pose.heading + turn_rate * dt);
  if (is_on && publishes) publish(now);
}

void ToyRobot::restart() {
  told_at_.reset();
  restart_navigator();
  origin_ = {pose.position, 0.0};
}

Odometry ToyRobot::odometry(Time now) const {
  const geom::Offset way = pose.position - origin_.position;
  return {.stamp = stamp_of(now),
          .frame = "odom",
          .child_frame = "base_link",
          .position = {way.x, way.y, 0.0},
          .orientation = facing(pose.heading),
          .speed = speed,
          .turn_rate = turn_rate,
          .writer = 7};
}

LaserScan ToyRobot::scan(Time now) const {
  LaserScan out{.topic = 0,
                .stamp = stamp_of(now),
                .frame = "laser",
                .angle_min = -1.5F,
                .angle_increment = 0.1F,
                .range_min = 0.1F,
                .range_max = 10.0F,
                .ranges = {}};
  for (int i = 0; i < 31; ++i) out.ranges.push_back(1.0F + 0.1F * static_cast<float>(i));
  out.ranges[3] = INFINITY;
  return out;
}

void ToyRobot::publish(Time now) {
  ++steps_;
  Heard heard;
  if (steps_ % 2 == 0) {
    heard.odometry.push_back(odometry(now));
    change_odometry(heard.odometry.back());
    heard.batteries.push_back({12.1F, 0.8F});
  }
  if (steps_ % 5 == 0) heard.scans.push_back(scan(now));
  if (goal) heard.feedback.push_back({goal->id, recoveries});
  // What was lost of its states comes again, as it does over DDS.
  if (spec_.navigator != Services::kNone) heard.goals = states_of_goals_;
  if (tells_mount && steps_ % 50 == 1)
    heard.transforms.push_back({"base_link", "laser", {0.2, 0.0, 0.3}, {}, true, true});
  tell(std::move(heard), now);
}

void ToyRobot::tell(Heard heard, Time now) {
  network.to_device(
      [this, heard = std::move(heard)] {
        const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        add(arrived_.odometry, heard.odometry);
        add(arrived_.scans, heard.scans);
        add(arrived_.batteries, heard.batteries);
        add(arrived_.transforms, heard.transforms);
        add(arrived_.feedback, heard.feedback);
        if (heard.goals) arrived_.goals = heard.goals;
      },
      now);
}

}  // namespace mlab::ros2::testing
