#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "mlab/flow/lists.h"
#include "mlab/flow/type_info.h"
#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/formation.h"
#include "mlab/percept/percepts.h"

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

template <>
struct PortTraits<bool> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<int> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<double> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<geom::Vector> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<geom::Point> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<geom::Pose> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<Obstacles> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<Robots> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<Objects> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<Ranges> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<percept::ObjectReading> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<ObjectClasses> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<percept::Formation> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<percept::FormationReference> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<percept::Task> {
  static const TypeInfo& info();
};
template <>
struct PortTraits<Text> {
  static const TypeInfo& info();
};

/// Adds all of the above to a library, with their historic names.
void add_port_types(Library& library);

}  // namespace mlab::flow
