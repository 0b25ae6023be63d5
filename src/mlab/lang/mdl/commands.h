#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Turns commands as written into commands that can be carried out: names looked up, times and numbers read.
class CommandReader {
 public:
  struct Scope {
    const mission::Mission& mission;
    const PlaceIndex& places;
    Roster& roster;
    const Damage& damage;
    /// Names of the overlays, for messages.
    std::vector<std::string> overlays;
  };

  CommandReader(Scope scope, text::SourcePtr source, text::Diagnostics& diagnostics);

  /// @return nothing for a command with an error, and for what is no command (a definition, say)
  std::optional<mission::Command> read(const Statement& statement);

 private:
  std::optional<mission::Command> unit_command(const statement::UnitAction& action);
  bool read_addressee(const statement::UnitAction& action, mission::UnitCommand& out);
  void read_location(const statement::UnitAction& action, mission::UnitCommand& out);
  void read_route(const statement::UnitAction& action, const overlay::ControlMeasure& line,
                  mission::UnitCommand& out);
  void read_places(const statement::UnitAction& action, mission::UnitCommand& out);
  void add_place(const Location& location, mission::UnitCommand& out);
  void read_area(const Location& location, mission::UnitCommand& out);
  void read_clause(const Clause& clause, mission::UnitCommand& out);
  void read_phase_line(const clause::PhaseLine& clause, text::Span span, mission::UnitCommand& out);
  std::optional<mission::MissionTime> read_time(const Moment& moment);
  bool may_copy(std::size_t points, text::Span span);
  const overlay::ControlMeasure* find_place(const Name& name);
  text::Place place(text::Span span) const { return {source_, span}; }

  Scope scope_;
  text::SourcePtr source_;
  text::Diagnostics& diagnostics_;
  std::size_t points_ = 0;  // copied from the overlay so far
};

}  // namespace mlab::mdl
