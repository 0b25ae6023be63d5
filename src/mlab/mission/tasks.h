#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/percept/percepts.h"

namespace mlab::mission {

/// What a unit is commanded to do. Its robots are told a percept::Task.
enum class Task : std::uint8_t {
  kStart,
  kMoveTo,
  kOccupy,
  kFollow,
  kSweepTo,
  kTeleoperate,
  kStop,
  kRally,
  kVisit,
  kSearch,
  kPatrol
};

/// What may stand behind a command, by the numbers of `mdl::Clause::what`.
enum class ClauseKind : std::uint8_t {
  kFormation,
  kTechnique,
  kSpeed,
  kHeading,
  kPhaseLine,
  kOnCompletion,
  kUntil,
  kSwath
};
/// Several of them: a bit for each.
using Clauses = std::uint32_t;
constexpr Clauses operator|(ClauseKind a, ClauseKind b) {
  return 1U << static_cast<unsigned>(a) | 1U << static_cast<unsigned>(b);
}
constexpr Clauses operator|(Clauses a, ClauseKind b) {
  return a | 1U << static_cast<unsigned>(b);
}

/// All that is to be known of a clause but how it is parsed.
struct ClauseInfo {
  ClauseKind kind;
  std::string_view word;      ///< `FORMATION`
  std::string_view argument;  ///< what editors say where it may come next
  std::string_view help;      ///< what they say of the word
};
inline constexpr std::array kClauses = {
    ClauseInfo{ClauseKind::kFormation, "FORMATION", "the shape of the unit", "the shape of the unit"},
    ClauseInfo{ClauseKind::kTechnique, "TECHNIQUE", "who moves and who watches", "who moves and who watches"},
    ClauseInfo{ClauseKind::kSpeed, "SPEED", "metres per second", "metres per second"},
    ClauseInfo{ClauseKind::kHeading, "HEADING", "degrees, counter-clockwise from east", ""},
    ClauseInfo{ClauseKind::kPhaseLine, "PHASE-LINE", "line: its crossing is told",
               "a line whose crossing is told"},
    ClauseInfo{ClauseKind::kOnCompletion, "ON-COMPLETION", "MESSAGE text",
               "`ON-COMPLETION MESSAGE text`: told when the command is done"},
    ClauseInfo{ClauseKind::kUntil, "UNTIL", "when it is done, wherever the unit is then",
               "when an OCCUPY proceeds by itself, or another command is done"},
    ClauseInfo{ClauseKind::kSwath, "SWATH", "metres that a robot sees at once", ""},
};
static_assert(base::has_a_row_for_each<kClauses, &ClauseInfo::kind>());

/// All that is to be known of a command of a unit. Parsers, printers, checks, completion, help, the console's
/// menu, editors' grammars and the documentation take it from here; `tools/tables` writes what is not C++.
struct TaskInfo {
  Task task;
  percept::Task told;          ///< what each of its robots is told
  std::string_view word;       ///< `MOVETO`
  std::string_view also = {};  ///< a second spelling; empty: none
  std::string_view place;      ///< what stands behind the word; empty: nothing
  std::string_view help;       ///< what editors say of the word
  std::string_view meaning;    ///< what the documentation says
  std::string_view done;       ///< when it is done, for the documentation
  Clauses clauses = 0;
  bool awaits_report = false;     ///< it is done when the programs of its robots say so
  bool is_shared = false;         ///< its robots share it: it is done when one of them says so
  std::string_view label = {};    ///< in the console's menu; empty: it isn't there
  std::string_view purpose = {};  ///< a line for that menu
  int menu = 0;                   ///< its place in that menu
};

/// In the order of messages and of the documentation.
inline constexpr std::array kTasks = {
    TaskInfo{
        .task = Task::kStart,
        .told = percept::Task::kStart,
        .word = "START",
        .place = "place [dx dy]",
        .help = "puts the robots on the map",
        .meaning =
            "puts the unit's robots on the map and starts them. Robot k (from 0) stands k times (dx, dy) "
            "from the place; without offsets all are put where there is room around it",
        .done =
            "every robot of the unit runs. Robot k stands k offsets from the place. One that runs already "
            "stays where it is, with a warning"},
    TaskInfo{.task = Task::kMoveTo,
             .told = percept::Task::kMoveTo,
             .word = "MOVETO",
             .place = "place",
             .help = "moves there",
             .meaning = "moves the unit's centre to the place",
             .done = "every robot says that it is done: the centre of the unit is near enough to the goal",
             .clauses = ClauseKind::kFormation | ClauseKind::kTechnique | ClauseKind::kSpeed |
                        ClauseKind::kHeading | ClauseKind::kPhaseLine | ClauseKind::kOnCompletion |
                        ClauseKind::kUntil,
             .awaits_report = true,
             .label = "Move to",
             .purpose = "Move the unit's centre there",
             .menu = 1},
    TaskInfo{
        .task = Task::kOccupy,
        .told = percept::Task::kOccupy,
        .word = "OCCUPY",
        .place = "place",
        .help = "moves there, holds it, asks to proceed",
        .meaning =
            "the same, takes up the formation there and holds it; then asks whether the unit may proceed",
        .done = "every robot is done (centre at the goal, robot in its place in the formation), then the "
                "operator clears it",
        .clauses = ClauseKind::kFormation | ClauseKind::kHeading | ClauseKind::kUntil,
        .awaits_report = true,
        .label = "Occupy",
        .purpose = "Take up the formation there, hold it, then ask to proceed",
        .menu = 2},
    TaskInfo{.task = Task::kFollow,
             .told = percept::Task::kFollow,
             .word = "FOLLOW",
             .place = "line",
             .help = "moves along it",
             .meaning = "moves along the points of a line, from its first to its last",
             .done = "every robot says that it is done: the centre came to the end of the line",
             .clauses = ClauseKind::kFormation | ClauseKind::kTechnique | ClauseKind::kSpeed |
                        ClauseKind::kPhaseLine | ClauseKind::kOnCompletion | ClauseKind::kUntil,
             .awaits_report = true,
             .label = "Follow",
             .purpose = "Move along a line, from its first point to its last",
             .menu = 4},
    TaskInfo{.task = Task::kSweepTo,
             .told = percept::Task::kSweepTo,
             .word = "SWEEPTO",
             .place = "place",
             .help = "moves there side by side",
             .meaning = "moves to the place side by side",
             .done = "as MOVETO. It takes the formation Sweep where no FORMATION is given",
             .clauses = ClauseKind::kFormation | ClauseKind::kTechnique | ClauseKind::kSpeed |
                        ClauseKind::kPhaseLine | ClauseKind::kOnCompletion | ClauseKind::kUntil,
             .awaits_report = true,
             .label = "Sweep to",
             .purpose = "Move there side by side",
             .menu = 3},
    TaskInfo{
        .task = Task::kRally,
        .told = percept::Task::kMoveTo,
        .word = "RALLY",
        .place = "place",
        .help = "each robot goes there by itself",
        .meaning =
            "each robot goes to the place by itself, without formation. The radius of the place is half its "
            "diameter; that of an outline reaches from its centre to its farthest corner; coordinates and "
            "lines have 25 m",
        .done = "all robots that it is for are within the radius of the place at the same time, whatever "
                "they say; where an obstacle of the map stands there, all are as near as they come",
        .clauses = ClauseKind::kSpeed | ClauseKind::kOnCompletion | ClauseKind::kUntil,
        .label = "Rally",
        .purpose = "Each robot goes there by itself",
        .menu = 6},
    TaskInfo{.task = Task::kTeleoperate,
             .told = percept::Task::kTeleoperate,
             .word = "TELEOPERATE",
             .also = "TELOP",
             .place = "place",
             .help = "you steer",
             .meaning = "lets you steer the unit",
             .done = "the operator ends the teleoperation, or the robots report that he did",
             .clauses =
                 ClauseKind::kFormation | ClauseKind::kSpeed | ClauseKind::kOnCompletion | ClauseKind::kUntil,
             .label = "Steer",
             .purpose = "Steer the unit yourself, with the place as objective",
             .menu = 5},
    TaskInfo{
        .task = Task::kVisit,
        .told = percept::Task::kVisit,
        .word = "VISIT",
        .place = "places",
        .help = "a robot goes to each of these places",
        .meaning =
            "one of the unit's robots goes to each of the places. They share them by auction, so that all "
            "their ways together are short; what a lost one had goes to the others. A line stands for its "
            "points",
        .done = "a robot was at each of the places",
        .clauses = ClauseKind::kSpeed | ClauseKind::kOnCompletion | ClauseKind::kUntil,
        .awaits_report = true,
        .is_shared = true,
        .label = "Visit",
        .purpose = "A robot goes to each of these places",
        .menu = 7},
    TaskInfo{
        .task = Task::kSearch,
        .told = percept::Task::kSearch,
        .word = "SEARCH",
        .place = "area",
        .help = "its robots look at all of an area",
        .meaning =
            "goes in lanes over all that is free of an outline, or of a place with a diameter, so that a "
            "robot comes within half a SWATH (10 m where none is said) of everything. The robots share the "
            "lanes by auction; what a lost or late one had goes to the others",
        .done = "all lanes were gone along",
        .clauses = ClauseKind::kSpeed | ClauseKind::kOnCompletion | ClauseKind::kUntil | ClauseKind::kSwath,
        .awaits_report = true,
        .is_shared = true,
        .label = "Search",
        .purpose = "Its robots look at all of an area",
        .menu = 8},
    TaskInfo{
        .task = Task::kPatrol,
        .told = percept::Task::kPatrol,
        .word = "PATROL",
        .place = "places",
        .help = "its robots go round these places, evenly spread",
        .meaning =
            "goes round the places in their order, and from the last to the first again; the robots spread "
            "evenly, and again when one is lost. A line stands for its points",
        .done =
            "the time of UNTIL has come; without one, a robot has gone round once and the operator clears "
            "it: they go on until then",
        .clauses = ClauseKind::kSpeed | ClauseKind::kOnCompletion | ClauseKind::kUntil,
        .awaits_report = true,
        .is_shared = true,
        .label = "Patrol",
        .purpose = "Its robots go round these places, evenly spread",
        .menu = 9},
    TaskInfo{.task = Task::kStop,
             .told = percept::Task::kStop,
             .word = "STOP",
             .place = "",
             .help = "ends the robots",
             .meaning = "ends the unit's robots",
             .done = "no robot of the unit runs"},
};
static_assert(base::has_a_row_for_each<kTasks, &TaskInfo::task>());

constexpr const TaskInfo& info(Task task) {
  return base::row_of(kTasks, &TaskInfo::task, task);
}
constexpr const ClauseInfo& info(ClauseKind clause) {
  return base::row_of(kClauses, &ClauseInfo::kind, clause);
}
constexpr bool takes(Task task, ClauseKind clause) {
  return (info(task).clauses >> static_cast<unsigned>(clause) & 1U) != 0;
}

}  // namespace mlab::mission
