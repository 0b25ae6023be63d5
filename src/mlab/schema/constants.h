#pragma once

#include <numbers>

namespace mlab::schema {

/// The strength of a demand that nothing may outweigh, such as "leave this safety margin". Finite on purpose:
/// sums and gains stay numbers, and limiting the speed turns it into a pure direction.
inline constexpr double kInfinity = 1e12;
/// From this strength on a vector counts as such a demand, whatever gain it went through.
inline constexpr double kAbsolute = 1e9;
inline constexpr double kPi = std::numbers::pi;

}  // namespace mlab::schema
