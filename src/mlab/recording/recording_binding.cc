#include "mlab/recording/recording_binding.h"

#include <utility>

#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::recording {
namespace {

void put(const geom::Pose& pose, wire::Pose& out) {
  out.set_x(pose.position.x);
  out.set_y(pose.position.y);
  out.set_heading(pose.heading);
}

void put(const binding::Kinematics& kinematics, wire::RecordedKinematics& out) {
  out.set_drive(static_cast<std::uint32_t>(kinematics.drive));
  out.set_axle(kinematics.axle);
  out.set_max_wheel_speed(kinematics.max_wheel_speed);
  out.set_wheelbase(kinematics.wheelbase);
  out.set_max_steer(kinematics.max_steer);
  out.set_max_speed(kinematics.max_speed);
  out.set_max_acceleration(kinematics.max_acceleration);
  out.set_max_turn_rate(kinematics.max_turn_rate);
  out.set_max_turn_acceleration(kinematics.max_turn_acceleration);
}

void put(geom::Point point, wire::Points& out) {
  out.add_x(point.x);
  out.add_y(point.y);
}

void put(const binding::Object& object, wire::RecordedObject& out) {
  out.set_id(object.id.value);
  out.set_object_class(static_cast<wire::ObjectClass>(object.object_class));
  out.set_style(static_cast<wire::ObjectStyle>(object.style));
  out.set_x(object.center.x);
  out.set_y(object.center.y);
  out.set_radius(object.radius);
  out.set_carrier(object.carrier.value);
  out.set_basket(object.basket.value);
}

bool is_same(const binding::Object& a, const binding::Object& b) {
  return a.id == b.id && a.object_class == b.object_class && a.center == b.center && a.carrier == b.carrier &&
         a.basket == b.basket;
}

}  // namespace

RecordingBinding::RecordingBinding(std::unique_ptr<binding::Binding> inner,
                                   std::shared_ptr<PerceptsWriter> file)
    : inner_(std::move(inner)), file_(std::move(file)) {
  write_world({});
}

std::expected<binding::Placement, std::string> RecordingBinding::embody(const binding::BodySetup& setup) {
  auto placement = inner_->embody(setup);
  if (!placement) return placement;
  if (bodies_.size() <= placement->body.value) bodies_.resize(placement->body.value + std::size_t{1});
  bodies_[placement->body.value].robot = setup.robot;
  const binding::Capabilities capabilities = inner_->capabilities(placement->body);
  wire::RecordedEntry entry;
  wire::RecordedBody& body = *entry.mutable_embodied();
  body.set_robot(setup.robot.value);
  put(placement->pose, *body.mutable_pose());
  body.set_moved(placement->moved);
  body.set_radius(capabilities.radius);
  body.set_range_sensors(capabilities.range_sensors);
  body.set_max_speed(capabilities.max_speed);
  body.set_max_turn_rate(capabilities.max_turn_rate);
  body.set_overlooks(capabilities.overlooks);
  if (capabilities.kinematics) put(*capabilities.kinematics, *body.mutable_kinematics());
  file_->write(entry);
  return placement;
}

void RecordingBinding::release(binding::BodyIndex body) {
  bodies_[body.value].is_present = false;
  inner_->release(body);
}

void RecordingBinding::percepts(std::span<const binding::Sensing> robots, int worker) {
  inner_->percepts(robots, worker);
  for (const binding::Sensing& sensing : robots) {
    Body& body = bodies_[sensing.body.value];
    body.has_acted = true;
    body.told.set_robot(body.robot.value);
    robot_wire::encode(*sensing.needs, *body.told.mutable_needs());
    robot_wire::encode(*sensing.out, *body.told.mutable_percepts());
  }
}

bool RecordingBinding::Links::arrives(binding::BodyIndex from, binding::BodyIndex to) const {
  if (inner->arrives(from, to)) return true;
  if (net_of(from) == net_of(to)) lost.emplace_back(from, to);
  return false;
}

const binding::RadioLinks* RecordingBinding::radio() {
  links_.inner = inner_->radio();
  links_.lost.clear();
  return links_.inner == nullptr ? nullptr : &links_;
}

