#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mlab/percept/percepts.h"

namespace mlab::flow {

/// What flows on a wire for "some of the readings of this cycle": indices into the percepts, in ascending
/// order, so nearest first. 64 are kept at most; the farthest fall out.
template <class Reading>
struct IndexList {
  static constexpr std::size_t kCapacity = 64;

  std::uint16_t count = 0;
  std::array<std::uint16_t, kCapacity> indices{};

  constexpr void clear() { count = 0; }
  /// Adds the reading with this index; dropped where the list is full.
  constexpr void add(std::size_t index) {
    if (count < kCapacity) indices[count++] = static_cast<std::uint16_t>(index);
  }
};

using Obstacles = IndexList<percept::Obstacle>;
using Robots = IndexList<percept::RobotReading>;
using Objects = IndexList<percept::ObjectReading>;

/// How a procedure sees such a list: readings by position, with their index for passing them on.
template <class Reading>
class ListView {
 public:
  ListView(const IndexList<Reading>& list, std::span<const Reading> readings)
      : list_(&list),
        readings_(readings.data()),
        count_(list.count <= readings.size() ? list.count : clipped(readings.size())) {}

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const Reading& operator[](std::size_t i) const { return readings_[list_->indices[i]]; }
  /// The index in the percepts of the i-th reading: `output.add(readings.index(i))` keeps it.
  std::size_t index(std::size_t i) const { return list_->indices[i]; }

  class Iterator {
   public:
    Iterator(const ListView* view, std::size_t at) : view_(view), at_(at) {}
    const Reading& operator*() const { return (*view_)[at_]; }
    Iterator& operator++() { return ++at_, *this; }
    friend bool operator==(Iterator, Iterator) = default;

   private:
    const ListView* view_;
    std::size_t at_;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, count_}; }

 private:
  // A list left over from an earlier cycle may name readings that are gone; those at its end are left out.
  std::size_t clipped(std::size_t available) const {
    std::size_t n = 0;
    while (n < list_->count && list_->indices[n] < available) ++n;
    return n;
  }

  const IndexList<Reading>* list_;
  const Reading* readings_;
  std::size_t count_;
};

/// On a wire: "the whole ring of range sensors of this cycle". Seen by a procedure as a span of RangeReading.
struct Ranges {
  std::uint16_t count = 0;
};

}  // namespace mlab::flow
