#include "mlab/component_test/situation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "mlab/base/hash.h"
#include "mlab/flow/port_types.h"

namespace mlab::component_test {
namespace {

using cdl::LoweredStep;
using cdl::TestPercept;

std::size_t index_of(const LoweredStep& step, std::string_view input) {
  const auto inputs = step.percept->inputs;
  return static_cast<std::size_t>(std::ranges::find(inputs, input, &cdl::TestInput::name) - inputs.begin());
}

bool has(const LoweredStep& step, std::string_view input) {
  return step.values.at(index_of(step, input)).has_value();
}

// As it was said, or as the table has it.
std::string text(const LoweredStep& step, std::string_view input) {
  const std::size_t i = index_of(step, input);
  return step.values.at(i).value_or(std::string(step.percept->inputs[i].initial));
}

template <class T>
T value(const LoweredStep& step, std::string_view input) {
  T out{};
  flow::type_info<T>().parse(text(step, input), &out);
  return out;
}

double number(const LoweredStep& step, std::string_view input) {
  return value<double>(step, input);
}

// The first of them: a thing is of one class.
percept::ObjectClass class_in(const LoweredStep& step) {
  const auto classes = value<flow::ObjectClasses>(step, "class");
  const int bit = classes.bits == 0 ? 64 : std::countr_zero(classes.bits);
  const auto last = static_cast<int>(percept::kLastObjectClass);
  return bit > last ? percept::ObjectClass::kUnknown : static_cast<percept::ObjectClass>(bit);
}

std::uint32_t said_id(const LoweredStep& step) {
  return static_cast<std::uint32_t>(value<int>(step, "id"));
}

percept::ObjectStyle style_of(const LoweredStep& step) {
  return cdl::test_object_style_named(text(step, "style"))->style;  // lowering lets no other word through
}

// What has the same key stays in the order of the text.
template <class Thing, class KeyOf>
void sort_by(std::vector<Thing>& things, const KeyOf& key_of) {
  using Key = std::decay_t<decltype(key_of(things.front()))>;
  std::vector<std::pair<Key, std::size_t>> order;
  for (std::size_t i = 0; i < things.size(); ++i) order.emplace_back(key_of(things[i]), i);
  std::ranges::sort(order);
  std::vector<Thing> sorted;
  for (const auto& [key, at] : order) sorted.push_back(std::move(things[at]));
  things = std::move(sorted);
}

// By the way to the edge.
void sort_nearest_first(auto& readings) {
  sort_by(readings, [](const auto& one) { return geom::length(one.center) - one.radius; });
}

}  // namespace

Situation::Situation(const std::vector<LoweredStep>& steps) {
  for (const LoweredStep& step : steps) {
    if (step.percept == nullptr || step.written->kind != cdl::TestStep::Kind::kGiven) continue;
    if (step.percept->percept == TestPercept::kRobot) robot_ids_.said.insert(said_id(step));
    if (step.percept->percept == TestPercept::kObject) object_ids_.said.insert(said_id(step));
  }
}

std::uint32_t Situation::id_of(const LoweredStep& step, Ids& ids) {
  if (const std::uint32_t id = said_id(step); id != 0) return id;
  while (ids.said.contains(ids.next)) ++ids.next;
  return ids.next++;
}

void Situation::forget(TestPercept what) {
  switch (what) {
    case TestPercept::kSelf:
      percepts_.pose = {};
      break;
    case TestPercept::kObstacle:
      obstacles_.clear();
      break;
    case TestPercept::kRobot:
      robots_.clear();
      break;
    case TestPercept::kObject:
      objects_.clear();
      break;
    case TestPercept::kCarrying:
      percepts_.carried = {};
      percepts_.carried_class = percept::ObjectClass::kUnknown;
      break;
    case TestPercept::kOrder:
      percepts_.order = percept::Order();
      percepts_.order.sequence = ++orders_;
      break;
    case TestPercept::kWaypoint:
      route_.clear();
      break;
    case TestPercept::kUnit:
      percepts_.unit = {};
      has_center_ = has_leader_ = has_neighbor_ = false;
      break;
    case TestPercept::kStick:
      percepts_.joystick = {};
      break;
    case TestPercept::kMessage:
      messages_.clear();
      break;
    case TestPercept::kCamera:
      percepts_.camera = {};
      break;
    case TestPercept::kBeam:
      beams_.clear();
      break;
    case TestPercept::kSharedPlace:
      shared_places_.clear();
      break;
    case TestPercept::kAskedPassage:
      asked_passages_.clear();
      break;
    case TestPercept::kClaim:
      claims_.clear();
      break;
    case TestPercept::kDoor:
      doors_.clear();
      break;
    case TestPercept::kHallway:
      hallways_.clear();
      break;
    case TestPercept::kPlace:
      break;
    case TestPercept::kTouch:
      percepts_.touch = {};
      break;
    case TestPercept::kRadio:
      contacts_.clear();
      break;
  }
}

void Situation::take_order(const LoweredStep& step) {
  percept::Order& order = percepts_.order;
  order.sequence = ++orders_;
  order.task = value<percept::Task>(step, "task");
  order.goal = value<geom::Point>(step, "goal");
  order.formation = value<percept::Formation>(step, "formation");
  order.has_heading = has(step, "heading");
  order.heading = order.has_heading ? number(step, "heading") : 0.0;
  order.speed = number(step, "speed");
  order.halted = value<bool>(step, "halted");
}

void Situation::take_unit(const LoweredStep& step) {
  percept::UnitPercept& unit = percepts_.unit;
  unit.size = static_cast<std::uint16_t>(value<int>(step, "size"));
  unit.rank = static_cast<std::uint16_t>(value<int>(step, "rank"));
  has_center_ = has(step, "center");
  has_leader_ = has(step, "leader");
  has_neighbor_ = has(step, "neighbor");
  unit.center = value<geom::Point>(step, "center");
  unit.leader = {value<geom::Point>(step, "leader"), number(step, "heading")};
  unit.neighbor = {value<geom::Point>(step, "neighbor"), number(step, "heading")};
  unit.formation_heading = number(step, "heading");
}

void Situation::take_robot(const LoweredStep& step) {
  Robot one{value<geom::Point>(step, "at"), number(step, "heading"), {}};
  one.reading.id = {id_of(step, robot_ids_)};
  one.reading.radius = number(step, "radius");
  one.reading.is_unit_mate = value<bool>(step, "mate");
  one.reading.object_class = class_in(step);
  robots_.push_back(one);
}

void Situation::take_object(const LoweredStep& step) {
  Object one{value<geom::Point>(step, "at"), {}};
  one.reading.id = {id_of(step, object_ids_)};
  one.reading.object_class = class_in(step);
  one.reading.style = style_of(step);
  one.reading.radius = number(step, "radius");
  objects_.push_back(one);
}

void Situation::take_stick(const LoweredStep& step) {
  percepts_.joystick = {number(step, "x"), number(step, "y"), number(step, "magnitude"),
                        value<bool>(step, "ahead"), value<bool>(step, "complete")};
}

// NOLINTNEXTLINE(readability-function-size): a row for each
void Situation::take(const LoweredStep& step) {
  if (step.percept == nullptr) return;
  is_sensed_ = false;
  const TestPercept what = step.percept->percept;
  if (step.written->kind == cdl::TestStep::Kind::kGivenNo) {
    forget(what);
    return;
  }
  const auto point = [&](std::string_view name) { return value<geom::Point>(step, name); };
  const auto id = [&](std::string_view name) { return static_cast<std::uint32_t>(value<int>(step, name)); };
  switch (what) {
    case TestPercept::kSelf:
      percepts_.pose = {point("at"), number(step, "heading")};
      break;
    case TestPercept::kObstacle:
      obstacles_.push_back({point("at"), number(step, "radius")});
      break;
    case TestPercept::kRobot:
      take_robot(step);
      break;
    case TestPercept::kObject:
      take_object(step);
      break;
    case TestPercept::kCarrying:
      percepts_.carried = {id("id")};
      percepts_.carried_class = class_in(step);
      break;
    case TestPercept::kOrder:
      take_order(step);
      break;
    case TestPercept::kWaypoint:
      route_.push_back(point("at"));
      break;
    case TestPercept::kUnit:
      take_unit(step);
      break;
    case TestPercept::kStick:
      take_stick(step);
      break;
    case TestPercept::kMessage:
      messages_.push_back(base::hash_text(text(step, "name")));
      break;
    case TestPercept::kCamera:
      percepts_.camera = {number(step, "pan"), number(step, "field_of_view")};
      break;
    case TestPercept::kBeam:
      beams_.push_back({static_cast<float>(number(step, "angle")),
                        static_cast<float>(number(step, "distance")), value<bool>(step, "hit")});
      break;
    case TestPercept::kSharedPlace:
      shared_places_.push_back({{id("from")}, {id("object")}, class_in(step), point("at"), percepts_.time});
      break;
    case TestPercept::kAskedPassage:
      asked_passages_.push_back({{id("from")}, point("to"), number(step, "cost"), percepts_.time});
      break;
    case TestPercept::kClaim:
      claims_.push_back({{id("object")}, {id("robot")}});
      break;
    case TestPercept::kDoor:
      doors_.push_back({point("from"), point("to"), value<bool>(step, "marked")});
      break;
    case TestPercept::kHallway:
      hallways_.push_back({point("from"), point("to"), number(step, "width")});
      break;
    case TestPercept::kPlace:
      break;
    case TestPercept::kTouch:
      percepts_.touch = geom::polar(1.0, number(step, "direction"));
      break;
    case TestPercept::kRadio:
      contacts_.push_back(
          {point("at"), {{id("robot")}, {}, number(step, "strength"), value<bool>(step, "mate")}});
      break;
  }
}

void Situation::sense_around() {
  const geom::Pose& here = percepts_.pose;
  seen_obstacles_.clear();
  seen_robots_.clear();
  seen_objects_.clear();
  for (const Obstacle& one : obstacles_) seen_obstacles_.push_back({here.to_robot(one.at), one.radius});
  for (const Robot& one : robots_) {
    percept::RobotReading& reading = seen_robots_.emplace_back(one.reading);
    reading.center = here.to_robot(one.at);
    reading.heading = one.heading - here.heading;
  }
  const percept::Camera& camera = percepts_.camera;
  for (const Object& one : objects_) {
    const geom::Vector center = here.to_robot(one.at);
    const double off = std::remainder(std::atan2(center.y, center.x) - camera.pan, 2.0 * std::numbers::pi);
    if (std::abs(off) > camera.field_of_view / 2.0 + 1e-9) continue;
    seen_objects_.emplace_back(one.reading).center = center;
  }
  sort_nearest_first(seen_obstacles_);
  sort_nearest_first(seen_robots_);
  sort_nearest_first(seen_objects_);
  percepts_.obstacles = seen_obstacles_;
  percepts_.robots = seen_robots_;
  percepts_.objects = seen_objects_;
}

void Situation::sense_unit() {
  percept::UnitPercept& unit = percepts_.unit;
  if (!has_center_) unit.center = percepts_.pose.position;
  if (!has_leader_) unit.leader.position = percepts_.pose.position;
  if (!has_neighbor_) unit.neighbor.position = percepts_.pose.position;
}

void Situation::sense() {
  is_sensed_ = true;
  sense_around();
  sense_unit();
  percepts_.ranges = beams_;
  percepts_.range_limit = 0.0;
  for (const percept::RangeReading& one : beams_)
    percepts_.range_limit = std::max(percepts_.range_limit, static_cast<double>(one.distance));
  percepts_.order.route = route_;
  percepts_.map.doors = doors_;
  percepts_.map.hallways = hallways_;
  std::ranges::sort(messages_);
  messages_.erase(std::ranges::unique(messages_).begin(), messages_.end());
  percepts_.notifications = messages_;
  sort_by(shared_places_, [](const auto& one) { return one.from.value; });
  percepts_.shared_places = shared_places_;
  sort_by(asked_passages_, [](const auto& one) { return one.from.value; });
  percepts_.asked_passages = asked_passages_;
  sort_by(claims_, [](const auto& one) { return one.object.value; });
  percepts_.claims = claims_;
  heard_.clear();
  for (const Contact& one : contacts_) {
    percept::RadioContact& contact = heard_.emplace_back(one.contact);
    contact.center = percepts_.pose.to_robot(one.at);
  }
  sort_by(heard_, [](const auto& one) { return -one.strength; });
  percepts_.radio = heard_;
}

const percept::Percepts& Situation::in_cycle(std::uint64_t cycle) {
  percepts_.id = {1};
  percepts_.cycle_duration = cdl::kTestCycle;
  percepts_.time = static_cast<double>(cycle - 1) * cdl::kTestCycle;
  if (!is_sensed_) sense();
  return percepts_;
}

}  // namespace mlab::component_test
