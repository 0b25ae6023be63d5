#pragma once

#include <string_view>
#include <vector>

namespace mlab::cdl_historic {

/// The historic architectures as bits: a library name could mean different things in each.
enum Architecture : unsigned { kAura = 1, kUrban = 2, kNaval = 4, kUgv = 8 };
inline constexpr unsigned kAnyArchitecture = 15;
/// Bit of an architecture's name (`AuRA.urban`); 0 where there is none of that name.
unsigned architecture_named(std::string_view name);

/// In the place of a parameter of ours: the historic one changed what a screen showed, so nothing is lost
/// with it, and nothing is said of it.
inline constexpr std::string_view kOnScreen = "-";

/// A pushed-up parameter of a historic library assemblage, which parameter of ours it is, and its default.
struct LibraryPort {
  std::string_view historic;  ///< without `%`; empty: it was fixed
  std::string_view ours;  ///< names that it may have, with `|` between them; the first that there is counts
  std::string_view initial;  ///< the historic default; empty: none
};

/// A ready-made assemblage, trigger or percept of the historic libraries, and the component of ours.
struct LibraryName {
  std::string_view historic;
  unsigned architectures = kAnyArchitecture;
  std::string_view ours;  ///< names with `|` between them, as above
  std::vector<LibraryPort> ports;
  std::string_view type;  ///< of flow's types
};

/// All names, for the tests.
const std::vector<LibraryName>& library_names();
/// The row for a name; where the architecture has none, that of another one. Null: nobody knows the name.
const LibraryName* library_name(std::string_view historic, unsigned architecture);

/// The part of `a|b|c` in front of the first `|`, which is taken away.
std::string_view next_name(std::string_view& names);

/// Our robot class for a historic one; empty: unknown.
std::string_view robot_class_named(std::string_view historic);

}  // namespace mlab::cdl_historic
