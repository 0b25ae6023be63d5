#include "mlab/recording/recorded_binding.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/recording/action_difference.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"
#include "mlab/text/shown.h"

namespace mlab::recording {
namespace {

geom::Pose pose_of(const wire::Pose& pose) {
  return {{pose.x(), pose.y()}, pose.heading()};
}

binding::Kinematics kinematics_of(const wire::RecordedKinematics& kinematics) {
  return {static_cast<binding::Drive>(kinematics.drive()),
          kinematics.axle(),
          kinematics.max_wheel_speed(),
          kinematics.wheelbase(),
          kinematics.max_steer(),
          kinematics.max_speed(),
          kinematics.max_acceleration(),
          kinematics.max_turn_rate(),
          kinematics.max_turn_acceleration()};
}

binding::Object object_of(const wire::RecordedObject& object) {
  return {{object.id()},
          static_cast<percept::ObjectClass>(object.object_class()),
          static_cast<percept::ObjectStyle>(object.style()),
          {object.x(), object.y()},
          object.radius(),
          {object.carrier()},
          {object.basket()}};
}

std::vector<base::RobotId> robots_of(const google::protobuf::RepeatedField<std::uint32_t>& ids) {
  std::vector<base::RobotId> out;
  for (const std::uint32_t id : ids) out.push_back({id});
  return out;
}

// What is wanted, and was not asked for when percepts were recorded.
std::string lack_of(const percept::Needs& wanted, const percept::Needs& recorded) {
  for (const percept::SensorInfo& sensor : percept::kSensors) {
    if (sensor.is_told || wanted[sensor.sensor] <= recorded[sensor.sensor]) continue;
    if (sensor.has_own_reach) return fmt::format("wants {}, which were not recorded", sensor.label);
    return fmt::format("wants to see {} {} m far; recorded are {} m", sensor.label, wanted[sensor.sensor],
                       recorded[sensor.sensor]);
  }
  return "";
}

}  // namespace

RecordedBinding::RecordedBinding(std::unique_ptr<PerceptsReader> file, int threads)
    : file_(std::move(file)), workers_(std::make_unique<binding::Workers>(threads)) {
  take_change();
}

const wire::RecordedBody* RecordedBinding::next_body(base::RobotId robot, std::size_t which) const {
  for (const wire::RecordedBody& body : file_->bodies()) {
    if (body.robot() == robot.value && which-- == 0) return &body;
  }
  return nullptr;
}

std::expected<binding::Placement, std::string> RecordedBinding::embody(const binding::BodySetup& setup) {
  Robot& robot = robots_[setup.robot.value];
  const wire::RecordedBody* made = next_body(setup.robot, robot.starts);
  if (made == nullptr)
    return std::unexpected(robot.starts == 0
                               ? fmt::format("`{}` has no percepts of it", text::shown(file_->path()))
                               : fmt::format("`{}` has no more than {} of it", text::shown(file_->path()),
                                             base::counted(robot.starts, "start")));
  ++robot.starts;
  Body& body = bodies_.emplace_back();
  body.number = {static_cast<std::uint32_t>(bodies_.size() - 1)};
  body.made = *made;
  body.pose = pose_of(made->pose());
  robot.body = &body;
  return binding::Placement{body.number, body.pose, made->moved()};
}

void RecordedBinding::release(binding::BodyIndex number) {
  Body& body = bodies_[number.value];
  body.is_present = false;
  Robot& robot = robots_[body.made.robot()];
  if (robot.body == &body) robot.body = nullptr;
}

binding::Capabilities RecordedBinding::capabilities(binding::BodyIndex body) const {
  const wire::RecordedBody& made = bodies_[body.value].made;
  binding::Capabilities out{made.radius(),
                            static_cast<std::uint16_t>(made.range_sensors()),
                            made.max_speed(),
                            made.max_turn_rate(),
                            {},
                            made.overlooks()};
  if (made.has_kinematics()) out.kinematics = kinematics_of(made.kinematics());
  return out;
}

RecordedBinding::Body* RecordedBinding::find(std::uint32_t robot) {
  const auto found = robots_.find(robot);
  return found == robots_.end() ? nullptr : found->second.body;
}

// The coming cycle.
void RecordedBinding::load() {
  while (cycle_ == nullptr) {
    const wire::RecordedEntry* entry = file_->peek();
    if (entry == nullptr || entry->has_end()) return;
    if (entry->has_cycle()) {
      cycle_ = &entry->cycle();
      continue;
    }
    if (entry->has_world()) take_world(entry->world());
    file_->take();
  }
  for (Body& body : bodies_) body.recorded = nullptr;
  time_ = cycle_->time();
  for (const wire::RecordedRobot& robot : cycle_->robots()) {
    if (Body* body = find(robot.robot())) body->recorded = &robot;
  }
}

void RecordedBinding::health(std::vector<binding::Ailment>& out) {
  load();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    if (!body.is_present || (cycle_ != nullptr && body.recorded != nullptr)) continue;
    out.push_back({{i},
                   cycle_ == nullptr ? fmt::format("has no more percepts: `{}` ends after cycle {}",
                                                   text::shown(file_->path()), cycles_done_)
                                     : fmt::format("has no percepts in cycle {} of `{}`", cycles_done_ + 1,
                                                   text::shown(file_->path()))});
  }
}

