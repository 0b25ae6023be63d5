#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// Warnings that differ in nothing but numbers are shown a few times, and counted from then on.
class RepeatedWarnings {
 public:
  struct Limits {
    std::size_t of_a_kind;
    std::size_t kinds;
  };
  explicit RepeatedWarnings(Limits limits) : limits_(limits) {}
  /// @return true where it is to be shown
  bool admit(const std::string& text);
  /// For each kind of which some were not shown: `1203 more like: ...`, with the first of them.
  std::vector<std::string> left_out() const;

 private:
  struct Kind {
    std::string first;
    std::size_t count = 0;
  };
  Limits limits_;
  std::map<std::string, Kind> kinds_;
  std::size_t of_no_kind_ = 0;  // past the number of kinds that are kept
};

/// What a run shows in the terminal: a line for each event, a progress bar below them where standard output
/// is a terminal, a summary at the end. Where somebody is asked, the question takes the place of the bar.
class RunScreen {
 public:
  explicit RunScreen(bool quiet);

  void show_start(const run::MissionRun& run);
  void show(const run::MissionRun& run, const mission::Effect& effect);
  /// Draws the progress bar anew, at most ten times a second.
  void show_progress(const run::MissionRun& run);
  /// One line, the bar out of the way.
  void line(const std::string& text);
  /// The bar disappears.
  void clear_progress();
  /// Asks, in the last line, until `end_prompt`; lines that come meanwhile are put above it.
  void show_prompt(const std::string& text);
  /// @param is_answered  the line has been ended by who answered
  void end_prompt(bool is_answered);
  /// PRINT: the places and units of the mission, or its robots.
  void show_database(const run::MissionRun& run);
  void show_robots(const run::MissionRun& run);
  void show_summary(const run::MissionRun& run, const std::string& outcome, double wall_seconds);
  /// Once more what was warned of when the mission was loaded, and what was not shown of later warnings.
  void show_warnings(const text::Diagnostics& at_load) const;

 private:
  bool is_worth_a_line(const run::MissionRun& run, const mission::effect::Tell& told);

  bool quiet_;
  bool is_terminal_;
  bool has_bar_ = false;
  std::string prompt_;  // on the screen; empty: none
  RepeatedWarnings warnings_;
  double last_drawn_ = -1.0;
  double last_cycles_ = 0.0;
  double rate_ = 0.0;  // simulated seconds per second
};

}  // namespace mlab::cli
