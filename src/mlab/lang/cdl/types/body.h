#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {

/// One number that the `body` of a class of robots may say, besides its drive.
struct BodyProperty {
  std::string_view name;
  std::string_view part;     ///< what of the body it describes: `body`, `drive`, `ring`, `camera` or `radio`
  std::string_view unit;     ///< in which people set it: `m`, `deg`; empty: a plain number
  std::string_view initial;  ///< of a body that does not say it, in CDL
  double min = 0.0;          ///< [unit]
  double max = 0.0;          ///< [unit]
  std::string_view help;
  bool is_whole = false;  ///< a count, or yes and no

  bool is_angle() const { return unit.starts_with("deg"); }
};

/// In the order in which forms ask for them.
std::span<const BodyProperty> body_properties();
/// Null where a body has no such number.
const BodyProperty* body_property(std::string_view name);

/// Why a property can't be a number.
enum class BodyMisfit : std::uint8_t {
  kNone,      ///< it can
  kUnit,      ///< it is another kind of quantity
  kRange,     ///< it is out of range
  kFraction,  ///< it is no whole number
};
/// @param unit  in which the number is
BodyMisfit body_misfit(const BodyProperty& property, double number, const Unit& unit);

/// What `drive` may be, by the number that a body has for it; the first where nothing is said.
inline constexpr std::array<std::string_view, 4> kDrives = {"holonomic", "differential", "car", "synchro"};
inline constexpr std::string_view kDriveHelp =
    "how it moves: holonomic goes to all sides at once, differential has two driven wheels, synchro steers "
    "and "
    "drives all wheels together, car steers its front wheels";

/// All names that may stand in a `body`: the properties' and `drive`.
std::vector<std::string> body_settings();

}  // namespace mlab::cdl