void RecordedBinding::percepts(std::span<const binding::Sensing> robots, int /*worker*/) {
  for (const binding::Sensing& sensing : robots) {
    Body& body = bodies_[sensing.body.value];
    body.has_acted = true;
    if (body.recorded == nullptr) continue;
    body.lack = lack_of(*sensing.needs, robot_wire::needs_of(body.recorded->needs()));
    // What can't be decoded was refused when the file was opened.
    if (!body.percepts.decode(body.recorded->percepts())) *sensing.out = body.percepts.percepts();
  }
}

bool RecordedBinding::Links::arrives(binding::BodyIndex from, binding::BodyIndex to) const {
  return net_of(from) == net_of(to) && !lost.contains({from.value, to.value});
}

// Whoever was not there then hears nobody.
const binding::RadioLinks* RecordedBinding::radio() {
  if (cycle_ == nullptr || !cycle_->has_radio()) return nullptr;
  const wire::RecordedRadio& radio = cycle_->radio();
  constexpr std::uint32_t kOfItsOwn = 1U << 31;
  links_.nets.clear();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) links_.nets.push_back(kOfItsOwn + i);
  for (int i = 0; i < radio.robot_size(); ++i) {
    if (const Body* body = find(radio.robot(i))) links_.nets[body->number.value] = radio.net(i);
  }
  links_.lost.clear();
  for (int i = 0; i < radio.lost_from_size(); ++i) {
    const Body* from = find(radio.lost_from(i));
    const Body* to = find(radio.lost_to(i));
    if (from != nullptr && to != nullptr) links_.lost.emplace(from->number.value, to->number.value);
  }
  return &links_;
}

void RecordedBinding::carry_out(std::span<const percept::Action> actions, double dt) {
  if (cycle_ == nullptr) {
    time_ += dt;
    return;
  }
  compare(actions, dt);
  take_states(*cycle_);
  time_ += dt;
  ++cycles_done_;
  cycle_ = nullptr;
  for (Body& body : bodies_) {
    body.recorded = nullptr;
    body.has_acted = false;
  }
  file_->take();
}

void RecordedBinding::compare(std::span<const percept::Action> actions, double dt) {
  for (const wire::RecordedRobot& recorded : cycle_->robots()) {
    Robot& robot = robots_[recorded.robot()];
    std::string what = "does not act; it did when percepts were recorded";
    if (robot.body != nullptr && robot.body->has_acted) {
      const std::size_t number = robot.body->number.value;
      what = difference_of(*robot.body, number < actions.size() ? actions[number] : percept::Action{}, dt);
    }
    if (what.empty())
      ++same_actions_;
    else if (!std::exchange(robot.is_told, true))
      differences_.push_back({{recorded.robot()}, cycles_done_ + 1, time_, std::move(what)});
  }
}

