#include "mlab/robot/wire/percepts_wire.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "mlab/base/table.h"

namespace mlab::robot_wire {
namespace {

constexpr auto kLastObjectStyle = percept::ObjectStyle::kContainer;
constexpr auto kLastFormation = percept::Formation::kSweep;
constexpr auto kLastReference = percept::FormationReference::kNeighbor;

// The names of the fields that a struct is taken apart into below: one that is added later does not compile
// until it is written, read and tested.

void encode(const geom::Pose& pose, wire::Pose& out) {
  const auto& [position, heading] = pose;
  out.set_x(position.x);
  out.set_y(position.y);
  out.set_heading(heading);
}

geom::Pose pose_of(const wire::Pose& message) {
  return {{message.x(), message.y()}, message.heading()};
}

// Also of -0, so that every bit arrives.
bool is_telling_velocity(const percept::Obstacle& obstacle) {
  const auto& [x, y, z] = obstacle.velocity;
  return (std::bit_cast<std::uint64_t>(x) | std::bit_cast<std::uint64_t>(y) |
          std::bit_cast<std::uint64_t>(z)) != 0;
}

void encode(std::span<const percept::Obstacle> obstacles, wire::Obstacles& out) {
  const bool any_moves = std::ranges::any_of(obstacles, is_telling_velocity);
  for (const auto& [center, radius, velocity] : obstacles) {
    out.add_x(center.x);
    out.add_y(center.y);
    out.add_z(center.z);
    out.add_radius(radius);
    if (!any_moves) continue;
    out.add_velocity_x(velocity.x);
    out.add_velocity_y(velocity.y);
    out.add_velocity_z(velocity.z);
  }
}

void encode(std::span<const percept::RobotReading> robots, wire::Robots& out) {
  for (const auto& [id, center, heading, radius, is_unit_mate, object_class] : robots) {
    out.add_id(id.value);
    out.add_x(center.x);
    out.add_y(center.y);
    out.add_z(center.z);
    out.add_heading(heading);
    out.add_radius(radius);
    out.add_is_unit_mate(is_unit_mate);
    out.add_object_class(static_cast<wire::ObjectClass>(object_class));
  }
}

void encode(std::span<const percept::ObjectReading> objects, wire::Objects& out) {
  for (const auto& [id, object_class, style, center, radius] : objects) {
    out.add_id(id.value);
    out.add_object_class(static_cast<wire::ObjectClass>(object_class));
    out.add_style(static_cast<wire::ObjectStyle>(style));
    out.add_x(center.x);
    out.add_y(center.y);
    out.add_z(center.z);
    out.add_radius(radius);
  }
}

void encode(std::span<const percept::RangeReading> ranges, wire::Ranges& out) {
  for (const auto& [angle, distance, hit] : ranges) {
    out.add_angle(angle);
    out.add_distance(distance);
    out.add_hit(hit);
  }
}

void encode(std::span<const percept::RadioContact> radio, wire::Radio& out) {
  for (const auto& [id, center, strength, is_unit_mate] : radio) {
    out.add_id(id.value);
    out.add_x(center.x);
    out.add_y(center.y);
    out.add_z(center.z);
    out.add_strength(strength);
    out.add_is_unit_mate(is_unit_mate);
  }
}

void encode(const percept::Camera& camera, wire::Camera& out) {
  const auto& [pan, field_of_view] = camera;
  out.set_pan(pan);
  out.set_field_of_view(field_of_view);
}

void encode(std::span<const percept::SharedPlace> places, wire::SharedPlaces& out) {
  for (const auto& [from, object, object_class, place, time] : places) {
    out.add_from(from.value);
    out.add_object(object.value);
    out.add_object_class(static_cast<wire::ObjectClass>(object_class));
    out.add_x(place.x);
    out.add_y(place.y);
    out.add_time(time);
  }
}

void encode(std::span<const percept::AskedPassage> passages, wire::AskedPassages& out) {
  for (const auto& [from, to, cost, time] : passages) {
    out.add_from(from.value);
    out.add_x(to.x);
    out.add_y(to.y);
    out.add_cost(cost);
    out.add_time(time);
  }
}

void encode(std::span<const percept::Claim> claims, wire::Claims& out) {
  for (const auto& [object, robot] : claims) {
    out.add_object(object.value);
    out.add_robot(robot.value);
  }
}

void encode(std::span<const percept::Contract> contracts, wire::Contracts& out) {
  for (const auto& [task, object, place, state, manager, contractor, reneged, time] : contracts) {
    out.add_task(task);
    out.add_object(object.value);
    out.add_x(place.x);
    out.add_y(place.y);
    out.add_state(static_cast<wire::Contracts::State>(state));
    out.add_manager(manager.value);
    out.add_contractor(contractor.value);
    out.add_reneged(reneged.value);
    out.add_time(time);
  }
}

void add(geom::Point point, wire::Points& out) {
  out.add_x(point.x);
  out.add_y(point.y);
}

void encode(const percept::SiteMap& map, wire::Percepts& out) {
  const auto& [doors, rooms, hallways] = map;
  if (doors.empty() && rooms.empty() && hallways.empty()) return;
  wire::SiteMap& site = *out.mutable_map();
  for (const auto& [a, b, is_marked] : doors) {
    add(a, *site.mutable_door_a());
    add(b, *site.mutable_door_b());
    site.add_door_is_marked(is_marked);
  }
  for (const auto& [outline] : rooms) {
    wire::Points& points = *site.add_rooms();
    for (const geom::Point point : outline) add(point, points);
  }
  for (const auto& [start, end, width] : hallways) {
    add(start, *site.mutable_hallway_start());
    add(end, *site.mutable_hallway_end());
    site.add_hallway_width(width);
  }
}

bool is_told(const percept::KnownGround& ground) {
  const auto& [revision, discs, walls, bounds, edges] = ground;
  return revision != 0 || !discs.empty() || !walls.empty() || bounds != ways::Bounds{} || edges != 0;
}

void encode(const percept::KnownGround& ground, wire::Ground& out) {
  const auto& [revision, discs, walls, bounds, edges] = ground;
  out.set_revision(revision);
  for (const auto& [center, radius] : discs) {
    add(center, *out.mutable_discs());
    out.add_disc_radius(radius);
  }
  for (const auto& [a, b] : walls) {
    add(a, *out.mutable_wall_a());
    add(b, *out.mutable_wall_b());
  }
  out.set_x0(bounds.x0);
  out.set_y0(bounds.y0);
  out.set_x1(bounds.x1);
  out.set_y1(bounds.y1);
  out.set_edges(static_cast<std::uint32_t>(edges));
}

void encode(const percept::Order& order, wire::Order& out) {
  const auto& [sequence, task, goal, route, formation, reference, heading, has_heading, speed, halted, swath,
               margin] = order;
  out.set_sequence(sequence);
  out.set_task(static_cast<wire::Order::Task>(task));
  out.set_goal_x(goal.x);
  out.set_goal_y(goal.y);
  for (const geom::Point point : route) {
    out.mutable_route()->add_x(point.x);
    out.mutable_route()->add_y(point.y);
  }
  out.set_formation(static_cast<wire::Order::Formation>(formation));
  out.set_reference(static_cast<wire::Order::Reference>(reference));
  out.set_heading(heading);
  out.set_has_heading(has_heading);
  out.set_speed(speed);
  out.set_halted(halted);
  out.set_swath(swath);
  out.set_margin(margin);
}

void encode(const percept::UnitPercept& unit, wire::Unit& out) {
  const auto& [size, rank, center, center_step, leader, neighbor, formation_heading] = unit;
  out.set_size(size);
  out.set_rank(rank);
  out.set_center_x(center.x);
  out.set_center_y(center.y);
  out.set_step_x(center_step.x);
  out.set_step_y(center_step.y);
  encode(leader, *out.mutable_leader());
  encode(neighbor, *out.mutable_neighbor());
  out.set_formation_heading(formation_heading);
}

void encode(const percept::Joystick& joystick, wire::Joystick& out) {
  const auto& [x, y, magnitude, is_robot_frame, complete] = joystick;
  out.set_x(x);
  out.set_y(y);
  out.set_magnitude(magnitude);
  out.set_is_robot_frame(is_robot_frame);
  out.set_complete(complete);
}

percept::Joystick joystick_of(const wire::Joystick& message) {
  return {message.x(), message.y(), message.magnitude(), message.is_robot_frame(), message.complete()};
}

// Where the message has what is wanted of a sensor.
struct NeedField {
  percept::Sensor sensor;
  double (*read)(const wire::Needs& message);
  void (*write)(double reach, wire::Needs& message);
};

constexpr std::array kNeedFields = {
    NeedField{percept::Sensor::kObstacles, [](const wire::Needs& message) { return message.obstacles(); },
              [](double reach, wire::Needs& message) { message.set_obstacles(reach); }},
    NeedField{percept::Sensor::kRobots, [](const wire::Needs& message) { return message.robots(); },
              [](double reach, wire::Needs& message) { message.set_robots(reach); }},
    NeedField{percept::Sensor::kObjects, [](const wire::Needs& message) { return message.objects(); },
              [](double reach, wire::Needs& message) { message.set_objects(reach); }},
    NeedField{percept::Sensor::kRanges,
              [](const wire::Needs& message) { return message.ranges() ? percept::kOwnReach : 0.0; },
              [](double reach, wire::Needs& message) { message.set_ranges(reach > 0.0); }},
    NeedField{percept::Sensor::kTouch,
              [](const wire::Needs& message) { return message.touch() ? percept::kOwnReach : 0.0; },
              [](double reach, wire::Needs& message) { message.set_touch(reach > 0.0); }},
    NeedField{percept::Sensor::kGround,
              [](const wire::Needs& message) { return message.ground() ? percept::kOwnReach : 0.0; },
              [](double reach, wire::Needs& message) { message.set_ground(reach > 0.0); }},
    NeedField{percept::Sensor::kRadio,
              [](const wire::Needs& message) { return message.radio() ? percept::kOwnReach : 0.0; },
              [](double reach, wire::Needs& message) { message.set_radio(reach > 0.0); }},
};
static_assert(base::has_a_row_for_each<kNeedFields, &NeedField::sensor>());

bool fits(int value, auto last) {
  return value >= 0 && value <= static_cast<int>(last);
}

bool are(int length, auto... lengths) {
  return ((length == lengths) && ...);
}

}  // namespace

void encode(const percept::Needs& needs, wire::Needs& out) {
  for (const NeedField& field : kNeedFields) field.write(needs[field.sensor], out);
}

percept::Needs needs_of(const wire::Needs& message) {
  percept::Needs out;
  for (const NeedField& field : kNeedFields) out.want(field.sensor, field.read(message));
  return out;
}

void encode(const percept::Percepts& percepts, wire::Percepts& out) {
  const auto& [id, pose, time, cycle_duration, obstacles, robots, objects, camera, ranges, range_limit, touch,
               map, carried, carried_class, order, unit, joystick, notifications, shared_places,
               asked_passages, claims, contracts, ground, radio] = percepts;
  out.Clear();
  out.set_id(id.value);
  encode(pose, *out.mutable_pose());
  out.set_time(time);
  out.set_cycle_duration(cycle_duration);
  if (!obstacles.empty()) encode(obstacles, *out.mutable_obstacles());
  if (!robots.empty()) encode(robots, *out.mutable_robots());
  if (!objects.empty()) encode(objects, *out.mutable_objects());
  if (!ranges.empty()) encode(ranges, *out.mutable_ranges());
  out.set_range_limit(range_limit);
  out.set_touch_x(touch.x);
  out.set_touch_y(touch.y);
  out.set_touch_z(touch.z);
  encode(map, out);
  out.set_carried(carried.value);
  out.set_carried_class(static_cast<wire::ObjectClass>(carried_class));
  encode(order, *out.mutable_order());
  encode(unit, *out.mutable_unit());
  encode(joystick, *out.mutable_joystick());
  for (const std::uint64_t name : notifications) out.add_notifications(name);
  encode(camera, *out.mutable_camera());
  if (!shared_places.empty()) encode(shared_places, *out.mutable_shared_places());
  if (!asked_passages.empty()) encode(asked_passages, *out.mutable_asked_passages());
  if (!claims.empty()) encode(claims, *out.mutable_claims());
  if (!contracts.empty()) encode(contracts, *out.mutable_contracts());
  if (is_told(ground)) encode(ground, *out.mutable_ground());
  if (!radio.empty()) encode(radio, *out.mutable_radio());
}

std::optional<std::string> DecodedPercepts::decode_readings(const wire::Percepts& message) {
  const wire::Obstacles& obstacles = message.obstacles();
  if (!are(obstacles.x_size(), obstacles.y_size(), obstacles.z_size(), obstacles.radius_size()))
    return "the columns of the obstacles are not equally long";
  const int told = obstacles.velocity_x_size();
  if (!are(told, obstacles.velocity_y_size(), obstacles.velocity_z_size()) ||
      (told != 0 && told != obstacles.x_size()))
    return "the columns of the obstacles are not equally long";
  obstacles_.clear();
  for (int i = 0; i < obstacles.x_size(); ++i) {
    geom::Vector velocity;
    if (told != 0) velocity = {obstacles.velocity_x(i), obstacles.velocity_y(i), obstacles.velocity_z(i)};
    obstacles_.push_back({{obstacles.x(i), obstacles.y(i), obstacles.z(i)}, obstacles.radius(i), velocity});
  }

  const wire::Robots& robots = message.robots();
  if (!are(robots.x_size(), robots.y_size(), robots.z_size(), robots.id_size(), robots.heading_size(),
           robots.radius_size(), robots.is_unit_mate_size(), robots.object_class_size()))
    return "the columns of the robots are not equally long";
  robots_.clear();
  for (int i = 0; i < robots.x_size(); ++i) {
    if (!fits(robots.object_class(i), percept::kLastObjectClass))
      return "a robot is of a class that there is not";
    robots_.push_back({{robots.id(i)},
                       {robots.x(i), robots.y(i), robots.z(i)},
                       robots.heading(i),
                       robots.radius(i),
                       robots.is_unit_mate(i),
                       static_cast<percept::ObjectClass>(robots.object_class(i))});
  }

  const wire::Objects& objects = message.objects();
  if (!are(objects.x_size(), objects.y_size(), objects.z_size(), objects.id_size(),
           objects.object_class_size(), objects.style_size(), objects.radius_size()))
    return "the columns of the objects are not equally long";
  objects_.clear();
  for (int i = 0; i < objects.x_size(); ++i) {
    if (!fits(objects.object_class(i), percept::kLastObjectClass) ||
        !fits(objects.style(i), kLastObjectStyle))
      return "an object is of a class or style that there is not";
    objects_.push_back({{objects.id(i)},
                        static_cast<percept::ObjectClass>(objects.object_class(i)),
                        static_cast<percept::ObjectStyle>(objects.style(i)),
                        {objects.x(i), objects.y(i), objects.z(i)},
                        objects.radius(i)});
  }

  const wire::Ranges& ranges = message.ranges();
  if (!are(ranges.angle_size(), ranges.distance_size(), ranges.hit_size()))
    return "the columns of the ranges are not equally long";
  ranges_.clear();
  for (int i = 0; i < ranges.angle_size(); ++i)
    ranges_.push_back({ranges.angle(i), ranges.distance(i), ranges.hit(i)});
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode_radio(const wire::Radio& radio) {
  if (!are(radio.id_size(), radio.x_size(), radio.y_size(), radio.z_size(), radio.strength_size(),
           radio.is_unit_mate_size()))
    return "the columns of the radio are not equally long";
  radio_.clear();
  for (int i = 0; i < radio.id_size(); ++i)
    radio_.push_back(
        {{radio.id(i)}, {radio.x(i), radio.y(i), radio.z(i)}, radio.strength(i), radio.is_unit_mate(i)});
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode_messages(const wire::Percepts& message) {
  notifications_.assign(message.notifications().begin(), message.notifications().end());
  const wire::SharedPlaces& places = message.shared_places();
  if (!are(places.from_size(), places.object_size(), places.object_class_size(), places.x_size(),
           places.y_size(), places.time_size()))
    return "the columns of the shared places are not equally long";
  shared_places_.clear();
  for (int i = 0; i < places.from_size(); ++i) {
    if (!fits(places.object_class(i), percept::kLastObjectClass))
      return "a shared place is of a class that there is not";
    shared_places_.push_back({{places.from(i)},
                              {places.object(i)},
                              static_cast<percept::ObjectClass>(places.object_class(i)),
                              {places.x(i), places.y(i)},
                              places.time(i)});
  }
  const wire::AskedPassages& passages = message.asked_passages();
  if (!are(passages.from_size(), passages.x_size(), passages.y_size(), passages.cost_size(),
           passages.time_size()))
    return "the columns of the asked passages are not equally long";
  asked_passages_.clear();
  for (int i = 0; i < passages.from_size(); ++i)
    asked_passages_.push_back(
        {{passages.from(i)}, {passages.x(i), passages.y(i)}, passages.cost(i), passages.time(i)});
  const wire::Claims& claims = message.claims();
  if (!are(claims.object_size(), claims.robot_size()))
    return "the columns of the claims are not equally long";
  claims_.clear();
  for (int i = 0; i < claims.object_size(); ++i) claims_.push_back({{claims.object(i)}, {claims.robot(i)}});
  const wire::Contracts& contracts = message.contracts();
  if (!are(contracts.task_size(), contracts.object_size(), contracts.x_size(), contracts.y_size(),
           contracts.state_size(), contracts.manager_size(), contracts.contractor_size(),
           contracts.reneged_size(), contracts.time_size()))
    return "the columns of the contracts are not equally long";
  contracts_.clear();
  for (int i = 0; i < contracts.task_size(); ++i) {
    if (!fits(contracts.state(i), percept::kLastContractState))
      return "a contract is in a state that there is not";
    contracts_.push_back({contracts.task(i),
                          {contracts.object(i)},
                          {contracts.x(i), contracts.y(i)},
                          static_cast<percept::ContractState>(contracts.state(i)),
                          {contracts.manager(i)},
                          {contracts.contractor(i)},
                          {contracts.reneged(i)},
                          contracts.time(i)});
  }
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode_map(const wire::SiteMap& message) {
  const auto point = [](const wire::Points& points, int i) { return geom::Point{points.x(i), points.y(i)}; };
  const wire::Points& a = message.door_a();
  const wire::Points& b = message.door_b();
  const wire::Points& start = message.hallway_start();
  const wire::Points& end = message.hallway_end();
  if (!are(message.door_is_marked_size(), a.x_size(), a.y_size(), b.x_size(), b.y_size()) ||
      !are(message.hallway_width_size(), start.x_size(), start.y_size(), end.x_size(), end.y_size()))
    return "the columns of the map are not equally long";
  doors_.clear();
  for (int i = 0; i < a.x_size(); ++i)
    doors_.push_back({point(a, i), point(b, i), message.door_is_marked(i)});
  hallways_.clear();
  for (int i = 0; i < start.x_size(); ++i)
    hallways_.push_back({point(start, i), point(end, i), message.hallway_width(i)});
  outlines_.clear();
  for (const wire::Points& room : message.rooms()) {
    if (!are(room.x_size(), room.y_size())) return "the columns of a room are not equally long";
    std::vector<geom::Point>& outline = outlines_.emplace_back();
    for (int i = 0; i < room.x_size(); ++i) outline.push_back(point(room, i));
  }
  rooms_.clear();
  for (const auto& outline : outlines_) rooms_.push_back({outline});
  percepts_.map = {doors_, rooms_, hallways_};
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode_ground(const wire::Ground& message) {
  if (!are(message.disc_radius_size(), message.discs().x_size(), message.discs().y_size()) ||
      !are(message.wall_a().x_size(), message.wall_a().y_size(), message.wall_b().x_size(),
           message.wall_b().y_size()))
    return "the columns of the ground are not equally long";
  discs_.clear();
  for (int i = 0; i < message.disc_radius_size(); ++i)
    discs_.push_back({{message.discs().x(i), message.discs().y(i)}, message.disc_radius(i)});
  walls_.clear();
  for (int i = 0; i < message.wall_a().x_size(); ++i)
    walls_.push_back(
        {{message.wall_a().x(i), message.wall_a().y(i)}, {message.wall_b().x(i), message.wall_b().y(i)}});
  if (message.edges() > walls_.size()) return "of the ground more walls are edges than there are";
  percepts_.ground = {message.revision(),
                      discs_,
                      walls_,
                      {message.x0(), message.y0(), message.x1(), message.y1()},
                      message.edges()};
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode_order(const wire::Order& message) {
  if (!fits(message.task(), percept::kLastTask) || !fits(message.formation(), kLastFormation) ||
      !fits(message.reference(), kLastReference))
    return "the order has a task, formation or reference that there is not";
  if (!are(message.route().x_size(), message.route().y_size()))
    return "the columns of the route are not equally long";
  route_.clear();
  for (int i = 0; i < message.route().x_size(); ++i)
    route_.push_back({message.route().x(i), message.route().y(i)});
  percepts_.order = {message.sequence(),
                     static_cast<percept::Task>(message.task()),
                     {message.goal_x(), message.goal_y()},
                     route_,
                     static_cast<percept::Formation>(message.formation()),
                     static_cast<percept::FormationReference>(message.reference()),
                     message.heading(),
                     message.has_heading(),
                     message.speed(),
                     message.halted(),
                     message.swath(),
                     message.margin()};
  return std::nullopt;
}

std::optional<std::string> DecodedPercepts::decode(const wire::Percepts& message) {
  if (auto problem = decode_readings(message)) return problem;
  if (auto problem = decode_radio(message.radio())) return problem;
  if (auto problem = decode_order(message.order())) return problem;
  if (auto problem = decode_messages(message)) return problem;
  if (auto problem = decode_map(message.map())) return problem;
  percepts_.ground = {};
  if (message.has_ground()) {
    if (auto problem = decode_ground(message.ground())) return problem;
  }
  if (!fits(message.carried_class(), percept::kLastObjectClass))
    return "what is carried is of a class that there is not";
  const wire::Unit& unit = message.unit();
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
  if (unit.size() > kMost || unit.rank() > kMost) return "the unit is larger than units are";

  percepts_.id = {message.id()};
  percepts_.pose = pose_of(message.pose());
  percepts_.time = message.time();
  percepts_.cycle_duration = message.cycle_duration();
  percepts_.obstacles = obstacles_;
  percepts_.robots = robots_;
  percepts_.objects = objects_;
  percepts_.ranges = ranges_;
  percepts_.range_limit = message.range_limit();
  percepts_.touch = {message.touch_x(), message.touch_y(), message.touch_z()};
  percepts_.carried = {message.carried()};
  percepts_.carried_class = static_cast<percept::ObjectClass>(message.carried_class());
  percepts_.unit = {static_cast<std::uint16_t>(unit.size()),
                    static_cast<std::uint16_t>(unit.rank()),
                    {unit.center_x(), unit.center_y()},
                    {unit.step_x(), unit.step_y()},
                    pose_of(unit.leader()),
                    pose_of(unit.neighbor()),
                    unit.formation_heading()};
  percepts_.joystick = joystick_of(message.joystick());
  percepts_.notifications = notifications_;
  percepts_.camera = {message.camera().pan(), message.camera().field_of_view()};
  percepts_.shared_places = shared_places_;
  percepts_.asked_passages = asked_passages_;
  percepts_.claims = claims_;
  percepts_.contracts = contracts_;
  percepts_.radio = radio_;
  return std::nullopt;
}

}  // namespace mlab::robot_wire
