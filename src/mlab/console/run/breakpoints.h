#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/run/sentence.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Where a run is to pause: transitions and conditions of robots' programs, and what a `Sentence` says. They
/// stay from one run to the next. Looking reads only, so a run with breakpoints is the same as one without,
/// but for when it pauses.
class BreakpointTable {
 public:
  static constexpr std::size_t kMost = 256;
  static constexpr int kMostHits = 20;  ///< that are told of one cycle

  /// Adds one (id 0) or changes the one of that id, and gives the id.
  /// @errors  a sentence for a person, in `error`; then 0
  std::uint32_t set(const Breakpoint& wanted, std::string& error);
  /// Id 0: all. False where there is none of that id.
  bool remove(std::uint32_t id);

  /// Those of an earlier session, with their ids.
  void recall(const std::vector<Breakpoint>& earlier);
  /// Some are switched on; if not, nobody need look.
  bool are_on() const { return count_on_ > 0; }
  /// Another run; null: there is none. It is looked at until the next one begins.
  void begin(const run::MissionRun* run);
  /// Programs of the run were exchanged.
  void change(const run::MissionRun* run);
  /// After each cycle. Adds what happened in it.
  void look(const run::MissionRun& run, Halted& out);
  void encode(Breakpoints& out) const;
  /// Something has changed since this was asked last.
  bool take_news() { return std::exchange(has_news_, false); }

 private:
  struct Entry {
    Breakpoint told;
    std::optional<Sentence> sentence;
    std::optional<double> number;  ///< that a condition's value is

    /// @errors  why it can't be meant at all
    static std::expected<Entry, std::string> read(const Breakpoint& wanted);
    /// A transition or a condition; a sentence about anything else looks for itself.
    const Breakpoint& what() const {
      return sentence && sentence->breakpoint() ? *sentence->breakpoint() : told;
    }
    std::optional<std::string> why_never(const run::MissionRun& run) const {
      return sentence ? sentence->why_never(run) : std::nullopt;
    }
    /// What is true already does not become so.
    void note(const run::MissionRun* run);
  };
  /// What a breakpoint means in a program.
  struct Meaning {
    bool is_there = false;
    std::uint32_t sequence = 0;
    std::optional<std::uint32_t> from;
    std::optional<std::uint32_t> to;
    const flow::Port* port = nullptr;
  };
  struct Robot {
    const flow::Program* program = nullptr;
    std::vector<flow::Program::SequenceState> states;
    std::map<std::uint32_t, bool> was_true;  ///< by breakpoint
  };

  void recount();
  void look_at(const fleet::FleetRobot& robot, Halted& out);
  void look_for_transit(Entry& one, const fleet::FleetRobot& robot,
                        const std::vector<flow::Program::Transit>& transits, Halted& out);
  void look_for_condition(Entry& one, const fleet::FleetRobot& robot, Robot& known,
                          const std::vector<std::uint32_t>& ran, Halted& out);
  void look_at_sentences(const run::MissionRun& run, Halted& out);
  void hit(Entry& one, Halted::Hit told, Halted& out);
  const Meaning& meaning(const Entry& one, const flow::Program& program);
  void say_problems(const run::MissionRun* run);

  std::map<std::uint32_t, Entry> all_;
  std::map<const flow::Program*, std::map<std::uint32_t, Meaning>> meanings_;
  std::map<std::uint32_t, Robot> robots_;
  const run::MissionRun* run_ = nullptr;  // only between `begin` and the end of that run
  std::uint32_t last_id_ = 0;
  std::size_t count_on_ = 0;
  bool has_news_ = true;
};

}  // namespace mlab::console
