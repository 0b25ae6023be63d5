#pragma once

#include <cstdio>
#include <string>

#include "mlab/fleet/mission_run.h"

namespace mlab::cli {

/// What a run shows in the terminal: a line for each event, a progress bar below them where standard output
/// is a terminal, a summary at the end.
class RunScreen {
 public:
  explicit RunScreen(bool quiet);

  void show_start(const fleet::MissionRun& run);
  void show(const fleet::MissionRun& run, const mission::Effect& effect);
  /// Draws the progress bar anew, at most ten times a second.
  void show_progress(const fleet::MissionRun& run);
  /// One line, the bar out of the way.
  void line(const std::string& text);
  /// The bar disappears.
  void clear_progress();
  /// PRINT: the places and units of the mission, or its robots.
  void show_database(const fleet::MissionRun& run);
  void show_robots(const fleet::MissionRun& run);
  void show_summary(const fleet::MissionRun& run, const std::string& outcome, double wall_seconds);

 private:
  bool quiet_;
  bool is_terminal_;
  bool has_bar_ = false;
  double last_drawn_ = -1.0;
  double last_cycles_ = 0.0;
  double rate_ = 0.0;  // simulated seconds per second
};

}  // namespace mlab::cli
