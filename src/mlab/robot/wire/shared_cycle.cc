#include "mlab/robot/wire/shared_cycle.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

#include "mlab/base/fields.h"
#include "mlab/flow/module.h"

namespace mlab::robot_wire {
namespace {

using percept::Action;
using percept::Percepts;

static_assert(std::is_trivially_copyable_v<Percepts> && std::is_trivially_copyable_v<Action>);

template <class T>
constexpr bool kIsList = false;
template <class T>
constexpr bool kIsList<std::span<T>> = true;

// Every list of the percepts, but for the rooms of the map, whose outlines are lists themselves.
template <class P, class Visit>
constexpr void for_each_list(P& part, Visit&& visit) {
  base::for_each_field(part, [&](auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (kIsList<Field> && !std::is_same_v<Field, std::span<const percept::Room>>)
      visit(field);
    else if constexpr (std::is_class_v<Field> && !kIsList<Field>)
      for_each_list(field, visit);
  });
}

constexpr std::size_t kLists = [] {
  std::size_t count = 0;
  Percepts percepts;
  for_each_list(percepts, [&](const auto&) { ++count; });
  return count;
}();
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

// Where the parts of an action stand that are not always of use. Requests, their number and the alert are the
// last, so that what is always of use is in front.
constexpr std::size_t kRequests = offsetof(Action, requests);
constexpr std::size_t kRequestCount = offsetof(Action, request_count);
constexpr std::size_t kAlert = offsetof(Action, alert);
static_assert(kRequests < kRequestCount && kRequestCount < kAlert);

// A byte of a bool field may hold anything.
void make_flag(std::byte& flag) {
  flag = std::byte{flag != std::byte{0}};
}

bool is_at_most(std::byte byte, auto last) {
  return std::to_integer<unsigned>(byte) <= static_cast<unsigned>(last);
}

bool is_request_sound(const std::byte* request) {
  using percept::Request;
  return is_at_most(request[offsetof(Request, kind)], percept::kLastRequest) &&
         is_at_most(request[offsetof(Request, audience)], percept::Audience::kSelf) &&
         is_at_most(request[offsetof(Request, object_class)], percept::kLastObjectClass);
}

}  // namespace

std::uint64_t shared_layout() {
  std::uint64_t key = flow::module_layout();
  for (const std::uint64_t part :
       {sizeof(Control), sizeof(PlaceHeader), sizeof(Head), sizeof(percept::Door), sizeof(percept::Hallway),
        sizeof(percept::SharedPlace), sizeof(percept::AskedPassage), sizeof(percept::Claim),
        sizeof(percept::Contract), sizeof(percept::RadioContact), sizeof(percept::Request),
        sizeof(flow::Interventions)})
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

void write_action(const Action& action, ActionBytes out) {
  const auto* const from = reinterpret_cast<const std::byte*>(&action);
  const auto copy = [&](std::size_t begin, std::size_t size) {
    std::memcpy(out.data() + begin, from + begin, size);
  };
  copy(0, kRequests + action.request_count * sizeof(percept::Request));
  copy(kRequestCount, 1);
  copy(kAlert, ::strnlen(action.alert.data(), action.alert.size() - 1) + 1);
}

// Each byte is looked at after it was copied: whoever wrote it may be writing again.
bool read_action(ConstActionBytes bytes, Action& out) {
  out = {};
  std::array<std::byte, kRequests> head;
  std::memcpy(head.data(), bytes.data(), head.size());
  for (const std::size_t flag : {offsetof(Action, drives), offsetof(Action, spins), offsetof(Action, looks),
                                 offsetof(Action, status) + offsetof(percept::OrderStatus, done)})
    make_flag(head[flag]);
  const std::byte count = bytes[kRequestCount];
  if (!is_at_most(count, Action::kMaxRequests)) return false;
  std::array<std::byte, sizeof(Action::requests)> requests;
  const std::size_t size = std::to_integer<std::size_t>(count) * sizeof(percept::Request);
  std::memcpy(requests.data(), bytes.data() + kRequests, size);
  for (std::size_t at = 0; at < size; at += sizeof(percept::Request)) {
    if (!is_request_sound(requests.data() + at)) return false;
  }
  auto* const to = reinterpret_cast<std::byte*>(&out);
  std::memcpy(to, head.data(), head.size());
  std::memcpy(to + kRequests, requests.data(), size);
  out.request_count = std::to_integer<std::uint8_t>(count);
  if (bytes[kAlert] != std::byte{0}) {
    std::memcpy(out.alert.data(), bytes.data() + kAlert, out.alert.size() - 1);
    std::fill(std::ranges::find(out.alert, '\0'), out.alert.end(), '\0');
  }
  return true;
}

}  // namespace mlab::robot_wire
