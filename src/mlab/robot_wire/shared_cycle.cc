#include "mlab/robot_wire/shared_cycle.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "mlab/flow/module.h"

namespace mlab::robot_wire {
namespace {

using percept::Action;
using percept::Percepts;

static_assert(std::is_trivially_copyable_v<Percepts> && std::is_trivially_copyable_v<Action>);

// Every list of the percepts, but for the rooms of the map, whose outlines are lists themselves. A field that
// is added to Percepts does not compile until somebody has decided here whether it is a list.
template <class P, class Visit>
void for_each_list(P& percepts, Visit visit) {
  auto& [id, pose, time, cycle_duration, obstacles, robots, objects, camera, ranges, range_limit, map,
         carried, carried_class, order, unit, joystick, notifications, shared_places, claims] = percepts;
  auto& [doors, rooms, hallways] = map;
  auto& [sequence, task, goal, route, formation, reference, heading, has_heading, speed, halted] = order;
  visit(obstacles);
  visit(robots);
  visit(objects);
  visit(ranges);
  visit(doors);
  visit(hallways);
  visit(route);
  visit(notifications);
  visit(shared_places);
  visit(claims);
}

constexpr std::size_t kLists = 10;
constexpr std::size_t kAlignment = 16;

struct Head {
  Percepts percepts;  // its lists are empty here
  std::array<std::uint64_t, kLists> counts{};
  std::uint64_t room_count = 0;
};

std::size_t aligned(std::size_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

// An outline stands behind its count.
std::size_t room_size(std::size_t points) {
  return kAlignment + aligned(points * sizeof(geom::Point));
}

template <class T>
void copy_list(std::span<const T> list, std::byte* out) {
  if (!list.empty()) std::memcpy(out, list.data(), list.size_bytes());
}

template <class T>
void view_list(std::span<const T>& list, const std::byte* from, std::size_t count) {
  list = std::span<const T>(reinterpret_cast<const T*>(from), count);
}

// Puts a byte of a bool field right, which may hold anything; false where an enumeration's is out of range.
struct ActionBytes {
  std::array<std::byte, sizeof(Action)> bytes;

  void make_flag(std::size_t offset) { bytes[offset] = std::byte{bytes[offset] != std::byte{0}}; }
  bool is_at_most(std::size_t offset, auto last) const {
    return std::to_integer<unsigned>(bytes[offset]) <= static_cast<unsigned>(last);
  }
};

bool are_requests_sound(const ActionBytes& raw) {
  using percept::Request;
  for (std::size_t i = 0; i < Action::kMaxRequests; ++i) {
    const std::size_t at = offsetof(Action, requests) + i * sizeof(Request);
    if (!raw.is_at_most(at + offsetof(Request, kind), Request::Kind::kEndMission) ||
        !raw.is_at_most(at + offsetof(Request, audience), percept::Audience::kSelf) ||
        !raw.is_at_most(at + offsetof(Request, object_class), percept::kLastObjectClass))
      return false;
  }
  return raw.is_at_most(offsetof(Action, request_count), Action::kMaxRequests);
}

}  // namespace

std::uint64_t shared_layout() {
  std::uint64_t key = flow::module_layout();
  for (const std::uint64_t part :
       {sizeof(Control), sizeof(PlaceHeader), sizeof(Head), sizeof(percept::Door), sizeof(percept::Hallway),
        sizeof(percept::SharedPlace), sizeof(percept::Claim), sizeof(percept::Request)})
    key = base::combine_bits(key, part);
  return key;
}

std::size_t percepts_size(const Percepts& percepts) {
  std::size_t size = aligned(sizeof(Head));
  for_each_list(percepts, [&](const auto& list) { size += aligned(list.size_bytes()); });
  for (const percept::Room& room : percepts.map.rooms) size += room_size(room.outline.size());
  return size;
}

void write_percepts(const Percepts& percepts, std::byte* out) {
  Head head{percepts, {}, percepts.map.rooms.size()};
  // No address of this process leaves it.
  for_each_list(head.percepts, [](auto& list) { list = {}; });
  head.percepts.map.rooms = {};
  std::byte* at = out + aligned(sizeof(Head));
  std::size_t next = 0;
  for_each_list(percepts, [&](const auto& list) {
    head.counts[next++] = list.size();
    copy_list(list, at);
    at += aligned(list.size_bytes());
  });
  for (const percept::Room& room : percepts.map.rooms) {
    const std::uint64_t count = room.outline.size();
    std::memcpy(at, &count, sizeof count);
    copy_list(room.outline, at + kAlignment);
    at += room_size(room.outline.size());
  }
  std::memcpy(out, &head, sizeof head);
}

const Percepts& ReadPercepts::read(const std::byte* from) {
  Head head;
  std::memcpy(&head, from, sizeof head);
  percepts_ = head.percepts;
  const std::byte* at = from + aligned(sizeof(Head));
  std::size_t next = 0;
  for_each_list(percepts_, [&](auto& list) {
    view_list(list, at, head.counts[next++]);
    at += aligned(list.size_bytes());
  });
  rooms_.resize(head.room_count);
  for (percept::Room& room : rooms_) {
    std::uint64_t count = 0;
    std::memcpy(&count, at, sizeof count);
    view_list(room.outline, at + kAlignment, count);
    at += room_size(count);
  }
  percepts_.map.rooms = rooms_;
  return percepts_;
}

std::optional<Action> sound_action(std::span<const std::byte, sizeof(Action)> bytes) {
  ActionBytes raw{};
  std::ranges::copy(bytes, raw.bytes.begin());
  for (const std::size_t flag : {offsetof(Action, drives), offsetof(Action, spins), offsetof(Action, looks),
                                 offsetof(Action, status) + offsetof(percept::OrderStatus, done)})
    raw.make_flag(flag);
  if (!are_requests_sound(raw)) return std::nullopt;
  auto action = std::bit_cast<Action>(raw.bytes);
  action.alert.back() = '\0';
  return action;
}

}  // namespace mlab::robot_wire
