#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>

#include "mlab/base/fields.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

/// Equality bit for bit: -0 is not 0, and a NaN equals itself.
namespace mlab::robot_wire::testing {

template <class T>
inline constexpr bool kIsSpan = false;
template <class T>
inline constexpr bool kIsSpan<std::span<T>> = true;

/// Of percepts and all that they are made of, field by field.
template <class T>
bool same(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  } else if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
  } else if constexpr (kIsSpan<T>) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return same(x, y); });
  } else if constexpr (std::is_class_v<T>) {
    return std::apply(
        [&](const auto&... of_a) {
          return std::apply([&](const auto&... of_b) { return (same(of_a, of_b) && ...); },
                            base::fields_of(b));
        },
        base::fields_of(a));
  } else {
    return a == b;
  }
}

inline bool same(const percept::Action& a, const percept::Action& b) {
  return a.alert == b.alert && same(a.pan, b.pan) && a.looks == b.looks && same(a.velocity, b.velocity) &&
         same(a.spin, b.spin) && a.drives == b.drives && a.spins == b.spins && same(a.status, b.status) &&
         same(std::span(a.requests).first(a.request_count), std::span(b.requests).first(b.request_count));
}

}  // namespace mlab::robot_wire::testing
