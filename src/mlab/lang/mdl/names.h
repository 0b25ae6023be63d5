#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// The control measures of an overlay by name, for many references. Sees the overlay as it was when it was
/// made.
class PlaceIndex {
 public:
  explicit PlaceIndex(const overlay::Overlay& overlay);
  /// What overlay::find_measure would find.
  const overlay::ControlMeasure* find(std::string_view reference) const;

 private:
  const overlay::Overlay& overlay_;
  std::unordered_map<std::string_view, std::uint32_t> by_name_;  // only asked, never walked through
};

/// Defines robot types, robots and units in a mission, and finds them again.
class Roster {
 public:
  /// @param mission  what is defined in it already counts; outlives this
  /// @param societies  null: a program is that of one robot
  Roster(mission::Mission& mission, text::SourcePtr source, const Damage& damage,
         text::Diagnostics& diagnostics, SocietyReader societies = nullptr);

  /// @return  false where nobody knows what robots it stands for
  bool define_type(const statement::NewRobot& statement);
  void define_unit(const statement::UnitDefinition& statement);
  /// A society that stands in no unit becomes one of its own name. To be called behind all definitions.
  void define_units_of_societies();
  /// The names of the robot types that a name stands for: one, or those of a society. Reports an unknown one.
  std::optional<std::vector<std::string>> types_named(const Name& name);
  /// Reports an unknown unit, with the name that may have been meant.
  std::optional<std::uint32_t> find_unit(const Name& name);
  /// Reports a number that no robot has.
  std::optional<base::RobotId> find_robot(const Number& number);
  /// A type of this name is defined further below, at this place: said where it is missed above.
  void announce_type(const Name& name);

 private:
  void check_color(const Name& color);
  text::Place place(text::Span span) const { return {source_, span}; }
  bool refuse_second_type(const Name& name);
  bool define_society(const Name& name, const mission::RobotType& type,
                      const std::vector<std::pair<std::string, int>>& members);
  void add_type(mission::RobotType type);
  std::optional<std::uint32_t> find_type(const Name& name);
  void report_unknown_type(const Name& name);
  /// The robots that a name in a unit stands for; a new one each time.
  std::vector<base::RobotId> create_robots(const Name& name);
  std::vector<base::RobotId> create_society(std::uint32_t society, const text::Place& where);
  base::RobotId create_robot(std::uint32_t type, text::Place where, bool has_wish = true);
  std::optional<std::uint32_t> wished_id(const mission::RobotType& type);

  mission::Mission& mission_;
  text::SourcePtr source_;
  const Damage& damage_;
  text::Diagnostics& diagnostics_;
  SocietyReader read_society_;
  std::unordered_map<std::string, std::uint32_t> types_;      // by name in small letters,
  std::unordered_map<std::string, std::uint32_t> societies_;  // likewise
  std::vector<bool> is_in_unit_;                              // by society
  int robots_of_societies_ = 0;
  std::vector<std::optional<std::uint32_t>> wished_ids_;  // one for each type
  std::unordered_map<std::string, std::uint32_t> units_;
  std::unordered_map<std::string, text::Span> announced_;
  std::unordered_map<std::uint32_t, std::uint32_t> taken_ids_;  // index into Mission::robots
  std::uint32_t last_id_ = 0;
};

/// Messages about the things of a mission that could name thousands of candidates look at no more than this
/// many.
inline constexpr std::size_t kNamesForHints = 2000;
/// A longer name is a slip of another kind than a spelling mistake.
inline constexpr std::size_t kLongestNameForHints = 100;

}  // namespace mlab::mdl
