#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mlab::comparison {

/// Something of both runs, the first one's first.
template <class T>
using Both = std::array<T, 2>;
inline constexpr Both<std::size_t> kSides = {0, 1};

/// A fact that is not the same in both, in words; empty: it is not there.
struct Fact {
  std::string what;
  Both<std::string> values;
  bool matters = true;  ///< false: no run goes otherwise for it alone, such as where its files lay
};

/// A text that is not the same in both.
struct TextDifference {
  Both<std::string> paths;  ///< empty: only the other one has it
  std::vector<std::string>
      lines;                 ///< `-` of the first, `+` of the second, ` ` of both, `@ 12` where they are
  std::size_t left_out = 0;  ///< lines that are not shown
};

/// What differs before anything happens.
struct Beginning {
  std::vector<Fact> facts;
  std::vector<TextDifference> texts;

  /// Nothing that matters differs.
  bool is_same() const;
};

/// Something came in from outside that did not come in in the other run, or not then.
struct InputDifference {
  std::uint64_t cycle = 0;   ///< that had run
  double time = 0.0;         ///< [s]
  Both<std::string> inputs;  ///< in words; empty: nothing came
};

/// A value of a robot's program, or something else of it, that differs.
struct Value {
  std::string path;
  Both<std::string> values;
};

/// Where two runs part.
struct Parting {
  enum class What : std::uint8_t {
    kPort,     ///< a value of a program
    kState,    ///< the state of a sequence
    kAction,   ///< what a program wants, all of whose values that can be seen are equal
    kPlace,    ///< where a body is
    kRobots,   ///< which robots there are, and whether they run
    kMission,  ///< how far the plan is
    kEnd       ///< one has come to its end, and the other goes on
  };
  What what = What::kPort;
  std::uint64_t cycle = 0;            ///< that had run: after it they are not the same for the first time
  double time = 0.0;                  ///< [s]
  std::uint32_t robot = 0;            ///< the first that parts; 0: it is about none
  Value value;                        ///< the first of it that differs, in the order in which it is computed
  std::vector<std::string> causes;    ///< what is behind that, as sentences, the nearest first
  std::vector<Value> consequences;    ///< along the wires from there, in the same cycle
  std::size_t values = 0;             ///< how many of its values differ in that cycle
  std::vector<std::uint32_t> robots;  ///< all that part in that cycle, ascending
  /// Only what was recorded was compared: up to this cycle they were certainly the same.
  std::optional<std::uint64_t> same_until;
};

/// One robot in both runs. Lengths [m], times [s].
struct RobotRow {
  std::uint32_t id = 0;
  Both<bool> is_there{};  ///< it was in the world at some time
  /// False: at some time only what it answered and where it was could be compared, not the values of its
  /// program.
  bool has_values = true;
  double most_apart = 0.0;
  double most_apart_at = 0.0;
  double apart_at_end = 0.0;  ///< when both were there last
  Both<double> driven{};
  Both<std::uint32_t> contacts{};
  Both<std::optional<double>> first_contact;        ///< nothing: there was none
  std::vector<float> apart;                         ///< by `Comparison::times`; NaN where not both were there
  Both<std::vector<std::pair<float, float>>> ways;  ///< likewise
};

/// A command of the plan, or of the operator.
struct CommandRow {
  struct Times {
    double start = 0.0;  ///< [s]
    double end = 0.0;    ///< [s]; where it has ended
    bool has_ended = false;
    std::string outcome;
  };
  std::string what;  ///< `step 2: unit scouts MOVETO X`
  Both<std::optional<Times>> times;
};

struct EventRow {
  std::string text;
  bool is_warning = false;
  Both<std::optional<double>> times;  ///< [s]
};

/// How a unit kept its formations.
struct UnitRow {
  struct Error {
    double mean = 0.0;       ///< [m]
    double most = 0.0;       ///< [m]
    double out_share = 0.0;  ///< of the time out of formation
  };
  std::string name;
  Both<std::optional<Error>> errors;  ///< nothing: there was no formation to keep
};

/// One of the two.
struct Side {
  std::string name;     ///< of its file
  std::string mission;  ///< path of its text
  std::string version;  ///< of missionlab
  std::uint64_t seed = 0;
  std::uint64_t cycles = 0;
  double length = 0.0;               ///< [s]
  std::string outcome;               ///< empty: it was cut off, or goes on
  std::vector<std::string> remarks;  ///< what is to be known of it: sentences
  std::string why_not_recomputed;    ///< as a sentence; empty: it was
};

/// What two runs have in common, and what not.
struct Comparison {
  Both<Side> sides;
  /// Both were computed again, so every value of every robot in every cycle was compared
  /// (RobotRow::has_values says of which it was not); else only what was recorded: poses, events, the end.
  bool is_recomputed = true;
  bool is_whole = true;  ///< false: nobody waited for the end
  Beginning beginning;
  std::optional<InputDifference> input;  ///< the first
  std::optional<Parting> parting;        ///< nothing: they are the same for as long as both go on
  std::vector<double> times;             ///< at which distances were noted [s]
  std::vector<RobotRow> robots;          ///< by id
  std::vector<CommandRow> commands;
  std::vector<EventRow> events;
  std::size_t events_left_out = 0;
  std::vector<UnitRow> units;
  /// By `times`: how far robots are from their stations on average [m]; NaN where there is no formation.
  Both<std::vector<float>> formation_errors;

  /// The same run twice, as far as it was compared, made from the same.
  bool is_same() const { return beginning.is_same() && !input && !parting; }
};

}  // namespace mlab::comparison
