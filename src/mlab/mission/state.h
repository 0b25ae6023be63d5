#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/mission/effect.h"
#include "mlab/mission/mission.h"

namespace mlab::mission {

/// How the executive does its work. Lengths [m], times [s].
struct ExecutiveOptions {
  bool proceed_all = false;     ///< every question is answered with yes at once
  double patience = 600.0;      ///< so long without progress, and a command has failed; <= 0: never
  double epoch_seconds = 0.0;   ///< the mission clock at run time 0, as seconds since 1970-01-01 00:00 UTC
  double zone_offset = 0.0;     ///< of the mission clock's time zone, east of UTC
  double bound_length = 150.0;  ///< longest bound of BOUNDING-OVERWATCH; never more than a third of the leg
  double spacing = 0.0;  ///< between the parts of a unit; 0: `formation_spacing` of its first robot's type
  double phase_line_ahead =
      0.5;  ///< a line counts as reached that a robot would cross within this time, or 3 cycles

  friend bool operator==(const ExecutiveOptions&, const ExecutiveOptions&) = default;
};

enum class Outcome : std::uint8_t { kPending, kRunning, kDone, kFailed, kAborted, kReplaced, kSkipped };
/// `done`, `failed`, ...
std::string_view name(Outcome outcome);

/// What kept a command from being done, apart from its details: the same for runs that failed alike.
enum class Failure : std::uint8_t {
  kNone,
  kNotStarted,  ///< robots that were to start do not run
  kNoProgress,  ///< nobody came nearer to being done for too long
  kRobotsLost,  ///< likewise, and some of those that it waited for do not run
  kNobodyLeft,  ///< none of its robots runs
  kNoWay        ///< no way leads those there that are not done
};
/// `no progress`, ...; empty for none
std::string_view name(Failure failure);

/// A unit command that lives as long as somebody speaks of it. Two are equal when they say the same.
struct CommandRef {
  std::shared_ptr<const UnitCommand> value;

  const UnitCommand& operator*() const { return *value; }
  const UnitCommand* operator->() const { return value.get(); }
  friend bool operator==(const CommandRef& a, const CommandRef& b);
};

/// One line of the run's history: a command, from its start to its end.
struct CommandRecord {
  std::string text;       ///< `unit scouts OCCUPY ATK-AP1 (Diamond)`, `SET SHOW-TRAILS ON`
  std::string unit;       ///< or the robots: `robots 2, 5`; empty for SET, PRINT, QUIT
  std::string task;       ///< `OCCUPY`, `SET`, ...
  std::string place;      ///< as written; empty: none
  std::string formation;  ///< `Diamond`; empty: none
  double start = 0.0;     ///< [s]
  double end = 0.0;       ///< [s]; meaningful when the outcome is not kRunning
  Outcome outcome = Outcome::kRunning;
  Failure failure = Failure::kNone;
  std::string message;  ///< why it failed; else empty

  friend bool operator==(const CommandRecord&, const CommandRecord&) = default;
};
/// A step of the plan, or an order of the operator.
struct StepRecord {
  std::string label;             ///< empty for an order of the operator
  std::uint32_t step = kNoStep;  ///< index into the steps of the plan that was in force
  double start = 0.0;
  double end = 0.0;
  Outcome outcome = Outcome::kRunning;
  std::uint32_t first_command = 0;  ///< index into State::commands
  std::uint32_t command_count = 0;

  friend bool operator==(const StepRecord&, const StepRecord&) = default;
};

inline constexpr std::uint32_t kNoRun = std::numeric_limits<std::uint32_t>::max();

/// What the executive knows of a robot.
struct RobotState {
  enum class Life : std::uint8_t { kNotStarted, kStarted, kStopped };  ///< as the mission wants it

  base::RobotId id;
  Life life = Life::kNotStarted;
  bool is_running = false;  ///< as it last reported
  bool done = false;        ///< with what `run` waits for; retracted only where a RALLY's robot leaves again
  bool warned = false;      ///< that it doesn't run, once per command
  bool has_given_up = false;   ///< it came nearer once, and has said last that it can do so no more
  std::uint32_t sequence = 0;  ///< of its order; 0: none
  std::uint32_t reported = 0;  ///< the sequence that it last spoke of
  std::uint32_t run = kNoRun;  ///< index into State::runs: who waits for it
  std::uint64_t seen = 0;      ///< number of the last cycle in which it reported; 0: never
  geom::Pose pose;             ///< last reported [m, rad, world]
  geom::Offset step;           ///< its motion in the last cycle [m]
  double radius = 0.2;         ///< [m]
  double remaining = std::numeric_limits<double>::infinity();  ///< last reported under its order [m]
  double best =
      std::numeric_limits<double>::infinity();  ///< the smallest so far that counted as progress [m]

  friend bool operator==(const RobotState&, const RobotState&) = default;
};

/// Robots under one order: a unit, or a part of one. The order stands until each of them has another one.
struct Group {
  std::uint32_t sequence = 0;
  std::vector<base::RobotId> members;  ///< in rank order
  CommandRef command;
  percept::Task task = percept::Task::kNone;  ///< what its command has them told, or a technique instead
  geom::Point goal;                           ///< [m, world]
  bool halted = false;

