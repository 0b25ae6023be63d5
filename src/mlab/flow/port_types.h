#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "mlab/flow/lists.h"
#include "mlab/flow/type_info.h"
#include "mlab/flow/value_types.h"
#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/formation.h"
#include "mlab/percept/percepts.h"
#include "mlab/ways/planned_way.h"

namespace mlab::flow {

class Library;

/// A set of object classes: bit i stands for percept::ObjectClass i.
struct ObjectClasses {
  std::uint32_t bits = 0;

  constexpr bool has(percept::ObjectClass c) const { return (bits >> static_cast<unsigned>(c) & 1U) != 0; }
  friend constexpr bool operator==(ObjectClasses, ObjectClasses) = default;
};

/// A short text that lives in the frame; what does not fit is refused where it is read.
struct Text {
  static constexpr std::size_t kCapacity = 63;
  std::array<char, kCapacity + 1> bytes{};

  std::string_view view() const { return {bytes.data(), ::strnlen(bytes.data(), kCapacity)}; }
  /// False, and unchanged, where the text is too long.
  bool assign(std::string_view text) {
    if (text.size() > kCapacity) return false;
    bytes.fill('\0');
    text.copy(bytes.data(), text.size());
    return true;
  }
};

/// How values of the types of `kValueTypes` are kept, by the numbers of ValueType.
using ValueTypes = std::tuple<bool, int, double, geom::Vector, geom::Point, geom::Pose, Obstacles, Robots,
                              Objects, percept::ObjectReading, Ranges, ObjectClasses, percept::Formation,
                              percept::FormationReference, percept::Task, Text, ways::PlannedWay>;
static_assert(std::tuple_size_v<ValueTypes> == kValueTypes.size());

const TypeInfo& type_info(ValueType type);

/// The number of a type among `ValueTypes`; their count where it is none of them.
template <class T>
inline constexpr std::size_t kValueTypeNumber = []<class... Types>(std::tuple<Types...>*) {
  std::size_t number = 0;
  static_cast<void>(((std::is_same_v<T, Types> ? false : (++number, true)) && ...));
  return number;
}(static_cast<ValueTypes*>(nullptr));

template <class T>
  requires(kValueTypeNumber<T> < kValueTypes.size())
struct PortTraits<T> {
  static const TypeInfo& info() { return type_info(static_cast<ValueType>(kValueTypeNumber<T>)); }
};

/// Adds all of the above to a library, with their historic names.
void add_port_types(Library& library);

}  // namespace mlab::flow
