#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mlab/mission/mission.h"
#include "mlab/percept/formation.h"
#include "mlab/text/source.h"

namespace mlab::mdl {

/// What stands around a construct and means nothing to the mission.
struct Comments {
  std::vector<std::string> above;  ///< each with its `--`; an empty one is a blank line
  std::string after;               ///< behind the construct on its last line; empty: none
};

/// A name as written: a word, a string, or a file's name.
struct Name {
  std::string text;  ///< without quotes, with the trailing `*`
  bool quoted = false;
  text::Span span;
};

struct Number {
  double value = 0.0;
  std::string text;  ///< as written, so that 0.3 stays 0.3
  text::Span span;
};

/// A label, a date or a time: text that only the checker takes apart.
struct Mark {
  std::string text;
  text::Span span;
};

/// A place of the map: by name, or by two coordinates.
struct Location {
  std::optional<Name> name;  ///< none: x and y count
  Number x;
  Number y;
  text::Span span;
};

/// When something may happen. At least one member is set; a number stands alone.
struct Moment {
  bool is_timeout = false;  ///< counted from the moment at which the unit is in place
  std::optional<Mark> time;
  std::optional<Mark> date;
  std::optional<Number> number;
  text::Span span;
};

namespace clause {
struct Formation {
  percept::Formation formation = percept::Formation::kNone;
};
struct Technique {
  mission::Technique technique = mission::Technique::kTraveling;
};
struct Speed {
  Number speed;
};
struct Heading {
  Number degrees;
};
struct PhaseLine {
  Name line;
  std::optional<Moment> moment;
  std::optional<Name> acknowledge;
  bool waits = false;
};
struct OnCompletion {
  Name message;
};
struct Until {
  Moment moment;
};
struct Swath {
  Number width;
};
}  // namespace clause

struct Clause {
  text::Span span;
  std::variant<clause::Formation, clause::Technique, clause::Speed, clause::Heading, clause::PhaseLine,
               clause::OnCompletion, clause::Until, clause::Swath>
      what;
};

/// `name = value` of NEW-ROBOT.
struct Parameter {
  Comments comments;
  Name key;
  std::string value;    ///< what the robot gets
  std::string written;  ///< what the author wrote, quotes included
  text::Span value_span;
};

/// A group of a UNIT statement; the statement holds them all, parents before their parts.
struct Group {
  std::optional<Name> name;
  std::vector<Name> robots;          ///< types; empty where there are parts
  std::vector<std::uint32_t> parts;  ///< indices into the statement's groups
  text::Span span;
};

/// From one robot of a starting unit to the next.
struct StartStep {
  Number x;
  Number y;
};

namespace statement {
struct MissionName {
  Name name;
};
struct Scenario {
  Name name;
};
struct OverlayFile {
  Name file;
};
struct MissionArea {
  Number width, height;
};
struct LoadMap {
  Name file;
};
struct StartPlace {
  Name name;
  Number x, y;
};
struct Obstacle {
  Number x, y, radius;
};
struct CreateObstacles {};
struct NewRobot {
  Name name;
  Name program;
  std::optional<Name> color;
  std::optional<Name> host;
  std::vector<Parameter> parameters;
  std::vector<std::string> comments_below;  ///< between the last parameter and the closing parenthesis
};
struct UnitDefinition {
  std::vector<Group> groups;
};  ///< the first one holds the others
struct Set {
  std::variant<mission::BooleanOption, mission::NumberOption> option;
  std::optional<bool> flag;      ///< as written; none means on
  std::optional<Number> number;  ///< of a number option
  text::Span option_span;
};
struct Print {
  bool robot_info = false;
};
struct Failsafe {
  std::optional<Name> type;  ///< FOR
  mission::FailsafeCondition condition = mission::FailsafeCondition::kOutside;
  std::optional<Name> fence;      ///< OUTSIDE
  std::optional<Number> share;    ///< BELOW, in per cent
  std::optional<Number> seconds;  ///< AFTER
  mission::FailsafeAction action = mission::FailsafeAction::kHold;
  text::Span action_span;
};
struct Quit {};
struct InjectTrack {
  bool is_red = true;
};
struct UnitAction {
  Name unit;                   ///< meaningless where robots are named
  std::vector<Number> robots;  ///< `ROBOT 3`, `ROBOTS 2 5 7`
  bool says_robots = false;    ///< ROBOTS, not ROBOT
  mission::Task task = mission::Task::kMoveTo;
  std::optional<Location> location;  ///< none for STOP
  std::vector<Location> more;        ///< VISIT, PATROL: the places behind the first one
  std::optional<StartStep> step;     ///< START
  std::vector<Clause> clauses;
};
}  // namespace statement

/// A statement of the preamble, a command of a step, or a typed command.
struct Statement {
  Comments comments;
  text::Span span;  ///< of its first word
  std::variant<statement::MissionName, statement::Scenario, statement::OverlayFile, statement::MissionArea,
               statement::LoadMap, statement::StartPlace, statement::Obstacle, statement::CreateObstacles,
               statement::NewRobot, statement::UnitDefinition, statement::Set, statement::Print,
               statement::Failsafe, statement::Quit, statement::InjectTrack, statement::UnitAction>
      what;
};

struct LabelledStep {
  Comments comments;
  Mark label;  ///< without its point
  std::vector<Statement> commands;
};

/// What the parser could not read, so that the checker doesn't complain about what follows from it.
struct Damage {
  bool units = false;
  bool types = false;
  bool places = false;
};

/// A mission file, or a typed line, as it was written.
struct Tree {
  text::SourcePtr source;
  bool is_immediate = false;  ///< `typed` counts, the rest is empty
  std::vector<Statement> preamble;
  Comments header;  ///< around COMMAND LIST:
  std::vector<LabelledStep> steps;
  std::vector<Statement> typed;
  std::vector<std::string> comments_below;  ///< at the end of the file
  Damage damage;
};

/// Deepest nesting of groups in a UNIT statement.
inline constexpr std::uint32_t kMaxGroupDepth = 64;

}  // namespace mlab::mdl
