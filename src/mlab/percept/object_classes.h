#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/percept/percepts.h"

namespace mlab::percept {

/// All that is to be known of a class of objects but what historic files call it. Configurations, colours on
/// maps, completion, messages between processes and the documentation take it from here; `tools/tables`
/// writes what is not C++.
struct ObjectClassInfo {
  ObjectClass object_class;
  std::string_view name;        ///< in configurations: `EnemyRobot`
  std::string_view color;       ///< that marks it, in small letters: `dark sea green`
  std::string_view color_word;  ///< the same in one word, as overlays have it: `DarkSeaGreen`
};

/// By their numbers.
/// @source  the historic table of object classes by colour
inline constexpr std::array kObjectClasses = {
    ObjectClassInfo{ObjectClass::kMine, "Mine", "orange", "orange"},
    ObjectClassInfo{ObjectClass::kEnemyRobot, "EnemyRobot", "red", "red"},
    ObjectClassInfo{ObjectClass::kFlag, "Flag", "purple", "purple"},
    ObjectClassInfo{ObjectClass::kBasket, "Basket", "green", "green"},
    ObjectClassInfo{ObjectClass::kRock, "Rock", "black", "black"},
    ObjectClassInfo{ObjectClass::kTree, "Tree", "dark sea green", "DarkSeaGreen"},
    ObjectClassInfo{ObjectClass::kHomeBase, "HomeBase", "white", "white"},
    ObjectClassInfo{ObjectClass::kUnknown, "Unknown", "brown", "brown"},
    ObjectClassInfo{ObjectClass::kHidingPlace, "HidingPlace", "light blue", "LightBlue"},
    ObjectClassInfo{ObjectClass::kYellowMarker, "YellowMarker", "yellow", "yellow"},
    ObjectClassInfo{ObjectClass::kFriendlyRobot, "FriendlyRobot", "blue", "blue"},
};
static_assert(base::has_a_row_for_each<kObjectClasses, &ObjectClassInfo::object_class>());
/// Bits of sets of classes are indices of rows.
consteval bool are_rows_by_number() {
  for (std::size_t i = 0; i < kObjectClasses.size(); ++i) {
    if (static_cast<std::size_t>(kObjectClasses[i].object_class) != i) return false;
  }
  return kObjectClasses.back().object_class == kLastObjectClass;
}
static_assert(are_rows_by_number());

}  // namespace mlab::percept