// Also where nobody told anything: whoever does, once this is replayed, is heard by the same.
void RecordingBinding::add_radio(wire::RecordedCycle& cycle) {
  if (links_.inner == nullptr && radio() == nullptr) return;
  wire::RecordedRadio& radio = *cycle.mutable_radio();
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].is_present) continue;
    radio.add_robot(bodies_[i].robot.value);
    radio.add_net(links_.net_of({i}));
  }
  for (const auto& [from, to] : links_.lost) {
    radio.add_lost_from(bodies_[from.value].robot.value);
    radio.add_lost_to(bodies_[to.value].robot.value);
  }
  links_.inner = nullptr;
}

void RecordingBinding::carry_out(std::span<const percept::Action> actions, double dt) {
  wire::RecordedEntry entry;
  wire::RecordedCycle& cycle = *entry.mutable_cycle();
  cycle.set_time(inner_->time());
  cycle.set_duration(dt);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!std::exchange(bodies_[i].has_acted, false)) continue;
    robot_wire::encode(i < actions.size() ? actions[i] : percept::Action{},
                       *bodies_[i].told.mutable_action());
    *cycle.add_robots() = bodies_[i].told;
  }
  add_radio(cycle);
  inner_->carry_out(actions, dt);
  add_states(cycle);
  add_objects(cycle);
  file_->write(entry);
}

void RecordingBinding::add_states(wire::RecordedCycle& cycle) const {
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].is_present) continue;
    const binding::BodyIndex body{i};
    geom::Pose pose;
    inner_->poses({&body, 1}, {&pose, 1});
    const binding::BodyState state = inner_->view().body(body);
    wire::RecordedState& out = *cycle.add_states();
    out.set_robot(bodies_[i].robot.value);
    put(pose, *out.mutable_pose());
    out.set_velocity_x(state.velocity.x);
    out.set_velocity_y(state.velocity.y);
    out.set_turn_rate(state.turn_rate);
    out.set_speed(state.speed);
    out.set_distance_driven(state.distance_driven);
    out.set_contacts(state.contacts);
    out.set_in_contact(state.in_contact);
    out.set_carried(state.carried.value);
    out.set_run_over(state.run_over);
  }
}

void RecordingBinding::add_objects(wire::RecordedCycle& cycle) {
  const std::span<const binding::Object> objects = inner_->view().objects();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (is_same(objects[i], objects_[i])) continue;
    put(objects[i], *cycle.add_objects());
    objects_[i] = objects[i];
  }
}

void RecordingBinding::write_world(const binding::MapChange& change) {
  const binding::WorldView& view = inner_->view();
  wire::RecordedEntry entry;
  wire::RecordedWorld& world = *entry.mutable_world();
  for (const binding::Disc& disc : view.discs()) {
    world.add_disc_x(disc.center.x);
    world.add_disc_y(disc.center.y);
    world.add_disc_radius(disc.radius);
  }
  for (const binding::Wall& wall : view.walls()) {
    put(wall.segment.a, *world.mutable_wall_a());
    put(wall.segment.b, *world.mutable_wall_b());
    world.add_wall_group(wall.group);
    world.add_wall_is_solid(wall.is_solid);
  }
  objects_.assign(view.objects().begin(), view.objects().end());
  for (const binding::Object& object : objects_) put(object, *world.add_objects());
  for (const base::RobotId robot : change.moved_by_obstacles) world.add_moved_by_obstacles(robot.value);
  for (const base::RobotId robot : change.moved_by_walls) world.add_moved_by_walls(robot.value);
  world.set_has_other_objects(change.has_other_objects);
  file_->write(entry);
}

binding::MapChange RecordingBinding::change_map(const overlay::Overlay& before,
                                                const overlay::Overlay& after) {
  binding::MapChange change = inner_->change_map(before, after);
  write_world(change);
  return change;
}

std::vector<base::RobotId> RecordingBinding::change_obstacles(std::span<const binding::Disc> gone,
                                                              std::span<const binding::Disc> come) {
  std::vector<base::RobotId> moved = inner_->change_obstacles(gone, come);
  write_world({moved, {}, false});
  return moved;
}

}  // namespace mlab::recording