std::string RecordedBinding::difference_of(Body& body, const percept::Action& action, double dt) const {
  if (dt != cycle_->duration())
    return fmt::format("acts for {} s; recorded is a cycle of {} s", dt, cycle_->duration());
  if (!body.lack.empty()) return std::move(body.lack);
  wire::Action is;
  robot_wire::encode(action, is);
  return difference(is, body.recorded->action());
}

void RecordedBinding::take_states(const wire::RecordedCycle& cycle) {
  for (const wire::RecordedState& state : cycle.states()) {
    Body* body = find(state.robot());
    if (body == nullptr) continue;
    body->pose = pose_of(state.pose());
    body->state = {{state.velocity_x(), state.velocity_y()},
                   state.speed(),
                   state.turn_rate(),
                   state.distance_driven(),
                   state.contacts(),
                   state.in_contact(),
                   {state.carried()},
                   state.run_over()};
  }
  for (const wire::RecordedObject& object : cycle.objects()) {
    const auto known = std::ranges::find(objects_, base::ObjectId{object.id()}, &binding::Object::id);
    if (known != objects_.end()) *known = object_of(object);
  }
}

void RecordedBinding::poses(std::span<const binding::BodyIndex> bodies, std::span<geom::Pose> out) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i] != binding::kNoBody) out[i] = bodies_[bodies[i].value].pose;
  }
}

std::vector<std::optional<geom::Pose>> RecordedBinding::places_for(
    std::span<const binding::BodySetup> setups) {
  std::vector<std::optional<geom::Pose>> out;
  for (const binding::BodySetup& setup : setups) {
    const auto robot = robots_.find(setup.robot.value);
    const wire::RecordedBody* made =
        next_body(setup.robot, robot == robots_.end() ? 0 : robot->second.starts);
    out.push_back(made == nullptr ? std::nullopt : std::optional(pose_of(made->pose())));
  }
  return out;
}

// What was changed at this place when percepts were recorded.
binding::MapChange RecordedBinding::take_change() {
  for (const wire::RecordedEntry* entry = file_->peek(); entry != nullptr; entry = file_->peek()) {
    if (!entry->has_embodied() && !entry->has_world()) break;
    if (!entry->has_world()) {
      file_->take();
      continue;
    }
    const wire::RecordedWorld& world = entry->world();
    binding::MapChange out{robots_of(world.moved_by_obstacles()), robots_of(world.moved_by_walls()),
                           world.has_other_objects()};
    take_world(world);
    file_->take();
    return out;
  }
  return {};
}

void RecordedBinding::take_world(const wire::RecordedWorld& world) {
  discs_.clear();
  walls_.clear();
  objects_.clear();
  for (int i = 0; i < world.disc_x_size(); ++i)
    discs_.push_back({{world.disc_x(i), world.disc_y(i)}, world.disc_radius(i)});
  for (int i = 0; i < world.wall_group_size(); ++i) {
    walls_.push_back(
        {{{world.wall_a().x(i), world.wall_a().y(i)}, {world.wall_b().x(i), world.wall_b().y(i)}},
         world.wall_group(i),
         world.wall_is_solid(i)});
  }
  for (const wire::RecordedObject& object : world.objects()) objects_.push_back(object_of(object));
}

binding::MapChange RecordedBinding::change_map(const overlay::Overlay& /*before*/,
                                               const overlay::Overlay& /*after*/) {
  return take_change();
}

std::vector<base::RobotId> RecordedBinding::change_obstacles(std::span<const binding::Disc> /*gone*/,
                                                             std::span<const binding::Disc> /*come*/) {
  return take_change().moved_by_obstacles;
}

percept::Percepts RecordedBinding::sense(binding::BodyIndex body, const percept::Needs& /*needs*/) const {
  return bodies_[body.value].percepts.percepts();
}

// What would have been seen elsewhere, nobody knows.
percept::Percepts RecordedBinding::sense_at(binding::BodyIndex /*body*/, const geom::Pose& pose,
                                            const percept::Needs& /*needs*/) const {
  percept::Percepts out;
  out.pose = pose;
  return out;
}

}  // namespace mlab::recording
