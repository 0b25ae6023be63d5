#include "mlab/sim/objects.h"

#include <algorithm>
#include <utility>

namespace mlab::sim {
namespace {

using percept::ObjectStyle;
using percept::Request;

bool is_in_sight(const Object& object) {
  return object.carrier.value == 0 && object.basket.value == 0;
}

}  // namespace

double edge_distance(const Bodies& bodies, std::uint32_t body, const Object& object) {
  return distance(bodies.position(body), object.center) - bodies.radius[body] - object.radius;
}

Objects::Objects(std::vector<Object> objects, std::span<const Travel> travels) : list_(std::move(objects)) {
  send_off(travels);
}

Object* Objects::find(base::ObjectId id) {
  const auto found = std::find_if(list_.begin(), list_.end(), [id](const Object& o) { return o.id == id; });
  return found == list_.end() ? nullptr : &*found;
}

void Objects::forget_grid() {
  grid_ = {};
  visible_ = {};
  is_stale_ = true;
}

void Objects::carry_out(const percept::Action& action, Bodies& bodies, std::uint32_t body) {
  const int count = std::min<int>(action.request_count, percept::Action::kMaxRequests);
  for (int i = 0; i < count; ++i) {
    const Request& request = action.requests[static_cast<std::size_t>(i)];
    switch (request.kind) {
      case Request::Kind::kPickUp:
        pick_up(request, bodies, body);
        break;
      case Request::Kind::kDrop:
        drop(bodies, body);
        break;
      case Request::Kind::kDropInBasket:
        drop_in_basket(request, bodies, body);
        break;
      case Request::Kind::kMarkObject:
        mark(request, bodies, body);
        break;
      case Request::Kind::kShowAs:
        bodies.seen_as[body] = request.object_class;
        break;
      case Request::Kind::kMarkDoor:
      case Request::Kind::kUnmarkDoor:
      case Request::Kind::kLocalize:
      case Request::Kind::kHalt:
      case Request::Kind::kEndMission:
      case Request::Kind::kNotify:
      case Request::Kind::kProceed:
      case Request::Kind::kTakeNotification:
      case Request::Kind::kSharePlace:
      case Request::Kind::kAskPassage:
      case Request::Kind::kClaim:
      case Request::Kind::kAnnounceTask:
      case Request::Kind::kBid:
      case Request::Kind::kKeepTasks:
      case Request::Kind::kStartTask:
      case Request::Kind::kFinishTask:
      case Request::Kind::kRenegeTask:
        break;  // none of the objects' business
    }
  }
}

void Objects::pick_up(const Request& request, Bodies& bodies, std::uint32_t body) {
  if (bodies.carried[body] != 0) return;
  Object* const object = find(request.object);
  if (object == nullptr || object->style != ObjectStyle::kMovable || !is_in_sight(*object)) return;
  if (!(edge_distance(bodies, body, *object) <= request.reach)) return;
  object->carrier = bodies.robot[body];
  object->center = bodies.position(body);
  const auto index = static_cast<std::uint32_t>(object - list_.data());
  if (std::erase_if(travellers_, [&](const Traveller& one) { return one.object == index; }) > 0)
    taken_.push_back(object->id);
  bodies.carried[body] = index + 1;
  is_stale_ = true;
}

void Objects::drop(Bodies& bodies, std::uint32_t body) {
  if (bodies.carried[body] == 0) return;
  Object& object = list_[bodies.carried[body] - 1];
  object.carrier = {};
  object.center = bodies.position(body);
  bodies.carried[body] = 0;
  is_stale_ = true;
}

void Objects::drop_in_basket(const Request& request, Bodies& bodies, std::uint32_t body) {
  if (bodies.carried[body] == 0) return;
  const Object* basket = nullptr;
  for (const Object& object : list_) {
    if (object.style != ObjectStyle::kContainer || !(edge_distance(bodies, body, object) <= request.reach))
      continue;
    if (request.object.value != 0 ? object.id == request.object
                                  : basket == nullptr || edge_distance(bodies, body, object) <
                                                             edge_distance(bodies, body, *basket)) {
      basket = &object;
    }
  }
  if (basket == nullptr) return;
  Object& object = list_[bodies.carried[body] - 1];
  object.carrier = {};
  object.basket = basket->id;
  object.center = basket->center;
  bodies.carried[body] = 0;
  is_stale_ = true;
}

void Objects::mark(const Request& request, const Bodies& bodies, std::uint32_t body) {
  Object* const object = find(request.object);
  if (object == nullptr || !is_in_sight(*object)) return;
  if (edge_distance(bodies, body, *object) <= request.reach) object->object_class = request.object_class;
}

void Objects::follow(const Bodies& bodies) {
  for (std::uint32_t body = 0; body < bodies.count(); ++body) {
    if (bodies.carried[body] != 0) list_[bodies.carried[body] - 1].center = bodies.position(body);
  }
}

void Objects::travel(double time) {
  for (const Traveller& one : travellers_) {
    Object& object = list_[one.object];
    object.center = one.course->at(time).place;
    if (object.style == ObjectStyle::kContainer) {
      for (Object& other : list_) {
        if (other.basket == object.id) other.center = object.center;
      }
    }
    is_stale_ = true;
  }
}

void Objects::send_off(std::span<const Travel> travels) {
  travellers_.clear();
  for (const Travel& one : travels) {
    const Object* const object = find(one.object);
    const bool stays = object == nullptr || std::ranges::find(taken_, one.object) != taken_.end();
    if (!stays) travellers_.push_back({static_cast<std::uint32_t>(object - list_.data()), one.course});
  }
}

void Objects::replace(std::vector<Object> objects, std::span<const Travel> travels,
                      std::span<const base::ObjectId> were, Bodies& bodies) {
  const auto index_of = [&](base::ObjectId was) {
    const auto found = was.value == 0 ? were.end() : std::ranges::find(were, was);
    return static_cast<std::size_t>(found - were.begin());
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Object& object = objects[i];
    object.carrier = {};
    object.basket = {};
    const Object* const before = were[i].value == 0 ? nullptr : find(were[i]);
    if (before == nullptr) continue;
    object.center = before->center;
    const std::size_t basket = index_of(before->basket);
    if (basket < objects.size() && objects[basket].style == ObjectStyle::kContainer)
      object.basket = objects[basket].id;
    if (object.style == ObjectStyle::kMovable) object.carrier = before->carrier;
  }
  for (std::uint32_t& carried : bodies.carried) {
    if (carried == 0) continue;
    const std::size_t now = index_of(list_[carried - 1].id);
    carried =
        now < objects.size() && objects[now].carrier.value != 0 ? static_cast<std::uint32_t>(now + 1) : 0;
  }
  std::vector<base::ObjectId> taken;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (std::ranges::find(taken_, were[i]) != taken_.end()) taken.push_back(objects[i].id);
  }
  list_ = std::move(objects);
  taken_ = std::move(taken);
  send_off(travels);
  is_stale_ = true;
}

std::uint32_t Objects::count_in(base::ObjectId container) const {
  return static_cast<std::uint32_t>(std::count_if(list_.begin(), list_.end(), [&](const Object& o) {
    return container.value != 0 && o.basket == container;
  }));
}

void Objects::refresh() {
  if (!is_stale_) return;
  visible_.clear();
  visible_.reserve(list_.size());
  for (std::uint32_t index = 0; index < list_.size(); ++index) {
    const Object& object = list_[index];
    if (!is_in_sight(object)) continue;
    visible_.push_back({object.center.x, object.center.y, rounded_up(object.radius), index});
  }
  grid_.build(visible_, 0.1);
  is_stale_ = false;
}

}  // namespace mlab::sim
