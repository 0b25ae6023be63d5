#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace mlab::base {

/// An index that can't be mistaken for another kind of index. `Tag` only tells the kinds apart.
/// Ids are dense, start where their owner says, and order by value.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  friend constexpr auto operator<=>(Id, Id) = default;
};

/// A robot of the run. The first robot that a mission mentions has the id 1, as missions count.
using RobotId = Id<struct RobotTag>;
/// A movable or fixed object of the world (attractor, basket, flag, ...), counted from 1; 0 is "no object".
using ObjectId = Id<struct ObjectTag>;

}  // namespace mlab::base

template <class Tag>
struct std::hash<mlab::base::Id<Tag>> {
  std::size_t operator()(mlab::base::Id<Tag> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.value);
  }
};