  friend bool operator==(const Group&, const Group&) = default;
};

/// How far a unit is with a phase line of its command.
struct LineState {
  enum class Phase : std::uint8_t { kAhead, kHolding, kPassed };
  Phase phase = Phase::kAhead;
  bool acknowledged = false;
  std::optional<double> not_before;  ///< run time, known once the line is reached [s]

  friend bool operator==(const LineState&, const LineState&) = default;
};

/// A part of a unit that moves by itself under a technique; the whole unit when it travels.
struct Part {
  std::uint32_t sequence = 0;  ///< of its group
  geom::Point goal;            ///< its own place beside or behind the unit's goal [m, world]
  double remaining = std::numeric_limits<double>::infinity();  ///< from its centre to its own goal [m]
  double behind =
      std::numeric_limits<double>::infinity();  ///< how far its centre is from the unit's goal [m]
  double ahead = 0.0;                           ///< of the unit's goal, where it ends [m]
  bool done = false;
  bool halted = false;  ///< as the technique wants it

  friend bool operator==(const Part&, const Part&) = default;
};

inline constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();

/// A unit command of the step that runs, or of an order of the operator that is under way.
struct Run {
  enum class Phase : std::uint8_t {
    kHeld,           ///< of the plan: waits until none of its robots is under an order of the operator
    kRobots,         ///< waits for its robots, or holds at a phase line
    kProceed,        ///< waits for the operator's clearance
    kTeleoperation,  ///< waits for the end of teleoperation
    kEnded
  };
  std::uint32_t record = 0;  ///< index into State::commands
  std::uint32_t owner = 0;   ///< index into State::steps: the step or the order that it belongs to
  std::uint32_t unit = 0;    ///< index into Mission::units; kNoUnit: the command names robots
  CommandRef command;
  Phase phase = Phase::kHeld;
  std::vector<base::RobotId> needed;    ///< whom it is for, without those that orders took, in rank order
  std::vector<base::RobotId> left_out;  ///< who did not run as it began: they take part once they run again
  std::optional<double> ends;           ///< it is done at this run time (UNTIL behind others than OCCUPY) [s]
  std::uint32_t missing = 0;            ///< how many of `needed` are not done
  double stalled = 0.0;                 ///< time without progress [s]
  std::vector<LineState> lines;         ///< for each phase line of the command
  Technique technique = Technique::kTraveling;  ///< what is possible: a unit of one robot travels
  std::vector<Part> parts;                      ///< empty for START and STOP
  bool in_file = false;           ///< the parts go one behind the other; else they can pass each other
  std::uint32_t mover = kNoPart;  ///< bounding: the part that moves
  std::uint32_t bounds = 0;       ///< bounding: how many bounds were begun
  double settled = 0.0;           ///< bounding: since all parts were halted; they may still roll [s]
  double target = 0.0;    ///< bounding: the mover's bound ends when so much remains [m]; 0: at its goal
  double distance = 0.0;  ///< bounding: length of a bound; overwatch: between parts [m]

  friend bool operator==(const Run&, const Run&) = default;
};

/// A question that the operator has not answered.
struct Question {
  std::uint32_t id = 0;
  std::uint32_t run = 0;                    ///< index into State::runs; meaningless where a robot asks
  std::optional<std::uint32_t> phase_line;  ///< index into the command's; none: Proceed?
  std::optional<double> expires;            ///< run time [s]
  base::RobotId robot = {};                 ///< whose program asks; 0: a unit's command does

  friend bool operator==(const Question&, const Question&) = default;
};

/// Everything that the executive knows. Plain and copyable; two states are equal when they would do the same
/// (the same plan is the same object). Everything but the plan is values, so a journal can hold it.
struct State {
  /// Running: a step or an order is under way.
  enum class Mode : std::uint8_t { kIdle, kRunning, kQuit };

  std::shared_ptr<const Mission> mission;  ///< never null
  ExecutiveOptions options;
  Mode mode = Mode::kIdle;
  bool paused = false;
  bool in_step = false;                 ///< a step of the plan runs: steps[step_record]
  bool single = false;                  ///< stops after the step that runs
  bool is_ending = false;               ///< all steps are over; the mission is done when the orders are
  Outcome outcome = Outcome::kPending;  ///< of the mission
  std::uint32_t step = 0;               ///< index of the step that runs, or that Execute would start
  std::uint32_t step_record = 0;        ///< index into `steps`; meaningful where a step runs
  double time = 0.0;                    ///< of the last cycle [s]
  std::uint64_t cycle = 0;              ///< number of the last cycle, from 1
  std::uint32_t last_sequence = 0;
  std::uint32_t last_question = 0;
  std::vector<RobotState> robots;   ///< by id, ascending
  std::vector<Group> groups;        ///< by sequence, ascending: the orders in force
  std::vector<Run> runs;            ///< of the step that runs and of all orders; those of one owner together
  std::vector<Question> questions;  ///< by id, ascending
  std::vector<StepRecord> steps;    ///< all that were started, in their order
  std::vector<CommandRecord> commands;

  friend bool operator==(const State&, const State&) = default;
};

/// Null where the mission has no robot of that id.
RobotState* find_robot(State& state, base::RobotId id);
const RobotState* find_robot(const State& state, base::RobotId id);

}  // namespace mlab::mission
