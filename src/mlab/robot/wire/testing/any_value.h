#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "mlab/base/fields.h"
#include "mlab/base/table.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

/// Percepts and actions with anything in them, for tests: numbers of any bits, and often the odd ones.
namespace mlab::robot_wire::testing {

inline double any_double() {
  constexpr std::array<std::uint64_t, 6> kOdd = {0x8000000000000000ULL,   // -0
                                                 0x7ff0000000000000ULL,   // infinity
                                                 0x7ff8000000000000ULL,   // a NaN
                                                 0xfff4000000012345ULL,   // a signalling NaN with a payload
                                                 0x0000000000000001ULL,   // the smallest number
                                                 0x3ff0000000000000ULL};  // 1
  const auto bits = *rc::gen::weightedOneOf<std::uint64_t>(
      {{3, rc::gen::arbitrary<std::uint64_t>()}, {1, rc::gen::elementOf(kOdd)}});
  return std::bit_cast<double>(bits);
}
inline float any_float() {
  return std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>());
}
inline bool any_bool() {
  return *rc::gen::arbitrary<bool>();
}
inline std::uint32_t any_id() {
  return *rc::gen::arbitrary<std::uint32_t>();
}
template <class Enum>
Enum any_of(Enum last) {
  return static_cast<Enum>(*rc::gen::inRange(0, static_cast<int>(last) + 1));
}
template <class Enum>
consteval Enum last_of() {
  return []<std::size_t... kNumbers>(std::index_sequence<kNumbers...>) {
    return static_cast<Enum>((std::size_t{base::is_enumerator<static_cast<Enum>(kNumbers)>()} + ...) - 1);
  }(std::make_index_sequence<64>());
}

/// Percepts with the lists that they are views of.
class AnyPercepts {
 public:
  AnyPercepts() {
    fill(percepts);
    percept::KnownGround& ground = percepts.ground;
    ground.edges = std::min(ground.edges, ground.walls.size());
  }
  AnyPercepts(const AnyPercepts&) = delete;
  AnyPercepts& operator=(const AnyPercepts&) = delete;

  percept::Percepts percepts;

 private:
  template <class T>
  void fill(std::span<const T>& list) {
    auto values = std::make_shared<std::vector<T>>();
    for (int n = *rc::gen::inRange(0, 5); n > 0; --n) fill(values->emplace_back());
    list = *values;
    lists_.push_back(std::move(values));
  }
  template <class T>
  void fill(T& value) {
    if constexpr (std::is_same_v<T, double>)
      value = any_double();
    else if constexpr (std::is_same_v<T, float>)
      value = any_float();
    else if constexpr (std::is_enum_v<T>)
      value = any_of(last_of<T>());
    else if constexpr (std::is_class_v<T>)
      base::for_each_field(value, [&](auto& field) { fill(field); });
    else
      value = *rc::gen::arbitrary<T>();
  }

  std::vector<std::shared_ptr<void>> lists_;
};

inline percept::Action any_action() {
  percept::Action action;
  action.velocity = {any_double(), any_double(), any_double()};
  action.spin = any_double();
  action.drives = any_bool();
  action.spins = any_bool();
  action.pan = any_double();
  action.looks = any_bool();
  action.status = {any_id(), any_bool(), any_double()};
  for (int n = *rc::gen::inRange(0, percept::Action::kMaxRequests + 1); n > 0; --n) {
    action.ask({any_of(percept::kLastRequest),
                any_of(percept::Audience::kSelf),
                any_of(percept::ObjectClass::kFriendlyRobot),
                {any_id()},
                any_double(),
                any_double(),
                *rc::gen::arbitrary<std::uint64_t>(),
                {any_double(), any_double()},
                any_double(),
                any_double(),
                any_double()});
  }
  for (int n = *rc::gen::inRange(0, 127); n > 0; --n) action.alert[static_cast<std::size_t>(n - 1)] = 'a';
  return action;
}

}  // namespace mlab::robot_wire::testing
